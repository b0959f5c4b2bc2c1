// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "reports/scene/motion_text.hpp"
#include "reports/scene/scene_report.hpp"
#include "scenes/read/read_text_test.hpp"

namespace cyl {
namespace {

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

SceneOptions question() {
  SceneOptions q;
  q.file = "robot.urdf";
  q.configurations = 20;
  q.prove = q.prove_others = true;
  return q;
}

/// Returns the reasons that come back when the text is read for the same robot, by the names of the links.
std::map<std::pair<std::string, std::string>, std::string> read_back(Scene scene, const std::string& text) {
  const Scratch scratch;
  scene.exemptions.clear();
  scene.notes.clear();
  const std::string file = scratch.write("back.srdf", text);
  NamedFiles files(file);
  read_srdf(files, file, NamedBy::user, scene);
  EXPECT_TRUE(scene.notes.empty());
  std::map<std::pair<std::string, std::string>, std::string> reasons;
  for (const Exemption& e : scene.exemptions)
    reasons[std::minmax(scene.links[e.a].name, scene.links[e.b].name)] = e.reason;
  return reasons;
}

std::string text_of(const Scene& scene, const SceneOptions& q = question()) {
  return srdf_text(scene, q, study_scene(scene, q));
}

TEST(SrdfText, DisablesWhatIsProvedOrJoinedByOneJoint) {
  const Scene scene = read_scene(folder + "arm.urdf");
  const std::string text = text_of(scene);
  const auto reasons = read_back(scene, text);
  EXPECT_EQ(reasons.at({"elbow", "upper"}), "Adjacent");
  EXPECT_EQ(reasons.at({"camera", "hand"}), "Adjacent") << "a fixed joint";
  EXPECT_EQ(reasons.at({"fore", "hand"}), "Default") << "two fixed joints, and they overlap";
  EXPECT_EQ(reasons.at({"base", "upper"}), "Never");
  EXPECT_FALSE(reasons.contains({"left_finger", "right_finger"})) << "they meet with the joints at 0";
  EXPECT_FALSE(reasons.contains({"hand", "table"})) << "they meet at times";
  EXPECT_FALSE(reasons.contains({"base", "fore"})) << "they meet at times";
  EXPECT_NE(text.find("<!-- proved: at least "), text.npos) << text;
  EXPECT_NE(text.find(": not disabled: some shapes were not tested -->"), text.npos)
      << "a mesh of the camera";
}

// Samples alone disable nothing, however many samples have no hit.
TEST(SrdfText, NothingIsNeverThatWasOnlyDrawn) {
  const Scene scene = read_scene(folder + "twenty.urdf");
  SceneOptions q = question();
  q.prove = false;
  for (const auto& [links, reason] : read_back(scene, text_of(scene, q)))
    EXPECT_EQ(reason, "Adjacent") << links.first << " - " << links.second;
  q = question();
  const SceneStudy few = study_scene(scene, q);
  const auto reasons = read_back(scene, srdf_text(scene, q, few));
  std::size_t open = 0;
  for (const MotionProof& proof : few.motions->pairs) {
    const auto& [a, b] = std::minmax(scene.links[scene.bodies[proof.a].link].name,
                                     scene.links[scene.bodies[proof.b].link].name);
    if (proof.verdict != MotionVerdict::open) continue;
    ++open;
    EXPECT_FALSE(reasons.contains({a, b})) << a << " - " << b;
  }
  EXPECT_GT(open, 0u);
}

// Two fixed links overlap for ever. The third is clear of the first. The last turns, and always overlaps the
// first two.
TEST(SrdfText, LinksThatOverlapForEverAreDisabled) {
  const auto link = [](const std::string& name, const std::string& x) {
    return "<link name='" + name + "'><collision><origin xyz='" + x +
           " 0 0'/><geometry><box size='1 1 1'/></geometry></collision></link>";
  };
  const auto joint = [](const std::string& type, const std::string& to) {
    return "<joint name='to_" + to + "' type='" + type + "'><parent link='base'/><child link='" + to +
           "'/><axis xyz='1 0 0'/></joint>";
  };
  Scene scene = read_text(".urdf", "<robot name='r'><link name='base'/>" + link("a", "0") + link("b", "0.9") +
                                       link("c", "1.5") + link("spun", "0.2") + joint("fixed", "a") +
                                       joint("fixed", "b") + joint("fixed", "c") +
                                       joint("continuous", "spun") + "</robot>");
  const std::string text = text_of(scene);
  const auto reasons = read_back(scene, text);
  EXPECT_EQ(reasons.at({"a", "b"}), "Default");
  EXPECT_EQ(reasons.at({"b", "c"}), "Default");
  EXPECT_EQ(reasons.at({"a", "c"}), "Never");
  EXPECT_EQ(reasons.at({"c", "spun"}), "Never");
  EXPECT_EQ(reasons.at({"a", "spun"}), "Always");
  EXPECT_EQ(reasons.at({"b", "spun"}), "Always");
  EXPECT_EQ(reasons.size(), 6u);
  for (const char* why :
       {"<!-- proved: of one rigid body, in every configuration, distance -0.1 as it stands -->",
        "<!-- proved: in every configuration, distance -0."})
    EXPECT_NE(text.find(why), text.npos) << text;
  // Read again, only "Never" is a claim.
  for (const bool is_claim : {false, true}) {
    scene.exemptions = {{1, 2, is_claim ? "Never" : "Default"}, {1, 3, "Never"}};
    const std::vector<ExemptionProof> proofs = study_scene(scene, question()).motions->exemptions;
    EXPECT_EQ(proofs.size(), is_claim ? 2u : 1u);
    EXPECT_EQ(proofs.front().verdict, is_claim ? MotionVerdict::refuted : MotionVerdict::never);
  }
}

// A free joint may take a body out of what it overlaps at first. Only what is welded stays in a plane.
TEST(SrdfText, WhatMayLeaveIsNotDisabled) {
  const auto reasons = [](const std::string& joint) {
    const Scene scene =
        read_text(".xml", "<mujoco><worldbody><geom type='plane' size='1 1 1'/><body><body name='b'>" +
                              joint + "<geom size='1'/></body></body></worldbody></mujoco>");
    return read_back(scene, text_of(scene));
  };
  EXPECT_EQ(reasons("").at({"b", "world"}), "Default");
  EXPECT_EQ(reasons("<joint/>").at({"b", "world"}), "Always") << "it turns about its middle";
  for (const char* joint : {"<freejoint/>", "<joint type='ball'/>", "<joint type='slide' range='0 2'/>"})
    EXPECT_EQ(reasons(joint).size(), 0u) << joint;
}

// Pairs that its own SRDF disables come back only if they are proved, not if they are refuted or open.
TEST(SrdfText, KeepsOfAnSrdfWhatIsProved) {
  Scene scene = read_scene(folder + "crane.urdf");
  const auto link = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(scene.links, name, &Link::name) - scene.links.begin());
  };
  for (const char* reason : {"Never", "User"}) {
    scene.exemptions.push_back({link("trolley"), link("tower"), reason});
    scene.disabled.emplace_back(link("trolley"), link("tower"));
    const std::string text = text_of(scene);
    const auto reasons = read_back(scene, text);
    EXPECT_EQ(reasons.at({"counterweight", "hook"}), "Never");
    EXPECT_EQ(reasons.at({"hook", "tower"}), "Never");
    EXPECT_FALSE(reasons.contains({"tower", "trolley"})) << reason;
    EXPECT_NE(text.find("tower - trolley: not disabled, although "), text.npos) << text;
    EXPECT_NE(text.find(std::string(" has the reason \"") + reason + "\": refuted: distance "), text.npos)
        << text;
    EXPECT_FALSE(reasons.contains({"boom", "tower"})) << "two joints are between them";
    scene.exemptions.pop_back();
  }
}

