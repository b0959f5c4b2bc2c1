// SPDX-License-Identifier: MIT
#include "solver/capsule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/detail/frame.hpp"
#include "solver/solver_test.hpp"

namespace cyl {
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

using Long3 = Eigen::Matrix<long double, 3, 1>;

long double long_distance_to_segment(const Long3& x, const Long3& p0, const Long3& p1) {
  const Long3 d = p1 - p0;
  const long double t = std::clamp((x - p0).dot(d) / d.squaredNorm(), 0.0L, 1.0L);
  return (x - p0 - t * d).norm();
}

// Eleven bits more than a double has, so that its own error, by the same bound, does not count.
long double long_distance(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  const Long3 p0 = a.cast<long double>(), p1 = b.cast<long double>(), q0 = c.cast<long double>(),
              q1 = d.cast<long double>();
  const Long3 n = (p1 - p0).cross(q1 - q0);
  long double least = std::min({long_distance_to_segment(p0, q0, q1), long_distance_to_segment(p1, q0, q1),
                                long_distance_to_segment(q0, p0, p1), long_distance_to_segment(q1, p0, p1)});
  const long double s = (q0 - p0).cross(q1 - q0).dot(n) / n.squaredNorm();
  if (s > 0 && s < 1) least = std::min(least, long_distance_to_segment(p0 + s * (p1 - p0), q0, q1));
  return least;
}

// At all angles and distances, across one another and beside one another, near the origin and far from it.
TEST(Segments, AreMeasuredWithinTheProvedError) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "no wider type to measure with";
  Numbers n(20261122);
  double worst = 0;
  for (int i = 0; i < 4 * 3600; ++i) {
    const double angle = std::ldexp(1.0, -(i % 60)), far = std::ldexp(1.0, -(i / 60 % 60));
    const Vector3 at = (i & 1) != 0 ? n.vector() : Vector3(0, 0, 0), d = n.vector();
    const Vector3 e = (i & 2) != 0 ? Vector3(d + angle * n.vector()) : Vector3(angle * n.vector());
    const Vector3 other = at + far * d.cross(e) / std::max(d.cross(e).norm(), 0x1p-200);
    const Vector3 p0 = at - n.unit() * d, p1 = p0 + d, q0 = other - n.unit() * e, q1 = q0 + e;
    const double lengths = ((p0 + p1) / 2).norm() + ((q0 + q1) / 2).norm() + d.norm() + e.norm();
    const long double off = segment_distance(p0, p1, q0, q1) - long_distance(p0, p1, q0, q1);
    worst = std::max(worst, static_cast<double>(std::fabs(off)) / lengths);
  }
  EXPECT_LE(worst, proxy_distance_error);
  EXPECT_GT(worst, 0x1p-55) << "nothing was put to the test";
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
      const Vector3 v = vector();
      if (const double l = length(v); l > 0.1 && l <= 1) return v / l;
    }
  }
};

double distance_from(const Capsule& c, const Vector3& x) { return segment_distance(c.from, c.to, x, x); }

// In the solid's own axis and radius, all of it and the widest part of the capsule.
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
}  // namespace cyl
