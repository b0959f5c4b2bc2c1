// SPDX-License-Identifier: MIT
// The signed distance of a pair with a box and no half-space.
#pragma once

#include "oracles/referee/referee.hpp"

namespace cyl {

/// As attain_distance(). The verdict only cuts the enclosure at 0. Its width is the one asked for or 2^-44 of
/// the pair's reach. It is wider if the cap on cells ends the search. For 1 in 70,000 pairs it is up to 3e-11
/// of the size. Cost: 2 to 14 us, up to 6 ms if many directions have the same depth.
AttainedDistance attain_box(const Pair& pair, Verdict verdict, double relative_width);

/// For a legal pair. Cost: 2 to 10 us.
MeasuredDistance measure_box(const Pair& pair, bool with_points);

}  // namespace cyl
