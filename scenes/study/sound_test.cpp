// SPDX-License-Identifier: MIT
// Statements that must not be made: "never" for links that meet, "adjacent" for links without a joint.
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>
#include <string>

#include "corpus/pairs/solid_kind.hpp"
#include "scenes/read/read_text_test.hpp"
#include "scenes/study/motion_proof.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {
namespace {

std::string ball(const std::string& link, const std::string& at, const std::string& radius = "0.1") {
  return "<link name='" + link + "'><collision><origin xyz='" + at + "'/><geometry><sphere radius='" +
         radius + "'/></geometry></collision></link>";
}
std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& rest = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" +
         child + "'/><axis xyz='0 0 1'/>" + rest + "</joint>";
}
Scene robot(const std::string& inside) {
  return read_text(".urdf", "<robot name='r'>" + inside + "</robot>");
}

std::size_t body_of(const Scene& scene, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(scene.bodies, name, &Body::name) - scene.bodies.begin());
}
MotionProof proof_of(const Scene& scene, double clearance = 0) {
  MotionQuestion question;
  question.clearance = clearance;
  return prove_motion(scene, body_of(scene, "arm"), body_of(scene, "post"), question);
}
PairRule::Reason reason_of(const Scene& scene, const std::string& a, const std::string& b) {
  const PairRule rule(scene);
  return rule.reason(scene.bodies[body_of(scene, a)], scene.bodies[body_of(scene, b)]);
}

/// An arm of 1 opposite to a post. It follows a joint of `gear`.
Scene geared(const std::string& type, const std::string& follower, const std::string& multiplier,
             const std::string& post = "-1 0 0.001") {
  const bool slides = follower == "prismatic";
  return robot("<link name='base'/><link name='gear'/>" + ball("arm", slides ? "0 0 0" : "1 0 -0.001") +
               ball("post", post) + joint("jg", type, "base", "gear") +
               joint("ja", follower, "base", "arm",
                     "<limit lower='-2' upper='2' effort='1' velocity='1'/><mimic joint='jg' multiplier='" +
                         multiplier + "'/>") +
               joint("jp", "fixed", "base", "post"));
}

double limit_of_gear(const Scene& scene) { return std::ranges::find(scene.links, "jg", &Link::joint)->high; }

TEST(Sound, AFollowerOfAContinuousJointGoesAsFarAsItsLeader) {
  const Scene half = geared("continuous", "continuous", "0.5");
  EXPECT_EQ(limit_of_gear(half), 2 * std::numbers::pi);
  EXPECT_EQ(proof_of(half).verdict, MotionVerdict::refuted);
  EXPECT_EQ(proof_of(geared("continuous", "continuous", "0.5", "-1.3 0 0")).verdict, MotionVerdict::never);
  const Scene whole = geared("continuous", "continuous", "2");
  EXPECT_EQ(limit_of_gear(whole), std::numbers::pi) << "once round shows all";
  EXPECT_EQ(proof_of(whole).verdict, MotionVerdict::refuted);
  // The position never repeats: nothing is proved, but a contact that can be shown is found.
  EXPECT_EQ(proof_of(geared("continuous", "continuous", "0.123456789")).verdict, MotionVerdict::refuted);
  EXPECT_EQ(proof_of(geared("continuous", "continuous", "0.123456789", "-1.3 0 0")).verdict,
            MotionVerdict::open);
}

TEST(Sound, ARackGoesAsFarAsItsGear) {
  EXPECT_EQ(proof_of(geared("continuous", "prismatic", "0.1", "0 0 1")).verdict, MotionVerdict::refuted)
      << "at 10";
  EXPECT_EQ(proof_of(geared("continuous", "prismatic", "0.1", "0 0 3")).verdict, MotionVerdict::open);
}

TEST(Sound, AFollowerOfAHeldJointIsHeld) {
  for (const char* type : {"planar", "floating", "ball", "fixed"}) {
    const Scene scene = geared(type, "continuous", "1");
    const MotionProof proof = proof_of(scene);
    EXPECT_EQ(proof.verdict, MotionVerdict::open) << type;
    EXPECT_TRUE(proof.held) << type;
    PairStudy pair;
    pair.a = body_of(scene, "arm");
    pair.b = body_of(scene, "post");
    EXPECT_EQ(joints_held_between(scene, pair).size(), 1u) << type;
  }
}

// If this were read as a tree, one link would stand in two places, and the other in none.
TEST(Sound, LinksThatAreNoTreeAreRefused) {
  const std::string links = ball("base", "0 0 -1") + ball("one", "1 0 0") + ball("two", "-1 0 0");
  const std::string loop = joint("a", "continuous", "one", "two") + joint("b", "fixed", "two", "one");
  EXPECT_THROW(robot(links + joint("c", "fixed", "base", "one") + joint("a", "fixed", "base", "two") +
                     joint("b", "continuous", "one", "two")),
               std::runtime_error);
  EXPECT_THROW(robot(links + loop), std::runtime_error);
  EXPECT_THROW(robot(links + loop + joint("c", "fixed", "base", "one")), std::runtime_error);
}

