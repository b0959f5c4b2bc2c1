// SPDX-License-Identifier: MIT
#include "scenes/study/motion_proof.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/support.hpp"
#include "scenes/read/bounding_solid.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/joint_path.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {
namespace {

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

std::vector<std::pair<std::size_t, std::size_t>> checked_pairs(const Scene& scene) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const PairRule rule(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (rule.reason(scene.bodies[j], scene.bodies[i]) == PairRule::Reason::checked)
        pairs.emplace_back(j, i);
  return pairs;
}

/// Returns the gap along a direction, which is the referee's f up to rounding.
double gap_along(const Pair& pair, const Vector3& n) {
  const auto reach = [&](const Solid& c) {
    return is_half_space(c) ? 0 : support(terms_of<double>(c), lifted<double>(n));
  };
  return n.dot(pair.b.center - pair.a.center) - reach(pair.a) - reach(pair.b);
}

// An arm of 1 that turns at the height of a post. It passes the wall at 0.2 when it points to the post.
Scene sweeper(double low, double high) {
  Scene scene =
      still_scene({{"post", {{1.6, 0, 0}, {0, 0, 1}, 0.3, 2}}, {"arm", {{0.5, 0, 0}, {1, 0, 0}, 0, 1, 0.1}}});
  Link& arm = scene.links[1];
  arm.joint = "turn";
  arm.motion = Motion::turn;
  arm.low = low;
  arm.high = high;
  return scene;
}

TEST(MotionProof, ProvesWhatAnArmMayNotReach) {
  MotionQuestion q;
  const MotionProof free = prove_motion(sweeper(-std::numbers::pi, std::numbers::pi), 0, 1, q);
  EXPECT_EQ(free.verdict, MotionVerdict::never);
  EXPECT_NEAR(free.least, 0.2, 1e-3);
  EXPECT_LT(free.bound, 0.2);
  EXPECT_GE(free.bound, 0.09);
  EXPECT_EQ(free.between, (std::vector<std::size_t>{1}));
  q.clearance = 0.199;
  const MotionProof near = prove_motion(sweeper(-std::numbers::pi, std::numbers::pi), 0, 1, q);
  EXPECT_EQ(near.verdict, MotionVerdict::never);
  EXPECT_GT(near.bound, 0.199);
  q.clearance = 0.201;
  const MotionProof met = prove_motion(sweeper(-std::numbers::pi, std::numbers::pi), 0, 1, q);
  EXPECT_EQ(met.verdict, MotionVerdict::within);
  EXPECT_LE(met.least, 0.201);
  EXPECT_EQ(prove_motion(sweeper(0.3, 6), 0, 1, q).verdict, MotionVerdict::never) << "it never points there";
}

// The same arm as a board that is 1 long, 0.2 wide and 0.1 thick: a corner goes farthest, sqrt(1.01). It also
// turns above a floor, with its lowest corner at 0.5 - sqrt(1.0025).
TEST(MotionProof, BoxesReachAsFarAsTheirCorners) {
  const double reach = std::sqrt(1.01), lowest = 0.5 - std::sqrt(1.0025);
  Scene scene = sweeper(-std::numbers::pi, std::numbers::pi);
  scene.bodies[1].solid = box_at(Pose(Eigen::Translation3d(0.5, 0, 0)), {1, 0.2, 0.1});
  MotionQuestion q;
  for (const double beside : {-1e-6, 1e-6}) {
    scene.bodies[0].solid.center.x() = 0.3 + reach + beside;
    const MotionProof post = prove_motion(scene, 0, 1, q);
    EXPECT_EQ(post.verdict, beside < 0 ? MotionVerdict::refuted : MotionVerdict::never);
    EXPECT_NEAR(post.least, beside, 1e-6);
  }
  for (const double z : {0.0, 0.05, lowest - 1e-6, lowest + 1e-6}) {
    Scene above = scene;
    above.bodies[0].solid = {.center = {7, 5, z}, .shape = Shape::half_space};
    above.links[1].origin = Eigen::Translation3d(0, 0, 0.5);
    above.links[1].axis = {0, 1, 0};
    for (const bool moved : {false, true}) {
      if (moved) {  // the floor turns about the board
        std::swap(above.links[0].motion, above.links[1].motion);
        std::swap(above.links[0].low, above.links[1].low);
        std::swap(above.links[0].high, above.links[1].high);
        above.links[0].joint = "floor";
        above.links[0].axis = {0, 1, 0};
        above.links[0].origin = Eigen::Translation3d(0, 0, 0.5);
        above.bodies[0].solid.center.z() -= 0.5;
      }
      const MotionProof floor = prove_motion(above, 0, 1, q);
      EXPECT_EQ(floor.verdict, z > lowest ? MotionVerdict::refuted : MotionVerdict::never) << z << moved;
    }
  }
}

// The arm above turns three times as far as its leader, and back. The leader is on no path between the two.
Scene geared(double low, double high) {
  Scene scene = sweeper(0, 0);
  Link leader;
  leader.joint = "lead";
  leader.motion = Motion::turn;
  leader.low = low;
  leader.high = high;
  scene.links.push_back(leader);
  scene.links[1].follow = Follow{2, -3, 0.3};
  return scene;
}

TEST(MotionProof, WhatMimicsIsMovedByItsLeader) {
  MotionQuestion q;
  q.clearance = 0.21;
  const MotionProof past = prove_motion(geared(-1, 0.05), 0, 1, q), met = prove_motion(geared(0, 1), 0, 1, q);
  EXPECT_EQ(past.verdict, MotionVerdict::never) << "from 0.15 on";
  ASSERT_EQ(met.verdict, MotionVerdict::within);
  const std::vector<double> joints = set_joints(geared(0, 1), met.between, met.joints);
  EXPECT_NEAR(joints[1], 0.3 - 3 * joints[2], 1e-15);
  EXPECT_EQ(met.between, (std::vector<std::size_t>{2}));
  const Scene scene = geared(-1, 1);
  JointPath path(scene, 0, 1);
  path.place_middle({{0.25, 0.35}});
  EXPECT_GT(path.travel({0, 1, 0}).length, std::sin(0.75) - std::sin(0.6)) << "0.15 rad on, at a length of 1";
}

// A chain that stays in a plane above a table. No joint changes the gap along the axes.
TEST(MotionProof, ParallelAxesKeepAGap) {
  Scene scene = still_scene({{"table", box_at(Pose::Identity(), {9, 9, 0.1})}});
  const auto prove = [&](double tilt) {
    scene.links.resize(1);
    scene.bodies.resize(1);
    for (std::size_t i = 1; i < 10; ++i) {
      Link& link = scene.links.emplace_back();
      link.joint = "j" + std::to_string(i);
      link.parent = i - 1;
      link.motion = Motion::turn;
      link.origin = Pose(Eigen::Translation3d(0.2, 0, i == 1 ? 0.15 : 0));
      link.axis = Vector3(i % 2 == 0 ? tilt : 0, 0, 1).normalized();
      link.low = -1;
      link.high = 1;
    }
    scene.bodies.push_back({"end", 9, {{0.1, 0, 0}, {1, 0, 0}, 0.04, 0.1}});
    return prove_motion(scene, 0, 1, {});
  };
  EXPECT_EQ(prove(0).verdict, MotionVerdict::never);
  EXPECT_EQ(prove(0).boxes, 1u);
  EXPECT_EQ(prove(0.5).verdict, MotionVerdict::refuted) << "it comes down";
}

// If a proof is incomplete, the part that is not proved has a share.
TEST(MotionProof, ShowsWhatIsLeftOpen) {
  MotionQuestion q;
  q.clearance = 0.2 * (1 - 1e-12);
  q.box_cap = 40;
  const MotionProof open = prove_motion(sweeper(-1, 2), 0, 1, q);
  EXPECT_EQ(open.verdict, MotionVerdict::open);
  EXPECT_GT(open.open_share, 0);
  EXPECT_LT(open.open_share, 0.1);
  EXPECT_LE(open.boxes, 40u);
  Scene held = sweeper(0.3, 6);
  held.links[0].held = true;
  EXPECT_EQ(prove_motion(held, 0, 1, q).verdict, MotionVerdict::open);
}

// In boxes of all sizes, the bodies never come nearer than the bound states, and they come almost as near. A
// signed distance is the greatest gap along any direction.
TEST(JointPath, NothingComesNearerThanItsTravel) {
  for (const char* file :
       {"twenty.urdf", "crane.urdf", "arm.urdf", "porter.urdf", "walker.xml", "crane.xml"}) {
    const Scene scene = read_scene(folder + file);
    const auto pairs = checked_pairs(scene);
    double most_used = 0;
    for (std::uint64_t k = 0; k < 1000; ++k) {
      RandomStream stream("travel", 1, k);
      const auto& [a, b] = pairs[stream.below(pairs.size())];
      JointPath path(scene, a, b);
      if (path.free_joints().empty()) continue;
      JointBox box = path.limits();
      const double part = std::ldexp(1, -stream.integer(0, 12));
      for (Range& range : box) {
        const double width = part * stream.unit() * (range.high - range.low);
        range.low += stream.unit() * (range.high - range.low - width);
        range.high = range.low + width;
      }
      const Pair middle = path.place_middle(box);
      Vector3 n = distance(middle.a, middle.b).direction;
      if (stream.coin() && !has_half_space(middle)) n = stream.unit_vector();
      if (const auto [gap, axis] = path.gap_along_axes(); gap > 0 && stream.coin()) n = axis;
      const double travel = path.travel(n).length, before = gap_along(middle, n);
      for (int i = 0; i < 10; ++i) {
        JointBox other = box;
        for (Range& range : other) {
          const double at = stream.unit();
          range.low = range.high = at < 0.2   ? range.low
                                   : at > 0.8 ? range.high
                                              : stream.between(range.low, range.high);
        }
        const Pair moved = path.place_middle(other);
        const Distance d = distance(moved.a, moved.b);
        if (d.value <= 0) continue;
        const double used = before - (d.value + d.error);
        ASSERT_LE(used, travel) << file << ": " << scene.bodies[a].name << " - " << scene.bodies[b].name;
        most_used = std::max(most_used, used / travel);
      }
    }
    EXPECT_GT(most_used, 0.8) << file;
  }
}

/// Takes back what these configurations show to be false.
void contradict_drawn(const Scene& scene, std::vector<MotionProof>& proofs) {
  for (std::size_t k = 0; k < 2000; ++k) {
    const std::vector<Solid> placed = place(scene, draw_joints(scene, 7, k));
    for (MotionProof& proof : proofs) contradict(proof, distance(placed[proof.a], placed[proof.b]).value);
  }
}

TEST(MotionProof, NoConfigurationContradictsIt) {
  for (const char* file :
       {"twenty.urdf", "crane.urdf", "arm.urdf", "porter.urdf", "walker.xml", "crane.xml"}) {
    const Scene scene = read_scene(folder + file);
    MotionQuestion q;
    q.clearance = 0.01;
    q.box_cap = 300;
    std::vector<MotionProof> never;
    for (const auto& [a, b] : checked_pairs(scene)) {
      MotionProof proof = prove_motion(scene, a, b, q);
      const std::vector<Solid> placed = place(scene, set_joints(scene, proof.between, proof.joints));
      if (proof.verdict <= MotionVerdict::within && (scene.bodies[a].box || scene.bodies[b].box)) {
        EXPECT_LE(distance(placed[a], placed[b]).value, proof.least) << "of inner solids";
        continue;
      }
      EXPECT_NEAR(distance(placed[a], placed[b]).value, proof.least, 1e-11);
      EXPECT_EQ(proof.verdict <= MotionVerdict::within || proof.bounded,
                referee_within({placed[a], placed[b]}, q.clearance) == true);
      EXPECT_EQ(proof.verdict == MotionVerdict::refuted,
                !proof.bounded && referee_within({placed[a], placed[b]}, 0) == true);
      EXPECT_EQ(proof.verdict == MotionVerdict::open, proof.open_share > 0);
      if (proof.verdict != MotionVerdict::never) continue;
      EXPECT_GT(proof.bound, q.clearance);
      EXPECT_LE(proof.bound, proof.least);
      never.push_back(std::move(proof));
    }
    EXPECT_GT(never.size(), 0u) << file;
    contradict_drawn(scene, never);
    EXPECT_EQ(std::ranges::count(never, true, &MotionProof::contradicted), 0) << file;
    never[0].bound = never[0].least * 1.5 + 0.01;
    contradict_drawn(scene, never);
    EXPECT_EQ(std::ranges::count(never, true, &MotionProof::contradicted), 1)
        << file << ": a false bound is seen";
    EXPECT_EQ(never[0].verdict, MotionVerdict::open);
  }
}

// A sample that contradicts a "never" cancels it, wherever the sample comes from. No reader lets limits be
// the wrong way round. Proofs then take the joint for fixed, and samples do not.
TEST(MotionProof, WhatDrawsDenyIsTakenBack) {
  Scene scene = sweeper(std::numbers::pi, -std::numbers::pi);
  SceneOptions q;
  q.prove = true;
  const auto proved = [&] { return *study_scene(scene, q).motions; };
  q.configurations = 1;
  EXPECT_EQ(proved().pairs[0].verdict, MotionVerdict::never);
  q.configurations = 300;
  scene.exemptions = {{0, 1, "Never"}};
  const MotionStudy denied = proved();
  EXPECT_EQ(denied.pairs[0].verdict, MotionVerdict::open);
  EXPECT_EQ(denied.exemptions[0].verdict, MotionVerdict::open);
  EXPECT_TRUE(denied.pairs[0].contradicted);
  EXPECT_EQ(denied.contradicted, 2u);
}

// An ellipsoid reaches 0.2 towards the arm, its bound 0.3, and its inner solid more than 0.1.
TEST(MotionProof, AnInnerSolidRefutes) {
  for (const auto& [gap, verdict] :
       {std::pair(0.31, MotionVerdict::never), {0.205, MotionVerdict::open}, {0.1, MotionVerdict::refuted}}) {
    Scene scene = sweeper(-1, 1);
    bound_ellipsoid(scene.bodies[0], {0.2, 0.3, 1}, Pose(Eigen::Translation3d(1.1 + gap, 0, 0)));
    const MotionProof proof = prove_motion(scene, 0, 1, {});
    EXPECT_EQ(proof.verdict, verdict) << gap;
    EXPECT_EQ(proof.bounded, verdict == MotionVerdict::open) << gap;
  }
}

// Only the bound around a mesh comes near, which refutes nothing.
TEST(MotionProof, ABoundOfAMeshRefutesNothing) {
  const Scene scene = read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/porter.urdf");
  std::size_t bounded = 0, refuted = 0;
  for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
      MotionQuestion question;
      question.box_cap = 50;
      const MotionProof proof = prove_motion(scene, a, b, question);
      const bool holds = scene.bodies[a].box || scene.bodies[b].box;
      EXPECT_FALSE(holds && proof.verdict <= MotionVerdict::within) << a << " " << b;
      EXPECT_TRUE(!proof.bounded || (holds && proof.verdict == MotionVerdict::open)) << a << " " << b;
      bounded += proof.bounded;
      refuted += proof.verdict == MotionVerdict::refuted;
    }
  }
  EXPECT_GT(bounded, 3u);
  EXPECT_GT(refuted, 0u);
}

}  // namespace
}  // namespace cyl
