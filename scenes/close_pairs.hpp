// SPDX-License-Identifier: MIT
// All close pairs of many cylinders that stand still: a tree of boxes, then the model hierarchy.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scenes/scene_study.hpp"

namespace cyl {

/// The levels that save more than they cost in a crowd of close pairs (a capsule costs more than the
/// cylinder).
inline constexpr std::array<Level, 4> crowd_levels{Level::sphere, Level::cylinder, Level::distance,
                                                   Level::certified};

struct ClosePairs {
  std::size_t bodies = 0;
  std::size_t candidates = 0;  ///< pairs whose boxes overlap
  std::array<std::size_t, level_count> decided{};
  std::size_t undecided = 0;  ///< by no level: taken for within
  std::vector<std::pair<std::uint32_t, std::uint32_t>> within;
  std::optional<Verification> verification;            ///< of all candidates
  double prepare_ms = 0, tree_ms = 0, cascade_ms = 0;  ///< CPU time
};

/// Returns the pairs of valid cylinders within the clearance, lower index first, sorted. To verify, the
/// referee is asked about all pairs whose boxes meet.
ClosePairs find_close_pairs(std::span<const Cylinder> cylinders, double clearance, bool verify = false);

}  // namespace cyl
