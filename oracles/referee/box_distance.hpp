// SPDX-License-Identifier: MIT
// The signed distance of a pair with a box and no half-space.
#pragma once

#include "oracles/referee/referee.hpp"

namespace cyl {

/// As attain_distance(). The verdict only cuts the enclosure at 0. Its width is the one asked for or 2^-52 of
/// the pair's reach. It is wider if the cap on cells ends the search. For 1 in 400 gaps near 1e-12 of the
/// size it is up to 1e-11 of the size. Cost: 20 us, up to 6 ms if many directions have the same depth.
AttainedDistance attain_box(const Pair& pair, Verdict verdict, double relative_width);

/// In long double. For a legal pair. Cost: 15 us.
MeasuredDistance measure_box(const Pair& pair, bool with_points);

}  // namespace cyl
