// SPDX-License-Identifier: MIT
#include "scenes/study/reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/scene_study.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

// In every configuration the ball around a body is within the box, and in some it nearly fills the box.
TEST(Reach, HoldsABodyInAllConfigurations) {
  for (const char* file : {"twenty.urdf", "crane.urdf", "arm.urdf", "hand.xml", "walker.xml", "crane.xml"}) {
    const Scene scene = read_scene(folder + file);
    std::vector<Box> boxes;
    for (const Body& body : scene.bodies) boxes.push_back(reach_of(scene, body));
    double fullest = 0;
    for (std::uint64_t k = 0; k < 200; ++k) {
      const std::vector<Solid> placed = place(scene, draw_joints(scene, 3, k));
      for (std::size_t i = 0; i < placed.size(); ++i) {
        if (is_half_space(placed[i])) continue;
        const Vector3 ball = Vector3::Constant(make_models(placed[i]).ball.rounding);
        const Vector3 low = placed[i].center - ball, high = placed[i].center + ball;
        ASSERT_TRUE((boxes[i].low.array() <= low.array()).all() &&
                    (high.array() <= boxes[i].high.array()).all())
            << file << ": " << scene.bodies[i].name;
        if (boxes[i].high.allFinite())
          fullest =
              std::max(fullest, ((high - low).array() / (boxes[i].high - boxes[i].low).array()).maxCoeff());
      }
    }
    EXPECT_GT(fullest, 0.5) << file;
  }
}

TEST(Reach, TurnsThroughItsLimitsAlone) {
  Scene scene = still_scene({{"arm", {{3, 0, 0}, {0, 0, 1}, 0.1, 0.2}}});
  scene.links[0].motion = Motion::turn;
  scene.links[0].low = 0.2;
  scene.links[0].high = 0.4;
  EXPECT_GT(reach_of(scene, scene.bodies[0]).low.x(), 2) << "0.1 rad to either side at 3 m";
  scene.links[0].high = 6;
  const Box round = reach_of(scene, scene.bodies[0]);
  EXPECT_LT(round.low.x(), -3);
  EXPECT_GT(round.low.x(), -3.6);
  EXPECT_GT(round.low.z(), -0.6) << "it turns about z";
  scene.links[0].held = true;
  EXPECT_FALSE(reach_of(scene, scene.bodies[0]).low.allFinite());
}

TEST(Reach, NearPairsAreThoseOfAllPairs) {
  std::vector<Box> boxes;
  for (std::uint64_t i = 0; i < 300; ++i) {
    RandomStream stream("boxes", 1, i);
    const Vector3 low = 10 * stream.unit_vector();
    boxes.push_back({low, low + Vector3::Constant(stream.between(0, 1))});
  }
  boxes[7].low.setConstant(-std::numeric_limits<double>::infinity());
  boxes[7].high = -boxes[7].low;
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t b = 0; b < boxes.size(); ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (gap_between(boxes[a], boxes[b]) <= 0.5) all.emplace_back(a, b);
  const auto any = [](std::size_t, std::size_t) { return true; };
  EXPECT_EQ(near_pairs(boxes, 0.5, all.size(), any), all);
  EXPECT_GT(near_pairs(boxes, 0.5, 10, any).size(), 10u);
}

// 220 posts on a field, and an arm that turns among them: more pairs than a study lists.
TEST(Reach, FarPairsAreCountedAndNeverNear) {
  std::vector<std::pair<std::string, Solid>> posts;
  for (std::uint64_t i = 0; i < 220; ++i) {
    RandomStream stream("posts", 1, i);
    const double x = stream.between(-20, 20), y = stream.between(-20, 20);
    posts.push_back({"post", {{x, y, 0}, {0, 0, 1}, 0.1, 0.5}});
  }
  posts.push_back({"arm", {{2, 0, 0}, {1, 0, 0}, 0.1, 4}});
  Scene scene = still_scene(std::move(posts));
  scene.links[220].joint = "turn";
  scene.links[220].motion = Motion::turn;
  scene.links[220].low = -1;
  scene.links[220].high = 1;
  SceneOptions q;
  q.configurations = 20;
  q.clearance = 0.05;
  const SceneStudy s = study_scene(scene, q);
  EXPECT_EQ(s.pairs.size() + s.far, 221u * 220 / 2);
  EXPECT_GT(s.far, 20'000u);
  std::set<std::pair<std::size_t, std::size_t>> listed;
  for (const PairStudy& pair : s.pairs) listed.emplace(pair.a, pair.b);
  std::size_t near_arm = 0;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const std::vector<Solid> placed = place(scene, draw_joints(scene, 5, k));
    for (std::size_t b = 0; b < placed.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        if (k > 0 && b != 220) continue;  // the posts stand still
        EXPECT_NE(listed.contains({a, b}), is_far(s, a, b, q.clearance));
        if (listed.contains({a, b})) continue;
        EXPECT_GT(distance(placed[a], placed[b]).value, q.clearance);
      }
    }
  }
  for (const auto& [a, b] : listed) near_arm += b == 220;
  EXPECT_GT(near_arm, 5u);
  EXPECT_LT(near_arm, 60u);
}

}  // namespace
}  // namespace cyl
