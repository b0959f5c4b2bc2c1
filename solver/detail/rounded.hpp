// SPDX-License-Identifier: MIT
// Solids grown by balls, as intersect(), decide() and distance() pass them on. The room is how near the
// solids without their rounding may come: both roundings and the clearance. Room > 0, both solids valid. It
// also covers a sum of roundings that overflows to infinity.
#pragma once

#include "solver/distance.hpp"

namespace cyl {

double contact_distance_of(const Prepared& a, const Prepared& b, double clearance) noexcept;
Verdict intersect_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept;
/// If the solids are not moderate, but would be at another scale, sets the verdict at that scale and returns
/// true. So one computation decides a pair at all its scales. Other computations may differ from it within
/// rounding of touching.
bool intersect_at_moderate_scale(const Prepared& a, const Prepared& b, double clearance,
                                 Verdict& verdict) noexcept;
Answer decide_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept;
/// For the solids without their rounding, which must be 0 in both.
Distance distance_of_cores(const Prepared& a, const Prepared& b) noexcept;

}  // namespace cyl
