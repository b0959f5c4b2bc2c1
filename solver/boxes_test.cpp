// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "corpus/pairs/support.hpp"
#include "solver/distance.hpp"
#include "solver/solver_test.hpp"

namespace cyl {
namespace {

using Long = long double;
using Long3 = Vec3<Long>;

Solid box(Vector3 center, double x, double y, double z, std::array<double, 4> q = {1, 0, 0, 0}) {
  Solid c;
  c.center = center;
  c.axis = {0, 0, 1};
  c.shape = Shape::box;
  c.edges = {x, y, z};
  c.quaternion = q;
  return c;
}
Solid half_space(Vector3 point, Vector3 normal) {
  Solid c;
  c.center = point;
  c.axis = normal;
  c.shape = Shape::half_space;
  return c;
}
Solid rounded(Solid c, double rounding) {
  c.rounding = rounding;
  return c;
}

// The verdict at a place just within and just beyond touching, and the distance there.
void expect_touching_near(const Solid& a, Solid b, Vector3 way, const char* what) {
  way.normalize();
  for (const double gap : {3e-12, 1e-9, 0.01}) {
    Solid near = b, far = b;
    near.center -= gap * way;
    far.center += gap * way;
    EXPECT_EQ(intersect(a, near), Verdict::intersecting) << what << gap;
    EXPECT_EQ(intersect(a, far), Verdict::disjoint) << what << gap;
    EXPECT_EQ(decide(a, near).verdict, Verdict::intersecting) << what << gap;
    EXPECT_EQ(decide(a, far).verdict, Verdict::disjoint) << what << gap;
    EXPECT_NEAR(distance(a, far).value, gap, 1e-13) << what;
    EXPECT_NEAR(distance(a, near).value, -gap, 1e-13) << what;
  }
}

TEST(Boxes, ClosedForms) {
  const double root2 = std::sqrt(2.0);
  const Solid cube = box({0, 0, 0}, 2, 2, 2);
  const std::array<double, 4> eighth_z{std::cos(M_PI / 8), 0, 0, std::sin(M_PI / 8)};
  const std::array<double, 4> eighth_x{std::cos(M_PI / 8), std::sin(M_PI / 8), 0, 0};
  expect_touching_near(cube, box({2, 0.3, 0.1}, 2, 2, 2), {1, 0, 0}, "facets");
  expect_touching_near(cube, box({1 + root2, 0.3, 0.1}, 2, 2, 2, eighth_z), {1, 0, 0}, "facet and edge");
  expect_touching_near(cube, rounded(upright(2, 0, 0, 0, 1), 1), {1, 0, 0}, "capsule");
  expect_touching_near(cube, rounded(upright(1.6, 1.8, 0, 0, 1), 1), {0.6, 0.8, 0}, "capsule and edge");
  expect_touching_near(cube, rounded(upright(1 + 2. / 3, 1 + 2. / 3, 1 + 1. / 3, 0, 0), 1), {2, 2, 1},
                       "sphere");
  expect_touching_near(cube, upright(1.6, 1.8, 0, 1, 1), {0.6, 0.8, 0}, "wall and edge");
  expect_touching_near(cube, upright(0.3, 0, 1.5, 1, 1), {0, 0, 1}, "cap and facet");
  expect_touching_near(rounded(cube, 0.5), rounded(upright(0.3, 0, 2.25, 1, 1), 0.25), {0, 0, 1}, "rounded");
  expect_touching_near(rounded(cube, 0.5), rounded(box({2.75 + root2 - 1, 0, 0}, 2, 2, 2, eighth_z), 0.25),
                       {1, 0, 0}, "rounded boxes");
  expect_touching_near(half_space({0, 0, 5}, {0, 0, -3}), box({7, 8, 5 - root2}, 2, 2, 2, eighth_x),
                       {0, 0, -1}, "plane and box");
  expect_touching_near(half_space({1, 2, 0}, {0, 0, 2}), rounded(upright(7, 8, 1.5, 1, 2), 0.5), {0, 0, 1},
                       "plane and cylinder");
}

TEST(Boxes, TinyGapsAreExact) {
  for (const double gap : {1e-11, 1e-10, 1e-7}) {
    const double out = gap / std::sqrt(2.0), x = (3 + out) * std::cos(0.9), y = (3 + out) * std::sin(0.9);
    const Solid cube = box({x + 0.5, y + 0.5, 0.6 + out}, 1, 1, 1);
    EXPECT_NEAR(distance(upright(0, 0, 0, 3, 0.2), cube).value, gap, 1e-14) << "vertex and rim";
    const Solid flat = box({-1, -0.5, 1}, 4, 3, 0, {0, gap, 2, -2}), other = box({1, 0.5, -2}, 1, 2, 3);
    EXPECT_NEAR(distance(flat, other).value, 1.5 * out, 1e-14) << "nearly square to edges of both";
  }
}

// The way between the nearest points does not show the gap.
TEST(Boxes, CapsNearlyOnFacets) {
  const Pair pairs[] = {
      {{{0, 0, 0}, {1, 0, 0}, 6, 2}, box({4, 8, -1}, 6, 4, 4, {1, 1, 0, 5e-9})},
      {{{0, 0, 0}, {0, 1, 0}, 1, 2}, rounded(box({1, 3, 1.5}, 2, 2, 1, {1.000000000001, 0, 0, 1}), 1)}};
  for (const Pair& p : pairs) {
    EXPECT_EQ(decide(p.a, p.b).verdict, Verdict::disjoint);
    const Distance d = distance(p.a, p.b);
    EXPECT_GT(d.value, 0.9e-12);
    EXPECT_LT(d.error, 3e-12);
  }
}

TEST(Boxes, WhatIsNoPair) {
  const Solid plane = half_space({0, 0, 0}, {0, 0, 1}), cube = box({0, 0, 3}, 1, 1, 1);
  EXPECT_EQ(intersect(plane, plane), Verdict::invalid);
  EXPECT_EQ(decide(plane, plane).verdict, Verdict::invalid);
  EXPECT_EQ(distance(plane, plane).verdict, Verdict::invalid);
  EXPECT_EQ(within(prepare(plane), prepare(plane), 1), Verdict::invalid);
  EXPECT_EQ(within(prepare(cube), prepare(plane), -1), Verdict::invalid);
  EXPECT_EQ(intersect(cube, box({0, 0, 0}, -1, 1, 1)), Verdict::invalid);
  EXPECT_EQ(intersect(cube, box({0, 0, 0}, 1, 1, 1, {0, 0, 0, 0})), Verdict::invalid);
}

TEST(Boxes, WithinIsTheRoundingGrown) {
  const Prepared cube = prepare(box({0, 0, 0}, 2, 2, 2)), plane = prepare(half_space({0, 0, -3}, {0, 0, 1}));
  const Prepared other = prepare(box({4, 0, 0}, 2, 2, 2)), cylinder = prepare(upright(0, 0, 4, 1, 2));
  for (const Prepared* const c : {&plane, &other, &cylinder}) {
    EXPECT_EQ(within(cube, *c, 1.999), Verdict::disjoint);
    EXPECT_EQ(within(cube, *c, 2.001), Verdict::intersecting);
    EXPECT_EQ(decide_within(cube, *c, 1.999).verdict, Verdict::disjoint);
    EXPECT_EQ(decide_within(*c, cube, 2.001).verdict, Verdict::intersecting);
  }
}

Solid random_solid(SolidKind kind, Numbers& n) {
  Solid c;
  const bool small = n.unit() < 0.3;
  const auto size = [&] { return small ? std::pow(10, -4 * n.unit()) : n.between(0.1, 1); };
  c.axis = n.vector();
  if (kind == SolidKind::half_space) return half_space({0, 0, 0}, c.axis);
  if (kind >= SolidKind::box) {
    c = box({0, 0, 0}, size(), size(), size(),
            {n.either_sign(), n.either_sign(), n.either_sign(), n.either_sign()});
  } else {
    c.radius = kind == SolidKind::cylinder || kind == SolidKind::rounded ? size() : 0;
    c.height = kind == SolidKind::sphere ? 0 : size();
  }
  if (kind != SolidKind::cylinder && kind != SolidKind::box) c.rounding = size();
  if (n.unit() < 0.3) {  // nearly parallel to the coordinate axes
    const double tilt = std::pow(10, -16 * n.unit());
    c.axis = Vector3(0, 0, 1) + tilt * n.vector();
    c.quaternion = {1, tilt * n.either_sign(), tilt * n.either_sign(), tilt * n.either_sign()};
  }
  return c;
}

Long3 random_unit(Numbers& n) {
  for (;;)
    if (const Vector3 x = n.vector(); x.norm() > 0.1) return lifted<Long>(x) / norm(lifted<Long>(x));
}

// A point around which a ball of radius `least` lies in the solid, from its centre.
std::optional<Long3> inner_point(const Terms<Long>& s, Long least, Numbers& n) {
  const Long spare = std::max(0.0L, s.rounding - least), taken = std::max(0.0L, least - s.rounding);
  const auto place = [&](Long half) {
    return (n.unit() < 0.5 ? n.either_sign() : n.either_sign() < 0 ? -1 : 1) * half;
  };
  Long3 x = spare * random_unit(n);
  if (s.box) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (s.halves[i] < taken) return {};
      x = x + place(s.halves[i] - taken) * s.edges[i];
    }
    return x;
  }
  if (s.half < taken || s.radius < taken) return {};
  const Long3 across = cross(s.axis, random_unit(n));
  return x + place(s.half - taken) * s.axis + (place(s.radius - taken) / norm(across)) * across;
}

