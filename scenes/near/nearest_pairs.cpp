// SPDX-License-Identifier: MIT
#include "scenes/near/nearest_pairs.hpp"

#include <algorithm>
#include <tuple>

#include "solver/distance.hpp"

namespace cyl {

std::vector<NearPair> nearest_pairs(std::span<const Solid> cylinders, double clearance,
                                    const ClosePairs& answered, std::size_t most) {
  struct Measured {
    double distance;
    PairOfBodies bodies;
    bool operator<(const Measured& other) const {
      return std::tie(distance, bodies) < std::tie(other.distance, other.bodies);
    }
  };
  std::vector<Measured> measured;
  measured.reserve(answered.candidates.size());
  for (const PairOfBodies& pair : answered.candidates)
    measured.push_back({distance(cylinders[pair.first], cylinders[pair.second]).value, pair});
  const std::size_t count = std::min(most, measured.size());
  const auto end = measured.begin() + static_cast<std::ptrdiff_t>(count);
  std::partial_sort(measured.begin(), end, measured.end());
  std::vector<NearPair> nearest;
  for (const Measured& m : std::span(measured).first(count)) {
    const Solid &a = cylinders[m.bodies.first], &b = cylinders[m.bodies.second];
    const Distance d = distance(a, b);
    nearest.push_back({m.bodies, d.value, d.error, a.center + d.on_a, b.center + d.on_b,
                       std::ranges::binary_search(answered.within, m.bodies),
                       decide_within(prepare(a), prepare(b), clearance).proof});
  }
  return nearest;
}

}  // namespace cyl
