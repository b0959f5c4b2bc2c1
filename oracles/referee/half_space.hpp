// SPDX-License-Identifier: MIT
// The referee for a half-space and a bounded solid. Nothing is searched: with the outward normal n, a point p
// of the plane, and the support h of the solid about its centre c,
//     f = h(n) - n.(c - p)
// is |n| times minus the signed distance. It is a sum of three roots, so its sign is always decided, and
// touching pairs are too.
#pragma once

#include "oracles/referee/referee.hpp"

namespace cyl {

/// The sign of f, exactly: 1 overlapping, 0 touching, -1 disjoint. The pair is legal and has a half-space.
/// Cost: 0.3 us, 10 us near touching.
int half_space_sign(const Pair& pair);

/// The normal as a direction from a to b. No other direction, but multiples of it, can separate.
Vector3 direction_of_half_space(const Pair& pair);

/// The verdict with its certificate. Its kinds are those of other pairs: the normal, a point, two points, or
/// points within 2^-200 of the size. If an overlap needs more than precision_cap bits to show a point, it has
/// no certificate. Cost: 5 us for overlaps.
Truth judge_half_space(const Pair& pair);

/// The enclosure has two neighbouring doubles, or one double if it is the distance.
AttainedDistance attain_half_space(const Pair& pair);

/// In 128 bits. For a legal pair.
MeasuredDistance measure_half_space(const Pair& pair);

}  // namespace cyl
