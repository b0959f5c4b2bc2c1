// SPDX-License-Identifier: MIT
// Pairs of solids grown by balls: spheres, capsules, rounded cylinders, and these with cylinders.
#pragma once

#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// Draws by index, in turns of four.
/// 1. The first pair is in any position. About half of these intersect.
/// 2. The second has a gap and the third an overlap by construction, at a margin of 1e-1 to 1e-15. Rounding
///    moves the margin by up to 5e-16 of the size.
/// 3. The fourth is in turn a pair of small integers, which may touch exactly, and an awkward pair. That has
///    solids on one line or about one centre, other scales, or tiny lengths or roundings.
/// It is random which solid is `a`.
Pair draw_rounded(SolidKind a, SolidKind b, RandomStream& stream, std::uint64_t index);

/// Draws pairs like the second and the third, of random kinds. One solid is up to a million times smaller.
Pair draw_unequal(RandomStream& stream, std::uint64_t index);

}  // namespace cyl
