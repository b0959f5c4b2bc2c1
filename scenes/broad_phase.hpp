// SPDX-License-Identifier: MIT
// Which of many boxes overlap: FCL's tree of boxes. On random rods, built anew and asked, it took 6 ms of
// 10,000 and 84 ms of 100,000 (Bullet's btDbvt 7 ms and 160 ms); of 200 bodies, 40 us, where comparing all
// balls takes 13 us; of 1000, 340 us against 300 us. So no tree is asked of fewer than study_cap.
#pragma once

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

/// All pairs of boxes that have a common point, each once, the lower index first. Cost: about n log n, as
/// long as few overlap.
std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::span<const Box> boxes);

}  // namespace cyl
