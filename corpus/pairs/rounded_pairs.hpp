// SPDX-License-Identifier: MIT
// Pairs of solids grown by balls: spheres, capsules, rounded cylinders, and these with cylinders.
#pragma once

#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Draws by index, in turns of four.
/// 1. The first pair is in any position. About half of these intersect.
/// 2. The second has a gap and the third an overlap by construction, at a margin of 1e-1 to 1e-15. Rounding
///    moves the margin by up to 5e-16 of the size.
/// 3. The fourth is in turn a pair of small integers, which may touch exactly, and an awkward pair. That has
///    solids on one line or about one centre, other scales, or tiny lengths or roundings.
/// It is random which solid is `a`.
Pair draw_rounded(SolidKind a, SolidKind b, RandomStream& stream, std::uint64_t index);

enum class HalfSpaceKind : unsigned char { tilted, thin, far, scaled_normal };
/// Draws a half-space and a solid near touching, at margins of 1e-1 to 1e-15, then changes it.
/// 1. tilted: the normal is along the axis or square to it, within 1e-3 rad.
/// 2. thin: a radius or a height is 0, or up to 1e-15 of the other.
/// 3. far: both are up to 1e12 from the origin, and the point of the plane from the solid.
/// 4. scaled_normal: the length of the normal is 1e-300 to 1e300.
Pair draw_half_space(HalfSpaceKind kind, RandomStream& stream, std::uint64_t index);

/// Draws pairs like the second and the third, of random kinds. One solid is up to a million times smaller.
Pair draw_unequal(RandomStream& stream, std::uint64_t index);

}  // namespace cyl
