// SPDX-License-Identifier: MIT
// Outer models hold the shapes that they stand for: the referee proves this for every point.
#include "scenes/read/bounding_solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

bool holds(const Solid& solid, const Vector3& point) {
  const Verdict verdict = judge_verdict({solid, {point, {0, 0, 1}, 0, 0, 0}}).verdict;
  return verdict == Verdict::intersecting || verdict == Verdict::touching;
}

/// Points in a box of sizes over some decades, on a sphere, on a line, in a plane, or on a lattice.
std::vector<Vector3> cloud(RandomStream& stream, std::uint64_t kind) {
  const std::array<double, 3> decades{1e-3, 1, 100};
  Vector3 size, away;
  for (int i = 0; i < 3; ++i) size[i] = stream.within_decades(decades);
  for (int i = 0; i < 3; ++i) away[i] = stream.coin() ? 0 : stream.between(-10, 10);
  const Vector3 line = stream.unit_vector();
  std::vector<Vector3> points;
  const std::size_t count = 1 + stream.below(60);
  for (std::size_t k = 0; k < count; ++k) {
    Vector3 p;
    for (int i = 0; i < 3; ++i) p[i] = size[i] * stream.between(-1, 1);
    if (kind == 1) p = size.x() * stream.unit_vector();
    if (kind == 2) p = p.x() * line;
    if (kind == 3) p -= p.dot(line) * line;
    if (kind == 4) p = p.array().round();
    points.push_back(away + p);
  }
  return points;
}

TEST(BoundingSolid, HoldsEveryPoint) {
  std::array<int, 4> kinds{};
  for (std::uint64_t i = 0; i < 200; ++i) {
    RandomStream stream("cloud", 20261124, i);
    const std::vector<Vector3> points = cloud(stream, i % 5);
    const Solid solid = moved(bound_of(points), Pose::Identity());
    ++kinds[static_cast<std::size_t>(kind_of(solid))];
    for (const Vector3& p : points) EXPECT_TRUE(holds(solid, p)) << i;
  }
  EXPECT_GT(kinds[static_cast<std::size_t>(SolidKind::sphere)], 5);
  EXPECT_GT(kinds[static_cast<std::size_t>(SolidKind::capsule)], 2);
  EXPECT_GT(kinds[static_cast<std::size_t>(SolidKind::cylinder)], 5);
}

// Boxes turned and moved far away. The long double corners, as doubles, are off by at most half a unit.
TEST(BoundingSolid, HoldsTheCornersOfBoxesWhereverTheyAre) {
  using Wide = Eigen::Matrix<long double, 3, 1>;
  for (std::uint64_t i = 0; i < 200; ++i) {
    RandomStream stream("box", 20261124, i);
    const std::array<double, 4> decades{1e-3, 0.1, 1, 10};
    Vector3 size, away;
    for (int k = 0; k < 3; ++k) size[k] = stream.within_decades(decades);
    for (int k = 0; k < 3; ++k) away[k] = stream.between(-10, 10);
    const Vector3 axis = stream.unit_vector();
    const double w = stream.between(-1, 1);
    Pose pose(Eigen::Translation3d(away) * Eigen::Quaterniond(w, axis.x(), axis.y(), axis.z()).normalized());
    const Eigen::Matrix<long double, 3, 3> turn =
        Eigen::Quaternion<long double>(w, axis.x(), axis.y(), axis.z()).normalized().toRotationMatrix();
    const Solid solid = moved(bound_of(corners_of(size)), pose);
    for (const Vector3& corner : corners_of(size)) {
      const Wide moved = turn * corner.cast<long double>() + away.cast<long double>();
      EXPECT_TRUE(holds(solid, moved.cast<double>())) << i;
    }
    EXPECT_LE(volume_of(solid), (1 + 1e-9) * std::numbers::pi / 4 *
                                    std::min({size.x() * (size.y() * size.y() + size.z() * size.z()),
                                              size.y() * (size.x() * size.x() + size.z() * size.z()),
                                              size.z() * (size.x() * size.x() + size.y() * size.y())}))
        << "no more than the cylinder about an axis of the box";
  }
}

double relative(const std::vector<Vector3>& points, double volume) {
  return volume_of(moved(bound_of(points), Pose::Identity())) / volume;
}

