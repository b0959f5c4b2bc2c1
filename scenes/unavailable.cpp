// SPDX-License-Identifier: MIT
// What stands in for a foreign library that this build is without.
#include <stdexcept>

#include "scenes/broad_phase.hpp"
#include "scenes/scene_files.hpp"

namespace cyl {

#ifndef DAYLIGHT_WITH_URDFDOM
Scene read_urdf(const std::string& file) {
  throw std::runtime_error(file + ": this build reads no URDF, for urdfdom was not there (liburdfdom-dev)");
}
#endif

#ifndef DAYLIGHT_WITH_FCL
std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::span<const Box> boxes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t j = 0; j < boxes.size(); ++j) {
    for (std::uint32_t i = 0; i < j; ++i) {
      if ((boxes[i].low.array() <= boxes[j].high.array()).all() &&
          (boxes[j].low.array() <= boxes[i].high.array()).all())
        pairs.emplace_back(i, j);
    }
  }
  return pairs;
}
#endif

}  // namespace cyl
