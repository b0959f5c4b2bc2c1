// SPDX-License-Identifier: MIT
// The least value of f over the unit directions at which a depth can be attained, if a solid is a box.
#pragma once

#include <cstddef>

#include "corpus/pairs/support.hpp"
#include "oracles/referee/box_search.hpp"

namespace cyl {

/// The square of a length below this has lost digits, or is 0. Such a vector counts as 0. Lengths are in the
/// unit of terms_in_unit(), and all that this and underflow change is less than `short_error`.
inline constexpr double short_tol = 0x1p-450, short_error = 0x1p-400;

/// f(D) is the support of K = (core of a) - (core of b), both about their centres, less D.delta.
struct CorePair : TermsPair<double> {          ///< at least one is a box; no half-space
  double value(const Vec3<double>& d) const {  ///< f of a unit direction
    return core_support(a, d) + core_support(b, d) - dot(d, delta);
  }
};

/// `best` is f(direction). On the circles and at the disk's axis, f is nowhere less than `floor`. If K holds
/// delta, it is nowhere less at all.
struct LeastOnCircles {
  double best = 0, floor = 0;
  Vec3<double> direction{};
  std::size_t cells = 0;  ///< arcs that were bounded
};

/// Narrows best - floor to `width`, or until so many arcs were bounded. Both are right up to the rounding of
/// some hundred operations on lengths of the pair. Cost: 3 us.
LeastOnCircles least_on_circles(const CorePair& pair, double width, std::size_t most_cells);

}  // namespace cyl
