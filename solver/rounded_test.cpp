// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "solver/distance.hpp"
#include "solver/solver_test.hpp"

namespace cyl {
namespace {

Solid ball(Vector3 center, double rounding) { return {center, {0, 0, 1}, 0, 0, rounding}; }
Solid capsule(Vector3 center, Vector3 axis, double length, double rounding) {
  return {center, axis, 0, length, rounding};
}

TEST(Rounded, BallsMeetWhereTheirRadiiReach) {
  EXPECT_EQ(intersect(ball({0, 0, 0}, 1), ball({3, 0, 0}, 2)), Verdict::intersecting);
  EXPECT_EQ(intersect(ball({0, 0, 0}, 1), ball({3, 0, 0}, 1.999)), Verdict::disjoint);
  EXPECT_EQ(distance(ball({0, 0, 0}, 1), ball({3, 4, 0}, 1)).value, 3);
  EXPECT_EQ(distance(ball({0, 0, 0}, 1), ball({0, 0, 0}, 2)).value, -3);
}

TEST(Rounded, CapsulesMeetAtSidesAndEnds) {
  const Solid lying = capsule({0, 0, 0}, {1, 0, 0}, 4, 0.5);
  EXPECT_EQ(intersect(lying, capsule({0, 0, 0.99}, {0, 1, 0}, 4, 0.5)), Verdict::intersecting);
  EXPECT_EQ(intersect(lying, capsule({0, 0, 1.01}, {0, 1, 0}, 4, 0.5)), Verdict::disjoint);
  EXPECT_EQ(intersect(lying, capsule({0, 3.99, 0}, {1, 1, 0}, 2, 3.2)), Verdict::intersecting);
  EXPECT_NEAR(distance(lying, capsule({6, 0, 0}, {1, 0, 0}, 2, 0.25)).value, 2.25, 1e-15);
  EXPECT_NEAR(distance(lying, capsule({0, 2, 0}, {1, 0, 0}, 9, 0.5)).value, 1, 1e-15);
}

Solid segment(const Vector3& from, const Vector3& to) {
  const Vector3 along = to - from;
  return {(from + to) / 2, along.isZero(0) ? Vector3(0, 0, 1) : along, 0, along.norm()};
}

using Long3 = Eigen::Matrix<long double, 3, 1>;

long double long_distance_to_segment(const Long3& x, const Long3& p0, const Long3& p1) {
  const Long3 d = p1 - p0;
  const long double square = d.squaredNorm();
  const long double t = square > 0 ? std::clamp((x - p0).dot(d) / square, 0.0L, 1.0L) : 0;
  return (x - p0 - t * d).norm();
}

// Eleven bits more than a double has, so that its own error does not count.
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
TEST(Rounded, SegmentsAreMeasuredWithinTheReturnedError) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "no wider type to measure with";
  Numbers n(20261122);
  for (int i = 0; i < 4 * 3600; ++i) {
    const double angle = std::ldexp(1.0, -(i % 60)), far = std::ldexp(1.0, -(i / 60 % 60));
    const Vector3 at = (i & 1) != 0 ? n.vector() : Vector3(0, 0, 0), d = n.vector();
    const Vector3 e = (i & 2) != 0 ? Vector3(d + angle * n.vector()) : Vector3(angle * n.vector());
    const Vector3 other = at + far * d.cross(e) / std::max(d.cross(e).norm(), 0x1p-200);
    const Vector3 p0 = at - n.unit() * d, p1 = p0 + d, q0 = other - n.unit() * e, q1 = q0 + e;
    const Distance said = distance(segment(p0, p1), segment(q0, q1));
    // Middles, lengths and axes are rounded.
    const double rounded = 0x1p-50 * (p0.norm() + p1.norm() + q0.norm() + q1.norm());
    ASSERT_NEAR(said.value, static_cast<double>(long_distance(p0, p1, q0, q1)), said.error + rounded) << i;
    ASSERT_LE(said.error, 1e-13 * (d.norm() + e.norm() + (q0 - p0).norm())) << i;
  }
}

// The distance from a rim is not the distance from a wall or a cap.
TEST(Rounded, EdgesOfRoundedCylindersAreRound) {
  const Solid standing{{0, 0, 0}, {0, 0, 1}, 1, 2, 0.5};
  const double diagonal = 1 + 0.5 * std::numbers::sqrt2 / 2 + 0.5 * std::numbers::sqrt2 / 2;
  EXPECT_EQ(intersect(standing, ball({diagonal - 1e-9, 0, diagonal - 1e-9}, 0.5)), Verdict::intersecting);
  EXPECT_EQ(intersect(standing, ball({diagonal + 1e-9, 0, diagonal + 1e-9}, 0.5)), Verdict::disjoint);
}

TEST(Rounded, AClearanceCountsAsARounding) {
  const Prepared a = prepare({{0, 0, 0}, {0, 0, 1}, 1, 2}), b = prepare({{2.02, 0, 0}, {0, 0, 1}, 1, 2});
  EXPECT_EQ(within(a, b, 0.019), Verdict::disjoint);
  EXPECT_EQ(within(a, b, 0.021), Verdict::intersecting);
  EXPECT_EQ(within(a, b, 0), intersect(a, b));
  const Answer near = decide_within(a, b, 0.021);
  ASSERT_EQ(near.proof, Proof::points);
  EXPECT_LE((b.center + near.point_tail - a.center - near.point_head).norm(), 0.021);
  EXPECT_EQ(decide_within(a, b, 0.019).proof, Proof::direction);
  // The square of a clearance of points may vanish.
  const Prepared point = prepare(Solid{}), far = prepare({{0x1p30, 0, 0}});
  EXPECT_EQ(decide_within(point, point, 0x1p-1000).verdict, Verdict::intersecting);
  EXPECT_TRUE(decide_within(point, far, 0x1p-1000).direction.allFinite());
}

TEST(Rounded, WhatIsNoRoundingIsInvalid) {
  constexpr double infinity = std::numeric_limits<double>::infinity(),
                   nan = std::numeric_limits<double>::quiet_NaN(), most = std::numeric_limits<double>::max();
  const Solid unit{{0, 0, 0}, {0, 0, 1}, 1, 2};
  const auto defect = [&](double rounding, double radius = 1) {
    return find_defect({{0, 0, 0}, {0, 0, 1}, radius, 2, rounding});
  };
  EXPECT_EQ(defect(-1), Defect::rounding_negative);
  EXPECT_EQ(defect(nan), Defect::rounding_not_finite);
  EXPECT_EQ(defect(infinity), Defect::rounding_not_finite);
  EXPECT_EQ(defect(most, most), Defect::rounding_overflows);
  EXPECT_EQ(defect(0, most), Defect::none);
  EXPECT_EQ(intersect(unit, {{0, 0, 0}, {0, 0, 1}, 1, 2, -1}), Verdict::invalid);
  const Prepared a = prepare(unit), wide = prepare({{0, 0, 0}, {0, 0, 1}, 0, 0, most});
  for (const double clearance : {-1.0, nan, infinity}) {
    EXPECT_EQ(within(a, a, clearance), Verdict::invalid) << clearance;
    EXPECT_EQ(decide_within(a, a, clearance).verdict, Verdict::invalid) << clearance;
  }
  EXPECT_EQ(within(wide, a, most), Verdict::invalid);
}

// The points are as far apart as the value, along the direction. Here many directions are as good within
// rounding, and the roundings are large.
TEST(Rounded, PointsOfTheDistanceFitItsValue) {
  const Pair pairs[] = {
      {{{0, 0, 0}, {0, 0, 1}, 0, 0, 99999999}, {{100000000, 1, 1}, {0, 1, 0}, 0, 0}},
      {{{0, 0, 0}, {0, 0, 1}, 0, 0, 100000001}, {{100000000, 1, 1}, {0, 1, 0}, 0, 0}},
      {{{0, 0, 0}, {3, 3, 2}, 4.2547939131117767, 0.25368488664576033, 0.0011371981062272736},
       {{2.9994966326204211, -0.78372490445227405, -3.6211294900788218},
        {0.31715316075193256, -0.84041974415710419, 0.43944115221035729},
        0.24677324390349123,
        0,
        0.2625547725034687}},
      {{{0, 0, 0}, {0, 0, 3}, 0.1603916955447609, 0, 14.331529423782474},
       {{-0.046790150053641739, -0.24147571546249474, 14.46730076100215},
        {-2, -2, 0},
        0.13577133721964341,
        0.24305716445424441}}};
  for (const Pair& p : pairs) {
    const Distance d = distance(p.a, p.b);
    const Vector3 way = p.b.center - p.a.center + d.on_b - d.on_a;
    EXPECT_LE((way - d.value * d.direction).norm(), d.error) << format_pair(p);
    EXPECT_LE(d.error, 1e-13 * size_of(p)) << format_pair(p);
  }
}

// A gap within rounding that decide() proves.
TEST(Rounded, IntersectingIsNotSaidOfWhatIsProvedApart) {
  const Solid needle{
      {0, 0, 0}, {0.63829364458279914, 0.43000605652707169, 0.63849511715849805}, 0, 8.6828981611252587},
      pill{{-2.7731874026589098, -1.8647780275510879, -2.7726289548422853},
           {0.6382936445827998, 0.43000605652708579, 0.63849511715848795},
           0,
           1.7966469509409612e-08,
           0.0029950787388571911};
  ASSERT_EQ(decide(needle, pill).verdict, Verdict::disjoint);
  for (const Distance& d : {distance(needle, pill), distance(pill, needle)}) {
    EXPECT_EQ(d.verdict, Verdict::disjoint);
    EXPECT_NEAR(d.value, 4.8569554296335306e-14, d.error);
    EXPECT_FALSE(d.least);
  }
}

// Lengths beside which the cores vanish, or which overflow in sum.
TEST(Rounded, NoRoundingIsTooLarge) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  const Solid dust{{0, 0, 0}, {1, 0, 0}, 0, tiny, 1}, needle{{0, 0, 0}, {1, 0, 0}, 1e-100, 1e-100, 0};
  const Pair overlapping[] = {{dust, dust},
                              {ball({0, 0, 0}, 1), ball({1e-320, 0, 0}, 1)},
                              {ball({0, 0, 0}, 1e300), needle},
                              {ball({0, 0, 0}, 1.7e308), ball({1, 0, 0}, 1.7e308)},
                              {ball({-1.6e308, 0, 0}, 1.7e308), ball({1.6e308, 0, 0}, 1.7e308)}};
  for (const Pair& p : overlapping) {
    EXPECT_EQ(decide(p.a, p.b).verdict, Verdict::intersecting) << format_pair(p);
    EXPECT_EQ(intersect(p.a, p.b), Verdict::intersecting) << format_pair(p);
    const Distance d = distance(p.a, p.b);
    EXPECT_EQ(d.verdict, Verdict::intersecting) << format_pair(p);
    EXPECT_TRUE(std::isfinite(d.value) && std::isfinite(d.error)) << format_pair(p);
  }
  // The sum of the roundings and the distance of the cores overflow, both.
  const Solid far{{-1.7e308, 1.7e308, 1.7e308}, {0, 0, 1}, 0, 0, 1.2e308},
      beyond{{1.7e308, -1.7e308, -1.7e308}, {0, 0, 1}, 0, 0, 1.2e308};
  EXPECT_EQ(decide(far, beyond).verdict, Verdict::disjoint);
  EXPECT_EQ(intersect(far, beyond), Verdict::disjoint);
  const Prepared a = prepare({{0, 0, 0}, {0, 0, 1}, 1e-80, 1e-80}),
                 b = prepare({{1, 0, 0}, {0, 1, 0}, 1e-80, 1e-80});
  EXPECT_EQ(decide_within(a, b, 1e230).verdict, Verdict::intersecting);
  // Without a rounding, with a clearance beside a distance of cores beyond the largest double.
  const Prepared left = prepare({{-1.7e308, 0, 0}, {0, 0, 1}, 0, 0}),
                 right = prepare({{1.7e308, 0, 0}, {0, 0, 1}, 0, 0});
  constexpr double most = std::numeric_limits<double>::max();
  EXPECT_EQ(within(left, right, most), Verdict::disjoint);
  EXPECT_EQ(decide_within(left, right, most).verdict, Verdict::disjoint);
}

