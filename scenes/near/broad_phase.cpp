// SPDX-License-Identifier: MIT
#include "scenes/near/broad_phase.hpp"

#ifdef DAYLIGHT_WITH_FCL
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>
#endif

#include <algorithm>
#include <cmath>
#include <memory>

namespace cyl {
namespace {

/// The rounding error of a box and of the centre in it, relative to its coordinates and sizes.
constexpr double box_error = 0x1p-48;

}  // namespace

Box box_around(const Prepared& c, double clearance) noexcept {
  Vector3 reach;
  for (int i = 0; i < 3; ++i) {
    const double w = std::fabs(c.unit_axis[i]);
    reach[i] = c.height / 2 * w + c.radius * std::sqrt(std::max(0.0, 1 - w * w)) + c.rounding +
               clearance / 2 +
               box_error * (std::fabs(c.center[i]) + c.height + c.radius + c.rounding + clearance);
  }
  return {c.center - reach, c.center + reach};
}

#ifdef DAYLIGHT_WITH_FCL
namespace {

struct Gathered {
  const fcl::CollisionObjectd* first;  ///< of all objects, in one block
  std::size_t most;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

bool gather(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
  auto& into = *static_cast<Gathered*>(data);
  const auto i = static_cast<std::uint32_t>(a - into.first), j = static_cast<std::uint32_t>(b - into.first);
  into.pairs.emplace_back(std::min(i, j), std::max(i, j));
  return into.pairs.size() > into.most;  // ends
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::span<const Box> boxes,
                                                                std::size_t most) {
  // Boxes that are not rotated keep their bounds. FCL bounds a rotated cylinder by the ball around it, which
  // would give six times as many pairs.
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
  Gathered gathered{objects.data(), most, {}};
  tree.collide(&gathered, gather);
  return std::move(gathered.pairs);
}
#else
std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::span<const Box> boxes,
                                                                std::size_t most) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t j = 0; j < boxes.size(); ++j) {
    for (std::uint32_t i = 0; i < j; ++i) {
      if ((boxes[i].low.array() <= boxes[j].high.array()).all() &&
          (boxes[j].low.array() <= boxes[i].high.array()).all())
        pairs.emplace_back(i, j);
      if (pairs.size() > most) return pairs;
    }
  }
  return pairs;
}
#endif

}  // namespace cyl
