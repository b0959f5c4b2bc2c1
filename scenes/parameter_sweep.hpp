// SPDX-License-Identifier: MIT
// All close pairs of many cylinders that stand still: a tree of boxes, then the ladder.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scenes/model_hierarchy.hpp"
#include "scenes/scene_study.hpp"

namespace cyl {

struct SceneSweep {
  std::size_t bodies = 0;
  std::size_t candidates = 0;  ///< pairs whose boxes overlap
  std::array<std::size_t, rung_count> decided{};
  std::size_t undecided = 0;  ///< by no rung: taken for within
  std::vector<std::pair<std::uint32_t, std::uint32_t>> within;
  std::optional<Verification> verification;           ///< of all candidates
  double prepare_ms = 0, tree_ms = 0, ladder_ms = 0;  ///< CPU time
};

/// The plan: sphere, then cylinder, then what is exact. Needs valid cylinders. To
/// verify, the referee is asked of all pairs whose boxes meet.
SceneSweep sweep_scene(std::span<const Cylinder> cylinders, double clearance, bool verify = false);

/// A line for people; `sweep_head` names the columns.
std::string sweep_head();
std::string sweep_line(const SceneSweep& sweep);
std::string sweep_json(const SceneSweep& sweep);

}  // namespace cyl
