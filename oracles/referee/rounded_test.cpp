// SPDX-License-Identifier: MIT
#include "oracles/referee/rounded.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

Pair pair_from(const std::string& a, const std::string& b) {
  return parse_case("{\"a\":{" + a + "},\"b\":{" + b + "}}", 1).value.value().pair;
}

constexpr const char* unit_ball = R"("center":[0,0,0],"axis":[0,0,1],"radius":0,"height":0,"rounding":1)";

TEST(RefereeOfRounded, BallsThatTouchTouch) {
  const Pair pair =
      pair_from(unit_ball, R"("center":[3,4,0],"axis":[1,0,0],"radius":0,"height":0,"rounding":4)");
  const Truth truth = judge(pair);
  EXPECT_EQ(truth.verdict, Verdict::touching);
  EXPECT_EQ(truth.certificate.kind, CertificateKind::points);
}

TEST(RefereeOfRounded, ALastBitOfRoundingParts) {
  for (const auto& [rounding, verdict] : {std::pair{"3.9999999999999996", Verdict::disjoint},
                                          std::pair{"4.000000000000001", Verdict::intersecting}}) {
    const Truth truth = judge(pair_from(
        unit_ball,
        std::string(R"("center":[3,4,0],"axis":[1,0,0],"radius":0,"height":0,"rounding":)") + rounding));
    EXPECT_EQ(truth.verdict, verdict) << rounding;
  }
}

// The contact is at irrational points: a ball on the wall of a cylinder whose axis is (1, 1, 0), from the
// side (1, -1, 0).
TEST(RefereeOfRounded, TouchingAtIrrationalPointsIsProvedToo) {
  const Pair pair = pair_from(R"("center":[0,0,0],"axis":[1,1,0],"radius":0,"height":6,"rounding":1)",
                              R"("center":[0,0,3],"axis":[1,-1,0],"radius":1,"height":4,"rounding":1)");
  const Truth truth = judge(pair);
  EXPECT_EQ(truth.verdict, Verdict::touching);
  const Pair tilted = pair_from(R"("center":[0,0,0],"axis":[1,1,0],"radius":0,"height":2,"rounding":1)",
                                R"("center":[0,0,0],"axis":[1,1,0],"radius":1,"height":2,"rounding":0)");
  EXPECT_EQ(judge(tilted).verdict, Verdict::intersecting);
}

class RefereeOfFamilies : public testing::TestWithParam<std::size_t> {};

TEST_P(RefereeOfFamilies, EveryPairIsJudgedAndEveryAnswerOfOursHolds) {
  const Family& family = rounded_families()[GetParam()];
  constexpr std::uint64_t count = 1500, seed = 20261123;
  std::size_t undecided = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Pair pair = family.generate(seed, i);
    const Truth truth = judge(pair);
    ASSERT_NE(truth.verdict, Verdict::undecided) << format_pair(pair);
    const Verdict yes_or_no = truth.verdict == Verdict::touching ? Verdict::intersecting : truth.verdict;
    const Answer said = decide(pair.a, pair.b);
    if (said.verdict == Verdict::undecided) {
      ++undecided;
      const Enclosure off = enclose_distance(pair, truth);
      ASSERT_LT(std::min(std::fabs(off.lo), std::fabs(off.hi)), 1e-13 * size_of(pair)) << format_pair(pair);
      continue;
    }
    ASSERT_EQ(said.verdict, yes_or_no) << format_pair(pair);
    MethodAnswer witness;
    witness.status = Status::answered;
    witness.verdict = said.verdict;
    witness.set_witness(certificate_of(said, pair.a, pair.b));
    ASSERT_EQ(check_witness(pair, witness), said.verdict) << format_pair(pair);
    // It proves nothing of other solids.
    if (said.proof != Proof::points) continue;
    Pair other = pair;
    other.b.center += Vector3(0, 0, 4 * size_of(pair) + std::numeric_limits<double>::min());
    ASSERT_EQ(check_witness(other, witness), Verdict::undecided) << format_pair(other);
  }
  EXPECT_LT(undecided, count / 10);
}

TEST(RefereeOfRounded, SmallIntegersTouchAndAreProvedTo) {
  std::size_t touching = 0;
  for (const Family& family : rounded_families())
    for (std::uint64_t i = 3; i < 4000; i += 8)
      touching += judge(family.generate(20261123, i)).verdict == Verdict::touching;
  EXPECT_GT(touching, 20u);
}

TEST_P(RefereeOfFamilies, TheDistanceIsEnclosed) {
  const Family& family = rounded_families()[GetParam()];
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Pair pair = family.generate(3, i);
    const Truth truth = judge(pair);
    const Enclosure e = enclose_distance(pair, truth);
    const Distance d = distance(pair.a, pair.b);
    ASSERT_LE(e.lo, e.hi) << format_pair(pair);
    if (d.value > 0) {
      ASSERT_GE(d.value + d.error, e.lo) << format_pair(pair);
    }
    ASSERT_LE(d.value - d.error, e.hi) << format_pair(pair);
    if (truth.verdict == Verdict::disjoint) {
      ASSERT_LE(e.hi - e.lo, 4 * gap_width_tol * (size_of(pair) + (pair.b.center - pair.a.center).norm()))
          << format_pair(pair);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RefereeOfFamilies, testing::Range<std::size_t>(0, rounded_families().size()),
                         [](const auto& info) { return std::string(rounded_families()[info.param].name); });

}  // namespace
}  // namespace cyl
