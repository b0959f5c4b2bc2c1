// SPDX-License-Identifier: MIT
// The hulls of flat solids, as the checks of certificates use them.
#pragma once

#include <cstddef>

#include "oracles/referee/certificate_check.hpp"
#include "solver/solid.hpp"

namespace cyl {

// A Hull is a set of coordinates that are 0 in it: bit 1 along the axis, bit 2 across it.
static_assert(static_cast<int>(Hull::plane) == 1 && static_cast<int>(Hull::line) == 2 &&
              static_cast<int>(Hull::center) == 3);
inline bool level(Hull hull) { return (static_cast<int>(hull) & 1) != 0; }
inline bool thin(Hull hull) { return (static_cast<int>(hull) & 2) != 0; }
inline Hull both(Hull x, Hull y) { return static_cast<Hull>(static_cast<int>(x) | static_cast<int>(y)); }

/// A flat box has the hull of a disk, segment or point.
Hull own_hull(const Solid& c);

/// The own hull and the named one. The hull that an answer names for a box counts for nothing.
Hull hull_within(const Solid& c, Hull named);

/// The edge that gives the direction of a flat box's hull: its only edge that is 0, or is not 0.
std::size_t hull_edge(const Solid& box);

/// The normal of the hull if that is a plane, its direction if it is a line.
Rational3 hull_axis(const Solid& c);

}  // namespace cyl
