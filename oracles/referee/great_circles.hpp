// SPDX-License-Identifier: MIT
// The least value of f over the unit directions at which a depth can be attained, if a solid is a box.
#pragma once

#include <cstddef>

#include "corpus/pairs/support.hpp"
#include "oracles/referee/box_search.hpp"

namespace cyl {

/// f(D) is the support of K = (core of a) - (core of b), both about their centres, less D.delta.
struct CorePair : TermsPair<long double> {               ///< at least one is a box; no half-space
  long double value(const Vec3<long double>& d) const {  ///< f of a unit direction
    return core_support(a, d) + core_support(b, d) - dot(d, delta);
  }
};

/// `best` is f(direction). On the circles and at the disk's axis, f is nowhere less than `floor`. If K holds
/// delta, it is nowhere less at all.
struct LeastOnCircles {
  long double best = 0, floor = 0;
  Vec3<long double> direction{};
  std::size_t cells = 0;  ///< arcs that were bounded
};

/// Narrows best - floor to `width`, or until so many arcs were bounded. Both are right up to the rounding of
/// some hundred operations on lengths of the pair. Cost: 10 us.
LeastOnCircles least_on_circles(const CorePair& pair, long double width, std::size_t most_cells);

}  // namespace cyl
