// SPDX-License-Identifier: MIT
// Solids built of integers. A plane has one solid on each closed side, and both reach it. They touch if
// their parts in the plane do, and otherwise only the plane separates them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "corpus/pairs/checks_test.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t touching_count = 3000;

/// Three vectors of integers, square to each other and 3 long.
struct Lattice {
  Vector3 up{2, -1, 2}, right{2, 2, -1}, front{-1, 2, 2};
};

/// The part of a solid that lies in the plane, about `middle` from the solid's centre. It is a disk, a
/// segment along the unit vector (x, y) on right and front, or a point.
struct Part {
  Solid solid;
  Vector3 middle;
  double disk = 0, half = 0, x = 0, y = 0;
};

Part draw_part(RandomStream& stream, const Lattice& l) {
  Part part;
  const double wide = stream.integer(1, 4), high = stream.integer(1, 4);
  const std::size_t kind = stream.below(3);
  const int turn = stream.integer(0, 3);
  const double xs[] = {1, 0, 0.6, -0.8}, ys[] = {0, 1, 0.8, 0.6};
  part.x = xs[turn];
  part.y = ys[turn];
  const Vector3 flat = turn < 2
                           ? Vector3(part.x * l.right + part.y * l.front)
                           : Vector3(std::round(5 * part.x) * l.right + std::round(5 * part.y) * l.front);
  const double length = turn < 2 ? 3 : 15;
  if (kind == 0) {  // a cap
    part.solid.axis = l.up;
    part.solid.radius = part.disk = 3 * wide;
    part.solid.height = 6 * high;
    part.middle = high * l.up;
  } else if (kind == 1) {  // a wall
    part.solid.axis = flat;
    part.solid.radius = 3 * wide;
    part.half = length * high;
    part.solid.height = 2 * part.half;
    part.middle = wide * l.up;
  } else {  // a rim: the axis has 3 up for 4 across, or a segment's end
    const Vector3 across = turn < 2 ? flat : (turn == 2 ? l.right : l.front);
    const bool thin = stream.coin();
    part.solid.axis = 3 * l.up + 4 * across;
    part.solid.radius = thin ? 0 : 15 * wide;
    part.solid.height = 30 * high;
    part.middle = high * part.solid.axis + (thin ? 0 : wide) * (4 * l.up - 3 * across);
  }
  part.solid.axis *= stream.sign();
  return part;
}

/// Returns how far two parts are from sharing a point, with b's middle at (x, y) from a's. Below 0 if they
/// share one.
double apart(const Part& a, const Part& b, double x, double y) {
  const double radii = a.disk + b.disk;
  double least = std::hypot(x, y);
  const auto from_segment = [](const Part& s, double px, double py) {
    const double along = std::clamp(px * s.x + py * s.y, -s.half, s.half);
    return std::hypot(px - along * s.x, py - along * s.y);
  };
  for (const double end : {-1.0, 1.0}) {
    least = std::min(least, from_segment(a, x + end * b.half * b.x, y + end * b.half * b.y));
    least = std::min(least, from_segment(b, end * a.half * a.x - x, end * a.half * a.y - y));
  }
  const double normal = a.x * b.y - a.y * b.x;
  if (a.half > 0 && b.half > 0 && std::fabs(normal) > 0.01) {
    const double s = (x * b.y - y * b.x) / normal, t = (x * a.y - y * a.x) / normal;
    if (std::fabs(s) <= a.half && std::fabs(t) <= b.half) least = 0;
  }
  return least - radii;
}

void touch(std::uint64_t index) {
  RandomStream stream("solids on a plane", drawing_seed, index);
  const Lattice l;
  Part a = draw_part(stream, l), b = draw_part(stream, l);
  const bool square = a.disk + a.half == 0 || b.disk + b.half == 0;  // else points hardly ever meet
  const int reach = square && a.disk + b.disk + a.half + b.half == 0 ? 1 : 4;
  const double right = stream.integer(-reach, reach),
               front = stream.coin() ? 0 : stream.integer(-reach, reach);
  const double beyond = apart(a, b, 3 * right, 3 * front);
  for (int i = 0; i < 3; ++i) a.solid.center[i] = stream.integer(-9, 9);
  b.solid.center = a.solid.center + a.middle + right * l.right + front * l.front + b.middle;
  // b hangs from the plane. Its parts are the parts of the same solid turned round.
  const Pair pair{a.solid, b.solid};
  if (beyond > 0 && beyond < 1e-9) return;
  const Verdict truth = judge(pair).verdict;
  const Verdict wanted = beyond <= 1e-9 ? Verdict::touching : Verdict::disjoint;
  check_that(truth == wanted, "touching: on a plane, wanted", to_string(wanted), "got", to_string(truth),
             pair);
}

