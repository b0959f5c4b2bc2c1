// SPDX-License-Identifier: MIT
// Pairs of solids of given kinds: spheres, capsules, cylinders, half-spaces and boxes, rounded or not.
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
/// It is random which solid is `a`. In a pair without a box, no overlap is deeper than both roundings.
Pair draw_rounded(SolidKind a, SolidKind b, RandomStream& stream, std::uint64_t index);

/// Draws the lengths of a solid of this kind by `length`, and its directions.
Solid draw_kind(SolidKind kind, RandomStream& stream, double (*length)(RandomStream&));
/// From 0.5 to 2.
double draw_moderate(RandomStream& stream);
/// Puts b around a. The centres are apart by up to 0.9 of the radii of the balls around the solids.
void put_anywhere(RandomStream& stream, Pair& pair);
/// Turns and puts solids as the second pair has them (even index) or the third, with any part of a box at the
/// contact. An overlap may be less deep than its margin, and one of 1e-1 may be none.
Pair put_near(Pair pair, RandomStream& stream, std::uint64_t index);
/// Draws such a pair with moderate lengths. b is `b_to_a` times as large.
Pair draw_near(SolidKind a, SolidKind b, RandomStream& stream, std::uint64_t index, double b_to_a = 1);

/// Moves both up to 1e12 from the origin, and the point of a half-space from the solid in half of the pairs.
void move_far(Pair& pair, RandomStream& stream);

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
