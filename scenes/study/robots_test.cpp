// SPDX-License-Identifier: MIT
// Every robot of corpus/scenes: its shapes, its checked pairs, and how often they come near. An independent
// reader in Python, with its own kinematics and distances, found the same numbers of pairs without boxes and
// planes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "corpus/pairs/solid_kind.hpp"
#include "oracles/referee/referee.hpp"
#include "scenes/read/bounding_solid.hpp"
#include "scenes/read/mesh_files.hpp"
#include "scenes/read/named_files.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {
namespace {

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

struct Robot {
  const char* file;
  const char* shapes;  ///< including shapes that are left out
  std::size_t left_out, folded;
  std::size_t pairs;   ///< the checked pairs
  std::size_t within;  ///< all pairs within in 100 configurations
};

void PrintTo(const Robot& robot, std::ostream* out) { *out << robot.file; }

class Robots : public testing::TestWithParam<Robot> {
 protected:
  SceneStudy study() const {
    SceneOptions question;
    question.clearance = clearance;
    question.configurations = 100;
    return study_scene(scene, question);
  }
  const double clearance = 0.02;
  const Scene scene = read_scene(folder + GetParam().file);
};

TEST_P(Robots, HaveTheirShapes) {
  std::map<std::string, int> counts;
  for (const Body& body : scene.bodies) ++counts[body.box ? body.box->shape : to_string(kind_of(body.solid))];
  for (const LeftOut& other : scene.left_out) ++counts[other.shape];
  std::string shapes;
  for (const auto& [shape, count] : counts) shapes += std::to_string(count) + " " + shape + " ";
  EXPECT_EQ(shapes, GetParam().shapes);
  EXPECT_EQ(scene.left_out.size(), GetParam().left_out);
  EXPECT_EQ(scene.folded, GetParam().folded);
}

// The referee checks each pair, and the sums are as counted.
TEST_P(Robots, ComeNearAsOftenAsTheRefereeSees) {
  const SceneStudy all = study();
  EXPECT_EQ(all.pairs.size(), GetParam().pairs);
  std::vector<std::size_t> within(all.pairs.size());
  for (std::size_t k = 0; k < all.configurations; ++k) {
    const std::vector<Solid> placed = place(scene, draw_joints(scene, 1, k));
    for (std::size_t i = 0; i < within.size(); ++i)
      within[i] += referee_within({placed[all.pairs[i].a], placed[all.pairs[i].b]}, clearance).value();
  }
  std::size_t sum = 0;
  for (std::size_t i = 0; i < within.size(); ++i) {
    EXPECT_EQ(all.pairs[i].within, within[i]);
    sum += within[i];
  }
  EXPECT_EQ(sum, GetParam().within);
}

INSTANTIATE_TEST_SUITE_P(
    All, Robots,
    testing::Values(
        Robot{"crane.urdf", "1 box 7 cylinder 1 sphere ", 0, 0, 20, 13},
        Robot{"twenty.urdf", "20 cylinder ", 0, 0, 171, 99},
        Robot{"arm.urdf", "1 box 5 capsule 4 cylinder 1 mesh 8 sphere ", 1, 3, 99, 393},
        Robot{"porter.urdf", "5 box 1 capsule 1 cylinder 3 mesh 2 sphere ", 1, 0, 39, 29},
        Robot{"hand.xml", "2 box 10 capsule 3 cylinder 1 ellipsoid 2 mesh 2 sphere ", 1, 0, 112, 1019},
        Robot{"walker.xml", "4 capsule 1 cylinder 1 ellipsoid 1 half_space 2 sphere ", 0, 0, 9, 14},
        Robot{"crane.xml", "5 cylinder 1 half_space 1 sphere ", 0, 0, 12, 15}),
    [](const auto& robot) {
      std::string name = robot.param.file;
      name[name.find('.')] = '_';
      return name;
    });

const Body& body(const Scene& scene, const std::string& name) {
  return *std::ranges::find(scene.bodies, name, &Body::name);
}

void expect_held(const Solid& solid, const Vector3& point, const std::string& name) {
  EXPECT_NE(judge_verdict({solid, {point, {0, 0, 1}, 0, 0, 0}}).verdict, Verdict::disjoint) << name;
}

std::vector<Vector3> vertices_of(const std::string& mesh) {
  return read_mesh(mesh, NamedFiles(folder + mesh).read(folder + mesh, NamedBy::user));
}

// The meshes have the scale and the place that the files give.
TEST(RobotBounds, HoldTheVerticesOfTheirMeshes) {
  using Turn = Eigen::AngleAxisd;
  const Scene porter = read_scene(folder + "porter.urdf"), hand = read_scene(folder + "hand.xml");
  for (const Vector3& v : vertices_of("meshes/bumper.stl"))
    expect_held(body(porter, "cart/bumper").solid,
                Vector3(0.36, 0, 0.15) + Turn(0.2, Vector3::UnitY()) * (0.01 * v), "bumper");
  for (const Vector3& v : vertices_of("meshes/plate.obj")) {
    const Vector3 of_fore = v.cwiseProduct(Vector3(0.002, 0.002, 0.004));
    expect_held(body(porter, "fore/2").solid,
                Vector3(0.04, 0, 0.1) + Turn(0.4, Vector3::UnitZ()) * (Turn(1.5, Vector3::UnitX()) * of_fore),
                "plate of porter");
    expect_held(body(hand, "palm/plate").solid,
                Vector3(0, 0.012, 0.03) + Turn(15 * std::numbers::pi / 180, Vector3::UnitZ()) * (0.001 * v),
                "plate of hand");
  }
}

}  // namespace
}  // namespace cyl
