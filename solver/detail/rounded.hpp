// SPDX-License-Identifier: MIT
// Solids grown by balls, as intersect(), decide() and distance() pass them on. The contact
// distance is how near the solids without their rounding may come: both roundings and the clearance. It is >
// 0, and infinite if their sum overflows. Both solids are valid.
#pragma once

#include <limits>

#include "solver/distance.hpp"

namespace cyl {

inline double contact_distance_of(const Prepared& a, const Prepared& b, double clearance) noexcept {
  return (a.rounding + b.rounding) + clearance;
}
inline bool is_valid_question(const Prepared& a, const Prepared& b, double clearance,
                              double contact_distance) noexcept {
  return (a.defect == Defect::none) & (b.defect == Defect::none) & (clearance >= 0) &
         (contact_distance >= 0) & (contact_distance <= std::numeric_limits<double>::max());
}
Verdict intersect_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept;
/// If the solids are not moderate, but would be at another scale, sets the verdict at that scale and returns
/// true. So one computation decides a pair at all its scales. Other computations may differ from it within
/// rounding of touching.
bool intersect_at_moderate_scale(const Prepared& a, const Prepared& b, double clearance,
                                 Verdict& verdict) noexcept;
Answer decide_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept;
/// For the solids without their rounding, which must be 0 in both. `grows`: they are about to grow, so that
/// direction and points must belong together.
Distance distance_of_cores(const Prepared& a, const Prepared& b, bool grows) noexcept;

/// From a unit of 2^exponent.
void bring_to_scene(Distance& out, int exponent) noexcept;

}  // namespace cyl
