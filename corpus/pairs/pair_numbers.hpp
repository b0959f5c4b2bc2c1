// SPDX-License-Identifier: MIT
// The numbers of a pair: in a row, checked, summed up, scaled.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "solver/solid.hpp"

namespace cyl {

/// Centre x y z, axis x y z, radius, height: the numbers of a cylinder without rounding, for code that does
/// not support roundings.
inline constexpr std::size_t core_number_count = 8;
/// The same, and the rounding.
inline constexpr std::size_t cylinder_number_count = core_number_count + 1;
/// The same, the edges and the quaternion.
inline constexpr std::size_t solid_number_count = cylinder_number_count + 7;

inline std::array<double*, solid_number_count> numbers_of(Solid& c) noexcept {
  return {&c.center[0],     &c.center[1],     &c.center[2],     &c.axis[0],      &c.axis[1],  &c.axis[2],
          &c.radius,        &c.height,        &c.rounding,      &c.edges[0],     &c.edges[1], &c.edges[2],
          &c.quaternion[0], &c.quaternion[1], &c.quaternion[2], &c.quaternion[3]};
}

inline std::array<double, solid_number_count> numbers_of(const Solid& c) noexcept {
  return {c.center[0],     c.center[1],     c.center[2],     c.axis[0],      c.axis[1],  c.axis[2],
          c.radius,        c.height,        c.rounding,      c.edges[0],     c.edges[1], c.edges[2],
          c.quaternion[0], c.quaternion[1], c.quaternion[2], c.quaternion[3]};
}

/// The 32 of a pair, those of a first.
inline std::array<double, 2 * solid_number_count> numbers_of(const Pair& p) noexcept {
  std::array<double, 2 * solid_number_count> all;
  std::ranges::copy(numbers_of(p.b), std::ranges::copy(numbers_of(p.a), all.begin()).out);
  return all;
}

inline bool is_rounded(const Pair& p) noexcept { return p.a.rounding != 0 || p.b.rounding != 0; }

inline bool is_half_space(const Solid& s) noexcept { return s.shape == Shape::half_space; }
inline bool has_half_space(const Pair& p) noexcept { return is_half_space(p.a) || is_half_space(p.b); }
inline bool is_box(const Solid& s) noexcept { return s.shape == Shape::box; }
inline bool has_box(const Pair& p) noexcept { return is_box(p.a) || is_box(p.b); }

/// The sum of the edges; 0 if the solid is not a box.
inline double edges_of(const Solid& s) noexcept { return s.edges[0] + s.edges[1] + s.edges[2]; }

/// The places in the row of numbers_of() that the shape has.
inline std::span<const std::size_t> places_of(Shape shape) noexcept {
  static constexpr std::array<std::size_t, 9> of_cylinder{0, 1, 2, 3, 4, 5, 6, 7, 8};
  static constexpr std::array<std::size_t, 11> of_box{0, 1, 2, 8, 9, 10, 11, 12, 13, 14, 15};
  if (shape == Shape::box) return of_box;
  return std::span(of_cylinder).first(shape == Shape::half_space ? 6 : of_cylinder.size());
}

/// Returns whether both solids are legal, and not both half-spaces.
inline bool is_legal(const Pair& p) noexcept {
  return find_defect(p.a) == Defect::none && find_defect(p.b) == Defect::none &&
         !(is_half_space(p.a) && is_half_space(p.b));
}

/// The sum of all radii, heights, edges and roundings, rounded, at most the largest double (the unit of
/// margins). A half-space adds nothing.
inline double size_of(const Pair& p) noexcept {
  return std::min(p.a.radius + p.a.height + p.b.radius + p.b.height + (p.a.rounding + p.b.rounding) +
                      (edges_of(p.a) + edges_of(p.b)),
                  std::numeric_limits<double>::max());
}

/// How far a solid extends along its axis and across it, roundings included. A box has its
/// shortest and its longest extent instead.
struct Extents {
  double along, across;
};
inline Extents extents_of(const Solid& c) noexcept {
  if (is_box(c))
    return {*std::ranges::min_element(c.edges) + 2 * c.rounding,
            *std::ranges::max_element(c.edges) + 2 * c.rounding};
  return {c.height + 2 * c.rounding, 2 * (c.radius + c.rounding)};
}

/// The lengths that a scene in its own unit has, and how far from the origin in sizes.
inline constexpr double least_ordinary_length = 0.01, most_ordinary_length = 100, most_ordinary_reach = 100;

/// Whether a scene in its own unit may hold the pair: such pairs are shown before those at the ends of the
/// range.
inline bool is_ordinary(const Pair& p) noexcept {
  for (const Solid* c : {&p.a, &p.b})
    for (const double x : {c->radius, c->height, c->rounding, c->edges[0], c->edges[1], c->edges[2]})
      if (x != 0 && !(x >= least_ordinary_length && x <= most_ordinary_length)) return false;
  return std::max(p.a.center.stableNorm(), p.b.center.stableNorm()) <= most_ordinary_reach * size_of(p);
}

/// Calls `change` with each length of the pair: the coordinates of the centres, radii, heights, roundings,
/// edges.
template <class Change>
void for_each_length(Pair& pair, Change change) {
  for (Solid* c : {&pair.a, &pair.b}) {
    for (double& x : c->center) change(x);
    change(c->radius);
    change(c->height);
    if (c->rounding != 0) change(c->rounding);
    if (is_box(*c)) std::ranges::for_each(c->edges, change);
  }
}

/// Returns the pair with all lengths times 2^exponent.
inline Pair scaled(Pair pair, int exponent) {
  for_each_length(pair, [&](double& x) { x = std::ldexp(x, exponent); });
  return pair;
}

/// Returns the same, or nothing if a length would be rounded.
inline std::optional<Pair> scaled_exactly(Pair pair, int exponent) {
  bool exact = true;
  for_each_length(pair, [&](double& x) {
    const double y = std::ldexp(x, exponent);
    exact = exact && std::isfinite(y) && std::ldexp(y, -exponent) == x;
    x = y;
  });
  if (!exact) return {};
  return pair;
}

}  // namespace cyl
