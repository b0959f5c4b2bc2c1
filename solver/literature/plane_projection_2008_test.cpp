// SPDX-License-Identifier: MIT
// Section 5 of the text of 2008: the projection of a solid to a plane, with an arbitrary unit normal N.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/literature/separation_2008.hpp"
#include "solver/solver_test.hpp"

namespace cyl::literature {
namespace {

class Draw : public Numbers {
 public:
  Draw() : Numbers(2008) {}
  Vector3 unit() { return vector().normalized(); }
  Solid solid() { return {2 * vector(), vector(), 1.1 + either_sign(), 1.1 + either_sign()}; }
};

/// The projection, P X = X - (N.X) N: between P(C +- (h/2) W) a rectangle, about these points two ellipses. W
/// along N leaves a disk, W square to N the rectangle.
struct Region {
  enum class Kind { disk, rectangle, rectangle_with_caps };

  /// V = W x U is in the plane of N and W, so P V is along P W, and |P V| = |N.W|.
  Region(const Solid& c, const Vector3& n) : r(c.radius) {
    const Vector3 w = c.axis.normalized(), across = w.cross(n), pw = n.cross(across);  // |P W| = |W x N|
    const double along = n.dot(w), size = across.norm();
    kind = !(size > 0) ? Kind::disk : along == 0 ? Kind::rectangle : Kind::rectangle_with_caps;
    middle = c.center - n.dot(c.center) * n;
    u = size > 0 ? Vector3(across / size) : n.unitOrthogonal();
    v = size > 0 ? Vector3(pw / size) : n.cross(u);
    side = c.height / 2 * size;
    cap = r * std::fabs(along);
  }

  /// The quadratic form that is 1 on either ellipse, y being the vector from its centre; for no rectangle.
  double ellipse(const Vector3& y) const {
    const double x = y.dot(u) / r, z = y.dot(v) / cap;
    return x * x + z * z;
  }
  /// The greatest X.D from the middle, D being a vector of the plane.
  double reach(const Vector3& d) const {
    return side * std::fabs(d.dot(v)) + std::hypot(r * d.dot(u), cap * d.dot(v));
  }

  Kind kind;
  Vector3 middle;  ///< P C
  Vector3 u, v;    ///< Unit axes of the ellipses: u square to W, v along P W (of a disk any two).
  double side;     ///< half a side of the rectangle, along v: (h/2) |P W|
  double r;        ///< half its other side, and half an axis of the ellipses, along u
  double cap;      ///< half their other axis: r |N.W|
};

Vector3 onto(const Vector3& x, const Vector3& n) { return x - x.dot(n) * n; }

TEST(PlaneProjection2008, HasThreeKinds) {
  const Solid upright{{1, 2, 3}, {0, 0, 1}, 2, 6};
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

// By section 3, the wall alone decides. This holds for a line, but not for a plane.
TEST(PlaneProjection2008, TheWallAloneLeavesAHole) {
  const Solid coin{{0, 0, 0}, {0, 0, 1}, 2, 0.1};
  for (const Vector3& n : {Vector3(0, 0, 1), Vector3(0, 0.6, 0.8)}) {
    double nearest = std::numeric_limits<double>::infinity();
    for (double angle = 0; angle < 2 * M_PI; angle += 0.01)
      for (double t = -0.05; t <= 0.05; t += 0.01)
        nearest = std::min(nearest, onto({2 * std::cos(angle), 2 * std::sin(angle), t}, n).norm());
    EXPECT_GT(nearest, 1.5);
    const Region region(coin, n);
    EXPECT_GT(region.cap + region.side, 1.5);
    EXPECT_LT(onto({0, 0, 0.05}, n).norm(), 0.1) << "the centre of an end disk";
  }
}

// Section 8 compares |P Delta| with r0: these would be apart, if section 7 had not settled parallel axes.
TEST(PlaneProjection2008, ADiskIsNearerThanItsCentre) {
  const Solid a{{0, 0, 0}, {0, 0, 1}, 1, 2}, b{{1.5, 0, 0}, {0, 0, 1}, 1, 2};
  const Region disk(b, {0, 0, 1});
  ASSERT_EQ(disk.kind, Region::Kind::disk);
  EXPECT_GT(disk.middle.norm(), a.radius);
  EXPECT_EQ(disk.middle.norm() - disk.r, 0.5);
  EXPECT_EQ(separation_2008(a, b, CircleWay::projection, CriticalWay::normalised, {}).verdict,
            Verdict::intersecting);
}

// The rims' projections lie on the two ellipses, and nothing is farther along any line than reach().
TEST(PlaneProjection2008, IsTheProjection) {
  Draw draw;
  for (int i = 0; i < 50; ++i) {
    const Solid c = draw.solid();
    const Vector3 n = draw.unit(), w = c.axis.normalized(), u = w.unitOrthogonal(), v = w.cross(u),
                  d = onto(draw.unit(), n);
    const Region region(c, n);
    double most = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < 1024; ++k) {
      const double angle = k * 0x1p-10 * 2 * M_PI;
      const Vector3 round = c.radius * (std::cos(angle) * u + std::sin(angle) * v);
      EXPECT_NEAR(region.ellipse(onto(round, n)), 1, 1e-9);
      for (const double sign : {0.5, -0.5}) most = std::max(most, d.dot(round + sign * c.height * w));
    }
    EXPECT_NEAR(region.reach(d), most, 2e-5);
    EXPECT_GE(region.reach(d), most - 1e-14);
  }
}

}  // namespace
}  // namespace cyl::literature
