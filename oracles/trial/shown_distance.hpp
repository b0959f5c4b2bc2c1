// SPDX-License-Identifier: MIT
// The distance that points and a direction show, in long double. A measured value is not used. It is cheaper
// than an enclosure, and narrower if the points and the direction are good.
#pragma once

#include "corpus/pairs/certificate.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

/// Returns bounds of the signed distance of a legal pair. `measured` has the points and the direction. They
/// are not used beside a half-space, for which a formula has the distance.
/// 1. Apart: both bounds are shown.
/// 2. Overlapping: `hi` is 0, so no depth is shown, but the depth is at most -lo.
/// 3. The bounds are wide or not finite if the points or the direction are bad.
/// Cost: 0.3 us.
Enclosure shown_distance(const Pair& pair, const MeasuredDistance& measured);

}  // namespace cyl
