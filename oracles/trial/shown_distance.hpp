// SPDX-License-Identifier: MIT
// The distance that the solver's own points and direction show, in long double and whatever the solver thinks
// of them: cheaper than an enclosure, and narrower where they are good.
#pragma once

#include "corpus/pairs/certificate.hpp"
#include "solver/distance.hpp"

namespace cyl {

/// Returns bounds of the signed distance of a legal pair, of which `measured` is the solver's: apart both are
/// shown; overlapping `hi` is 0, so that no depth is shown, but none is more than -lo. Wide or not finite
/// where points or direction are no good. Cost: 0.3 us.
Enclosure shown_distance(const Pair& pair, const Distance& measured);

}  // namespace cyl