// Truth by construction. Solids are put apart along a direction between their farthest points, or about a
// point deep in both.
std::optional<Pair> place(Solid a, Solid b, bool apart, double margin, Numbers& n) {
  const Terms<Long> s = terms_of<Long>(a), t = terms_of<Long>(b);
  const bool plane = is_half_space(a);
  const Long least = margin * size_of({a, b});
  Long3 center;
  if (apart) {
    const auto own = [&](const Terms<Long>& of) {
      return of.box ? of.edges[static_cast<std::size_t>(3 * n.unit())] : of.axis;
    };
    const double kind = n.unit();
    Long3 d = plane || kind < 0.25 ? own(s)
              : kind < 0.4         ? own(t)
              : kind < 0.7         ? cross(own(s), own(t))
                                   : random_unit(n);
    if (!(norm(d) > 1e-17L)) return {};
    d = (1 / norm(d)) * d;
    const Long3 on_a = plane ? Long3{} : farthest(s, d) + s.rounding * d;
    center = on_a + least * d - (farthest(t, -1.0L * d) - t.rounding * d);
  } else {
    const auto in_a = plane ? Long3(-least * s.axis) : inner_point(s, least, n),
               in_b = inner_point(t, least, n);
    if (!in_a || !in_b) return {};
    center = *in_a - *in_b;
  }
  b.center = {static_cast<double>(center.x), static_cast<double>(center.y), static_cast<double>(center.z)};
  return n.unit() < 0.5 ? Pair{a, b} : Pair{b, a};
}