// The cores' gap is beyond the largest double, the solids' own is not.
TEST(Rounded, TheDistanceMayBeADoubleWhereThatOfTheCoresIsNone) {
  for (const auto& [first, second] :
       {std::pair{1e308, 1e308}, std::pair{1.7e308, 0.0}, std::pair{1e308, 1.7e308}}) {
    const Solid a = ball({0, 0, 0}, first), b = ball({1.7e308, 1.7e308, 0}, second);
    const double truth = static_cast<double>(std::sqrt(2.0L) * 1.7e308L - first - second);
    const Distance d = distance(a, b);
    EXPECT_EQ(d.verdict, truth > 0 ? Verdict::disjoint : Verdict::intersecting) << first;
    EXPECT_NEAR(d.value, truth, d.error) << first;
    EXPECT_LT(d.error, 1e294) << first;
    EXPECT_NEAR(d.on_a.x() / first, std::sqrt(0.5), 1e-12) << first;
  }
}

// The points of this certificate lose bits on their way back into the scene's unit.
TEST(Rounded, SubnormalSolidsThatOverlapAreProvedTo) {
  const Solid grain{{0, 0, 0}, {1, 2, 3}, 1e-319, 1e-319},
      ground{{4e-315, 0, 5e-315}, {0, 1, 1}, 4e-315, 5e-315, 2.7e-315};
  EXPECT_EQ(decide(grain, ground).verdict, Verdict::intersecting);
}

