// SPDX-License-Identifier: MIT
// Pairs of solids grown by balls: spheres, capsules, rounded cylinders, and these with cylinders.
#pragma once

#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// By index, in turns of four: two pairs in any position, about half of them intersecting; a pair at a margin
/// of 1e-1 to 1e-15 by construction, first a gap and then an overlap (rounding moves it by up to 5e-16 of the
/// size). The last of four are small integers, some of which touch exactly, solids on one line or about one
/// centre, other scales, and tiny lengths or roundings. It is random which solid is `a`.
Pair draw_rounded(SolidKind a, SolidKind b, RandomStream& stream, std::uint64_t index);

}  // namespace cyl
