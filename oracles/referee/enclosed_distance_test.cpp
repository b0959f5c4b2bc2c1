// SPDX-License-Identifier: MIT
// Compares solver/distance.hpp with the referee's enclosures. It asks a few pairs daily.
// DAYLIGHT_DISTANCE_PAIRS=5000 DAYLIGHT_SEED=n makes a long run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

TEST(EnclosedDistance, OnEveryFamily) {
  const std::uint64_t seed = from_environment("DAYLIGHT_SEED", 20261121);
  const std::uint64_t many = from_environment("DAYLIGHT_DISTANCE_PAIRS", 60);
  for (const Family& family : families()) {
    int apart = 0, overlapping = 0, at_odds = 0;
    double worst = 0;  // how far outside its enclosure, in units of the size
    for (std::uint64_t i = 0; i < many; ++i) {
      const Pair pair = family.generate(seed, i);
      const Truth truth = judge(pair);
      if (truth.verdict == Verdict::undecided) continue;
      const Enclosure truly = truth.verdict == Verdict::disjoint ? enclose_distance(pair, truth, 1e-14)
                                                                 : enclose_distance(pair, truth);
      const Distance said = distance(pair.a, pair.b);
      const double size = size_of(pair), reach = size + (pair.b.center - pair.a.center).lpNorm<1>();
      if (reach > 0x1p-200 && reach < 0x1p200) {                      // else f in double over- or underflows
        const double width = 1e-6, rounding = 256 * 0x1p-53 * reach;  // twice the enclosure's slack
        const AttainedDistance at = attain_distance(pair, truth, width);
        ASSERT_TRUE(at.distance.hi - at.distance.lo <= width * size + rounding || at.cells >= cell_cap)
            << format_pair(pair);
        const double f =
            support_gap(terms_of<double>(pair.a), terms_of<double>(pair.b),
                        lifted<double>(Vector3(pair.b.center - pair.a.center)), lifted<double>(at.direction));
        ASSERT_NEAR(f, -at.distance.lo, 16 * rounding) << format_pair(pair);
        const auto [x, y, z] = at.direction;
        ASSERT_NEAR(std::hypot(x, y, z), 1, 0x1p-50) << format_pair(pair);
      }
      const double outside = std::max({0.0, truly.lo - said.value, said.value - truly.hi});
      ASSERT_LE(outside, 1e-13 * size) << format_pair(pair);
      if (size > 0) worst = std::max(worst, outside / size);
      (truth.verdict == Verdict::disjoint ? apart : overlapping) += 1;
      at_odds += (truth.verdict == Verdict::disjoint) != (said.verdict == Verdict::disjoint);
      if (said.verdict != Verdict::disjoint) continue;
      // Its own bounds hold, and are close.
      ASSERT_LE(said.error, 1e-13 * (size + (pair.b.center - pair.a.center).stableNorm()) + 0x1p-1071)
          << format_pair(pair);
      ASSERT_LE(truly.lo, said.value + said.error) << format_pair(pair);
      ASSERT_GE(truly.hi, said.value - said.error) << format_pair(pair);
    }
    std::printf("%-24s %5d apart, %5d not, %3d verdicts at odds, worst %.1e size\n", family.name.data(),
                apart, overlapping, at_odds, worst);
  }
}

// From glotzerlab/hoomd-rs, pull request 130: two long rods, 3.75e-13 apart. The enclosure was [0, 7.1e-9].
TEST(EnclosedDistance, DoesNotContradictTheVerdictByItsWidth) {
  const Pair apart{{{0, 0, 0}, {0, 0, 1}, 0.25, 1e6}, {{1, 0, 0}, {-1e-6, 0, 1}, 0.25, 1e6}};
  const Truth truth = judge(apart);
  ASSERT_EQ(truth.verdict, Verdict::disjoint);
  const Enclosure gap = enclose_distance(apart, truth);
  EXPECT_GT(gap.lo, 0);
  EXPECT_LE(gap.lo, 3.76e-13);
  EXPECT_GE(gap.hi, 3.74e-13);
  Pair meet = apart;
  meet.b.center.x() -= 1e-11;
  const Truth shown = judge(meet);
  ASSERT_EQ(shown.verdict, Verdict::intersecting);
  const Enclosure depth = enclose_distance(meet, shown);
  EXPECT_LT(depth.hi, 0);
  EXPECT_GE(depth.hi, -1e-11);
}

