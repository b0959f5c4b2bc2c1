// SPDX-License-Identifier: MIT
// The configurations of a study that are worth a look, and what is seen in each: where everything is, how
// near each pair, and which models alone are wrong about it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/enum_words.hpp"
#include "scenes/scene_study.hpp"

namespace cyl {

enum class Why : unsigned char {
  first,    ///< one of the first drawn
  closest,  ///< the study's closest call
  alarm,    ///< the worst false alarm of a model that is trusted alone
  missed    ///< what such a model misses by most
};
constexpr auto words_of(Why) noexcept {
  return std::array{"drawn first", "closest call", "false alarm", "missed"};
}

struct Reason {
  Why why = Why::first;
  std::size_t pair = 0;      ///< of the study's pairs; all but `first`
  Rung model = Rung::outer;  ///< `alarm` and `missed`
  double length = 0;  ///< how far beyond (closest: or below, then negative) the clearance; missed: below
};

/// One pair in one configuration.
struct SeenPair {
  double distance = 0;                   ///< negative: the depth
  Vector3 on_a{0, 0, 0}, on_b{0, 0, 0};  ///< nearest points, or deepest
  bool within = false;  ///< proved, but for what the referee does not prove: taken for within
  std::array<bool, rung_count> wrong{};  ///< the models that say something else
};

struct Kept {
  std::size_t configuration = 0;
  std::vector<Reason> reasons;
  std::vector<double> joints;
  std::vector<Cylinder> placed;  ///< by body
  std::vector<SeenPair> pairs;   ///< by the study's pairs
};

/// Configurations drawn first that are kept, and worst pairs of each model.
inline constexpr std::size_t first_kept_cap = 2, worst_kept_cap = 2;

/// In the order of the reasons: drawn first, closest, then the models from the cheapest on. A few
/// microseconds a pair and configuration.
std::vector<Kept> kept_configurations(const Scene& scene, const SceneQuestion& question,
                                      const SceneStudy& study);

}  // namespace cyl
