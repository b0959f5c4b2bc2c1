// SPDX-License-Identifier: MIT
// The nearest pairs of many cylinders, with what proves whether each is within the clearance.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scenes/near/close_pairs.hpp"

namespace cyl {

/// A pair, the lower index first. `value` and `error` of the distance are those of solver/distance.hpp.
struct NearPair {
  PairOfBodies bodies;
  double distance = 0, error = 0;  ///< negative: minus the depth of the overlap
  Vector3 on_a, on_b;              ///< the nearest, or the deepest points
  bool within = false;             ///< as was answered
  Proof proof = Proof::none;       ///< the solver's certificate
};

/// Returns the nearest pairs whose boxes meet, by distance and then by index, at most `count`. If they are
/// farther apart than the clearance, other pairs whose boxes do not meet may be nearer. Cost: the distance of
/// every such pair, some 1 us each.
std::vector<NearPair> nearest_pairs(std::span<const Solid> cylinders, double clearance,
                                    const ClosePairs& answered, std::size_t most);

}  // namespace cyl
