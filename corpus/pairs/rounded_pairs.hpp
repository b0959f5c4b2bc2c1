// SPDX-License-Identifier: MIT
// Pairs of solids grown by balls: spheres, capsules, rounded cylinders, and these with cylinders.
#pragma once

#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// By index, four in turn: two that lie anywhere, about half of such pairs intersecting; two at a margin of
/// 1e-1 to 1e-15 by construction, a gap and then an overlap (rounding moves it by up to 5e-16 of the size);
/// last, in turn, small integers, some of which touch exactly, and solids in line, about one centre, of other
/// scales, with a length or a rounding that is next to nothing. Which of the two is `a` is drawn.
Pair draw_rounded(SolidKind a, SolidKind b, RandomStream& stream, std::uint64_t index);

}  // namespace cyl