TEST(Sound, OnlyAJointMakesNeighbours) {
  using Reason = PairRule::Reason;
  const Scene sibling =
      robot(ball("base", "0 0 -1") + ball("arm", "1 0 0") + ball("post", "-1 0 0") +
            joint("ja", "continuous", "base", "arm") + joint("jp", "fixed", "base", "post"));
  EXPECT_EQ(reason_of(sibling, "arm", "post"), Reason::checked);
  EXPECT_EQ(reason_of(sibling, "arm", "base"), Reason::adjacent);
  EXPECT_EQ(reason_of(sibling, "post", "base"), Reason::same_body);
  EXPECT_EQ(proof_of(sibling).verdict, MotionVerdict::refuted);
  const Scene arms =
      robot("<link name='base'/>" + ball("arm", "1 0 0") + ball("post", "-1 0 0") +
            joint("ja", "continuous", "base", "arm") + joint("jp", "continuous", "base", "post"));
  EXPECT_EQ(reason_of(arms, "arm", "post"), Reason::checked) << "two arms on a base without shapes";
}

TEST(Sound, WhatSlidesOrFloatsOnTheWorldMayMeetWhatStandsThere) {
  for (const char* type : {"planar", "floating", "prismatic"}) {
    const std::string limit = "<limit lower='-2' upper='2' effort='1' velocity='1'/>";
    const auto on = [&](const std::string& world) {
      return robot(world + ball("arm", "0 0 0") + ball("post", "1 0 0") +
                   joint("jb", type, "world", "arm", limit) + joint("jp", "fixed", "world", "post"));
    };
    const auto reason =
        type == std::string("floating") ? PairRule::Reason::floating : PairRule::Reason::checked;
    EXPECT_EQ(reason_of(on("<link name='world'/>"), "arm", "post"), reason) << type;
    const Scene floor = on(ball("world", "0 0 -2"));
    EXPECT_EQ(reason_of(floor, "arm", "world"), reason) << type;
    EXPECT_FALSE(carries_directly(floor, 0, floor.bodies[body_of(floor, "arm")].link)) << type;
  }
}

/// A cylinder of radius 1 with a sphere at each end, below another ball on its own link.
Scene ended(const std::string& radius, const std::string& above) {
  const auto shape = [](const std::string& z, const std::string& geometry) {
    return "<collision><origin xyz='0 0 " + z + "'/><geometry>" + geometry + "</geometry></collision>";
  };
  const std::string sphere = "<sphere radius='" + radius + "'/>";
  return robot("<link name='arm'>" + shape("0", "<cylinder radius='1' length='4'/>") + shape("-2", sphere) +
               shape("2", sphere) + "</link>" + ball("post", "0 0 " + above, "0.5") +
               joint("jp", "fixed", "arm", "post"));
}

TEST(Sound, OnlyWhatFitsWithinTheDecimalsIsACapsule) {
  const Scene apart = ended("0.991", "3.497");  // 0.006 above the poles
  ASSERT_EQ(apart.folded, 0u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(prove_motion(apart, i, 3, {}).verdict, MotionVerdict::never) << apart.bodies[i].name;
  const Scene wider = ended("1.0000000009", "3.5000000008");  // overlap by 1e-10
  ASSERT_EQ(wider.folded, 1u);
  EXPECT_GE(wider.bodies[0].solid.rounding, 1.0000000009);
  EXPECT_EQ(proof_of(wider).verdict, MotionVerdict::open);
  const Scene narrower =
      ended("0.9999999992", "3.4999999996");  // apart by 4e-10, though the capsule overlaps
  ASSERT_EQ(narrower.folded, 1u);
  EXPECT_EQ(proof_of(narrower).verdict, MotionVerdict::open);
}

TEST(Sound, AnExemptionIsAboutContact) {
  Scene scene = geared("continuous", "continuous", "1", "-1.3 0 0");
  scene.exemptions.push_back({scene.bodies[0].link, scene.bodies[1].link, "Never"});
  MotionQuestion question;
  question.clearance = 0.15;
  const MotionStudy study = prove_motions(scene, {}, {}, question);
  ASSERT_EQ(study.exemptions.size(), 1u);
  EXPECT_EQ(study.exemptions[0].verdict, MotionVerdict::within);
  EXPECT_GT(study.exemptions[0].bodies.at(0).bound, 0) << "and never touches";
  EXPECT_LT(study.exemptions[0].bodies.at(0).bound, 0.1001);
}

/// Two hinges. The second one follows the first.
Scene followed(const std::string& before, const std::string& equality = "") {
  return read_text(".xml", "<mujoco>" + before + R"(<worldbody>
    <body name="a"><joint name="one" range="-90 90"/><geom size="1"/></body>
    <body name="b" pos="3 0 0"><joint name="two" range="-90 90"/><geom size="1"/></body></worldbody>
    <equality><joint joint1="two" joint2="one" )" +
                               equality + "/></equality></mujoco>");
}
Link link_of(const Scene& scene, const std::string& joint) {
  for (const Link& link : scene.links)
    if (link.joint == joint) return link;
  throw std::runtime_error("no joint " + joint);
}

