// SPDX-License-Identifier: MIT
// MJCF beyond the MuJoCo that is installed here: newer parts, included files, and refused files.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <tuple>

#include "base/error_of_test.hpp"
#include "base/scratch_test.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

class Mjcf : public testing::Test, protected Scratch {
 protected:
  Mjcf() { std::filesystem::create_directory(folder / "parts"); }
  Scene read(const std::string& inside) const {
    return read_scene(write("model.xml", "<mujoco>" + inside + "</mujoco>"));
  }
  std::string why(const std::string& inside) const {
    const std::string error = error_of([&] { read(inside); }), file = folder / "model.xml";
    return error.starts_with(file) ? error.substr(file.size()) : error;
  }
};

TEST_F(Mjcf, IncludesFilesBesideTheFirst) {
  write("parts/arm.xml",
        "<mujocoinclude><body name='arm'><include file='parts/geom.xml'/></body></mujocoinclude>");
  write("parts/geom.xml", "<any><geom name='g' size='0.5'/></any>");
  write("ball.xml", "<any><geom size='0.5'/></any>");
  write("ring.xml", "<any><include file='ring.xml'/></any>");
  const Scene scene = read("<worldbody><include file='parts/arm.xml'/></worldbody>");
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].name, "arm/g");
  EXPECT_EQ(why("<include file='ring.xml'/>"), ": files include each other in a circle");
  EXPECT_EQ(read("<worldbody><include file='ball.xml'/></worldbody>"
                 "<worldbody><body><include file='ball.xml'/></body></worldbody>")
                .bodies.size(),
            2u)
      << "a file twice is no circle";
  EXPECT_TRUE(why("<include file='none.xml'/>").ends_with("none.xml: it is not there"));
}

TEST_F(Mjcf, WhatIsNotReadIsNamed) {
  const Scene scene = read(R"(<option newest="1"/><keyframe/><worldbody>
    <geom type="hfield" hfield="h"/><geom type="sdf"/><geom type="sphere" mesh="m"/><geom type="mesh" mesh="m"/>
    <geom name="shown" contype="0" conaffinity="0" type="plane"/>
    <geom name="met" contype="0" conaffinity="0" size="1"/><geom size="1"/>
    <body name="b"><composite type="cable"/><replicate count="3"><geom size="1"/></replicate><site/></body>
    <body name="m" mocap="true"><geom size="1"/></body></worldbody>
    <contact><pair geom1="met" geom2="geom 6"/><exclude body1="b" body2="c"/></contact>
    <equality><connect body1="b" body2="m"/></equality>)");
  EXPECT_EQ(scene.left_out, (std::vector<LeftOut>{{"hfield", "world"},
                                                  {"sdf", "world"},
                                                  {"sphere", "world"},
                                                  {"mesh", "world"},
                                                  {"composite", "b"},
                                                  {"replicate", "b"}}));
  EXPECT_EQ(scene.bodies.size(), 3u);
  EXPECT_TRUE(scene.links.at(2).held);
  EXPECT_EQ(scene.notes,
            (std::vector<std::string>{
                "A mesh of world cannot be read: m: no such asset.",
                "Joint m is carried from outside (mocap): it stays in the place that the file gives.",
                "Exclude b, c: no such bodies.",
                "Equality connect is ignored: the bodies that it connects move independently.",
                "Not needed and not read: keyframe, option."}));
}

// A class inherits from the class around it. An element's own values win. A joint has limits if it has a
// range.
TEST_F(Mjcf, ClassesInClasses) {
  const Scene scene = read(R"(<default><geom type="capsule" size="1 2"/><default class="a"><geom size="3 4"/>
    <joint range="0 90"/><default class="b"><geom type="cylinder"/></default></default></default>
    <worldbody><geom/><body childclass="a"><joint name="j"/><geom/><geom class="b"/><geom class="main"/>
    <frame childclass="b"><geom size="5 6"/></frame><body><joint name="free" limited="false"/><geom/></body></body>
    </worldbody>)");
  ASSERT_EQ(scene.bodies.size(), 6u);
  const auto expect = [&](std::size_t i, SolidKind kind, double wide, double height) {
    const Solid& c = scene.bodies[i].solid;
    EXPECT_EQ(kind_of(c), kind) << i;
    EXPECT_EQ(c.radius + c.rounding, wide) << i;
    EXPECT_EQ(c.height, height) << i;
  };
  expect(0, SolidKind::capsule, 1, 4);
  expect(1, SolidKind::capsule, 3, 8);
  expect(2, SolidKind::cylinder, 3, 8);
  expect(3, SolidKind::capsule, 1, 4);
  expect(4, SolidKind::cylinder, 5, 12);
  expect(5, SolidKind::capsule, 3, 8);
  EXPECT_NEAR(scene.links.at(1).high, std::acos(0.0), 1e-15);
  EXPECT_NEAR(scene.links.at(3).high, 2 * std::acos(0.0), 1e-15);
}

