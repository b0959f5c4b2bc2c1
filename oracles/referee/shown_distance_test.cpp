// SPDX-License-Identifier: MIT
#include "oracles/referee/shown_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/own_answers.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

// Tests what solver/distance.hpp promises always and on every machine. It includes the smallest solids, for
// which the reported values are a few of the smallest doubles.
TEST(ShownDistance, IsThatOfTheSolverWithinTheErrorItShows) {
  for (const Family& family : families()) {
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Pair pair = family.generate(11, i);
      const Distance d = distance(pair.a, pair.b);
      const Enclosure shown = shown_distance(pair, measured_of(d));
      if (!std::isfinite(shown.lo)) continue;
      const MethodAnswer answer = answer_of(pair, d);
      EXPECT_LE(error_bound_of(shown, answer).hi, answer.error_bound) << family.name << format_pair(pair);
    }
  }
}

TEST(ShownDistance, IsWideWhereDirectionOrPointsAreNoGood) {
  const Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {0, 0, 1}, 1, 2}};
  MeasuredDistance d = measure_with_points(pair);
  EXPECT_NEAR(shown_distance(pair, d).lo, 1, 1e-15);
  EXPECT_NEAR(shown_distance(pair, d).hi, 1, 1e-15);
  d.direction = {0.6, 0.8, 0};
  EXPECT_NEAR(shown_distance(pair, d).lo, 3 * 0.6 - 2, 1e-15);
  d.on_a = {0, 2, 0};  // outside by 1
  EXPECT_GT(shown_distance(pair, d).hi, 2);
  d.direction.setZero();
  EXPECT_EQ(shown_distance(pair, d).lo, -INFINITY);
}

TEST(ShownDistance, OfBoxes) {
  Pair pair{{}, {{3, 4, 3}, {0, 0, 1}, 0, 0, 1}};
  pair.a.shape = Shape::box;
  pair.a.edges = {2, 4, 2};
  pair.a.rounding = 0.25;
  MeasuredDistance d = measure_with_points(pair);
  const double gap = std::sqrt(12) - 1.25;
  EXPECT_NEAR(shown_distance(pair, d).lo, gap, 1e-14);
  EXPECT_NEAR(shown_distance(pair, d).hi, gap, 1e-14);
  d.on_a += Vector3(3, 4, 0);  // outside by 5, as the way gets longer or shorter
  EXPECT_GT(shown_distance(pair, d).hi, 4);
}

}  // namespace
}  // namespace cyl
