// SPDX-License-Identifier: MIT
// Pairs with exact numbers: small integers, pairs that touch up to less than doubles can show, and the ends
// of the range of doubles. The last two reach branches of the solver and the referee that no other family
// reaches (tools/untaken_branches.py).
#pragma once

#include <array>
#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// Small angles in radians, or small lengths.
inline constexpr std::array<double, 7> dusts{0, 1e-16, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3};

/// Draws two solids of small integers.
Pair draw_on_lattice(RandomStream& stream, std::uint64_t index);

/// Draws two such solids, one turned by a tiny angle. By index the angle changes fastest, then the shapes:
/// two cubes, two disks, two needles, a disk and a needle.
Pair draw_beside_lattice(RandomStream& stream, std::uint64_t index);

/// Draws, by index: two points at one place or one unit apart, rods that cross beyond the largest double,
/// solids with centres whose difference is not a double, and small multiples of the smallest double.
Pair draw_range_end(RandomStream& stream, std::uint64_t index);

/// Draws two solids that touch exactly and moves one of them by 2^-300 to 2^-900. By index: ends of segments,
/// a point and a segment, a point on a rim, the ends of tilted segments, a cap on a cap, and a disk and one
/// nearly as thin about the same centre.
Pair draw_whisker(RandomStream& stream, std::uint64_t index);

}  // namespace cyl
