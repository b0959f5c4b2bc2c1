// SPDX-License-Identifier: MIT
// The sizes and positions of solids that a method states it supports.
#pragma once

#include <limits>
#include <optional>

#include "solver/solid.hpp"

namespace cyl {

/// Limits of the radius, height, edges and rounding of one solid, in the unit of the scene. A sphere has no
/// radius and no height, and a capsule no radius. The limits do not apply to these.
struct SizeRange {
  double least = 0, greatest = std::numeric_limits<double>::infinity();
  double aspect = std::numeric_limits<double>::infinity();  ///< the greatest length divided by the least
  /// It includes cylinders with a radius or height of 0 and boxes with an edge of 0, rounded or not.
  bool zero_lengths = true;

  /// The greatest coordinate of a centre in absolute value.
  double coordinate = std::numeric_limits<double>::infinity();
  /// The greatest gap between the balls around the two solids, with the same centres. The solids are at least
  /// as far apart as these balls.
  double gap = std::numeric_limits<double>::infinity();

  bool holds(const Solid& solid) const;
  bool holds(const Pair& pair) const;
  bool operator==(const SizeRange&) const = default;
};

/// Returns the range that both hold.
SizeRange common_range(const SizeRange& x, const SizeRange& y);

/// Returns the pair, times a power of two if the range does not hold it as it is. Returns nothing if no power
/// of two brings it into the range, or if a length would be rounded.
std::optional<Pair> fitted(const Pair& pair, const SizeRange& range);

}  // namespace cyl