TEST(BoundingSolid, IsHardlyMoreThanWhatItHolds) {
  std::vector<Vector3> ball, capsule, cylinder;
  RandomStream stream("tight", 1, 1);
  const Vector3 axis = stream.unit_vector();
  for (int i = 0; i < 4000; ++i) {
    const Vector3 u = stream.unit_vector(), v = stream.unit_vector();
    const double end = stream.sign();
    ball.push_back(Vector3(1, 2, 3) + 2 * u);
    capsule.push_back(2 * end * axis + 0.5 * v);
    cylinder.push_back(Vector3(-3, 0, 1) + end * axis + 0.5 * (v - v.dot(axis) * axis).normalized());
  }
  EXPECT_NEAR(relative(ball, 4 * std::numbers::pi / 3 * 8), 1, 0.01);
  EXPECT_NEAR(relative(capsule, std::numbers::pi * (0.25 * 4 + 4.0 / 3 * 0.125)), 1, 0.02);
  EXPECT_NEAR(relative(cylinder, std::numbers::pi * 0.25 * 2), 1, 0.02);
}

/// How far a capsule stays inside a shape with this support, at least, in many directions.
template <class Support>
double least_room(const Solid& inner, const Support& support) {
  RandomStream stream("room", 1, 1);
  double least = INFINITY;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 n = stream.unit_vector();
    least = std::min(least, support(n) - n.dot(inner.center) -
                                inner.height / 2 * std::fabs(n.dot(inner.axis)) - inner.rounding);
  }
  return least;
}

TEST(InnerSolid, IsInTheShapeAndNotMuchSmaller) {
  for (std::uint64_t k = 0; k < 30; ++k) {
    RandomStream stream("inner", 1, k);
    Vector3 half(stream.between(0.1, 1), stream.between(0.1, 1), k % 3 == 0 ? 0.1 : stream.between(0.1, 1));
    if (k % 3 == 1) half.y() = half.x();
    Body body;
    bound_ellipsoid(body, half, Pose::Identity());
    EXPECT_EQ(find_defect(body.solid), Defect::none);
    const double room =
        least_room(*body.inner, [&](const Vector3& n) { return half.cwiseProduct(n).norm(); });
    EXPECT_GE(room, 0) << half.transpose();
    EXPECT_LT(room, 0.05 * half.minCoeff()) << half.transpose();
    std::vector<Vector3> points;
    for (const Vector3& corner : corners_of(2 * half)) points.push_back(corner + Vector3(5, 0, 0));
    const auto inner = capsule_in_hull(points, bound_of(points));
    ASSERT_TRUE(inner);
    const double left =
        least_room(*inner, [&](const Vector3& n) { return half.dot(n.cwiseAbs()) + 5 * n.x(); });
    EXPECT_GE(left, 0) << half.transpose();
    EXPECT_LT(left, 0.25 * half.minCoeff()) << half.transpose();
  }
  const std::vector<Vector3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(capsule_in_hull(flat, bound_of(flat)));
}

TEST(BoundingSolid, OfFewPoints) {
  const Solid point = moved(bound_of(std::vector<Vector3>{{1, 2, 3}}), Pose::Identity());
  EXPECT_LT(point.radius + point.rounding + point.height, 1e-12);
  EXPECT_TRUE(holds(point, {1, 2, 3}));
  const std::vector<Vector3> same(5, Vector3(1, 2, 3));
  EXPECT_TRUE(holds(moved(bound_of(same), Pose::Identity()), {1, 2, 3}));
  const std::vector<Vector3> tiny{{1e-170, 0, 0}, {0, 1e-160, 0}, {0, 0, -1e-300}};
  for (const Vector3& p : tiny) EXPECT_TRUE(holds(moved(bound_of(tiny), Pose::Identity()), p));
  EXPECT_THROW(bound_of({}), std::runtime_error);
  EXPECT_THROW(moved(bound_of(std::vector<Vector3>{{1e308, 0, 0}, {-1e308, 0, 0}}), Pose::Identity()),
               std::runtime_error);
}

TEST(BoundingSolid, KeepsTheBox) {
  const std::vector<Vector3> points{{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {0, 0, 6}};
  const Body body = bounded_body("b", 3, "mesh", bound_of(points), Pose(Eigen::Translation3d(10, 0, 0)));
  ASSERT_TRUE(body.box);
  EXPECT_EQ(body.link, 3u);
  EXPECT_EQ(body.box->size, Vector3(2, 4, 6));
  EXPECT_EQ(body.box->pose.translation(), Vector3(11, 2, 3));
}

}  // namespace
}  // namespace cyl
