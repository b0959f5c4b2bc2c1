// SPDX-License-Identifier: MIT
// Of which pairs a study tells nothing.
#include <algorithm>

#include "scenes/scene_study.hpp"

namespace cyl {

bool is_known(const Scene& scene, const PairStudy& pair) {
  return pair.within == 0 || (!scene.bodies[pair.a].box && !scene.bodies[pair.b].box);
}

std::vector<std::string> held_between(const Scene& scene, const SceneStudy& study) {
  std::vector<bool> between(scene.links.size());
  for (const PairStudy& pair : study.pairs) {
    // A parent comes before its link: the later of the two goes up until they meet.
    std::size_t a = scene.bodies[pair.a].link, b = scene.bodies[pair.b].link;
    while (a != b) {
      std::size_t& later = a > b ? a : b;
      if (scene.links[later].held) between[later] = true;
      if (!scene.links[later].parent) break;
      later = *scene.links[later].parent;
    }
  }
  std::vector<std::string> joints;
  for (std::size_t i = 0; i < between.size(); ++i)
    if (between[i]) joints.push_back(scene.links[i].joint);
  return joints;
}

}  // namespace cyl
