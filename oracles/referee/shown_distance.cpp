// SPDX-License-Identifier: MIT
#include "oracles/referee/shown_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/half_space.hpp"
#include "oracles/referee/interval.hpp"

namespace cyl {
namespace {

/// The error of fewer than 250 operations in twins, relative to the lengths in them, and a bound of all that
/// underflow changes. (The least square is 2^-1074.)
constexpr double twin_error = 0x1p-92, underflow_error = 0x1p-500;

/// How far an offset from the solid's centre is outside the core.
Twin outside(const Terms<Twin>& s, const Vec3<Twin>& x) {
  const auto positive = [](const Twin& y) { return std::max(y, Twin(0.0)); };
  const auto along = [&](std::size_t i) { return positive(abs(dot(x, s.edges[i])) - s.halves[i]); };
  if (s.box) return norm(Vec3<Twin>{along(0), along(1), along(2)});
  const auto [caps, wall] = beyond(s, x);
  return norm(Vec3<Twin>{positive(caps), positive(wall), 0.0});
}

}  // namespace

ShownBounds shown_bounds(const TermsPair<Twin>& p, const Vec3<double>& direction, const Vec3<double>& on_a,
                         const Vec3<double>& on_b) {
  const auto twins = [](const Vec3<double>& v) { return Vec3<Twin>{v.x, v.y, v.z}; };
  const Vec3<Twin> d = twins(direction), x = twins(on_a), y = twins(on_b);
  const Twin gap = (dot(d, p.delta) - core_support(p.a, d) - core_support(p.b, d)) / norm(d),
             way = norm(p.delta + y - x) + outside(p.a, x) + outside(p.b, y),
             roundings = p.a.rounding + p.b.rounding, lengths = reach_of(p) + roundings + way,
             error = twin_error * lengths + Twin(lengths.hi > 0 ? underflow_error : 0);
  return {gap - roundings - error, way - roundings + error};
}

Enclosure ShownBounds::in_scene(int exponent) const {
  using interval_detail::next_down, interval_detail::next_up;
  const double least = std::ldexp(lo.hi, exponent), most = std::ldexp(hi.hi, exponent);
  return {lo.hi == 0 ? 0 : next_down(least), hi.hi == 0 ? 0 : next_up(most)};
}

Enclosure shown_distance(const Pair& pair, MeasuredDistance measured) {
  if (has_half_space(pair)) return attain_half_space(pair).distance;
  int exponent = 0;
  const TermsPair<Twin> p = terms_in_unit<Twin>(pair, exponent);
  for (Vector3* point : {&measured.on_a, &measured.on_b})
    for (double& x : *point) x = std::ldexp(x, -exponent);
  const auto on_a = lifted<double>(measured.on_a), on_b = lifted<double>(measured.on_b);
  Enclosure shown = shown_bounds(p, lifted<double>(measured.direction), on_a, on_b).in_scene(exponent);
  if (!(measured.value > 0)) shown.hi = 0;
  if (std::isfinite(shown.lo) && std::isfinite(shown.hi)) return shown;
  return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

}  // namespace cyl
