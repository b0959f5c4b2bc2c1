// SPDX-License-Identifier: MIT
#include "oracles/trial/shown_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"
#include "oracles/referee/half_space.hpp"

namespace cyl {
namespace {

/// The error of some eighty operations in long double, relative to the lengths in them.
constexpr long double wide_error = 0x1p-56L;
using Wide = Vec3<long double>;

/// Returns how far an offset from the solid's centre is outside.
long double outside(const Terms<long double>& s, const Wide& x) {
  if (s.box) {
    Wide out{};
    for (std::size_t i = 0; i < 3; ++i)
      out = out + std::max(0.0L, std::abs(dot(x, s.edges[i])) - s.halves[i]) * s.edges[i];
    return std::max(0.0L, norm(out) - s.rounding);
  }
  const auto [caps, wall] = beyond(s, x);
  return std::max(0.0L, std::hypot(std::max(0.0L, caps), std::max(0.0L, wall)) - s.rounding);
}

}  // namespace

Enclosure shown_distance(const Pair& pair, const MeasuredDistance& measured) {
  if (has_half_space(pair)) return attain_half_space(pair).distance;
  const auto a = terms_of<long double>(pair.a), b = terms_of<long double>(pair.b);
  const Wide delta = lifted<long double>(pair.b.center) - lifted<long double>(pair.a.center),
             u = lifted<long double>(measured.direction), x = lifted<long double>(measured.on_a),
             y = lifted<long double>(measured.on_b);
  long double lengths = norm(delta);
  for (const auto* s : {&a, &b})
    lengths += s->radius + s->half + s->rounding + s->halves[0] + s->halves[1] + s->halves[2];
  const long double slack = wide_error * lengths;
  const long double least = (dot(u, delta) - support(a, u) - support(b, u)) / norm(u) - slack;
  const long double most =
      measured.value > 0 ? norm(delta + y - x) + outside(a, x) + outside(b, y) + slack : 0;
  constexpr long double largest = std::numeric_limits<double>::max();
  if (!(std::abs(least) < largest && most < largest))
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  return {static_cast<double>(least), static_cast<double>(most)};
}

}  // namespace cyl
