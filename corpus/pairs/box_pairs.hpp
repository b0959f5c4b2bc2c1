// SPDX-License-Identifier: MIT
// Pairs with a box at the boundaries that boxes have: edges and facets in parallel, stacks, flat boxes,
// quaternions of any length.
#pragma once

#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// If a kind names a margin, even indices have it as a gap, and odd ones as an overlap, which may be less
/// deep. It is 1e-1 to 1e-15, and rounding moves it by up to 1e-15 of the size.
enum class BoxKind : unsigned char {
  edges,    ///< an edge meets an edge, a side or a segment, at a margin. They are 1 to 1e-15 rad from
            ///< parallel, or square. Half of the contacts are at the corners. Only the direction square to
            ///< both shows the gap
  flush,    ///< a facet meets a facet, an edge, a cap or a side, 1e-2 to 1e-15 rad from flat or flat, at a
            ///< margin
  stacked,  ///< boxes turned alike, equal or not, one at the other's facet, edge or corner, at a margin, or
            ///< touching but for rounding, or about one centre
  nested,   ///< a solid of 1e-1 to 1e-12 of the box's size, inside or through the surface at a margin. So
            ///< overlaps have every decade
  thin,     ///< one, two or three edges are 0, or 1e-16 to 1e-3 of what they were, and in half of the pairs
            ///< a length of the other solid. Half of them are at a margin
  lattice,  ///< small integers and quarter turns. A third touch exactly or are beside each other, a third
            ///< are turned by 1e-16 to 1e-3, and in a third a coordinate is the next double
  far,      ///< at a margin, 1e2 to 1e12 from the origin. A half-space may be as far from the box
  quaternion,  ///< at a margin, quaternions of length 1e-300 to 1e300 and of either sign
};

/// Draws a box and a solid of any kind that fits. It is random which is `a`.
Pair draw_with_box(BoxKind kind, RandomStream& stream, std::uint64_t index);

}  // namespace cyl
