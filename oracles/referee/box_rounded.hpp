// SPDX-License-Identifier: MIT
// The referee for a box and a cylinder with a radius, one of them rounded. Their nearest points are searched
// with more and more bits. Ties are proved by algebra, except for an edge and a rim that are nearest in a
// direction that is not rational.
#pragma once

#include "corpus/pairs/certificate.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Cost: 0.1 ms to some ms.
Truth judge_rounded_box(const Pair& pair, int bits_cap);

}  // namespace cyl