/// The simplest rational near a simple number is that number. In any case it is near the number.
void simplify(std::uint64_t index) {
  RandomStream stream("simple rationals", drawing_seed, index);
  mpq_class simple(stream.integer(-300, 300), stream.integer(1, 30));
  simple.canonicalize();
  const mpq_class near = simple + mpq_class(stream.between(-1, 1)) / mpq_class(0x1p30),
                  any(stream.between(-5, 5));
  check_that(simplest_within(near, mpq_class(0x1p-29)) == simple, "touching: the simplest rational");
  check_that(simplest_within(any, 0) == any && abs(simplest_within(any, mpq_class(0x1p-9)) - any) <= 0x1p-9,
             "touching: a rational far off");
}

// The shortest common point is in the certificate: short decimals if they are in both solids.
TEST(RefereeTouching, HasAShortCommonPoint) {
  const Vector3 up(0, 0, 1);
  const struct {
    Pair pair;
    std::array<double, 3> point;
  } all[] = {
      // A cap on a cap, coins in one plane, walls along each other and crossed, a coin on a cap at a level of
      // 17
      // digits.
      {{{{0, 0, 0}, up, 1, 1}, {{0.3, 0.2, 1}, up, 1, 1}}, {0.15, 0.1, 0.5}},
      {{{{0.1, 0.2, 0.3}, up, 0.3, 0}, {{0.15, 0.2, 0.3}, up, 0.2, 0}}, {0.15, 0.2, 0.3}},
      {{{{0, 0, 0}, up, 0.014, 0.5}, {{0.024, 0, 0}, up, 0.01, 0.35}}, {0.014, 0, 0}},
      {{{{0, 0, 0}, up, 0.3, 1}, {{0.6, 0, 0}, {0, 1, 0}, 0.3, 1}}, {0.3, 0, 0}},
      {{{{-0.78, -0.24, -0.86}, up, 0.125, 1.8}, {{-0.826, -0.24, 0.040000000000000036}, up, 0.25, 0}},
       {-0.78, -0.24, 0.040000000000000036}},
      // The same in a large unit and far off.
      {{{{0, 0, 0}, up, 0x1p600, 0x1p600}, {{0, 0, 0x1p600}, up, 0x1p600, 0x1p600}}, {0, 0, 0x1p599}},
      {{{{1e9, 0, 0}, up, 1, 1}, {{1e9, 0.25, 1}, up, 1, 1}}, {1e9, 0.13, 0.5}},
  };
  for (const auto& [pair, point] : all) {
    const Truth truth = judge(pair);
    EXPECT_EQ(truth.verdict, Verdict::touching);
    EXPECT_EQ(truth.certificate.kind, CertificateKind::point);
    EXPECT_TRUE(truth.certificate.vector.in_doubles());
    EXPECT_EQ(truth.certificate.vector.head, point);
    EXPECT_EQ(truth.certificate.vector.tail, (std::array<double, 3>{0, 0, 0}));
  }
  // 3 digits of this radius exceed the largest double.
  const Truth huge = judge({{{0, 0, 0}, up, 1.796e308, 1}, {{1.796e308, 0, 0}, up, 0, 1}});
  EXPECT_EQ(huge.certificate.vector.head[0], 1.796e308);
  // Rounding leaves the plane of these caps. A fraction in the middle of what they share is exact.
  const Truth tilted = judge({{{0, 0, 0}, {2, -1, 2}, 3, 6}, {{5, 2, 5}, {2, -1, 2}, 6, 6}});
  EXPECT_EQ(tilted.certificate.kind, CertificateKind::point);
  EXPECT_EQ(tilted.certificate.vector.exact, (std::array<std::string, 3>{"7/3", "1/3", "7/3"}));
}

TEST(RefereeTouching, IsProved) {
  for (std::uint64_t i = 0; i < touching_count; ++i) {
    touch(i);
    simplify(i);
  }
}

}  // namespace
}  // namespace cyl
