// SPDX-License-Identifier: MIT
// Tests the table of laws, and that our own methods keep all of them.
#include "props/laws/laws_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

/// Returns the laws that our own methods break on this pair against their contract, or nothing.
std::string broken_by_ours(const Pair& pair) {
  for (const auto& method : own_methods()) {
    for (const Law& law : all_laws()) {
      const auto violation = violation_of(*method, law, pair);
      if (violation && violation->severity == Severity::contract) {
        return std::string(method->name()) + ", law " + std::to_string(law.number) + ", " +
               std::string(law.name) + ": " + violation->what;
      }
    }
  }
  return {};
}

class FamilyLaws : public testing::TestWithParam<std::size_t> {};

TEST_P(FamilyLaws, HoldOnTheFirstPairs) {
  const std::uint64_t pairs = from_environment("DAYLIGHT_LAW_PAIRS", 50);
  for (std::uint64_t index = 0; index < pairs; ++index) {
    const Pair pair = campaign_families()[GetParam()].generate(family_seed, index);
    ASSERT_EQ(broken_by_ours(pair), "") << format_pair(pair);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, FamilyLaws, testing::Range<std::size_t>(0, campaign_families().size()),
                         [](const auto& info) { return std::string(campaign_families()[info.param].name); });

TEST(Laws, AreNumberedByKindAndFoundByNumber) {
  int last = 0;
  for (const Law& law : all_laws()) {
    EXPECT_GT(law.number, last);
    last = law.number;
    EXPECT_EQ(static_cast<int>(law.kind), std::min(law.number / 10, 3)) << law.number;
    EXPECT_EQ(&law_numbered(law.number), &law);
    EXPECT_FALSE(law.name.empty() || law.statement.empty() || law.where.empty()) << law.number;
  }
  EXPECT_THROW(law_numbered(99), std::invalid_argument);
}

TEST(Laws, SayNothingOfAMethodThatIsNeverSure) {
  EXPECT_EQ(laws_broken_by(plant(
                "intersect", [](const Pair&, MethodAnswer& answer) { answer.verdict = Verdict::undecided; })),
            Numbers{});
}

}  // namespace
}  // namespace cyl
