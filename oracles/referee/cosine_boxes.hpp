// SPDX-License-Identifier: MIT
// The least value of f over all unit directions, by branch and bound over the two cosines between a direction
// and the axes. f is as in direction_bounds.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "oracles/referee/direction_bounds.hpp"

namespace cyl {

/// The known facts about min f.
struct LeastValue {
  double width;                                           ///< how far apart `floor` and `best` may be
  double best = std::numeric_limits<double>::infinity();  ///< f(direction)
  double floor = -best;                                   ///< f is nowhere less
  Vec direction{};
  std::size_t cells = 0;  ///< parts of the sphere that were bounded

  bool is_found() const { return best - floor <= width; }
  void take(double value, const Vec& d) {
    if (value < best) best = value, direction = d;
  }
  void floor_at(double bound) { floor = std::max(floor, bound); }
};

/// Narrows `least` until it is found or `cosine_box_cap` boxes were bounded. `bounds` is that of p. Both
/// bounds hold within bound_error * bounds.reach(). Cost: 0.1 us for each box, 20 boxes for most pairs that
/// overlap. Returns at once if the axes are nearly parallel.
void narrow_by_cosines(const DirectionBounds& bounds, const SearchPair<double>& p, LeastValue& least);

/// Pairs that need more have a valley, in which cells of the sphere are fewer.
inline constexpr std::size_t cosine_box_cap = 96;

}  // namespace cyl
