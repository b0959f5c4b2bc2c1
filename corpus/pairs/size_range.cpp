// SPDX-License-Identifier: MIT
#include "corpus/pairs/size_range.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"

namespace cyl {
namespace {

struct Lengths {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
};

/// Returns the least and the greatest of the lengths that are not 0.
Lengths lengths_of(const Solid& c) {
  Lengths lengths;
  for (const double x : {c.radius, c.height, c.rounding, c.edges[0], c.edges[1], c.edges[2]}) {
    if (x == 0) continue;
    lengths.least = std::min(lengths.least, x);
    lengths.greatest = std::max(lengths.greatest, x);
  }
  return lengths;
}

bool has_zero_length(const Solid& c) {
  if (is_box(c)) return std::ranges::count(c.edges, 0.0) > 0;
  const SolidKind kind = kind_of(c);
  return (kind == SolidKind::cylinder && c.radius == 0) ||
         ((kind == SolidKind::cylinder || kind == SolidKind::rounded) && c.height == 0);
}

double coordinate_of(const Solid& c) { return c.center.cwiseAbs().maxCoeff(); }

double ball_of(const Solid& c) {
  if (is_box(c)) return std::hypot(c.edges[0], c.edges[1], c.edges[2]) / 2 + c.rounding;
  return std::hypot(c.radius, c.height / 2) + c.rounding;
}

/// Returns the gap between the balls around the solids, negative if they overlap.
double gap_of(const Pair& pair) {
  const Vector3 half = pair.b.center / 2 - pair.a.center / 2;  // the difference itself may overflow
  return 2 * std::hypot(half.x(), half.y(), half.z()) - ball_of(pair.a) - ball_of(pair.b);
}

/// Returns the factor that brings a length down to its limit.
double factor_to(double limit, double length) { return length > limit ? limit / length : 1; }

}  // namespace

bool SizeRange::holds(const Solid& solid) const {
  if (!zero_lengths && has_zero_length(solid)) return false;
  if (coordinate_of(solid) > coordinate) return false;
  const Lengths lengths = lengths_of(solid);
  if (lengths.greatest == 0) return true;
  return lengths.least >= least && lengths.greatest <= greatest && lengths.greatest / lengths.least <= aspect;
}

bool SizeRange::holds(const Pair& pair) const {
  return holds(pair.a) && holds(pair.b) && (has_half_space(pair) || !(gap_of(pair) > gap));
}

SizeRange common_range(const SizeRange& x, const SizeRange& y) {
  return {std::max(x.least, y.least),           std::min(x.greatest, y.greatest),
          std::min(x.aspect, y.aspect),         x.zero_lengths && y.zero_lengths,
          std::min(x.coordinate, y.coordinate), std::min(x.gap, y.gap)};
}

std::optional<Pair> fitted(const Pair& pair, const SizeRange& range) {
  if (range.holds(pair)) return pair;
  const Lengths a = lengths_of(pair.a), b = lengths_of(pair.b);
  const double least = std::min(a.least, b.least), greatest = std::max(a.greatest, b.greatest);
  if (!(greatest > 0)) return {};
  // Takes the least power of two that makes the least length large enough. Otherwise takes the greatest that
  // keeps the greatest length, the coordinates and the gap small enough.
  const double shrunk =
      std::min({factor_to(range.greatest, greatest),
                factor_to(range.coordinate, std::max(coordinate_of(pair.a), coordinate_of(pair.b))),
                factor_to(range.gap, gap_of(pair))});
  const double factor = least < range.least ? range.least / least : shrunk;
  if (factor == 0) return {};  // the gap is larger than every double
  const int exponent = least < range.least ? static_cast<int>(std::ceil(std::log2(factor)))
                                           : static_cast<int>(std::floor(std::log2(factor)));
  const auto moved = scaled_exactly(pair, exponent);
  if (!moved || !range.holds(*moved)) return {};
  return moved;
}

}  // namespace cyl
