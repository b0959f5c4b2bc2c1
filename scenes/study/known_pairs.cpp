// SPDX-License-Identifier: MIT
// The pairs that a study reports nothing about.
#include <set>

#include "scenes/study/scene_study.hpp"

namespace cyl {

bool is_known(const Scene& scene, const PairStudy& pair) {
  return pair.within == 0 || (!scene.bodies[pair.a].box && !scene.bodies[pair.b].box);
}

std::vector<std::size_t> joints_held_between(const Scene& scene, const PairStudy& pair) {
  std::vector<std::size_t> links;
  // A parent comes before its link. The later of the two goes up until they meet.
  std::size_t a = scene.bodies[pair.a].link, b = scene.bodies[pair.b].link;
  while (a != b) {
    std::size_t& later = a > b ? a : b;
    if (!drawn_in_full(scene, later)) links.push_back(later);
    if (!scene.links[later].parent) break;
    later = *scene.links[later].parent;
  }
  return links;
}

std::vector<std::string> joints_held_between(const Scene& scene, const SceneStudy& study) {
  std::set<std::size_t> between;
  for (const PairStudy& pair : study.pairs)
    for (const std::size_t link : joints_held_between(scene, pair)) between.insert(link);
  std::vector<std::string> joints;
  for (const std::size_t link : between) joints.push_back(scene.links[link].joint);
  return joints;
}

}  // namespace cyl
