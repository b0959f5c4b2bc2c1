// SPDX-License-Identifier: MIT
// The referee's own search for the nearest points of two cylinders without rounding that are apart. Its
// result is a guess until it is checked. So one text serves double and every precision of MPFR.
//
// Steps to the nearest point of the other solid and back never increase the distance, but may be slow. So the
// search alternates them with Newton's method. That takes the faces, sides and rims of the current points as
// the right ones, and goes to the points at which their distance is stationary. Each step doubles the digits.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "corpus/pairs/support.hpp"
#include "oracles/referee/search.hpp"

namespace cyl {

/// Two points, relative to a's centre, and their distance.
template <class R>
struct Nearest {
  Vec3<R> on_a, on_b;
  R apart;
};

namespace nearest_detail {

using std::abs;
using std::sqrt;

template <class R>
struct Core {
  Vec3<R> center, axis;  // unit
  R radius, half;

  Vec3<R> nearest(const Vec3<R>& x) const {
    const Vec3<R> d = x - center;
    R along = dot(d, axis);
    Vec3<R> across = d - along * axis;
    const R beside = norm(across);
    if (along > half) along = half;
    if (along < -half) along = -half;
    if (beside > radius) across = R(radius / beside) * across;
    return center + along * axis + across;
  }
};

/// The part of a solid's surface that a point lies on: the inside of its side, the inside of its cap, or the
/// edge between them.
enum class Part : unsigned char { side, cap, rim };

/// A point of a part, with up to two tangents, and the second derivative along each.
template <class R>
struct Place {
  Vec3<R> at{};
  std::array<Vec3<R>, 2> tangent{}, bend{};
  std::size_t count = 0;
};

/// `u` is the unit vector from the axis to the point. `end` is +1 or -1.
template <class R>
Place<R> place_on(const Core<R>& s, Part part, const Vec3<R>& x) {
  const Vec3<R> d = x - s.center;
  const R along = dot(d, s.axis), zero(0.0);
  Vec3<R> u = d - along * s.axis;
  const R beside = norm(u);
  const R end = along < zero ? R(-s.half) : s.half;
  Place<R> p;
  if (part == Part::cap) {
    p.at = s.center + end * s.axis + u;
    // Any two vectors that span the cap's plane.
    const bool x_least = abs(s.axis.x) < abs(s.axis.y) && abs(s.axis.x) < abs(s.axis.z);
    const bool y_least = abs(s.axis.y) < abs(s.axis.z);
    const Vec3<R> other{R(x_least ? 1.0 : 0.0), R(!x_least && y_least ? 1.0 : 0.0),
                        R(!x_least && !y_least ? 1.0 : 0.0)};
    Vec3<R> first = cross(s.axis, other);
    first = first / norm(first);
    p.tangent = {first, cross(s.axis, first)};
    p.count = 2;
    return p;
  }
  const bool turns = s.radius > zero && beside > zero;
  if (turns) u = u / beside;
  const Vec3<R> out = turns ? s.radius * u : Vec3<R>{zero, zero, zero};
  p.at = s.center + (part == Part::rim ? end : along) * s.axis + out;
  if (turns) {
    p.tangent[0] = s.radius * cross(s.axis, u);
    p.bend[0] = R(-1.0) * out;
    p.count = 1;
  }
  if (part == Part::side) p.tangent[p.count++] = s.axis;
  return p;
}

/// Solves the symmetric system of up to four unknowns by elimination with pivots. An unknown that the system
/// does not determine is 0.
template <class R>
std::array<R, 4> solve(std::array<std::array<R, 5>, 4> m, std::size_t n, int bits) {
  constexpr std::size_t none = 4;
  std::array<std::size_t, 4> pivot_of{none, none, none, none};
  std::array<bool, 4> used{};
  // Angles and lengths have different units. Each unknown is scaled so that its own entry is 1. Else the
  // choice of undetermined unknowns would depend on the scale of the scene.
  std::array<R, 4> unit{R(1.0), R(1.0), R(1.0), R(1.0)};
  for (std::size_t i = 0; i < n; ++i) {
    const R d = abs(m[i][i]);
    if (d > R(0.0)) unit[i] = R(1.0) / R(sqrt(d));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = m[i][j] * unit[i] * unit[j];
    m[i][n] = m[i][n] * unit[i];
  }
  R largest(0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) largest = std::max(largest, R(abs(m[i][j])));
  const R least = largest * R(std::ldexp(1.0, -std::min(bits * 3 / 4, 1000)));
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t best = none;
    for (std::size_t row = 0; row < n; ++row)
      if (!used[row] && (best == none || abs(m[row][column]) > abs(m[best][column]))) best = row;
    if (best == none || !(abs(m[best][column]) > least)) continue;
    used[best] = true;
    pivot_of[column] = best;
    for (std::size_t row = 0; row < n; ++row) {
      if (row == best) continue;
      const R share = m[row][column] / m[best][column];
      for (std::size_t k = column; k <= n; ++k) m[row][k] = m[row][k] - share * m[best][k];
    }
  }
  std::array<R, 4> x{R(0.0), R(0.0), R(0.0), R(0.0)};
  for (std::size_t column = 0; column < n; ++column)
    if (const std::size_t row = pivot_of[column]; row != none)
      x[column] = unit[column] * m[row][n] / m[row][column];
  return x;
}

template <class R>
class Search {
 public:
  Search(const SearchPair<R>& p, int bits) : bits_(bits) {
    const auto unit = [](const Vec3<R>& w) { return w / norm(w); };
    const R zero(0.0);
    a_ = {{zero, zero, zero}, unit(p.axis0), p.radius0, p.half0};
    b_ = {p.delta, unit(p.axis1), p.radius1, p.half1};
    const R size = a_.radius + a_.half + b_.radius + b_.half + norm(p.delta);
    const R digits(std::ldexp(1.0, -std::min(bits / 2 + 4, 1000)));
    settled_ = (size * digits) * (size * digits);
    for (int left = bits / 2 + 4 - 1000; left > 0; left -= 500)
      settled_ = settled_ * R(std::ldexp(1.0, -std::min(2 * left, 1000)));
  }

