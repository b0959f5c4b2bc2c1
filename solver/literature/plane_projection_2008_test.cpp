// SPDX-License-Identifier: MIT
#include "solver/literature/plane_projection_2008.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/detail/frame.hpp"
#include "solver/literature/separation_2008_circle.hpp"
#include "solver/solver_test.hpp"

namespace cyl::literature {
namespace {

class Draw : public Numbers {
 public:
  Draw() : Numbers(2008) {}
  Vector3 vector() {
    const double x = either_sign(), y = either_sign(), z = either_sign();
    return {x, y, z};
  }
  Vector3 unit() { return vector().normalized(); }
  Cylinder solid() { return {2 * vector(), vector(), 1.1 + either_sign(), 1.1 + either_sign()}; }
};

Vector3 onto(const Vector3& x, const Vector3& n) { return x - x.dot(n) * n; }

TEST(PlaneProjection2008, HasThreeKinds) {
  const Prepared upright = prepare({{1, 2, 3}, {0, 0, 1}, 2, 6});
  const Region disk(upright, {0, 0, 1}), rectangle(upright, {0, 1, 0}), capped(upright, {0, 0.6, 0.8});
  EXPECT_EQ(disk.kind, Region::Kind::disk);
  EXPECT_EQ(disk.middle, Vector3(1, 2, 0));
  EXPECT_EQ(disk.side, 0);
  EXPECT_EQ(disk.cap, 2);
  EXPECT_EQ(rectangle.kind, Region::Kind::rectangle);
  EXPECT_EQ(rectangle.side, 3);
  EXPECT_EQ(rectangle.cap, 0);
  EXPECT_EQ(capped.kind, Region::Kind::rectangle_with_caps);
  EXPECT_NEAR(capped.side, 3 * 0.6, 1e-15);
  EXPECT_NEAR(capped.cap, 2 * 0.8, 1e-15);
}

// Section 3 says that the wall alone decides: of a line, not of a plane.
TEST(PlaneProjection2008, TheWallAloneLeavesAHole) {
  const Cylinder coin{{0, 0, 0}, {0, 0, 1}, 2, 0.1};
  for (const Vector3& n : {Vector3(0, 0, 1), Vector3(0, 0.6, 0.8)}) {
    double nearest = std::numeric_limits<double>::infinity();
    for (double angle = 0; angle < 2 * M_PI; angle += 0.01)
      for (double t = -0.05; t <= 0.05; t += 0.01)
        nearest = std::min(nearest, onto({2 * std::cos(angle), 2 * std::sin(angle), t}, n).norm());
    EXPECT_GT(nearest, 1.5);
    const Region region(prepare(coin), n);
    EXPECT_GT(region.cap + region.side, 1.5);
    EXPECT_LT(onto({0, 0, 0.05}, n).norm(), 0.1) << "the centre of an end disk";
  }
}

// Section 8 compares |P Delta| with r0: these would be apart, if section 7 had not settled parallel axes.
TEST(PlaneProjection2008, ADiskIsNearerThanItsCentre) {
  const Cylinder a{{0, 0, 0}, {0, 0, 1}, 1, 2}, b{{1.5, 0, 0}, {0, 0, 1}, 1, 2};
  const Region disk(prepare(b), {0, 0, 1});
  ASSERT_EQ(disk.kind, Region::Kind::disk);
  EXPECT_GT(disk.middle.norm(), a.radius);
  EXPECT_EQ(disk.middle.norm() - disk.r, 0.5);
  EXPECT_EQ(separation_2008(a, b, CircleWay::projection, CriticalWay::normalised, {}).verdict,
            Verdict::intersecting);
}

// The rims' projections lie on the two ellipses, four points of the surface on the corners, and nothing is
// farther along any line than farthest().
TEST(PlaneProjection2008, IsTheProjection) {
  Draw draw;
  for (int i = 0; i < 50; ++i) {
    const Cylinder c = draw.solid();
    const Vector3 n = draw.unit(), w = c.axis.normalized(), u = w.unitOrthogonal(), v = w.cross(u),
                  d = onto(draw.unit(), n);
    const Region region(prepare(c), n);
    double most = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < 1024; ++k) {
      const double angle = k * 0x1p-10 * 2 * M_PI;
      const Vector3 round = c.radius * (std::cos(angle) * u + std::sin(angle) * v);
      EXPECT_NEAR(region.ellipse(onto(round, n)), 1, 1e-9);
      for (const double sign : {0.5, -0.5}) most = std::max(most, d.dot(round + sign * c.height * w));
    }
    EXPECT_NEAR(region.farthest(d).dot(d), most, 2e-5);
    EXPECT_GE(region.farthest(d).dot(d), most - 1e-14);
    for (const Vector3& corner : region.corners()) {
      const Vector3 out = corner - region.middle;
      EXPECT_NEAR(std::fabs(out.dot(region.u)), c.radius, 1e-14);
      EXPECT_NEAR(std::fabs(out.dot(region.v)), c.height / 2 * onto(w, n).norm(), 1e-14);
      EXPECT_NEAR(out.dot(n), 0, 1e-14);
    }
  }
}

// A plane that holds a separating direction separates; one that separates holds such a direction; and the
// plane square to an axis says what section 8 says of that axis' circle.
TEST(PlaneProjection2008, SeparatesAsItsDirectionsDo) {
  Draw draw;
  const Options options{.faults = {}, .step_cap = 60, .tolerance = 0};
  int apart = 0, circles = 0;
  for (int i = 0; i < 2000; ++i) {
    const Prepared a = prepare(draw.solid()), b = prepare(draw.solid());
    const Couple<double> p = scale(a, b).couple();
    const Solids solids(p, Axes(a.unit_axis, b.unit_axis));
    const auto separation = [&](const Vector3& n) {
      return separation_in_plane(Region(a, n), Region(b, n), n, options);
    };
    const Vector3 found = separation(draw.unit());
    EXPECT_TRUE(found == Vector3::Zero() || solids.gap(found) < 1e-14);
    const auto decided = decide(a, b);
    if (decided.verdict == Verdict::disjoint) {
      ++apart;
      const Vector3 n = decided.direction.cross(draw.unit()).normalized();
      EXPECT_NE(separation(n), Vector3(0, 0, 0));
    }
    Finder finder(solids);
    const bool on_circle = separated_on_circle(solids, 0, CircleWay::projection, {{}, 60, 1e-3}, finder);
    circles += on_circle;
    EXPECT_EQ(separation(a.unit_axis) != Vector3::Zero(), on_circle) << i;
  }
  EXPECT_GT(apart, 200);
  EXPECT_GT(circles, 100);
}

}  // namespace
}  // namespace cyl::literature
