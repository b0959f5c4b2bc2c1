// SPDX-License-Identifier: MIT
// The configurations of a study that the page shows: the position of every body, the distance of each pair,
// and the models that are wrong.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/enum_words.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {

enum class Reason : unsigned char {
  first,    ///< one of the first drawn
  closest,  ///< the study's closest call
  alarm,    ///< the worst false alarm of an accepted model
  missed    ///< what such a model misses by most
};
constexpr auto words_of(Reason) noexcept {
  return std::array{"drawn first", "closest call", "false alarm", "missed"};
}

/// The reason to show a configuration.
struct Highlight {
  Reason reason = Reason::first;
  std::size_t pair = 0;        ///< of the study's pairs; all but `first`
  Level model = Level::outer;  ///< `alarm` and `missed`
  /// How far beyond the clearance. For `closest` it is negative if below. For `missed` it is how far below.
  double length = 0;
};

/// One pair in one configuration.
struct Sample {
  double distance = 0;                   ///< negative: the depth
  Vector3 on_a{0, 0, 0}, on_b{0, 0, 0};  ///< nearest points, or deepest
  bool within = false;  ///< proved, but for what the referee does not prove: taken for within
  std::array<bool, level_count> wrong{};  ///< the models that answer otherwise
};

struct Shown {
  std::size_t configuration = 0;
  std::vector<Highlight> highlights;
  std::vector<double> joints;
  std::vector<Cylinder> placed;  ///< by body
  std::vector<Sample> pairs;     ///< by the study's pairs
};

/// Configurations drawn first that are shown, and worst pairs of each model.
inline constexpr std::size_t first_shown_cap = 2, worst_shown_cap = 2;

/// Returns each configuration once, in the order of the reasons: drawn first, closest, then the models from
/// the cheapest on. Costs a few microseconds a pair and configuration.
std::vector<Shown> shown_configurations(const Scene& scene, const SceneOptions& question,
                                        const SceneStudy& study);

}  // namespace cyl
