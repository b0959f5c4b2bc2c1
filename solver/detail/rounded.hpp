// SPDX-License-Identifier: MIT
// Solids grown by balls, as intersect(), decide() and distance() hand them on: the room is how near the
// solids without their rounding may come: both roundings and the clearance. Room > 0, both solids valid;
// where the sum of the roundings overflows, as infinity, too.
#pragma once

#include "solver/distance.hpp"

namespace cyl {

double contact_distance_of(const Prepared& a, const Prepared& b, double clearance) noexcept;
Verdict intersect_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept;
Answer decide_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept;
/// Of the solids without their rounding, which must be 0 in both.
Distance distance_of_cores(const Prepared& a, const Prepared& b) noexcept;

}  // namespace cyl
