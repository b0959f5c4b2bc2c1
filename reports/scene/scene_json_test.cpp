// SPDX-License-Identifier: MIT
// The JSON of a study.
#include <gtest/gtest.h>

#include "base/json.hpp"
#include "reports/scene/scene_report.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

using json = nlohmann::json;

SceneOptions question(const char* file) {
  SceneOptions q;
  q.file = file;
  q.configurations = 20;
  return q;
}

Scene crane() { return read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/crane.urdf"); }

std::string written(const Scene& scene, const SceneOptions& q) {
  return study_json(scene, q, study_scene(scene, q));
}

// The crane's ground is a box.
TEST(SceneJson, HoldsTheSolids) {
  const Scene scene = crane();
  const json all = parse_json(written(scene, question("crane.urdf")));
  std::size_t ground = 0;
  while (!all["bodies"].at(ground)["solid"].contains("shape")) ++ground;
  EXPECT_EQ(all["bodies"][ground]["solid"], parse_json(R"({"shape":"box","center":[0.0,0.0,-0.05],
            "edges":[4.0,4.0,0.1],"quaternion":[1.0,0.0,0.0,0.0]})"));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    EXPECT_EQ(all["bodies"][i]["name"], scene.bodies[i].name);
    EXPECT_EQ(all["bodies"][i]["solid"].value("radius", 0.0), scene.bodies[i].solid.radius);
  }
}

TEST(SceneJson, ALineAPair) {
  const Scene scene = crane();
  const SceneOptions q = question("crane.urdf");
  const SceneStudy study = study_scene(scene, q);
  const std::string text = study_json(scene, q, study);
  std::size_t lines = 0;
  for (std::size_t at = text.find("\n  {\"a\":"); at != text.npos; at = text.find("\n  {\"a\":", at + 1))
    ++lines;
  EXPECT_EQ(lines, study.pairs.size());
}

}  // namespace
}  // namespace cyl
