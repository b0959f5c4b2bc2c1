// SPDX-License-Identifier: MIT
// Pairs whose numbers are exact: small integers, what touches but for less than doubles show, and the ends of
// the doubles' range. The last two lead the solver and the referee where no other family does
// (tools/untaken_branches.py).
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

/// Draws two such solids, one turned by a dust; by index the dust runs fastest, then the shapes: two cubes,
/// two disks, two needles, a disk and a needle.
Pair draw_beside_lattice(RandomStream& stream, std::uint64_t index);

/// Draws, by index: two points at one place or one unit apart, rods that cross beyond the largest double,
/// solids whose centres' difference is no double, and small integers of the smallest double.
Pair draw_range_end(RandomStream& stream, std::uint64_t index);

/// Draws two solids that touch exactly, one of them then moved by 2^-300 to 2^-900: by index, ends of
/// segments, a point and a segment, a point on a rim, the ends of tilted segments, a cap on a cap; and last
/// a disk and one nearly as thin about the same centre.
Pair draw_whisker(RandomStream& stream, std::uint64_t index);

}  // namespace cyl