// Checked in long double: whether the certificate shows the verdict, up to its rounding.
void expect_shown(const Pair& p, const Answer& answer) {
  const Terms<Long> s = terms_of<Long>(p.a), t = terms_of<Long>(p.b);
  const Long size = size_of(p), rounding = 1e-17L * (size + norm(lifted<Long>(p.b.center - p.a.center)));
  const Long3 delta = lifted<Long>(p.b.center) - lifted<Long>(p.a.center);
  const bool plane = has_half_space(p);
  if (answer.proof == Proof::direction && !plane) {
    const Long3 d = lifted<Long>(answer.direction);
    EXPECT_LT(support_gap(s, t, delta, d) / norm(d), rounding);
    EXPECT_GT(dot(d, delta), 0);
  }
  if (answer.proof == Proof::direction && plane) {
    const Solid& of = is_half_space(p.a) ? p.a : p.b;
    const auto to_size_1 = [](const Vector3& v) { return Vector3(v / v.cwiseAbs().maxCoeff()); };
    EXPECT_EQ(to_size_1(answer.direction), to_size_1(is_half_space(p.a) ? of.axis : Vector3(-of.axis)));
  }
  if (answer.proof == Proof::points) {
    const Long3 x = lifted<Long>(answer.point_head), y = lifted<Long>(answer.point_tail);
    EXPECT_LE(norm(delta + y - x), static_cast<Long>(p.a.rounding) + p.b.rounding + rounding);
    if (plane) return;
    if (answer.hull_a == Hull::space) {
      EXPECT_LE(std::max(beyond(s, x).caps, beyond(s, x).wall), rounding);
    }
    if (answer.hull_b == Hull::space) {
      EXPECT_LE(std::max(beyond(t, y).caps, beyond(t, y).wall), rounding);
    }
  }
  if (answer.proof == Proof::point && !plane && answer.hull_a == Hull::space &&
      answer.hull_b == Hull::space) {
    const Long3 at = lifted<Long>(answer.point_head) + lifted<Long>(answer.point_tail);
    const Long3 x = at - lifted<Long>(p.a.center), y = at - lifted<Long>(p.b.center);
    EXPECT_LE(std::max(beyond(s, x).caps, beyond(s, x).wall), rounding);
    EXPECT_LE(std::max(beyond(t, y).caps, beyond(t, y).wall), rounding);
  }
}

