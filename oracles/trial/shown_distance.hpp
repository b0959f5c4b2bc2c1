// SPDX-License-Identifier: MIT
// The distance that the solver's own points and direction show, in long double. The solver's value and error
// bound are not used. It is cheaper than an enclosure, and narrower if the points and the direction are good.
#pragma once

#include "corpus/pairs/certificate.hpp"
#include "solver/distance.hpp"

namespace cyl {

/// Returns bounds of the signed distance of a legal pair. `measured` is the solver's distance of the pair.
/// 1. Apart: both bounds are shown.
/// 2. Overlapping: `hi` is 0, so no depth is shown, but the depth is at most -lo.
/// 3. The bounds are wide or not finite if the points or the direction are bad.
/// Cost: 0.3 us.
Enclosure shown_distance(const Pair& pair, const Distance& measured);

}  // namespace cyl
