// SPDX-License-Identifier: MIT
// Pairs with exact numbers: small integers, pairs that touch up to less than doubles can show, and the ends
// of the range of doubles. The last two reach branches of the solver and the referee that no other family
// reaches.
#pragma once

#include <array>
#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Small angles in radians, or small lengths.
inline constexpr std::array<double, 7> dusts{0, 1e-16, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3};

/// Draws two solids of small integers.
Pair draw_on_lattice(RandomStream& stream, std::uint64_t index);

/// Draws two such solids, one turned by a tiny angle. By index the angle changes fastest, then the shapes:
/// two cubes, two disks, two needles, a disk and a needle.
Pair draw_beside_lattice(RandomStream& stream, std::uint64_t index);

/// Draws one of these, by index:
/// 1. two points at one place or one unit apart,
/// 2. rods that cross beyond the largest double,
/// 3. solids with centres whose difference is not a double,
/// 4. small multiples of the smallest double.
Pair draw_range_end(RandomStream& stream, std::uint64_t index);

/// Draws two solids that touch exactly and moves one of them by 2^-300 to 2^-900. The solids depend on the
/// index:
/// 1. ends of segments,
/// 2. a point and a segment,
/// 3. a point on a rim,
/// 4. the ends of tilted segments,
/// 5. a cap on a cap,
/// 6. a disk and one nearly as thin about the same centre.
Pair draw_whisker(RandomStream& stream, std::uint64_t index);

}  // namespace cyl
