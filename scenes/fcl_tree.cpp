// SPDX-License-Identifier: MIT
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <memory>

#include "scenes/broad_phase.hpp"

namespace cyl {
namespace {

struct Gathered {
  const fcl::CollisionObjectd* first;  ///< of all, in one block
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

bool gather(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
  auto& into = *static_cast<Gathered*>(data);
  const auto i = static_cast<std::uint32_t>(a - into.first), j = static_cast<std::uint32_t>(b - into.first);
  into.pairs.emplace_back(std::min(i, j), std::max(i, j));
  return false;  // go on
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::span<const Box> boxes) {
  // A box that is not turned keeps its bounds as they are; FCL's own bounds of a turned cylinder are those of
  // the ball around it, with six times as many pairs.
  std::vector<fcl::CollisionObjectd> objects;
  objects.reserve(boxes.size());
  for (const Box& box : boxes) {
    objects.emplace_back(std::make_shared<fcl::Boxd>(box.high - box.low), fcl::Matrix3d::Identity(),
                         (box.low + box.high) / 2);
  }
  std::vector<fcl::CollisionObjectd*> pointers;
  for (fcl::CollisionObjectd& object : objects) pointers.push_back(&object);
  fcl::DynamicAABBTreeCollisionManagerd tree;
  tree.registerObjects(pointers);
  tree.setup();
  Gathered gathered{objects.data(), {}};
  tree.collide(&gathered, gather);
  return std::move(gathered.pairs);
}

}  // namespace cyl
