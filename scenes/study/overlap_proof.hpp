// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "scenes/scene.hpp"

namespace cyl {

/// Returns whether two bodies that overlap or touch in one configuration are proved to do so in every one.
/// There is no proof for bounds of meshes, and if a joint between the bodies is held.
bool overlap_always(const Scene& scene, std::size_t a, std::size_t b);

}  // namespace cyl
