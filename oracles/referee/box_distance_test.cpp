// SPDX-License-Identifier: MIT
#include "oracles/referee/box_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/support.hpp"
#include "oracles/referee/great_circles.hpp"

namespace cyl {
namespace {

Solid box(const Vector3& center, std::array<double, 3> edges, double rounding = 0,
          std::array<double, 4> quaternion = {1, 0, 0, 0}) {
  return {center, {0, 0, 1}, 0, 0, rounding, Shape::box, edges, quaternion};
}
Solid cylinder(const Vector3& center, const Vector3& axis, double radius, double height,
               double rounding = 0) {
  return {center, axis, radius, height, rounding};
}
Pair swapped(const Pair& p) { return {p.b, p.a}; }

constexpr double diagonal = 0.70710678118654757;  // sqrt(1/2)

TEST(BoxDistance, IsThatOnPaper) {
  const Vector3 o(0, 0, 0), x(1, 0, 0), z(0, 0, 1);
  const std::array<double, 4> turned{std::cos(0.39269908169872414), 0, 0, std::sin(0.39269908169872414)};
  struct Known {
    Pair pair;
    double distance;
  };
  const Known all[] = {
      {{box(o, {2, 2, 2}), box({3, 0, 0}, {2, 2, 2})}, 1},       // along an axis
      {{box(o, {2, 2, 2}), box({5, 6, 1}, {2, 2, 2})}, 5},       // edge to edge
      {{box(o, {2, 2, 2}), box({1.5, 0, 0}, {2, 2, 2})}, -0.5},  // overlapping
      {{box(o, {8, 8, 8}), box({1, 0, 0}, {2, 2, 2})}, -4},      // inside
      {{box(o, {2, 2, 2}), box({2.5, 0, 0}, {2, 2, 2}, 0, turned)}, 1.5 - 2 * diagonal},
      {{box(o, {4, 4, 2}), cylinder({0.5, 0, 1.75}, x, 1, 2)}, -0.25},                  // a lying cylinder
      {{box(o, {4, 4, 2}), cylinder({0.5, 0, 2.25}, z, 1, 2)}, 0.25},                   // a standing one
      {{box(o, {4, 4, 2}), cylinder({2.5, 2.5, 0}, z, 1, 2)}, 2 * 0.5 * diagonal - 1},  // wall to edge
      {{box(o, {2, 2, 2}), cylinder({3, 3, 2}, z, 0, 0, 1)}, 2},  // a sphere at a corner
      {{box(o, {2, 2, 2}, 0.5), cylinder({3, 3, 2}, z, 0, 0, 1)}, 1.5},
      {{box(o, {2, 2, 2}), cylinder({0.5, 0, 0}, z, 0, 0, 1)}, -1.5},      // a sphere inside
      {{box(o, {4, 4, 2}), cylinder({0, 0, 1.5}, x, 0, 8, 0.75)}, -0.25},  // a capsule
      {{box(o, {4, 4, 0}), box({0.5, 0, 0}, {0, 0, 3})}, -1.5},            // a rectangle, a segment
      {{box(o, {4, 4, 0}), cylinder({0, 0, 0}, x, 1, 0)}, -1},             // a rectangle, a disk
      {{box({1, 2, 3}, {0, 0, 0}), cylinder({1, 2, 4}, z, 2, 0)}, 1},      // a point, a disk
  };
  for (const Known& k : all)
    for (const Pair& pair : {k.pair, swapped(k.pair)})
      for (const double unit : {1.0, 0x1p-1000, 0x1p1000}) {
        Pair p = pair;
        for_each_length(p, [&](double& length) { length *= unit; });
        const Enclosure e = attain_box(p, Verdict::undecided, depth_width_tol).distance;
        EXPECT_LE(e.lo, k.distance * unit) << format_pair(p);
        EXPECT_GE(e.hi, k.distance * unit) << format_pair(p);
        EXPECT_LE(e.hi - e.lo, 1.01 * depth_width_tol * size_of(p) + 1e-322) << format_pair(p);
        const MeasuredDistance measured = measure_box(p, true);
        EXPECT_NEAR(measured.value / unit, k.distance, 1e-12) << format_pair(p);
        EXPECT_NEAR(measured.direction.norm(), 1, 1e-15);
        if (k.distance <= 0) continue;
        const Vector3 way = (p.b.center - p.a.center + measured.on_b - measured.on_a) / unit;
        EXPECT_NEAR(way.norm(), k.distance, 1e-12) << format_pair(p);
      }
}

/// A solid of any kind, half of the time in a simple place, with some lengths 0.
Solid drawn(RandomStream& s, bool boxed) {
  const bool simple = s.integer(0, 1) == 0;
  const auto length = [&] { return s.integer(0, 5) == 0 ? 0 : std::exp(s.between(-1, 1.2)); };
  const auto whole = [&] { return static_cast<double>(s.integer(-1, 1)); };
  const double rounding = s.integer(0, 2) == 0 ? s.between(0, 0.5) : 0;
  const Vector3 center = simple ? Vector3(whole(), whole(), whole()) : Vector3(0.8 * s.unit_vector());
  if (boxed) {
    std::array<double, 4> q{1, whole(), whole(), 0};
    if (!simple) q = {s.between(-1, 1), s.between(-1, 1), s.between(-1, 1), s.between(0.1, 1)};
    return box(center, {length(), length(), length()}, rounding, q);
  }
  return cylinder(center, simple ? Vector3(1, whole(), whole()) : s.unit_vector(), length(), length(),
                  rounding);
}

// The signed distance is the greatest -f. No descent from any start goes below the least f, and the best of
// many comes near it.
TEST(BoxDistance, NoDirectionSeparatesMore) {
  int apart = 0, overlapping = 0;
  std::size_t cells = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    RandomStream s("box_distance_test", 1, i);
    Pair pair{drawn(s, true), drawn(s, s.integer(0, 1) == 0)};
    if (s.integer(0, 1) == 0) pair = swapped(pair);
    const Terms<double> a = terms_of<double>(pair.a), b = terms_of<double>(pair.b);
    const Vec3<double> delta = lifted<double>(Vector3(pair.b.center - pair.a.center));
    const double delta_length = norm(delta);
    const auto f = [&](const Vector3& d) {
      const Vec3<double> at = lifted<double>(d);
      return support(a, at) + support(b, at) - dot(at, delta);
    };
    double least = std::numeric_limits<double>::infinity();
    for (int start = 0; start < 16; ++start) {
      Vector3 at = s.unit_vector();
      double lowest = f(at), step = 0.5;
      for (int k = 0; k < 300; ++k) {
        const Vector3 next = (at + step * s.unit_vector()).normalized();
        const double there = f(next);
        step *= there < lowest ? 2 : 0.85;
        if (there < lowest) at = next;
        lowest = std::min(lowest, there);
      }
      least = std::min(least, lowest);
    }
    const AttainedDistance found = attain_box(pair, Verdict::undecided, depth_width_tol);
    const double size = size_of(pair) + delta_length;
    ASSERT_GE(found.distance.hi, -least - 1e-14 * size) << format_pair(pair);
    ASSERT_LE(found.distance.lo, -least + 1e-3 * size) << format_pair(pair);
    ASSERT_LE(found.distance.hi - found.distance.lo, 1.01 * depth_width_tol * size) << format_pair(pair);
    const MeasuredDistance measured = measure_box(pair, true);
    ASSERT_NEAR(measured.value, found.distance.lo, 1e-8 * size) << format_pair(pair);
    (found.distance.lo > 0 ? apart : overlapping) += 1;
    cells += found.cells;
    if (found.distance.lo <= 0) continue;
    const Vector3 way = pair.b.center - pair.a.center + measured.on_b - measured.on_a;
    ASSERT_NEAR(way.norm(), measured.value, 1e-8 * size) << format_pair(pair);
  }
  std::printf("%d apart, %d overlapping, %zu arcs\n", apart, overlapping, cells);
  EXPECT_GT(apart, 100);
  EXPECT_GT(overlapping, 100);
}

// For every verdict and width. The solids of the first two pairs touch, or their cores do.
TEST(BoxDistance, IsShownByItsDirection) {
  const Solid plate = box({-5, -2, -1}, {98, 0, 98}, 0, {6, 2, 3, 0}),
              rod = box({26, 10, -37}, {0, 0, 50}, 0, {3, 4, 0, 0});
  Solid rounded = rod;
  rounded.rounding = 2;
  std::vector<Pair> pairs{{plate, rod}, {plate, rounded}};
  for (std::uint64_t i = 0; i < 100; ++i) {
    RandomStream s("box_distance_test", 3, i);
    pairs.push_back({drawn(s, true), drawn(s, s.integer(0, 1) == 0)});
  }
  for (const Pair& pair : pairs) {
    const Truth truth = judge_verdict(pair);
    const Terms<double> a = terms_of<double>(pair.a), b = terms_of<double>(pair.b);
    const Vec3<double> delta = lifted<double>(Vector3(pair.b.center - pair.a.center));
    const double size = size_of(pair) + norm(delta);
    for (const double width : {1.0, 1e-2, 1e-6, 1e-12}) {
      const AttainedDistance found = attain_distance(pair, truth, width);
      const Vec3<double> d{found.direction[0], found.direction[1], found.direction[2]};
      ASSERT_NEAR(dot(d, delta) - support(a, d) - support(b, d), found.distance.lo, 1e-14 * size)
          << width << format_pair(pair);
    }
    const Enclosure e = enclose_distance(pair, truth), narrow = enclose_distance(pair, truth, 1e-15);
    ASSERT_LE(e.lo, narrow.hi) << format_pair(pair);
    ASSERT_GE(e.hi, narrow.lo) << format_pair(pair);
    const bool apart = truth.verdict == Verdict::disjoint;
    ASSERT_LE(e.hi - e.lo, 1.01 * (apart ? gap_width_tol : depth_width_tol) * size) << format_pair(pair);
    ASSERT_GE(truth.verdict == Verdict::intersecting ? 0 : e.lo, 0) << format_pair(pair);
    ASSERT_LE(apart ? 0 : e.hi, 0) << format_pair(pair);
  }
}

}  // namespace
}  // namespace cyl
