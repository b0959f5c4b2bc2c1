// SPDX-License-Identifier: MIT
// Tests the table of laws, and that our own methods keep all of them.
#include <gtest/gtest.h>
// After gtest.h.
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/referee/referee.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {

void showValue(const Solid& c, std::ostream& out) { out << format_pair({c, c}); }

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

/// Numbers n/64 with least <= n <= 256, which are exact in sums and products and often touch.
rc::Gen<double> on_grid(int least) {
  return rc::gen::map(rc::gen::inRange(least, 257), [](int n) { return n / 64.0; });
}

template <typename Coordinate>
rc::Gen<Vector3> vector_of(const rc::Gen<Coordinate>& x) {
  return rc::gen::map(rc::gen::tuple(x, x, x),
                      [](const auto& v) { return Vector3(std::get<0>(v), std::get<1>(v), std::get<2>(v)); });
}

/// Half of the axes have coordinates -2..2, so parallel and perpendicular axes are common.
rc::Gen<Solid> grid_cylinder() {
  const auto axis =
      rc::gen::suchThat(rc::gen::oneOf(vector_of(rc::gen::inRange(-2, 3)), vector_of(on_grid(-256))),
                        [](const Vector3& v) { return v != Vector3::Zero(); });
  return rc::gen::map(rc::gen::tuple(vector_of(on_grid(-256)), axis, on_grid(0), on_grid(0)),
                      [](const auto& c) {
                        return Solid{std::get<0>(c), std::get<1>(c), std::get<2>(c), std::get<3>(c)};
                      });
}

void expect_kept(const Pair& pair) {
  const Verdict truth = judge(pair).verdict;
  RC_CLASSIFY(truth == Verdict::disjoint, "disjoint");
  RC_CLASSIFY(truth == Verdict::intersecting, "intersecting");
  RC_CLASSIFY(truth == Verdict::touching, "touching");
  const std::string violation = broken_by_ours(pair);
  if (!violation.empty()) RC_FAIL(violation);
}

RC_GTEST_PROP(Laws, HoldOnTheGrid, ()) {
  const Solid a = *grid_cylinder(), b = *grid_cylinder();
  expect_kept({a, b});
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