  /// Starts from points that are nearly right, and keeps the parts on which they lie.
  Nearest<R> refine(const Vec3<R>& on_a, const Vec3<R>& on_b) {
    take(on_a);
    take(a_.nearest(on_b));
    follow(part_of(a_, best_.on_a), part_of(b_, best_.on_b));
    return best_;
  }

  Nearest<R> run(const Vec3<R>& start) {
    take(start);
    for (int round = 0; round < 12; ++round) {
      const R before = best_.apart;
      for (int i = 0; i < 8; ++i) take(best_.on_b);
      for (const Part pa : {Part::side, Part::cap, Part::rim})
        for (const Part pb : {Part::side, Part::cap, Part::rim}) follow(pa, pb);
      if (!(best_.apart < before * (R(1.0) - R(std::ldexp(1.0, -std::min(bits_ - 4, 1000)))))) break;
    }
    return best_;
  }

 private:
  static Part part_of(const Core<R>& s, const Vec3<R>& x) {
    const R nearly(1 - 0x1p-30);
    const Vec3<R> d = x - s.center;
    const R along = dot(d, s.axis);
    const bool at_cap = !(abs(along) < nearly * s.half);
    const bool at_side = !(norm(d - along * s.axis) < nearly * s.radius);
    return !at_cap ? Part::side : at_side ? Part::rim : Part::cap;
  }

  // `x` is on a or near it. Takes the nearest point of a, and the point of b nearest to that.
  void take(const Vec3<R>& x) {
    const Vec3<R> on_a = a_.nearest(x), on_b = b_.nearest(on_a);
    const R apart = norm(on_b - on_a);
    if (!started_ || apart < best_.apart) best_ = {on_a, on_b, apart};
    started_ = true;
  }

  // Newton's method with the points on these parts. Its result is kept if the points are nearer.
  void follow(Part part_a, Part part_b) {
    Vec3<R> x = best_.on_a, y = best_.on_b;
    for (int step = 0; step < 10 + bits_ / 64; ++step) {
      const Place<R> p = place_on(a_, part_a, x), q = place_on(b_, part_b, y);
      const Vec3<R> e = q.at - p.at;
      const std::size_t n = p.count + q.count;
      if (n == 0) break;
      std::array<std::array<R, 5>, 4> m{};
      for (auto& row : m) row.fill(R(0.0));
      const auto tangent = [&](std::size_t i) {
        return i < p.count ? R(-1.0) * p.tangent[i] : q.tangent[i - p.count];
      };
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) m[i][j] = dot(tangent(i), tangent(j));
        const bool of_a = i < p.count;
        const Vec3<R>& bend = of_a ? p.bend[i] : q.bend[i - p.count];
        m[i][i] = m[i][i] + (of_a ? R(-dot(e, bend)) : dot(e, bend));
        m[i][n] = -dot(e, tangent(i));
      }
      const std::array<R, 4> by = solve(m, n, bits_);
      x = p.at;
      y = q.at;
      for (std::size_t i = 0; i < p.count; ++i) x = x + by[i] * p.tangent[i];
      for (std::size_t i = 0; i < q.count; ++i) y = y + by[p.count + i] * q.tangent[i];
      // A step doubles the right digits. So after a step below half of the digits, all are right.
      R moved(0.0);
      for (std::size_t i = 0; i < n; ++i) moved = moved + by[i] * by[i] * dot(tangent(i), tangent(i));
      if (!(moved > settled_)) break;
    }
    take(x);
    take(a_.nearest(y));
  }

  Core<R> a_, b_;
  int bits_;
  R settled_;  // the square of a step with which half of the digits are right
  bool started_ = false;
  Nearest<R> best_{};
};

}  // namespace nearest_detail

/// `start` is any point, relative to a's centre. Cost in double: some 10 us.
template <class R>
Nearest<R> find_nearest(const SearchPair<R>& p, int bits, const Vec3<R>& start) {
  return nearest_detail::Search<R>(p, bits).run(start);
}

/// The same from points that were found with fewer bits. Cost: a twentieth of that.
template <class R>
Nearest<R> refine_nearest(const SearchPair<R>& p, int bits, const Vec3<R>& on_a, const Vec3<R>& on_b) {
  return nearest_detail::Search<R>(p, bits).refine(on_a, on_b);
}

}  // namespace cyl
