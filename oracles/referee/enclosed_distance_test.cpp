// SPDX-License-Identifier: MIT
// Compares solver/distance.hpp with the referee's enclosures. It asks a few pairs daily.
// DAYLIGHT_DISTANCE_PAIRS=5000 DAYLIGHT_SEED=n makes a long run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/random_stream.hpp"
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
      const double size = size_of(pair);
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

}  // namespace
}  // namespace cyl