// A disk and a segment that meet. Fuzzing found it: the lower bound was 1e-7, from a direction of length 1.4.
TEST(EnclosedDistance, HoldsForAxesThatDifferByLessThanTheRoundingOfTheirLengths) {
  RandomStream stream("enclosed_distance_test", 1, 0);
  Pair pair{{{4.6875640108913475e-08, 0, -4.687564010891348e-09}, {0, 1, 0}, 0, 4.76837158203125e-07},
            {{9.172239372780156e-12, 2.3841857910143852e-07, 0},
             {0, 1, 0},
             2.4795911328876837e-06,
             2.4795911328901635e-19}};
  for (int i = 0; i < 200; ++i) {
    pair.a.axis.y() = stream.between(0.5, 2);
    pair.b.axis.z() = std::ldexp(1.0, stream.integer(-600, -60));
    const Truth truth = judge(pair);
    ASSERT_EQ(truth.verdict, Verdict::intersecting);
    const Enclosure depth = enclose_distance(pair, truth);
    ASSERT_LE(depth.lo, -2.4e-19) << format_pair(pair);
    ASSERT_LE(depth.hi, 0) << format_pair(pair);
  }
}

TEST(Enclosure, HoldsAmongTheSmallestAndTheLargestDoubles) {
  constexpr double e = 5e-324, huge = 1e308;
  auto upright = [](double x, double radius, double height) {
    return Solid{Vector3(x, 0, 0), Vector3(0, 0, 1), radius, height};
  };
  struct Known {
    Pair pair;
    double distance;
  };
  for (const Known& k :
       {Known{{upright(e, 0, 0), upright(7 * e, 0, 0)}, 6 * e},
        Known{{upright(e, e, 0), upright(15 * e, e, 0)}, 12 * e},
        Known{{upright(-huge / 2, huge / 8, 1), upright(huge / 2, huge / 8, 1)}, 0.75 * huge},
        Known{{upright(huge, e, e), upright(huge, e, e)}, -e}}) {
    const Enclosure found = enclose_distance(k.pair, judge(k.pair));
    EXPECT_LE(found.lo, k.distance) << format_pair(k.pair);
    EXPECT_GE(found.hi, k.distance) << format_pair(k.pair);
  }
}

// The squares of the axes' tilt, of the offset or of the gap are subnormal or 0.
TEST(Enclosure, HoldsWhereSquaresUnderflow) {
  const std::pair<const char*, double> all[] = {
      {R"({"a":{"center":[0,0,0],"axis":[1,0,0],"radius":1,"height":10},)"
       R"("b":{"center":[0.25,0,1.5],"axis":[1,1.7e-162,0],"radius":1,"height":10}})",
       -0.5},
      {R"({"a":{"center":[0,0,0],"axis":[1,0,0],"radius":1,"height":10},)"
       R"("b":{"center":[0.25,0,2.5],"axis":[1,3.3e-162,0],"radius":1,"height":10}})",
       0.5},
      {R"({"a":{"center":[0,0,0],"axis":[0.93802855423460041,0.20899593535445551,0.27644733756334433],)"
       R"("radius":0.039461180842312427,"height":0.35815195331538652},)"
       R"("b":{"center":[1.477412159609916e-163,8.7712162317925232e-163,2.2065783915529403e-163],)"
       R"("axis":[0.54973931746572768,-0.43924458190441734,-0.71052859203548557],)"
       R"("radius":0.50528699969771806,"height":0.9622775011991217}})",
       -0.5447481805400305},
      {R"({"a":{"center":[0,0,0],"axis":[1,0,0],"radius":0,"height":2},)"
       R"("b":{"center":[0,3e-160,1e-160],"axis":[0,1,0],"radius":0,"height":0}})",
       3.1622776601683794e-160},
      {R"({"a":{"center":[0,0,0],"axis":[1,0,0],"radius":0,"height":2},)"
       R"("b":{"center":[0,3e-162,1e-162],"axis":[1,0,0],"radius":0,"height":0}})",
       3.1622776601683794e-162}};
  for (const auto& [text, distance] : all) {
    const Pair pair = parse_case(text, 1).value.value().pair;
    const AttainedDistance found = attain_distance(pair, judge(pair), 1e-12);
    EXPECT_LE(found.distance.lo, distance) << text;
    EXPECT_GE(found.distance.hi, distance) << text;
    const auto [x, y, z] = found.direction;
    EXPECT_NEAR(x * x + y * y + z * z, 1, 1e-14) << text;
  }
}