TEST(SrdfText, NamesMayHoldAnything) {
  const std::string one = "one--\"&<\t", other = "other-->\r\n", third = "third--->";
  Scene scene =
      still_scene({{"a", {}}, {"b", {{3, 0, 0}, {0, 0, 1}, 1, 1}}, {"c", {{9, 0, 0}, {0, 0, 1}, 1, 1}}});
  scene.links[0].name = one;
  scene.links[1].name = other;
  scene.links[2].name = third;
  scene.left_out.push_back({"box", third});
  const std::string text = text_of(scene);
  const auto reasons = read_back(scene, text);
  EXPECT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons.at({one, other}), "Never");
  EXPECT_NE(text.find("third- - ->: not disabled"), text.npos) << text;
}

TEST(SrdfText, NeighboursThatTheFilePairsAreNotDisabled) {
  Scene scene = read_scene(folder + "arm.urdf");
  const auto body_on = [&](const std::string& link) -> Body& {
    return *std::ranges::find_if(scene.bodies,
                                 [&](const Body& b) { return scene.links[b.link].name == link; });
  };
  Body &upper = body_on("upper"), &elbow = body_on("elbow");
  upper.paired = {elbow.name};
  elbow.paired = {upper.name};
  EXPECT_FALSE(read_back(scene, text_of(scene)).contains({"elbow", "upper"}));
}

TEST(SrdfText, RatesAreRoundedUp) {
  EXPECT_EQ(rate_text(400), "0.75 %");
  EXPECT_EQ(rate_text(1000), "0.3 %");
  EXPECT_EQ(rate_text(1), "100 %");
}

}  // namespace
}  // namespace cyl
