// SPDX-License-Identifier: MIT
// The distance that points and a direction show. A measured value is not used. It is cheaper than an
// enclosure, and narrower if the points and the direction are good.
#pragma once

#include "oracles/referee/box_search.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/referee/twin_interval.hpp"

namespace cyl {

/// Returns bounds of the signed distance of a legal pair. `measured` has the points and the direction. They
/// are not used if there is a half-space, since a formula has the distance.
/// 1. Apart: both bounds are shown.
/// 2. Overlapping: `hi` is 0, so no depth is shown, but the depth is at most -lo.
/// 3. The bounds are wide or not finite if the points or the direction are bad.
/// Cost: 1 us.
Enclosure shown_distance(const Pair& pair, MeasuredDistance measured);

/// The same for bounded solids, in the unit of terms_in_unit(). Each point is seen from the centre of its
/// solid. How far it is outside the core is added. `hi` may be below 0.
struct ShownBounds {
  Twin lo, hi;
  Enclosure in_scene(int exponent) const;  ///< rounded outward
};
ShownBounds shown_bounds(const TermsPair<Twin>& p, const Vec3<double>& direction, const Vec3<double>& on_a,
                         const Vec3<double>& on_b);

}  // namespace cyl
