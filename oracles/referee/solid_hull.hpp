// SPDX-License-Identifier: MIT
// The hulls of flat solids, as the checks of certificates use them.
#pragma once

#include <cstddef>

#include "oracles/referee/certificate_check.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// A flat box has the hull of a disk, segment or point.
Hull own_hull(const Solid& c);

/// The own hull and the named one. The hull that an answer names for a box counts for nothing.
Hull hull_within(const Solid& c, Hull named);

/// The edge that gives the direction of a flat box's hull: its only edge that is 0, or is not 0.
std::size_t hull_edge(const Solid& box);

/// The normal of the hull if that is a plane, its direction if it is a line.
Rational3 hull_axis(const Solid& c);

}  // namespace cyl
