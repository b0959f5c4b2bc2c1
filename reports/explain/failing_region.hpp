// SPDX-License-Identifier: MIT
// From one pair on which a method fails: how far each parameter can be moved, all else kept, before it stops
// failing in that way.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/enum_words.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

enum class Parameter : unsigned char {
  distance,  ///< signed, a length: b moves along the direction of the distance. Values are those that the
             ///< referee encloses
  angle,  ///< between the lines of the axes, radians: b is turned about its centre in the plane of both. The
          ///< lines of a box are those of its edges; the two most nearly parallel lines are taken
  radius_a,
  height_a,
  radius_b,
  height_b,
  first_edge_a,  ///< of boxes, which have no radius and height
  second_edge_a,
  third_edge_a,
  first_edge_b,
  second_edge_b,
  third_edge_b
};
constexpr auto words_of(Parameter) noexcept {
  return std::array{"signed distance", "angle",           "radius of a",      "height of a",
                    "radius of b",     "height of b",     "first edge of a",  "second edge of a",
                    "third edge of a", "first edge of b", "second edge of b", "third edge of b"};
}

/// One side of a region. The failure ends between the two values. Each is of a pair that was asked and
/// judged. The samples are the values that were tried outwards at first, each a factor of region_step from
/// the next.
struct RegionEnd {
  double fails_at = 0;            ///< the farthest value at which it was seen to fail
  Trial failing;                  ///< there
  std::optional<double> ends_at;  ///< the nearest value beyond; empty if it fails as far as was tried
  std::optional<Trial> beyond;    ///< there
  unsigned failing_samples = 0;   ///< inside, without the pair's own value
  unsigned right_samples = 0;     ///< beyond, with the same true verdict
  bool fails_beyond = false;      ///< a sample beyond fails again
};

/// Around the pair's own value. Failures beyond an end are not looked for: the region may have holes that no
/// question fell into, and others may follow.
struct FailingRegion {
  Parameter parameter;
  double at;  ///< the pair's own value
  RegionEnd low, high;
};

/// Values are tried outwards from the pair's own by this factor (angles: by their distances from parallel and
/// from perpendicular). Then the step at which the failure ends is
/// bisected until its ends are this share apart, or this often.
inline constexpr double region_step = 2, region_share = 0.01;
inline constexpr int region_rounds_cap = 6;

/// Distance, angle, the lengths of a and of b. A parameter that cannot move has both ends at
/// its own value. (A flat solid's height may grow, an axis without the other's plane may not turn.) If angle
/// or lengths move, b follows along the direction of the distance, so that the signed distance stays. If it
/// is 0, b stays. Cost: about 400 pairs in the first round and 100 in each of the others. Deterministic.
std::vector<FailingRegion> failing_regions(const std::unique_ptr<Method>& method, const Trial& failing);

}  // namespace cyl
