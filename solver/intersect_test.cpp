// SPDX-License-Identifier: MIT
// Tests intersect() on pairs whose truth is known on paper. Touching counts as meeting here because no
// operation rounds. intersect() never promises it.
#include <gtest/gtest.h>

#include <limits>

#include "solver/distance.hpp"
#include "solver/solver_test.hpp"

namespace cyl {
namespace {

TEST(Intersect, PairsKnownOnPaper) {
  const Solid unit = upright(0, 0, 0, 1, 2);
  EXPECT_EQ(intersect(unit, upright(0, 0, 0, 1, 2)), Verdict::intersecting);
  EXPECT_EQ(intersect(unit, upright(1.5, 0, 1.5, 1, 2)), Verdict::intersecting);
  EXPECT_EQ(intersect(unit, upright(2, 0, 0, 1, 2)), Verdict::intersecting);  // touching is meeting
  EXPECT_EQ(intersect(unit, upright(2.001, 0, 0, 1, 2)), Verdict::disjoint);
  EXPECT_EQ(intersect(unit, upright(0, 0, 2.001, 1, 2)), Verdict::disjoint);
  const Solid lying{Vector3(0, 0, 1.99), Vector3(1, 0, 0), 1, 2};
  EXPECT_EQ(intersect(unit, lying), Verdict::intersecting);
  const Solid higher{Vector3(0, 0, 2.01), Vector3(1, 0, 0), 1, 2};
  EXPECT_EQ(intersect(unit, higher), Verdict::disjoint);
  // Rims at the corner of a 3-4-5 triangle: the upright solid's rim point (3, 4, 1).
  const Solid wide = upright(0, 0, 0, 5, 2);
  EXPECT_EQ(intersect(wide, upright(6, 8, 2, 4.999, 2)), Verdict::disjoint);
  EXPECT_EQ(intersect(wide, upright(6, 8, 1.999, 5.001, 2)), Verdict::intersecting);
}

// All numbers are exact: the corner of the widths is at 3 and 12, the half lengths there are 4 and 5, and the
// lines are 9 apart.
TEST(Intersect, RimsThatTouchMeet) {
  const Solid a = upright(0, 0, 0, 5, 2);
  EXPECT_EQ(intersect(a, {Vector3(4, 9, 13), Vector3(1, 0, 0), 13, 2}), Verdict::intersecting);
  EXPECT_EQ(intersect(a, {Vector3(4, 9.0001, 13), Vector3(1, 0, 0), 13, 2}), Verdict::disjoint);
}

TEST(Intersect, SegmentsDisksAndPointsAreSolids) {
  const Solid fat = upright(0, 0, 0, 1, 2);
  const Solid through{Vector3(0, 0, 0), Vector3(1, 1, 1), 0, 10};
  const Solid beside{Vector3(0, 1.1, 0), Vector3(1, 0, 0), 0, 10};
  EXPECT_EQ(intersect(fat, through), Verdict::intersecting);
  EXPECT_EQ(intersect(fat, beside), Verdict::disjoint);
  EXPECT_EQ(intersect(fat, upright(0, 0, 0.5, 0, 0)), Verdict::intersecting);
  EXPECT_EQ(intersect(fat, upright(0, 0, 1.5, 0, 0)), Verdict::disjoint);
  EXPECT_EQ(intersect(fat, upright(0, 0, 0.5, 9, 0)), Verdict::intersecting);
  const Solid crossed{Vector3(0, 0, 0), Vector3(0, 1, 0), 0, 2};
  EXPECT_EQ(intersect(upright(0, 0, 0, 0, 2), crossed), Verdict::intersecting);
  const Solid passed{Vector3(0.001, 0, 0), Vector3(0, 1, 0), 0, 2};
  EXPECT_EQ(intersect(upright(0, 0, 0, 0, 2), passed), Verdict::disjoint);
}

TEST(Intersect, BadInputIsInvalidAndSaysWhy) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Solid good = upright(0, 0, 0, 1, 2);
  struct Bad {
    Solid c;
    Defect defect;
  };
  const Bad all[] = {{upright(nan, 0, 0, 1, 2), Defect::center_not_finite},
                     {{Vector3(0, 0, 0), Vector3(0, inf, 1), 1, 2}, Defect::axis_not_finite},
                     {{Vector3(0, 0, 0), Vector3(0, 0, 0), 1, 2}, Defect::axis_zero},
                     {upright(0, 0, 0, nan, 2), Defect::radius_not_finite},
                     {upright(0, 0, 0, -1, 2), Defect::radius_negative},
                     {upright(0, 0, 0, 1, inf), Defect::height_not_finite},
                     {upright(0, 0, 0, 1, -1), Defect::height_negative}};
  for (const Bad& bad : all) {
    EXPECT_EQ(find_defect(bad.c), bad.defect) << to_string(bad.defect);
    EXPECT_EQ(intersect(bad.c, good), Verdict::invalid);
    EXPECT_EQ(intersect(good, bad.c), Verdict::invalid);
    EXPECT_EQ(decide(good, bad.c).verdict, Verdict::invalid);
    EXPECT_EQ(distance(good, bad.c).verdict, Verdict::invalid);
  }
}

// Axes 1e-6 apart: rounding must not shift one disk across the other's axis.
TEST(Intersect, FlatDisksEdgeToEdge) {
  const Solid a{Vector3(0, 0, 0), Vector3(-0x1.2ddcedd2db0e1p-1, -0x1.8262196711fc7p-5, 0x1.9cd7dfb5b0a54p-1),
                0x1.b002a28eb95ap-1, 0};
  const Solid b{Vector3(-0x1.5b55bc4e3bf6ap+0, 0x1.a577aa5bdbbb6p-7, -0x1.fb8b52323579dp-1),
                Vector3(-0x1.2ddcfc96fb6d8p-1, -0x1.82646f4fdd55fp-5, 0x1.9cd7d2ba23646p-1),
                0x1.ac583bd286322p-1, 0};
  EXPECT_EQ(intersect(a, b), Verdict::intersecting);
}

}  // namespace
}  // namespace cyl