class RoundedFamilies : public testing::TestWithParam<std::size_t> {
 protected:
  static constexpr std::uint64_t count = 3000, seed = 20261123;
  const Family& family() const { return rounded_families()[GetParam()]; }
  Pair pair(std::uint64_t i) const { return family().generate(seed, i); }
};

TEST_P(RoundedFamilies, AllWaysSayTheSameAwayFromTouching) {
  std::size_t stated = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Pair p = pair(i);
    const Distance d = distance(p.a, p.b);
    const Answer proved = decide(p.a, p.b);
    if (!(std::fabs(d.value) > 1e-13 * size_of(p) + d.error)) continue;
    ++stated;
    ASSERT_EQ(intersect(p.a, p.b), d.verdict) << format_pair(p);
    ASSERT_EQ(proved.verdict, d.verdict) << format_pair(p);
  }
  EXPECT_GT(stated, count * 8 / 10);
}

TEST_P(RoundedFamilies, TheVerdictDoesNotDependOnTheScale) {
  for (std::uint64_t i = 0; i < count; ++i) {
    const Pair p = pair(i);
    const double clearance = p.a.rounding / 4;
    for (const int k : {-500, -300, 300, 500}) {
      const Pair there = scaled(p, k);
      if (format_pair(scaled(there, -k)) != format_pair(p)) continue;  // a length over- or underflows
      ASSERT_EQ(intersect(p.a, p.b), intersect(there.a, there.b)) << k << ' ' << format_pair(p);
      ASSERT_EQ(within(prepare(p.a), prepare(p.b), clearance),
                within(prepare(there.a), prepare(there.b), std::ldexp(clearance, k)))
          << k << ' ' << format_pair(p);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RoundedFamilies, testing::Range<std::size_t>(0, rounded_families().size()),
                         [](const auto& info) { return std::string(rounded_families()[info.param].name); });

}  // namespace
}  // namespace cyl