TEST(Sound, WhatSwitchesEqualitiesAndLimitsOffIsRead) {
  const Scene plain = followed("");
  ASSERT_TRUE(link_of(plain, "two").follow);
  EXPECT_EQ(link_of(plain, "two").follow->multiplier, 1) << "the default of polycoef";
  EXPECT_FALSE(link_of(plain, "one").endless);
  EXPECT_EQ(link_of(followed("", "polycoef='0.2'"), "two").follow->multiplier, 1)
      << "what is not given stays";
  EXPECT_FALSE(link_of(followed("<default><equality active='false'/></default>"), "two").follow);
  EXPECT_TRUE(link_of(followed("<default><joint active='false'/></default>"), "two").follow);
  EXPECT_FALSE(link_of(followed("<option><flag equality='disable'/></option>"), "two").follow);
  EXPECT_TRUE(link_of(followed("<option><flag limit='disable'/></option>"), "one").endless);
  const Scene free = followed("<option><flag constraint='disable'/></option>");
  EXPECT_FALSE(link_of(free, "two").follow);
  EXPECT_TRUE(link_of(free, "one").endless);
}

TEST(Sound, WhatSwitchesTheFilterOfParentsOffIsRead) {
  const auto carried = [](const std::string& before) {
    return read_text(".xml", "<mujoco>" + before + R"(<worldbody><body name="a"><freejoint/>
      <geom name="one" size="1"/><body name="b"><joint name="x"/><joint name="y" axis="0 1 0"/>
      <geom name="two" size="1"/></body></body></worldbody></mujoco>)");
  };
  const Scene plain = carried(""), off = carried("<option><flag filterparent='disable'/></option>");
  EXPECT_EQ(reason_of(plain, "a/one", "b/two"), PairRule::Reason::adjacent);
  EXPECT_EQ(reason_of(off, "a/one", "b/two"), PairRule::Reason::checked);
  EXPECT_FALSE(carries_directly(off, off.bodies[0].link, off.bodies[1].link));
}

TEST(Sound, AnEmptyRangeIsNoLimit) {
  const Scene scene = read_text(".xml", R"(<mujoco><worldbody><body name="a"><joint name="one" range="30 30"/>
    <geom size="1"/></body></worldbody></mujoco>)");
  EXPECT_TRUE(link_of(scene, "one").endless);
}

TEST(Sound, AnOrientationOfTwoKindsIsRefused) {
  const auto turned = [](const std::string& own) {
    return read_text(
        ".xml", "<mujoco><default><geom euler='0 90 0'/></default><worldbody><body name='a'><geom size='1' " +
                    own + "/></body></worldbody></mujoco>");
  };
  EXPECT_THROW(turned("quat='1 0 0 0'"), std::runtime_error);
  EXPECT_NO_THROW(turned("euler='0 0 0'"));
  EXPECT_NO_THROW(turned(""));
}

TEST(Sound, AnOriginByAQuaternionIsRefused) {
  const auto turned = [](const std::string& joint, const std::string& inertia) {
    return robot(ball("a", "0 0 0") + "<link name='b'><inertial><origin " + inertia +
                 "/><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
                 "izz='1'/></inertial></link><joint name='j' type='fixed'><parent link='a'/><child "
                 "link='b'/><origin " +
                 joint + "/></joint>");
  };
  EXPECT_THROW(turned("quat_xyzw='1 0 0 0'", ""), std::runtime_error);
  EXPECT_NO_THROW(turned("rpy='0 0 1'", "quat_xyzw='1 0 0 0'"));
}

TEST(Sound, AnAxisOfAnyLengthTurns) {
  const Scene scene =
      robot(ball("a", "0 0 0") + ball("b", "1 0 0") +
            "<joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1e200'/>"
            "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint>");
  EXPECT_EQ(link_of(scene, "j").axis, Vector3(0, 0, 1));
}

TEST(Sound, PairsThatAFileNamesAreChecked) {
  const Scene scene = read_text(".xml", R"(<mujoco><worldbody><geom name="floor" size="1"/>
    <body name="a" pos="3 0 0"><freejoint/><geom name="one" size="1" contype="0" conaffinity="0"/></body>
    <body name="b" pos="6 0 0"><freejoint/><geom name="two" type="box" size="1 1 1" contype="0" conaffinity="0"/>
    <geom name="seen" size="1" contype="0" conaffinity="0"/></body></worldbody>
    <contact><pair geom1="one" geom2="two"/></contact></mujoco>)");
  EXPECT_TRUE(scene.left_out.empty());
  ASSERT_EQ(scene.bodies.size(), 3u) << "but not what is only to be seen";
  EXPECT_EQ(reason_of(scene, "a/one", "b/two"), PairRule::Reason::checked);
  EXPECT_EQ(reason_of(scene, "b/two", "a/one"), PairRule::Reason::checked);
  EXPECT_EQ(reason_of(scene, "world/floor", "a/one"), PairRule::Reason::disabled);
}

}  // namespace
}  // namespace cyl