TEST(Boxes, RightFromAMarginOf1e13OnForEveryKindOfPair) {
  Numbers n(63);
  for (int a = static_cast<int>(SolidKind::half_space); a <= static_cast<int>(SolidKind::rounded_box); ++a)
    for (int b = 0; b <= static_cast<int>(SolidKind::rounded_box); ++b) {
      if (b == static_cast<int>(SolidKind::half_space)) continue;
      for (int i = 0; i < 3000; ++i) {
        const bool apart = n.unit() < 0.5;
        const double margin = 1.2e-13 * std::pow(10, 12 * n.unit());
        Solid first = random_solid(static_cast<SolidKind>(a), n),
              second = random_solid(static_cast<SolidKind>(b), n);
        const auto pair = place(first, second, apart, margin, n);
        if (!pair) continue;
        const std::string what = std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(i);
        const long before = allocations;
        const Prepared pa = prepare(pair->a), pb = prepare(pair->b);
        const Verdict verdict = intersect(pa, pb);
        const Answer answer = decide(pa, pb), reversed = decide(pb, pa);
        const Distance d = distance(pa, pb);
        EXPECT_EQ(allocations, before);
        ASSERT_EQ(verdict, apart ? Verdict::disjoint : Verdict::intersecting) << what << " margin " << margin;
        EXPECT_EQ(verdict, intersect(pb, pa)) << what;
        ASSERT_NE(answer.verdict, apart ? Verdict::intersecting : Verdict::disjoint) << what;
        EXPECT_EQ(answer.verdict, reversed.verdict) << what;
        if (answer.proof == Proof::direction) {
          EXPECT_EQ(answer.direction, -reversed.direction) << what;
        }
        if (apart) {
          EXPECT_EQ(answer.verdict, Verdict::disjoint) << what << " margin " << margin;
        }
        expect_shown(*pair, answer);
        const double size = size_of(*pair), reach = size + (pair->b.center - pair->a.center).norm();
        EXPECT_LE(d.iterations, distance_step_cap);
        if (apart) {
          EXPECT_NEAR(d.value, margin * size, d.error + 1e-15 * reach) << what;
        }
        if (apart) {
          EXPECT_LE(d.error, 1e-10 * reach) << what;
          const Vector3 way = (pair->b.center - pair->a.center) + (d.on_b - d.on_a);
          EXPECT_NEAR(way.norm(), d.value, d.error + 1e-15 * reach) << what;
        }
        if (!apart) {
          EXPECT_LE(d.value, -2 * margin * size + d.error + 1e-15 * reach) << what;
        }
        // Every length times a power of two.
        for (const double factor : {0x1p-600, 0x1p40, 0x1p700}) {
          const auto scaled = [&](Solid c) {
            c.center *= factor, c.radius *= factor, c.height *= factor, c.rounding *= factor;
            for (double& e : c.edges) e *= factor;
            return c;
          };
          ASSERT_EQ(intersect(scaled(pair->a), scaled(pair->b)), verdict) << what;
          ASSERT_EQ(decide(scaled(pair->a), scaled(pair->b)).verdict, answer.verdict) << what;
        }
      }
    }
}

