// SPDX-License-Identifier: MIT
// Pairs of a box and a solid of any kind that fits, in any order, at the boundaries that boxes have. At a
// margin means 1e-1 to 1e-15 of the size. Even indices have it as a gap, and odd ones as an overlap, which
// may be less deep. Rounding moves it by up to 1e-15 of the size.
#pragma once

#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// An edge meets an edge, a side or a segment, at a margin. They are 1 to 1e-15 rad from parallel, or square.
/// Half of the contacts are at the corners. Only the direction square to both shows the gap.
Pair draw_box_edges(RandomStream& stream, std::uint64_t index);
/// A facet meets a facet, an edge, a cap or a side, 1e-2 to 1e-15 rad from flat or flat, at a margin.
Pair draw_box_flush(RandomStream& stream, std::uint64_t index);
/// Boxes turned alike, equal or not. One is at the other's facet, edge or corner, at a margin or touching
/// except for rounding, or both are about one centre.
Pair draw_box_stacked(RandomStream& stream, std::uint64_t index);
/// A solid of 1e-1 to 1e-12 of the box's size, inside or through the surface at a margin. So overlaps have
/// every decade.
Pair draw_box_nested(RandomStream& stream, std::uint64_t index);
/// One, two or three edges are 0, or 1e-16 to 1e-3 of what they were, and in half of the pairs a length of
/// the other solid. Half of them are at a margin.
Pair draw_box_thin(RandomStream& stream, std::uint64_t index);
/// Small integers and quarter turns. A third touch exactly or are beside each other, a third are turned by
/// 1e-16 to 1e-3, and in a third a coordinate is the next double.
Pair draw_box_lattice(RandomStream& stream, std::uint64_t index);
/// At a margin, 1e2 to 1e12 from the origin. A half-space may be as far from the box.
Pair draw_box_far(RandomStream& stream, std::uint64_t index);
/// At a margin, quaternions of length 1e-300 to 1e300 and of either sign.
Pair draw_box_quaternion(RandomStream& stream, std::uint64_t index);

}  // namespace cyl
