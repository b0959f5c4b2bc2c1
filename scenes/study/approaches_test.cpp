// SPDX-License-Identifier: MIT
// Shapes, places, pairs and approaches of every robot in corpus/scenes, against a script that shares no line
// with us.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "base/json.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {
namespace {

using Counts = std::map<std::string, std::size_t>;

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

nlohmann::json counted(const std::string& arguments) {
  const std::string command = "python3 '" DAYLIGHT_SOURCE_DIR "/scenes/study/approaches.py' " + arguments;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return parse_json(text);
}

nlohmann::json vector_of(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

/// The solids that stand in for boxes and meshes, for the script to try; away when it is done with.
class Bounds {
 public:
  explicit Bounds(const Scene& scene)
      : file_((std::filesystem::path(testing::TempDir()) / ("bounds_" + std::to_string(getpid()) + ".json"))
                  .string()) {
    nlohmann::json all = nlohmann::json::object();
    for (const Body& body : scene.bodies) {
      const Cylinder& c = body.solid;
      if (body.box) all[body.name] = {vector_of(c.center), vector_of(c.axis), c.radius, c.height, c.rounding};
    }
    std::ofstream(file_) << all;
  }
  ~Bounds() { std::filesystem::remove(file_); }
  std::string option() const { return " --bounds '" + file_ + "' "; }

 private:
  std::string file_;
};

Counts shapes_of(const Scene& scene) {
  Counts counts;
  for (const Body& body : scene.bodies) ++counts[body.box ? body.box->shape : to_string(kind_of(body.solid))];
  for (const LeftOut& other : scene.left_out) ++counts[other.shape];
  return counts;
}

/// Both names of a pair, the lower one first.
std::string name_of(const Scene& scene, const PairStudy& pair) {
  const auto& [a, b] = std::minmax(scene.bodies[pair.a].name, scene.bodies[pair.b].name);
  return a + " - " + b;
}

/// Centres and axes, of boxes and meshes those of their boxes, to 1e-12.
void expect_places(const Scene& scene, const nlohmann::json& expected) {
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const std::vector<Pose> poses = pose_links(scene, draw_joints(scene, 1, k));
    std::vector<Cylinder> placed;
    place(scene, poses, placed);
    ASSERT_EQ(expected[k].size(), placed.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const Body& body = scene.bodies[i];
      Vector3 center = placed[i].center, axis = placed[i].axis;
      if (body.box) {
        const Pose box = poses[body.link] * body.box->pose;
        center = box.translation();
        axis = box.linear().col(2);
      }
      const auto& [there, along] = expected[k].at(body.name).get<std::array<std::array<double, 3>, 2>>();
      for (int x = 0; x < 3; ++x) {
        EXPECT_NEAR(center[x], there[static_cast<std::size_t>(x)], 1e-12) << body.name;
        EXPECT_NEAR(axis[x], along[static_cast<std::size_t>(x)], 1e-12) << body.name;
      }
    }
  }
}

TEST(Approaches, EveryShapeOfEveryRobotIsCountedAndPlaced) {
  std::size_t robots = 0, bounded = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = entry.path().string();
    if (entry.path().extension() != ".urdf" && entry.path().extension() != ".xml") continue;
    ++robots;
    const Scene scene = read_scene(file);
    const Bounds bounds(scene);
    const auto expected = counted(bounds.option() + "--configurations 20 --places 20 '" + file + "'");
    EXPECT_EQ(shapes_of(scene), expected["shapes"].get<Counts>()) << file;
    EXPECT_EQ(scene.left_out.size(), expected["not_looked_at"]) << file;
    EXPECT_EQ(expected["outside"], 0) << file << ": corners beyond what is to hold them";
    bounded += static_cast<std::size_t>(
        std::ranges::count_if(scene.bodies, [](const Body& b) { return b.box.has_value(); }));
    expect_places(scene, expected["places"]);
  }
  EXPECT_GE(robots, 7u);
  EXPECT_GE(bounded, 12u);
}

/// Of so many configurations; returns how many pairs with a box or mesh come near a bound, and really near.
std::pair<std::size_t, std::size_t> expect_approaches(const std::string& name, std::size_t configurations,
                                                      bool each_link) {
  const std::string file = folder + name;
  const Scene scene = read_scene(file);
  SceneOptions question;
  question.clearance = 0.02;
  question.configurations = configurations;
  question.each_link = each_link;
  const SceneStudy study = study_scene(scene, question);
  const Bounds bounds(scene);
  const auto expected = counted(bounds.option() + "--configurations " + std::to_string(study.configurations) +
                                " '" + file + (each_link ? "' --each-link" : "'"));
  EXPECT_EQ(scene.folded, expected["folded"]) << name;
  Counts within;
  std::size_t all = 0;
  for (const PairStudy& pair : study.pairs) all += within[name_of(scene, pair)] = pair.within;
  EXPECT_EQ(within, expected["by_pair"].get<Counts>()) << name;
  EXPECT_GT(all, 10u) << name;
  std::pair<std::size_t, std::size_t> near{0, 0};
  for (const auto& [pair, count] : expected["really"].get<Counts>()) {
    EXPECT_LE(count, within[pair]) << name << ": " << pair << " is nearer than what holds it";
    near.first += within[pair];
    near.second += count;
  }
  return near;
}

TEST(Approaches, AsManyAsAScriptFinds) {
  for (const char* name : {"crane.urdf", "twenty.urdf", "arm.urdf"})
    for (const bool each_link : {false, true}) expect_approaches(name, 100, each_link);
}

TEST(Approaches, AsManyAsAScriptFindsOfBoxesMeshesAndMjcf) {
  const auto [near, really] = expect_approaches("porter.urdf", 400, false);
  EXPECT_GT(really, 50u);
  EXPECT_GT(near, really);
  expect_approaches("hand.xml", 400, false);
  expect_approaches("hand.xml", 50, true);
  expect_approaches("walker.xml", 400, false);
}

}  // namespace
}  // namespace cyl
