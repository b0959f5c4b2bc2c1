// SPDX-License-Identifier: MIT
// Shapes, pairs and approaches of every robot in corpus/scenes, against a script that shares no line with us.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

#include "base/json.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "scenes/scene_files.hpp"
#include "scenes/scene_study.hpp"

namespace cyl {
namespace {

using Counts = std::map<std::string, std::size_t>;

nlohmann::json counted(const std::string& arguments) {
  const std::string command = "python3 '" DAYLIGHT_SOURCE_DIR "/scenes/approaches.py' " + arguments;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return parse_json(text);
}

Counts shapes_of(const Scene& scene) {
  Counts counts;
  for (const Body& body : scene.bodies) ++counts[to_string(kind_of(body.solid))];
  for (const LeftOut& other : scene.left_out) ++counts[other.shape];
  return counts;
}

/// Both names of a pair, the lower one first.
std::string name_of(const Scene& scene, const PairStudy& pair) {
  const auto& [a, b] = std::minmax(scene.bodies[pair.a].name, scene.bodies[pair.b].name);
  return a + " - " + b;
}

TEST(Approaches, EveryShapeOfEveryRobotIsCounted) {
  std::size_t robots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DAYLIGHT_SOURCE_DIR "/corpus/scenes")) {
    const std::string file = entry.path().string();
    if (entry.path().extension() != ".urdf" && entry.path().extension() != ".xml") continue;
    ++robots;
    const Scene scene = read_scene(file);
    EXPECT_EQ(shapes_of(scene), counted("--configurations 0 '" + file + "'")["shapes"].get<Counts>()) << file;
  }
  EXPECT_GE(robots, 5u);
}

TEST(Approaches, AsManyAsAScriptFinds) {
  for (const char* name : {"crane", "twenty", "arm"}) {
    const std::string file = std::string(DAYLIGHT_SOURCE_DIR "/corpus/scenes/") + name + ".urdf";
    const Scene scene = read_scene(file);
    SceneQuestion question;
    question.clearance = 0.02;
    question.configurations = 100;
    for (const bool each_link : {false, true}) {
      question.each_link = each_link;
      const SceneStudy study = study_scene(scene, question);
      const auto expected = counted("--configurations 100 '" + file + (each_link ? "' --each-link" : "'"));
      EXPECT_EQ(scene.folded, expected["folded"]) << name;
      Counts within;
      std::size_t all = 0;
      for (const PairStudy& pair : study.pairs) all += within[name_of(scene, pair)] = pair.within;
      EXPECT_EQ(within, expected["by_pair"].get<Counts>()) << name;
      EXPECT_GT(all, 10u) << name;
    }
  }
}

}  // namespace
}  // namespace cyl
