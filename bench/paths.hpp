// SPDX-License-Identifier: MIT
// How steadily a method answers along paths of pairs: through touching, and through parallel, perpendicular
// and coaxial axes at a distance that does not change. A path's distances and the direction along which they
// are attained are known by construction, up to rounding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

/// A pair on a path. f(normal) is minus the distance.
struct PathStep {
  double at;  ///< what the path changes: the margin, the tangent of the axes' angle, or an offset relative to
              ///< the size
  Pair pair;
  double distance;  ///< signed; rounding of the input moves it by up to 1e-15 of the size
};

struct Path {
  std::string name;   ///< "touching side-side", "parallel-tilt overlap", ...
  std::size_t flips;  ///< of the true verdict: 1 through touching, else 0
  std::vector<PathStep> steps;
};

/// Signed margin of the paths on which it does not change.
inline constexpr double path_margin = 1e-7;

/// Returns the paths of a seed, a pure function of the seed.
/// 1. Through touching. Two features are in general position, or two sides are parallel. b moves along the
///    normal, from an overlap of 1e-3 of the size to a gap of that.
///    * "touching ..": by decades down to 1e-15
///    * "touching-fine ..": by steps of 2e-15 of the size about touching, each more than rounding
/// 2. At a gap and at an overlap of path_margin, through a special position of the axes.
///    * "parallel-..": their angle goes from 1e-2 through 0 to -1e-2, and is exactly 0 in the middle
///    * "perpendicular-..": the same from a right angle
///    * ".. -cross": they turn about the normal
///    * ".. -tilt": they turn against it, and a rim comes next on either side
///    * "coaxial ..": caps lie face to face, and the axes move across, through one line
std::vector<Path> make_paths(std::uint64_t seed);

/// How steady one method is on one path, at the worst of all seeds.
struct PathStability {
  std::string method, path;
  std::size_t steps = 0;  ///< of a path
  std::size_t said = 0;   ///< verdicts on them
  /// Changes between disjoint and another verdict. Undecided, declined and failed answers are skipped.
  std::size_t flips = 0;
  /// The largest difference, relative to the size, between the change of the returned distances of two
  /// neighbours and the true change.
  std::optional<double> distance_jump;
  /// The angle between the returned directions of two neighbours. The direction of the distance is the same
  /// along the path. A method that only separates may choose another one, more freely if the gap is wider.
  std::optional<double> direction_jump_degrees;
};

/// Two seeds: a path of one is of one pair of shapes.
inline constexpr std::uint64_t path_seeds = 2;

/// Returns the stability of one method whose answers along a path are given.
PathStability stability_along(const Path& path, std::string_view method,
                              std::span<const MethodAnswer> answers);

/// Returns the stability by method and path. Paths without an answer of a method are left out. Foreign
/// methods are contained, and a method that hangs often is not asked again. Costly methods are asked on the
/// first seed only. Cost: 3,180 pairs for each method and seed.
std::vector<PathStability> path_stability(std::span<const std::unique_ptr<Method>> methods,
                                          std::uint64_t seeds = path_seeds);

nlohmann::json paths_json(std::span<const PathStability> paths);

}  // namespace cyl
