// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "base/scratch_test.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/motion_proof.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {
namespace {

const std::string crane = DAYLIGHT_SOURCE_DIR "/corpus/scenes/crane.urdf";

TEST(Srdf, TheOneBesideOrTheOneNamed) {
  const Scene beside = read_scene(crane);
  EXPECT_TRUE(beside.srdf.ends_with("crane.srdf"));
  ASSERT_EQ(beside.exemptions.size(), 1u);
  EXPECT_EQ(beside.links[beside.exemptions[0].a].name, "hook");
  EXPECT_EQ(beside.exemptions[0].reason, "Never");
  const Scratch scratch;
  const std::string own =
      scratch.write("own.srdf",
                    "<robot name='crane'><disable_collisions link1='tower' link2='trolley' reason='User'/>"
                    "<disable_collisions link1='jib' link2='hook'/><disable_collisions link1='hook' "
                    "link2='winch'/></robot>");
  const Scene named = read_scene(crane, own);
  EXPECT_EQ(named.srdf, own);
  ASSERT_EQ(named.exemptions.size(), 1u);
  EXPECT_EQ(named.exemptions[0].reason, "User");
  EXPECT_EQ(named.disabled.size(), 1u);
  ASSERT_EQ(named.notes.size(), beside.notes.size() + 1);
  EXPECT_NE(named.notes.back().find("names links that are not there: jib, winch."), std::string::npos);
}

TEST(Srdf, WhatCannotBeReadIsSaid) {
  EXPECT_THROW(read_scene(crane, "none.srdf"), std::runtime_error);
  const Scratch scratch;
  for (const char* text : {"<robot><disable_collisions", "<sdf/>"})
    EXPECT_THROW(read_scene(crane, scratch.write("bad.srdf", text)), std::runtime_error);
}

// The trolley meets the tower in about 1 of 100 configurations. A planner with this file never looks there.
TEST(Srdf, AFalseNeverIsRefutedWithAConfiguration) {
  const Scratch scratch;
  const std::string planted =
      scratch.write("planted.srdf",
                    "<robot name='crane'><disable_collisions link1='trolley' link2='tower' reason='Never'/>"
                    "<disable_collisions link1='hook' link2='counterweight' reason='Never'/>"
                    "<disable_collisions link1='hook' link2='ground' reason='User'/>"
                    "<disable_collisions link1='counterweight' link2='ground' reason='Never'/></robot>");
  const Scene scene = read_scene(crane, planted);
  const MotionStudy study = prove_motions(scene, {}, {}, {});
  ASSERT_EQ(study.exemptions.size(), 3u);
  const ExemptionProof& refuted = study.exemptions[0];
  EXPECT_EQ(refuted.verdict, MotionVerdict::refuted);
  ASSERT_EQ(refuted.bodies.size(), 1u);
  const auto placed = place(scene, joints_in(scene, refuted.bodies[0]));
  EXPECT_EQ(referee_within({placed[refuted.bodies[0].a], placed[refuted.bodies[0].b]}, 0), true);
  const ExemptionProof& proved = study.exemptions[1];
  EXPECT_EQ(proved.verdict, MotionVerdict::never);
  EXPECT_EQ(proved.bodies.size(), 2u) << "both of the counterweight";
  const ExemptionProof& bounded = study.exemptions[2];
  EXPECT_FALSE(bounded.not_looked_at) << "the ground's box has a bound";
  EXPECT_EQ(bounded.verdict, MotionVerdict::never);
}

}  // namespace
}  // namespace cyl
