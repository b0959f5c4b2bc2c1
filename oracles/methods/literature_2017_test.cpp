// SPDX-License-Identifier: MIT
// The text of 2017 against the referee: put right, and each of its faults alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/literature_2017_errata_test.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl {
namespace {

using literature::Minimiser;
using literature::Separation;

constexpr std::uint64_t family_seed = 20170416;

std::vector<Case> errata() {
  std::ifstream in(DAYLIGHT_SOURCE_DIR "/corpus/cases/errata.jsonl");
  std::vector<Case> cases;
  CaseReader reader(in);
  while (const auto line = reader.next()) {
    EXPECT_TRUE(line->value) << line->error;
    if (line->value && line->value->id.starts_with("errata-2017-")) cases.push_back(*line->value);
  }
  return cases;
}

TEST(Errata2017, EachFaultAloneIsWrong) {
  std::map<std::string, Case> cases;
  for (const Case& c : errata()) cases.emplace(c.id, c);
  for (const Fault2017& shown : faults_2017()) {
    const auto found = cases.find("errata-2017-" + std::string(shown.name));
    if (found == cases.end()) continue;  // no effect on a verdict was found: solver/literature/errata.md
    EXPECT_TRUE(shows(shown, found->second.pair)) << shown.name;
    EXPECT_EQ(judge(found->second.pair).verdict, found->second.truth) << shown.name;
    cases.erase(found);
  }
  for (const auto& [id, c] : cases) ADD_FAILURE() << id << " shows nothing";
}

/// What the whole text put right says of the cases, by both minimisers.
TEST(Errata2017, NoneIsWrongOncePutRight) {
  for (const Case& c : errata())
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
      EXPECT_LT(std::max(d.lo, -d.hi), rounding_margin_2017 * size_of(pair)) << format_pair(pair);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Literature2017, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& info) { return std::string(families()[info.param].name); });

}  // namespace
}  // namespace cyl
