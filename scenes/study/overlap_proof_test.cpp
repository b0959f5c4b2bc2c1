// SPDX-License-Identifier: MIT
#include "scenes/study/overlap_proof.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "corpus/pairs/random_stream.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/motion_proof.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// A trunk, and a rotor that turns about x through its own middle. The joint is at `at`.
Scene rotor(const Solid& trunk, const Solid& solid, const Vector3& at) {
  Scene scene = still_scene({{"trunk", trunk}, {"rotor", solid}});
  Link& link = scene.links[1];
  link.parent = 0;
  link.joint = "spin";
  link.motion = Motion::turn;
  link.endless = true;
  link.origin = Pose(Eigen::Translation3d(at));
  link.axis = {1, 0, 0};
  link.low = -3.2;
  link.high = 3.2;
  return scene;
}

const Solid trunk = box_at(Pose::Identity(), {2, 1, 0.5});

TEST(OverlapProof, OfARotorInItsTrunk) {
  const Solid disk{{0, 0, 0}, {1, 0, 0}, 0.2, 0.1};
  EXPECT_TRUE(overlap_always(rotor(trunk, disk, {0.9, 0.5, 0}), 0, 1));
  EXPECT_TRUE(prove_motion(rotor(trunk, disk, {0.9, 0.5, 0}), 0, 1, {}).always);
  EXPECT_FALSE(prove_motion(rotor(trunk, disk, {0.9, 0.8, 0}), 0, 1, {}).always) << "apart";
  const Solid arm{{0, 0.2, 0}, {0, 1, 0}, 0.05, 0.3};
  EXPECT_FALSE(prove_motion(rotor(trunk, arm, {0.9, 0.5, 0}), 0, 1, {}).always) << "it swings out";
  Scene held = rotor(trunk, disk, {0.9, 0.5, 0});
  held.links[1].held = true;
  held.links[1].motion = Motion::fixed;
  EXPECT_FALSE(prove_motion(held, 0, 1, {}).always) << "its joint moves in another way";
  Scene bounded = rotor(trunk, disk, {0.9, 0.5, 0});
  bounded.bodies[1].box = BoxShape{"mesh", Pose::Identity(), {0.1, 0.1, 0.1}};
  EXPECT_FALSE(overlap_always(bounded, 0, 1));
}

// Wherever there is a proof, no configuration is apart. Many of the pairs overlap only a little.
TEST(OverlapProof, NoConfigurationContradictsIt) {
  std::size_t proved = 0, not_proved = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    RandomStream r("overlap", 7, i);
    const auto length = [&](double most) { return r.between(0.05, most); };
    const auto place = [&] {
      return Vector3{r.between(-0.4, 0.4), r.between(-0.4, 0.4), r.between(-0.4, 0.4)};
    };
    const Solid solids[]{box_at(Pose::Identity(), {length(1), length(1), length(1)}),
                         {place() / 4, {r.between(-1, 1), 1, 0}, length(0.3), length(0.5), i % 3 ? 0 : 0.05},
                         {place() / 4, {1, 0, 0}, 0, length(0.5), length(0.2)}};
    const Scene scene = rotor(solids[i % 3], solids[(i / 3) % 3], place());
    if (!overlap_always(scene, 0, 1)) {
      ++not_proved;
      continue;
    }
    ++proved;
    for (std::uint64_t k = 0; k < 100; ++k) {
      const std::vector<Solid> placed = cyl::place(scene, draw_joints(scene, 3, k));
      EXPECT_LT(distance(placed[0], placed[1]).value, 0) << i;
    }
  }
  EXPECT_GT(proved, 30u);
  EXPECT_GT(not_proved, 100u);
}

}  // namespace
}  // namespace cyl
