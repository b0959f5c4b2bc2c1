// SPDX-License-Identifier: MIT
// The text of 2017, put right, against the referee.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/decide.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl {
namespace {

using literature::Minimiser;
using literature::Separation;

constexpr std::uint64_t family_seed = 20170416;

/// In sizes: below it the text put right is rounding too.
constexpr double rounding_margin = 1e-12;

std::vector<Case> errata_cases() {
  std::vector<Case> cases;
  for (const Case& c : read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases"))
    if (c.id.find("-2017-") != std::string::npos) cases.push_back(c);
  return cases;
}

/// What the whole text put right says of the cases, by both minimisers.
TEST(Errata2017, NoneIsWrongOncePutRight) {
  for (const Case& c : errata_cases())
    for (Minimiser m : {Minimiser::conjugate_gradients, Minimiser::powell})
      EXPECT_EQ(separated_cylinders(prepare(c.pair.a), prepare(c.pair.b), m, {}).verdict == Verdict::disjoint,
                c.truth == Verdict::disjoint)
          << c.id;
}

class Literature2017 : public testing::TestWithParam<std::size_t> {};

/// Claims of oracles/methods/literature_2017_method.cpp, in brief.
TEST_P(Literature2017, AgreesWithTheSolverAboveItsClaim) {
  const Family& family = families()[GetParam()];
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Pair pair = family.generate(family_seed, i);
    const Prepared a = prepare(pair.a), b = prepare(pair.b);
    const Verdict truth = decide(a, b).verdict;
    if (truth == Verdict::undecided) continue;
    for (Minimiser m : {Minimiser::conjugate_gradients, Minimiser::powell}) {
      const Separation found = separated_cylinders(a, b, m, {});
      if (found.verdict == truth) continue;
      const Enclosure d = enclose_distance(pair, judge(pair));
      EXPECT_LT(std::max(d.lo, -d.hi), rounding_margin * size_of(pair)) << format_pair(pair);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Literature2017, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& info) { return std::string(families()[info.param].name); });

/// Section 5 tests W0 x W1 by (r0 + r1) |W0 x W1| - |(W0 x W1).Delta|, which rounds as f() does not.
TEST(Printed2017, TestsTheAxesByTheFormulasOfTheText) {
  const literature::Options printed{
      .faults = literature::printed_2017, .literal = true, .touching_apart = true};
  for (const std::uint64_t index : {34, 169}) {
    const Pair pair = find_family("close_contacts_by_angle")->generate(1, index);
    EXPECT_EQ(separated_cylinders(literature::prepare_as_given(pair.a), literature::prepare_as_given(pair.b),
                                  Minimiser::conjugate_gradients, printed)
                  .verdict,
              judge(pair).verdict);
    EXPECT_EQ(judge(pair).verdict, Verdict::disjoint);
  }
}

}  // namespace
}  // namespace cyl
