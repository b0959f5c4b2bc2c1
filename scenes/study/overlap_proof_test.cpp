// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "corpus/pairs/random_stream.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/motion_proof.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// A trunk, and a rotor that turns about x, or is held there. The joint is at `at`.
Scene rotor(const Solid& trunk, const Solid& solid, const Vector3& at, bool held = false) {
  Scene scene = still_scene({{"trunk", trunk}, {"rotor", solid}});
  Link& link = scene.links[1];
  link.parent = 0;
  link.motion = held ? Motion::fixed : Motion::turn;
  link.held = held;
  link.origin = Pose(Eigen::Translation3d(at));
  link.axis = {1, 0, 0};
  link.low = -3.2;
  link.high = 3.2;
  return scene;
}

TEST(OverlapProof, OfARotorInItsTrunk) {
  const Solid trunk = box_at(Pose::Identity(), {2, 1, 0.5}), disk{{0, 0, 0}, {1, 0, 0}, 0.2, 0.1},
              arm{{0, 0.2, 0}, {0, 1, 0}, 0.05, 0.3};
  const auto always = [&](const Solid& solid, double y, bool held = false) {
    return prove_motion(rotor(trunk, solid, {0.9, y, 0}, held), 0, 1, {}).always;
  };
  EXPECT_TRUE(always(disk, 0.5));
  EXPECT_FALSE(always(disk, 0.8)) << "apart";
  EXPECT_TRUE(prove_motion(rotor(trunk, disk, {1.02, 0.3, 0}), 0, 1, {}).always) << "its middle is outside";
  EXPECT_FALSE(always(arm, 0.5)) << "it swings out";
  EXPECT_FALSE(always(disk, 0.5, true)) << "its joint moves in another way";
}

// Wherever there is a proof, no configuration is apart. Many of the pairs overlap only a little.
TEST(OverlapProof, NoConfigurationContradictsIt) {
  std::size_t proved = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    RandomStream r("overlap", 7, i);
    const auto place = [&] { return Vector3(r.unit_vector() * r.between(0, 0.5)); };
    const auto length = [&] { return r.between(0.05, 0.6); };
    const Solid solids[]{box_at(Pose(Eigen::Translation3d(place() / 4)), {length(), length(), length()}),
                         {place() / 4, r.unit_vector(), length() / 2, length()},
                         {place() / 4, r.unit_vector(), 0, length(), length() / 2}};
    const Scene scene = rotor(solids[i % 3], solids[i / 3 % 3], place());
    if (!prove_motion(scene, 0, 1, {}).always) continue;
    ++proved;
    for (std::uint64_t k = 0; k < 100; ++k) {
      const std::vector<Solid> placed = cyl::place(scene, draw_joints(scene, 3, k));
      EXPECT_LT(distance(placed[0], placed[1]).value, 0) << i;
    }
  }
  EXPECT_GT(proved, 30u);
  EXPECT_LT(proved, 270u);
}

}  // namespace
}  // namespace cyl
