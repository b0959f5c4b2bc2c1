// SPDX-License-Identifier: MIT
// Finds the overlapping ones of many boxes, by FCL's tree of boxes. On random rods, one build and query took
// 6 ms for 10,000 and 84 ms for 100,000 (Bullet's btDbvt took 7 ms and 160 ms). For 200 bodies it took 40 us,
// but comparing all balls takes 13 us; for 1000 bodies 340 us and 300 us. So studies, which have at most 1000
// bodies, do without the tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "solver/decide.hpp"

namespace cyl {

struct Box {
  Vector3 low, high;
};

/// Around a valid cylinder, wider by half the clearance and by what rounding may do to it.
Box box_around(const Prepared& c, double clearance) noexcept;

/// All pairs of boxes that have a common point, each once, the lower index first. If there are more than
/// `most`, it ends with `most` + 1 of them. Cost: about n log n, as long as few overlap.
std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::span<const Box> boxes, std::size_t most);

}  // namespace cyl
