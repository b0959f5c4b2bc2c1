// SPDX-License-Identifier: MIT
// Each approximate law catches a planted fault. If other laws catch it too, there is a reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oracles/referee/referee.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

// The fault depends on the angle to the coordinate axes. No mirror or permutation changes it. The factor is
// above 1, so moves are too long as well.
TEST(ApproximateLaws, CatchADistanceThatDependsOnTheDirection) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   const Vector3 delta = pair.b.center - pair.a.center;
                                   const double steep = delta.lpNorm<Eigen::Infinity>() / delta.norm();
                                   answer.distance *= 1 + 1e-6 * steep;
                                 })),
            (Numbers{20, 22, 24, 33}));
}

TEST(ApproximateLaws, CatchADistanceThatDependsOnThePlace) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   if (pair.a.center.norm() > 1000 * size_of(pair)) answer.distance *= 2;
                                 })),
            Numbers{21});
}

TEST(ApproximateLaws, CatchAVerdictThatDependsOnThePlace) {
  EXPECT_EQ(laws_broken_by(plant("intersect",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   if (pair.a.center.norm() > 1000 * size_of(pair))
                                     answer.verdict = Verdict::intersecting;
                                 })),
            Numbers{21});
}

// The distance is also wrong and below what its direction shows. Two ways together are shorter than one.
TEST(ApproximateLaws, CatchADistanceInSteps) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   const double step = size_of(pair) / 100;
                                   answer.distance = step * std::trunc(answer.distance / step);
                                 })),
            (Numbers{13, 22, 23, 33, 42}));
}

// A small turn leaves the axis at nearly unit length.
TEST(ApproximateLaws, CatchAVerdictThatMissesASmallTurn) {
  EXPECT_EQ(laws_broken_by(plant("intersect",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   const double square = pair.a.axis.squaredNorm();
                                   if (std::fabs(square - 1) > 0x1p-23 && std::fabs(square - 1) < 0x1p-19)
                                     answer.verdict = Verdict::intersecting;
                                 })),
            Numbers{22});
}

// One solid is much smaller than the other. Only the middle solid of the triangle is.
TEST(ApproximateLaws, CatchAWayThatIsLongerThanAround) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   if (std::min(pair.a.radius, pair.b.radius) <
                                           std::max(pair.a.radius, pair.b.radius) / 512 &&
                                       answer.distance > 0)
                                     answer.distance = 0;
                                 })),
            Numbers{23});
}

TEST(ApproximateLaws, CatchARoundingThatCountsTwice) {
  const auto counts_twice = [](const Pair& pair, MethodAnswer& answer) {
    if (answer.distance > pair.a.rounding) answer.distance -= pair.a.rounding;
  };
  const Numbers violated = laws_broken_by(plant("distance", counts_twice), "capsule_capsule");
  EXPECT_NE(std::find(violated.begin(), violated.end(), 25), violated.end());
}

// The fault lies next to touching. No drawn pair lies there, but every slide ends there.
TEST(ApproximateLaws, CatchADepthBeyondTheWayBack) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   const double least = 1e-5 * size_of(pair);
                                   if (answer.distance < 0 && answer.distance > -least)
                                     answer.distance = -least;
                                 })),
            Numbers{24});
}

// For a method that never takes the right way out, the gap that a slide leaves shows the fault.
TEST(ApproximateLaws, CatchADepthThatOpensAGap) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair&, MethodAnswer& answer) {
                                   if (answer.distance < 0) answer.distance *= 1.001;
                                 })),
            (Numbers{22, 24, 33}));
}

}  // namespace
}  // namespace cyl
