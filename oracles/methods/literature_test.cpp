// SPDX-License-Identifier: MIT
// Tests the texts of 2008 and 2017 against the solver and the referee, corrected and as printed.
#include <gtest/gtest.h>

#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/decide.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t pairs_per_family = 100;
constexpr std::uint64_t family_seed = 20080302;

class Literature : public testing::TestWithParam<std::size_t> {};

// Compares every setting without faults with `decide` and its certificates.
TEST_P(Literature, AgreesWithDecideBeyondItsClaim) {
  const Family& family = families()[GetParam()];
  for (const auto make : {literature_2008_methods, literature_2017_methods})
    for (const auto& method : make()) {
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

INSTANTIATE_TEST_SUITE_P(Families, Literature, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& info) { return std::string(families()[info.param].name); });

/// Checks the verdicts of the corrected text of 2017 about the cases.
TEST(Errata2017, NoneIsWrongOncePutRight) {
  for (const Case& c : read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases")) {
    if (c.id.find("-2017-") == std::string::npos) continue;
    EXPECT_EQ(separated_cylinders(prepare(c.pair.a), prepare(c.pair.b), literature::Options{}).verdict ==
                  Verdict::disjoint,
              c.truth == Verdict::disjoint)
        << c.id;
  }
}

/// Section 5 tests W0 x W1 by (r0 + r1) |W0 x W1| - |(W0 x W1).Delta|, which rounds as f() does not.
TEST(LiteraturePrinted, TestsTheAxesByTheFormulasOfTheTextOf2017) {
  const literature::Options printed{
      .faults = literature::printed_2017, .literal = true, .touching_apart = true};
  for (const std::uint64_t index : {34u, 169u}) {
    const Pair pair = find_family("close_contacts_by_angle")->generate(1, index);
    EXPECT_EQ(separated_cylinders(literature::prepare_as_given(pair.a), literature::prepare_as_given(pair.b),
                                  printed)
                  .verdict,
              judge(pair).verdict);
    EXPECT_EQ(judge(pair).verdict, Verdict::disjoint);
  }
}

}  // namespace
}  // namespace cyl