// The plane passes through the origin, because its point is a multiple of a vector square to the normal.
TEST(Boxes, PointsOfPlanesMayBeFarAway) {
  Numbers n(11);
  for (int i = 0; i < 3000; ++i) {
    Vector3 normal = n.vector();
    if (i % 3 == 0) normal.x() *= std::pow(10, -300 * n.unit());
    const double far = std::ldexp(1, static_cast<int>(980 * n.unit()));
    const Solid plane = half_space(far * Vector3(normal.y(), -normal.x(), 0), normal);
    Solid c = random_solid(i % 2 == 0 ? SolidKind::box : SolidKind::rounded, n);
    const Terms<Long> s = terms_of<Long>(c);
    const Long3 u = lifted<Long>(normal) / norm(lifted<Long>(normal));
    for (const double side : {1, -1}) {
      const Long height = support(s, u) + side * 1e-12L * size_of({plane, c});
      c.center = Vector3(static_cast<double>(height * u.x), static_cast<double>(height * u.y),
                         static_cast<double>(height * u.z));
      const Answer answer = decide(plane, c);
      EXPECT_EQ(intersect(plane, c), side > 0 ? Verdict::disjoint : Verdict::intersecting) << i;
      EXPECT_NE(answer.verdict, side > 0 ? Verdict::intersecting : Verdict::disjoint) << i;
      if (side > 0) {
        EXPECT_EQ(answer.verdict, Verdict::disjoint) << i;
      }
      // Deep inside, it is decided even if the solid is thin.
      c.center = -far * normal;
      EXPECT_EQ(decide(plane, c).verdict, Verdict::intersecting) << i;
    }
  }
}

TEST(Boxes, PointsOfAnswersHoldAtTheEndsOfTheRange) {
  Numbers n(12);
  for (int i = 0; i < 3000; ++i) {
    const double unit = i % 2 == 0 ? 0x1p-1070 : 0x1p1023;
    const auto some = [&] { return unit < 1 ? std::floor(40 * n.either_sign()) : n.either_sign(); };
    const Solid plane = half_space(unit * Vector3(some(), some(), some()), n.vector());
    Solid ball = rounded(upright(0, 0, 0, 0, 0), unit * std::fabs(some()));
    ball.center = unit * Vector3(some(), some(), some());
    const Answer answer = decide(plane, ball);
    EXPECT_TRUE(answer.point_head.allFinite() && answer.point_tail.allFinite());
    if (answer.proof == Proof::points) {
      EXPECT_LE(dot(lifted<Long>(plane.axis), lifted<Long>(answer.point_head)), 0) << i;
    }
  }
  // The sum of the roundings overflows.
  const Solid a = rounded(box({0, 0, 0}, 1e307, 1e307, 1e307), 1.4e308);
  const Solid b = rounded(box({1.2e308, 0, 0}, 1e307, 1e307, 1e307), 1.1e308);
  EXPECT_EQ(intersect(a, b), Verdict::intersecting);
  EXPECT_EQ(decide(a, b).verdict, Verdict::intersecting);
}