// Each joint of a body is moved or held by itself.
TEST_F(Mjcf, HoldsWhatItDoesNotMove) {
  const Scene scene = read(R"(<worldbody><geom size="1"/><body name="b"><joint name="x" type="slide"/>
    <joint name="s" type="ball"/><joint name="h"/><geom size="1"/></body></worldbody>)");
  ASSERT_EQ(scene.links.size(), 5u);
  for (const auto& [link, joint, held] : {std::tuple(1, "x", true), {2, "s", true}, {3, "h", false}}) {
    EXPECT_EQ(scene.links[static_cast<std::size_t>(link)].joint, joint);
    EXPECT_EQ(scene.links[static_cast<std::size_t>(link)].held, held);
  }
  EXPECT_EQ(scene.bodies.back().link, 4u);
  EXPECT_EQ(PairRule(scene).reason(scene.bodies[0], scene.bodies[1]), PairRule::Reason::checked);
  for (const char* joint : {"<joint type='free'/>", "<freejoint/>"}) {
    const Scene free = read("<worldbody><geom size='1'/><body>" + std::string(joint) +
                            "<geom size='1'/><body><joint/><geom size='1'/></body></body></worldbody>");
    for (const std::size_t i : {1, 2})
      EXPECT_EQ(PairRule(free).reason(free.bodies[0], free.bodies[i]), PairRule::Reason::floating);
  }
}

// Two joints of a body both belong to it. If three bodies form a chain, the first does not carry the last.
TEST_F(Mjcf, NeighboursAreBodiesOfWhichOneCarriesTheOther) {
  const Scene scene = read(R"(<worldbody><body><joint/><geom size="1"/><body><joint/><joint/><geom size="1"/>
    <body><joint/><geom size="1"/></body></body></body></worldbody>)");
  const auto neighbours = [&](std::size_t a, std::size_t b) {
    return carries_directly(scene, scene.bodies[a].link, scene.bodies[b].link);
  };
  EXPECT_TRUE(neighbours(0, 1));
  EXPECT_TRUE(neighbours(2, 1));
  EXPECT_FALSE(neighbours(0, 2));
}

TEST_F(Mjcf, FaultsAreNamed) {
  EXPECT_EQ(why("<worldbody><body name='body 2'><body/></body></worldbody>"),
            ": body 'body 2' is there twice: rename one");
  EXPECT_EQ(why("<worldbody><geom name='g' type='capsule' size='1'/></worldbody>"),
            ": geom g of world: sizes must be positive");
  EXPECT_EQ(why("<worldbody><geom name='g' size='nan'/></worldbody>"),
            ": geom g of world: geom g: size is 'nan', no numbers");
  EXPECT_EQ(why("<worldbody><geom class='c'/></worldbody>"), ": no class 'c'");
  EXPECT_EQ(why("<worldbody><body pos='1 2'/></worldbody>"), ": pos is '1 2', not 3 numbers");
  EXPECT_EQ(why("<worldbody><body><joint name='j' range='2 1'/></body></worldbody>"),
            ": joint j: its range is none");
  EXPECT_EQ(why("<worldbody><body><joint name='j' axis='0 0 0'/></body></worldbody>"),
            ": joint j: its axis is zero");
  EXPECT_EQ(why("<worldbody>\n<body></worldbody>").substr(0, 9), ": line 2:");
  EXPECT_EQ(why("<compiler eulerseq='xya'/>"), ": eulerseq is 'xya'");
  EXPECT_EQ(why("<compiler coordinate='global'/>"), ": global coordinates, which MuJoCo gave up too");
}

}  // namespace
}  // namespace cyl
