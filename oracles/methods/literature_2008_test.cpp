// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "corpus/pairs/families.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t pairs_per_family = 100;
constexpr std::uint64_t family_seed = 20080302;

class Literature2008 : public testing::TestWithParam<std::size_t> {};

// `decide` and its certificates against every setting without faults.
TEST_P(Literature2008, AgreeWithDecideBeyondTheirClaim) {
  const Family& family = families()[GetParam()];
  for (const auto& method : literature_2008_methods()) {
    if (method->name().find("printed") != std::string_view::npos) continue;
    for (std::uint64_t index = 0; index < pairs_per_family; ++index) {
      const Pair pair = family.generate(family_seed, index);
      const MethodAnswer answer = method->ask(pair);
      const Verdict truth = decide(pair.a, pair.b).verdict;
      if (answer.verdict == truth || truth == Verdict::undecided) continue;
      Trial trial(pair);
      const auto finding = compare(trial, method->claim(), answer);
      EXPECT_FALSE(finding && finding->severity == Severity::contract)
          << method->name() << ' ' << family.name << ' ' << index;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EachFamily, Literature2008, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& info) { return std::string(families()[info.param].name); });

TEST(Literature2008Printed, AreOftenWrong) {
  const Family& family = *find_family("random");
  for (const auto& method : literature_2008_methods()) {
    if (method->name() != "seed2008-printed") continue;
    int wrong = 0;
    for (std::uint64_t index = 0; index < 1000; ++index) {
      const Pair pair = family.generate(family_seed, index);
      wrong += method->ask(pair).verdict != judge(pair).verdict;
    }
    EXPECT_GT(wrong, 50);
  }
}

}  // namespace
}  // namespace cyl
