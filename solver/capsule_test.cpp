// SPDX-License-Identifier: MIT
#include "solver/capsule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "solver/detail/frame.hpp"
#include "solver/solver_test.hpp"

namespace cyl::seeds {
namespace {

TEST(Segments, ExactCases) {
  const Vector3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(segment_distance(-x, x, z - y, z + y), 1);                       // crossing at a height
  EXPECT_EQ(segment_distance(-x, x, -y, y), 0);                              // crossing
  EXPECT_EQ(segment_distance(o, x, 2 * x, 3 * x), 1);                        // in one line
  EXPECT_EQ(segment_distance(o, 2 * x, x, 3 * x), 0);                        // in one line, overlapping
  EXPECT_EQ(segment_distance(o, x, y, x + y), 1);                            // parallel
  EXPECT_EQ(segment_distance(o, x, y + 4 * x, y + 5 * x), std::sqrt(10.0));  // parallel, apart
  EXPECT_EQ(segment_distance(o, x, 3 * x + y, 3 * x - y), 2);                // an end and an inside
  EXPECT_EQ(segment_distance(o, x, 4 * x + 4 * y, 5 * x + 9 * y), 5);        // two ends
  EXPECT_EQ(segment_distance(o, o, 3 * x + 4 * y, 3 * x + 4 * y), 5);        // two points
  EXPECT_EQ(segment_distance(o, o, 2 * y - x, 2 * y + x), 2);                // a point and a segment
  EXPECT_EQ(segment_distance(2 * y - x, 2 * y + x, o, o), 2);
}

TEST(Segments, NearlyParallelOnesCross) {
  for (double angle : {1e-4, 1e-8, 1e-12, 1e-15}) {
    const Vector3 p(1, 2, 3), d(1, 1, 1), e(1 + angle, 1 - angle, 1);
    EXPECT_NEAR(segment_distance(p - d, p + 2 * d, p - 2 * e, p + e), 0, 4e-15) << angle;
    const double apart = segment_distance(p - d, p + 2 * d, p - 2 * e + Vector3(1, 1, -2) * 1e-3,
                                          p + e + Vector3(1, 1, -2) * 1e-3);
    EXPECT_NEAR(apart, 1e-3 * std::sqrt(6.0), 1e-14) << angle;
  }
}

TEST(Capsules, SignedDistance) {
  const Capsule a{{0, 0, 0}, {0, 0, 2}, 1};
  EXPECT_EQ(capsule_distance(a, {{3, 0, 1}, {5, 0, 1}, 1}), 1);
  EXPECT_EQ(capsule_distance(a, {{3, 0, 1}, {5, 0, 1}, 2}), 0);
  EXPECT_EQ(capsule_distance(a, {{3, 0, 1}, {5, 0, 1}, 2.5}), -0.5);
  EXPECT_EQ(capsule_distance(a, {{0, 0, 6}, {0, 0, 6}, 1}), 2);
}

class Draw : public Numbers {
 public:
  Draw() : Numbers(1717) {}
  double next() { return either_sign(); }
  Vector3 unit() {
    for (;;) {
      const double x = next(), y = next(), z = next();
      const Vector3 v(x, y, z);
      if (const double l = length(v); l > 0.1 && l <= 1) return v / l;
    }
  }
};

double distance_from(const Capsule& c, const Vector3& x) { return segment_distance(c.from, c.to, x, x); }

// In the solid's own axis and radius: all of it, and where the capsule is widest.
TEST(Proxies, ContainAndAreContained) {
  Draw n;
  int some = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3 at = 10 * n.unit(), axis = n.unit();
    const Cylinder c{at, 3 * axis, std::max(0.0, n.next()), std::max(0.0, 2 * n.next())};
    const Vector3 w = prepare(c).unit_axis;
    const Capsule outer = outer_proxy(c), inner = inner_proxy(c);
    for (int k = 0; k < 50; ++k) {
      const Vector3 across = w.cross(n.unit());
      const double side = length(across);
      if (side < 0.1) continue;
      const Vector3 rim =
          c.center + c.radius / side * across + (k % 2 == 0 ? 0.5 : 0.5 * n.next()) * c.height * w;
      EXPECT_LE(distance_from(outer, rim), outer.radius);
      if (inner.radius < 0) continue;
      ++some;
      const double t = 0.5 + 0.5 * n.next();
      const Vector3 x = (1 - t) * inner.from + t * inner.to + inner.radius * n.unit(), y = x - c.center;
      EXPECT_LE(length(y.cross(w)), c.radius);
      EXPECT_LE(std::fabs(dot(y, w)), c.height / 2);
    }
  }
  EXPECT_GT(some, 10000);
}

TEST(Proxies, NothingIsInsideASegmentOrADisk) {
  EXPECT_LT(inner_proxy(Cylinder{{1, 2, 3}, {1, 1, 1}, 0, 2}).radius, 0);
  EXPECT_LT(inner_proxy(Cylinder{{1, 2, 3}, {1, 1, 1}, 2, 0}).radius, 0);
}

}  // namespace
}  // namespace cyl::seeds
