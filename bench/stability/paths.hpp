// SPDX-License-Identifier: MIT
// How steadily a method answers along paths of pairs: through touching, and through parallel, perpendicular
// and coaxial axes at a distance that does not change. A path's distances and the direction they are attained
// in are known by construction, but for rounding.
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

/// Returns the paths of a seed, as a pure function of it. For each two features that touch in general
/// position, and parallel sides: b moves along the normal, from an overlap of 1e-3 of the size to a gap of
/// that, by decades down to 1e-15
/// ("touching .."); and by steps of 2e-15 of the size about touching ("touching-fine .."), each above what
/// rounding moves. Then, at a gap and at an overlap of path_margin, axes whose angle goes from 1e-2 through 0
/// to -1e-2
/// ("parallel-..", exactly parallel in the middle) or likewise from a right angle ("perpendicular-.."),
/// turned about the normal (".. -cross") or against it (".. -tilt", where a rim is next on either side of
/// it); and caps face to face whose axes are moved across, through one line ("coaxial ..").
std::vector<Path> make_paths(std::uint64_t seed);

/// How steady one method is on one path, at the worst of all seeds.
struct PathStability {
  struct TracePoint {
    double at;
    Verdict verdict;
    std::optional<double> distance;
  };
  std::string method, path;
  std::size_t steps = 0;  ///< of a path
  std::size_t said = 0;   ///< verdicts on them
  /// Changes between disjoint and not. What is undecided, declined or failed is passed over.
  std::size_t flips = 0;
  /// How much farther, relative to the size, the distances it told of two neighbours are apart than the
  /// pairs' own.
  std::optional<double> distance_jump;
  /// Between the directions it told of two neighbours. The one in which the distance is attained is the same
  /// all the way; a method that only separates may choose another, more freely the wider the gap.
  std::optional<double> direction_jump_degrees;
  /// What it said on the first seed with most flips, where these are more than right: where it flips, and
  /// evenly between, at most trace_cap points.
  std::vector<TracePoint> trace;
};

inline constexpr std::size_t trace_cap = 40;
/// Two seeds: a path of one is of one pair of shapes.
inline constexpr std::uint64_t path_seeds = 2;

/// Returns the stability of one method whose answers along a path are given.
PathStability stability_along(const Path& path, std::string_view method,
                              std::span<const MethodAnswer> answers);

/// Returns the stability by method and path; paths on which a method said nothing are left out. Foreign
/// methods are contained; one that hangs often is not asked on. Costly methods are asked on the first seed
/// alone. Cost: 3,180 questions to each method a seed.
std::vector<PathStability> path_stability(std::span<const std::unique_ptr<Method>> methods,
                                          std::uint64_t seeds = path_seeds);

nlohmann::json paths_json(std::span<const PathStability> paths);

}  // namespace cyl