TEST(Boxes, TinyOnesBesideLongOnes) {
  // A rounded box of 1e-11 at the rim of a cylinder. The way between the cores shows the angle about the axis
  // only roughly.
  const Solid tiny = rounded(box({-1.0712662899815921, -1.107015924154405, 2.6223852271605876}, 3.6e-11,
                                 1e-19, 6e-15, {0.48, -0.42, -0.15, -0.45}),
                             1.285e-11);
  Solid wide = upright(0, 0, 0, 3, 1);
  wide.axis = {-0.5794562543467425, -0.7333274073784539, -0.35561406452225425};
  Solid near = tiny;
  const Distance d = distance(tiny, wide);
  near.center += (d.value - 8e-13) * d.direction;
  EXPECT_EQ(decide(near, wide).verdict, Verdict::disjoint);
  // A capsule along a facet. The last vector that the search saw shows the gap, and not the shortest.
  const Pair beside{{{-1.923439513084186, 0.4978203846106596, 0.2873952844642019},
                     {0, -1, 0},
                     0,
                     0.6923188245293892,
                     1.014615831853391},
                    box({0, 0.8642404946519557, 0}, 1.1747473430856847, 1.387606787738569, 0.5753659348632671,
                        {0, 3.325980842020992, -1.4972557585774386, 0})};
  expect_shown(beside, decide(beside.a, beside.b));
  // A rounding below that of numbers.
  const Pair deep{rounded(upright(0, 0, 0, 2, 1), 1e-16), half_space({0, 1, 0}, {0, 1, 1})};
  expect_shown(deep, decide(deep.a, deep.b));
  // A capsule nearly along a facet, deepest at one end.
  const Solid along = rounded(upright(5, 0, 0, 0, 4), 3);
  EXPECT_EQ(decide(box({1.5 + 1e-14, 0, 0}, 1, 6, 6, {1, 0, 1e-10, 0}), along).verdict,
            Verdict::intersecting);
  // A capsule inside a box, with a rounding far below the other errors.
  const Solid capsule = rounded(upright(0.3, 0.2, 0.1, 0, 1e-10), 1e-20);
  EXPECT_EQ(decide(box({0, 0, 0}, 2, 2, 2, {0.9, 0.1, 0.2, 0.3}), capsule).verdict, Verdict::intersecting);
}

TEST(Boxes, QuaternionsOfAnyLength) {
  Numbers n(7);
  for (int i = 0; i < 2000; ++i) {
    Solid a = random_solid(SolidKind::box, n), b = random_solid(SolidKind::rounded_box, n);
    b.center = n.vector();
    const Verdict verdict = intersect(a, b);
    for (double& x : a.quaternion) x *= 0x1p-700;
    for (double& x : b.quaternion) x *= -0x1p900;
    EXPECT_EQ(intersect(a, b), verdict);
  }
  // Edges that are parallel but for a subnormal number.
  const Solid a = box({0, 0, 0}, 1, 2, 1), b = box({-0.2, 1.6, -0.5}, 2, 1, 1, {2, 3, 0, 0x2p-1074});
  EXPECT_EQ(intersect(a, b), Verdict::intersecting);
  EXPECT_EQ(decide(a, b).verdict, Verdict::intersecting);
}

TEST(Boxes, ACapsuleThinnerThanRoundingPiercesASheet) {
  const Solid needle = {Vector3(0, -0.2, 0.2), Vector3(18, 4, 6), 0, 2, 1e-30};
  EXPECT_EQ(intersect(box({0, 0, 0}, 2, 2, 0), needle), Verdict::intersecting);
}

}  // namespace
}  // namespace cyl
