// SPDX-License-Identifier: MIT
// Solids grown by balls, as intersect(), decide() and distance() pass them on. The room is how near the
// solids without their rounding may come: both roundings and the clearance. Room > 0, both solids valid. It
// also covers a sum of roundings that overflows to infinity.
#pragma once

#include "solver/distance.hpp"

namespace cyl {

double contact_distance_of(const Prepared& a, const Prepared& b, double clearance) noexcept;
Verdict intersect_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept;
Answer decide_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept;
/// For the solids without their rounding, which must be 0 in both.
Distance distance_of_cores(const Prepared& a, const Prepared& b) noexcept;

}  // namespace cyl