// The support point of a direction within 1e-9 of an axis lies on the rim. The direction hardly determines
// its place. The distance, to 16 digits, is from mpmath.
TEST(Enclosure, KeepsToTheRimNearAnAxis) {
  const Pair p{{{0.07799465032728059, -0.6491270501948554, 0.18302059596377318},
                {0.36144175990345634, -0.8814801938102229, -0.3038955776548649},
                9.66695294305895,
                0},
               {{6.185082114466994, 6.914833155770789, -14.493483402312991},
                {0.36144176053822225, -0.8814801933388567, -0.3038955782671444},
                7.954923558490437,
                0}};
  const Enclosure e = enclose_distance(p, judge(p), 1e-14);
  EXPECT_LE(e.lo, 3.7935233225620569e-10);
  EXPECT_GE(e.hi, 3.7935233225620569e-10);
}

// The segments are end to end. By cancellation the double computation is off by more than the last place,
// and only the slack covers it.
TEST(Enclosure, CoversItsOwnRounding) {
  for (int i = 1; i <= 200; ++i) {
    const Pair p{{Vector3(0, 0, 0.1 * i), Vector3(0, 0, 1), 0, 0.3 * i},
                 {Vector3(0, 0, 0.7 * i), Vector3(0, 0, 1), 0, 0.7 * i + 1e-9}};
    const mpq_class gap = mpq_class(p.b.center.z()) - mpq_class(p.a.center.z()) -
                          (mpq_class(p.a.height) + mpq_class(p.b.height)) / 2;
    const Enclosure e = enclose_distance(p, judge(p));
    EXPECT_LE(mpq_class(e.lo), gap) << i;
    EXPECT_GE(mpq_class(e.hi), gap) << i;
  }
}

// It steers the harness and may err. So only the share of pairs on which it errs is held.
TEST(ApproximateDistance, IsInTheEnclosureOnNearlyAllPairs) {
  int pairs = 0, off = 0, apart = 0, points_off = 0;
  for (const Family& family : families()) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Pair pair = family.generate(7, i);
      const Enclosure truth = enclose_distance(pair, judge_verdict(pair));
      const MeasuredDistance d = measure_with_points(pair);
      const double slack = 1e-9 * (size_of(pair) + (pair.b.center - pair.a.center).stableNorm());
      if (!std::isfinite(slack)) continue;
      ++pairs;
      off += d.value < truth.lo - slack || d.value > truth.hi + slack;
      if (truth.lo <= 0) continue;
      ++apart;
      const Vector3 way = pair.b.center - pair.a.center + d.on_b - d.on_a;
      points_off += std::abs(way.stableNorm() - d.value) > slack;
    }
  }
  EXPECT_GT(pairs, 1000);
  EXPECT_LE(off, pairs / 200);
  EXPECT_LE(points_off, apart / 100);
  const Pair invalid{{}, {{0, 0, 0}, {0, 0, 0}, 1, 1}};
  EXPECT_TRUE(measure_with_points(invalid).direction.isZero(0));
}

}  // namespace
}  // namespace cyl
