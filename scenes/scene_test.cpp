// SPDX-License-Identifier: MIT
#include "scenes/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error_of_test.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "scenes/read/read_text_test.hpp"

namespace cyl {
namespace {

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

const Body& body(const Scene& scene, const std::string& name) {
  return *std::ranges::find(scene.bodies, name, &Body::name);
}

TEST(Joints, StayWithinLimitsAndMimic) {
  const Scene scene = read_scene(folder + "crane.urdf");
  const auto of = [&](const std::vector<double>& joints, const char* name) {
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (scene.links[i].joint == name) return joints[i];
    throw std::runtime_error(name);
  };
  double least = 9, most = -9;
  for (std::uint64_t k = 0; k < 200; ++k) {
    const auto joints = draw_joints(scene, 7, k);
    const double travel = of(joints, "travel");
    EXPECT_GE(travel, 0.1);
    EXPECT_LE(travel, 1.3);
    EXPECT_EQ(of(joints, "balance"), 0.5 * travel + 0.3);
    EXPECT_EQ(of(joints, "hoist"), 0);
    least = std::min(least, of(joints, "slew"));
    most = std::max(most, of(joints, "slew"));
  }
  EXPECT_LT(least, -3);
  EXPECT_GT(most, 3);
  EXPECT_EQ(draw_joints(scene, 7, 3), draw_joints(scene, 7, 3));
  EXPECT_NE(draw_joints(scene, 7, 3), draw_joints(scene, 8, 3));
  const std::vector<std::pair<std::string, double>> at{{"travel", 0.8}};
  EXPECT_EQ(of(joints_at(scene, at), "balance"), 0.5 * 0.8 + 0.3);
  EXPECT_EQ(of(joints_at(scene), "travel"), 0.1);  // 0 is outside its limits
  const std::vector<std::pair<std::string, double>> mimic{{"balance", 0.8}};
  EXPECT_THROW(joints_at(scene, mimic), std::invalid_argument);
  const std::vector<std::pair<std::string, double>> beyond{{"travel", 9}}, round{{"slew", 9}};
  EXPECT_THROW(joints_at(scene, beyond), std::invalid_argument);
  EXPECT_EQ(of(joints_at(scene, round), "slew"), 9) << "a continuous joint has no limits";
}

TEST(Pairs, ThoseThatMoveItLeavesOut) {
  const Scene scene = read_scene(folder + "crane.urdf");
  const PairRule rule(scene);
  using Reason = PairRule::Reason;
  const auto why = [&](const char* a, const char* b) {
    EXPECT_EQ(rule.reason(body(scene, a), body(scene, b)), rule.reason(body(scene, b), body(scene, a)));
    return rule.reason(body(scene, a), body(scene, b));
  };
  EXPECT_EQ(why("counterweight/weight", "counterweight/shackle"), Reason::same_body);
  EXPECT_EQ(why("ground/post", "tower"), Reason::adjacent);
  EXPECT_EQ(why("tower", "boom/beam"), Reason::adjacent);  // through the hinge, which has no shape
  EXPECT_EQ(why("trolley", "counterweight/weight"), Reason::checked);
  EXPECT_EQ(why("hook", "counterweight/shackle"), Reason::disabled);
  EXPECT_EQ(why("ground/post", "boom/beam"), Reason::checked);
  // The hook is fixed to the trolley, so they are one body. But only the trolley is next to the boom.
  EXPECT_EQ(why("trolley", "hook"), Reason::same_body);
  EXPECT_EQ(why("boom/beam", "hook"), Reason::checked);
}

TEST(Files, JsonLinesHaveAllSolids) {
  const Scene scene =
      read_text(".jsonl", R"({"shape":"half_space","point":[0,0,0],"normal":[0,0,2],"name":"floor"}
    {"shape":"half_space","point":[0,0,9],"normal":[0,0,-1]}
    {"shape":"box","center":[0,0,3],"edges":[1,2,3],"quaternion":[1,1e-17,0,0],"rounding":0.5}
    {"shape":"sphere","center":[0,0,0.5],"radius":0.5})");
  ASSERT_EQ(scene.bodies.size(), 4u);
  EXPECT_EQ(scene.bodies[0].name, "floor");
  const std::vector<Solid> placed = place(scene, joints_at(scene));
  EXPECT_EQ(placed[0].axis, Vector3(0, 0, 2));
  EXPECT_EQ(placed[2].quaternion, (std::array{1.0, 1e-17, 0.0, 0.0})) << "what stands still is not rounded";
  EXPECT_EQ(placed[2].rounding, 0.5);
  EXPECT_EQ(placed[3].rounding, 0.5);
  EXPECT_FALSE(moves(scene));
  EXPECT_EQ(PairRule(scene).reason(scene.bodies[0], scene.bodies[1]), PairRule::Reason::disabled);
  EXPECT_EQ(PairRule(scene).reason(scene.bodies[0], scene.bodies[3]), PairRule::Reason::checked);
}

std::string why(const std::string& ending, const std::string& text) {
  const Scratch scratch;
  const std::string file = scratch.write("scene" + ending, text), error = error_of([&] { read_scene(file); });
  return error.starts_with(file) ? error.substr(file.size()) : error;
}

TEST(Files, FaultsAreNamed) {
  EXPECT_NE(why(".jsonl", "\n{\"center\":[0,0,0],\"axis\":[0,0,1],\"radius\":-1,\"height\":2}")
                .find("line 2: radius is negative"),
            std::string::npos);
  EXPECT_NE(why(".jsonl", "{\"center\":[0,0,0],\"axis\":[0,0,1],\"radius\":1e-999,\"height\":2}")
                .find("line 1: 1e-999 underflows a double"),
            std::string::npos);
  EXPECT_NE(why(".jsonl", "{\"centre\":[0,0,0]}").find("line 1: centre is not a field of a solid; "),
            std::string::npos);
  EXPECT_NE(why(".urdf", "<robot name='r'><link name='a'/><link name='b'/></robot>").find("root"),
            std::string::npos);
  EXPECT_NE(why(".urdf", "<robot>\n<link name='a'></robot>").find("line 2: "), std::string::npos);
  const auto slides = [](const std::string& end, const std::string& mimic) {
    const auto joint = [&](const std::string& name, const std::string& parent, const std::string& rest) {
      return "<link name='" + name + "'/><joint name='j" + name + "' type='prismatic'><parent link='" +
             parent + "'/><child link='" + name + "'/><limit lower='-" + end + "' upper='" + end +
             "' effort='1' velocity='1'/>" + rest + "</joint>";
    };
    return "<robot name='r'><link name='a'/>" + joint("b", "a", "") + joint("c", "b", mimic) + "</robot>";
  };
  const std::string overflow =
      ": its limits or its origin are so large that numbers overflow: give smaller ones";
  EXPECT_EQ(why(".urdf", slides("1e308", "")), ": joint jb" + overflow);
  EXPECT_EQ(why(".urdf", slides("8.9e307", "<mimic joint='jb' multiplier='2'/>")), ": joint jc" + overflow);
  EXPECT_EQ(why(".urdf", slides("1e10", "<mimic joint='jb' multiplier='1e308'/>")), ": joint jc" + overflow);
  EXPECT_EQ(why(".urdf", slides("1e307", "")), "nothing thrown");
  EXPECT_NE(why(".obj", "").find("not a scene"), std::string::npos);
}

TEST(Urdf, UnknownShapesAreNamedNotFatal) {
  const Scene scene =
      read_text(".urdf",
                "<robot name='r'><link name='a'><collision><geometry><capsule radius='1' length='2'/>"
                "</geometry></collision><collision/><collision><geometry><cylinder radius='1' length='2'/>"
                "</geometry></collision></link></robot>");
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(kind_of(scene.bodies[0].solid), SolidKind::capsule);
  EXPECT_EQ(scene.bodies[0].solid.height, 2);
  EXPECT_EQ(kind_of(scene.bodies[1].solid), SolidKind::cylinder);
  EXPECT_EQ(scene.left_out, (std::vector<LeftOut>{{"nothing", "a"}}));
}

// Its links are not there before the macros are expanded. The expanded file may still name the namespace.
TEST(Urdf, MacrosAreToBeExpandedFirst) {
  const std::string robot = "<robot name='r' xmlns:xacro='x'><link name='a'/>",
                    command = ": it has macros, so expand it first: xacro ";
  for (const auto& [ending, inside] :
       {std::pair(".urdf", "<xacro:arm/>"), {".urdf.xacro", ""}, {".xacro", ""}}) {
    const std::string said = why(ending, robot + inside + "</robot>");
    EXPECT_TRUE(said.starts_with(command)) << said;
    EXPECT_TRUE(said.ends_with("/expanded.urdf")) << said;
  }
  EXPECT_EQ(why(".urdf", robot + "</robot>"), "nothing thrown");
}

// urdfdom drops a shape that it cannot parse, and at most reports it. Here it counts as not looked at.
TEST(Urdf, WhatCannotBeReadIsNotLookedAt) {
  const auto shape = [](const std::string& geometry, const std::string& place = "0 0 0") {
    return "<collision><origin xyz='" + place + "'/><geometry>" + geometry + "</geometry></collision>";
  };
  const Scene scene = read_text(
      ".urdf", "<robot name='r'><link name='a'>" + shape("<mesh filename='a.stl' scale='1 1 1 1'/>") +
                   shape("<box size='1 2'/>") + shape("<box size='1 2 x'/>") + shape("<mesh/>") +
                   shape("<box size='1 2 3'/>") + shape("<box size='1 2 -3'/>") +
                   shape("<sphere radius='1'/>") + "</link><link name='b'>" + shape("<sphere radius='1'/>") +
                   shape("<sphere radius='1'/>", "0 0") +
                   "</link><joint name='j' type='ball'><parent link='a'/><child link='b'/></joint></robot>");
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[0].name, "a/5");
  EXPECT_EQ(scene.bodies[0].solid.edges, (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ(scene.bodies[1].solid.rounding, 1);
  EXPECT_EQ(scene.left_out, (std::vector<LeftOut>{{"mesh", "a"},
                                                  {"box", "a"},
                                                  {"box", "a"},
                                                  {"mesh", "a"},
                                                  {"box", "a"},
                                                  {"sphere", "b"},
                                                  {"sphere", "b"}}));
  EXPECT_TRUE(scene.links.at(1).held);
}

// This is like Panda's collision model. The second cylinder has one sphere, and the third has no match.
TEST(Urdf, ACylinderWithASphereAtEachEndIsACapsule) {
  const auto shape = [](const std::string& z, const std::string& geometry) {
    return "<collision><origin xyz='0 0 " + z + "' rpy='0 0 0'/><geometry>" + geometry +
           "</geometry></collision>";
  };
  const std::string cylinder = "<cylinder radius='0.06' length='0.3'/>", ball = "<sphere radius='0.06'/>";
  const Scene scene = read_text(
      ".urdf", "<robot name='r'><link name='a'>" + shape("0.35", ball) + shape("0.2", cylinder) +
                   shape("0.05", ball) + shape("2", cylinder) + shape("2.15", ball) + shape("4", cylinder) +
                   shape("4.15", "<sphere radius='0.07'/>") + shape("3.85", ball) + "</link></robot>");
  EXPECT_EQ(scene.folded, 1u);
  std::size_t capsules = 0, cylinders = 0, spheres = 0;
  for (const Body& b : scene.bodies) {
    capsules += kind_of(b.solid) == SolidKind::capsule;
    cylinders += kind_of(b.solid) == SolidKind::cylinder;
    spheres += kind_of(b.solid) == SolidKind::sphere;
  }
  EXPECT_EQ(capsules, 1u);
  EXPECT_EQ(cylinders, 2u);
  EXPECT_EQ(spheres, 3u);
  EXPECT_NEAR(scene.bodies[0].solid.rounding, 0.06, 1e-15);
  EXPECT_NEAR(scene.bodies[0].solid.height, 0.3, 1e-15);
}

}  // namespace
}  // namespace cyl
