// SPDX-License-Identifier: MIT
// The broad phase over motions: a box around all that a body may reach, and the pairs whose boxes meet.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "scenes/scene.hpp"

namespace cyl {

/// Along the axes of the scene's root. A coordinate may be infinite.
struct Box {
  Vector3 low, high;
};

/// Returns a box that holds the body, and the balls and capsules that stand for it, in every configuration,
/// rounding included. It is endless for a half-space, and for a body that a held joint carries.
Box reach_of(const Scene& scene, const Body& body);

/// Returns the greatest gap of two boxes along an axis: what they hold is at least as far apart. Below 0 if
/// they overlap.
double gap_between(const Box& a, const Box& b);

/// Returns all wanted pairs of boxes with a gap of at most the clearance, the lower index first, sorted by
/// the higher index. If there are more than `most`, it ends with more than that. Cost: about n log n, if few
/// are near.
std::vector<std::pair<std::size_t, std::size_t>> near_pairs(
    std::span<const Box> boxes, double clearance, std::size_t most,
    const std::function<bool(std::size_t, std::size_t)>& wanted);

}  // namespace cyl
