// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "base/files.hpp"
#include "reports/scene/motion_text.hpp"
#include "reports/scene/scene_report.hpp"
#include "scenes/scene_files.hpp"

namespace cyl {
namespace {

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

SceneQuestion question(bool prove) {
  SceneQuestion q;
  q.file = "robot.urdf";
  q.configurations = 200;
  q.prove = prove;
  return q;
}

/// What comes back when it is read for the same robot: by the names of the links.
std::map<std::pair<std::string, std::string>, std::string> read_back(Scene scene, const std::string& text) {
  const auto file =
      std::filesystem::path(testing::TempDir()) / ("back_" + std::to_string(getpid()) + ".srdf");
  write_file(file.string(), text);
  scene.exemptions.clear();
  scene.notes.clear();
  read_srdf(file.string(), scene);
  std::filesystem::remove(file);
  EXPECT_TRUE(scene.notes.empty());
  std::map<std::pair<std::string, std::string>, std::string> reasons;
  for (const Exemption& e : scene.exemptions)
    reasons[std::minmax(scene.links[e.a].name, scene.links[e.b].name)] = e.reason;
  return reasons;
}

TEST(SrdfText, DisablesWhatIsKnownAndTellsWhy) {
  const Scene scene = read_scene(folder + "arm.urdf");
  const SceneQuestion q = question(false);
  const std::string text = srdf_text(scene, q, study_scene(scene, q));
  const auto reasons = read_back(scene, text);
  EXPECT_EQ(reasons.at({"elbow", "upper"}), "Adjacent");
  EXPECT_EQ(reasons.at({"fore", "hand"}), "Adjacent") << "one rigid body";
  EXPECT_EQ(reasons.at({"base", "upper"}), "Never");
  EXPECT_EQ(reasons.at({"left_finger", "right_finger"}), "Default");
  EXPECT_FALSE(reasons.contains({"hand", "table"})) << "the table is a box";
  EXPECT_FALSE(reasons.contains({"base", "fore"})) << "they meet at times";
  EXPECT_NE(text.find("<!-- 200 draws without a hit: below 1.5 % at 95 % -->"), text.npos) << text;
  EXPECT_NE(
      text.find("<!-- table - hand: not disabled: they come near the bound of a box or mesh, so nothing is "
                "known -->"),
      text.npos)
      << text;
  EXPECT_NE(text.find(": shapes were not looked at -->"), text.npos) << "a mesh of the camera";
}

TEST(SrdfText, NoNeverAcrossAJointThatWasNotMoved) {
  const Scene scene = read_scene(folder + "porter.urdf");
  const SceneQuestion q = question(false);
  const SceneStudy study = study_scene(scene, q);
  const auto reasons = read_back(scene, srdf_text(scene, q, study));
  std::size_t held = 0, never = 0;
  for (const PairStudy& pair : study.pairs) {
    const std::string &a = scene.links[scene.bodies[pair.a].link].name,
                      &b = scene.links[scene.bodies[pair.b].link].name;
    const auto said = reasons.find(std::minmax(a, b));
    const bool is_never = said != reasons.end() && said->second == "Never",
               is_held = !held_between(scene, pair).empty();
    EXPECT_FALSE(is_never && is_held) << a << " - " << b;
    held += is_held;
    never += is_never;
  }
  EXPECT_GT(held, 0u);
  EXPECT_GT(never, 0u);
}

// tower - trolley is met in fewer than 1 of 100 configurations: draws may miss it, the proof does not.
TEST(SrdfText, NoNeverThatIsRefuted) {
  Scene scene = read_scene(folder + "crane.urdf");
  const auto link = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(scene.links, name, &Link::name) - scene.links.begin());
  };
  const SceneQuestion q = question(true);
  const SceneStudy drawn = study_scene(scene, q);
  const auto drawn_reasons = read_back(scene, srdf_text(scene, q, drawn));
  EXPECT_EQ(drawn_reasons.at({"hook", "tower"}), "Never");
  EXPECT_FALSE(drawn_reasons.contains({"tower", "trolley"})) << "the proof shows a configuration";
  scene.exemptions.push_back({link("trolley"), link("tower"), "Never"});
  scene.disabled.emplace_back(link("trolley"), link("tower"));
  const std::string text = srdf_text(scene, q, study_scene(scene, q));
  const auto reasons = read_back(scene, text);
  EXPECT_EQ(reasons.at({"counterweight", "hook"}), "Never");
  EXPECT_FALSE(reasons.contains({"tower", "trolley"}));
  EXPECT_NE(text.find("NOT disabled as "), text.npos);
  EXPECT_NE(text.find("proved: at least "), text.npos);
}

TEST(SrdfText, NamesMayHoldAnything) {
  Scene scene = still_scene({{"a", {}}, {"b", {{3, 0, 0}, {0, 0, 1}, 1, 1}}, {"c", {}}});
  scene.links[0].name = "one--\"&<";
  scene.links[1].name = "other-->";
  scene.links[2].name = "third";
  scene.left_out.push_back({"box", "third"});
  const SceneQuestion q = question(false);
  const auto reasons = read_back(scene, srdf_text(scene, q, study_scene(scene, q)));
  EXPECT_EQ(reasons.at({"one--\"&<", "other-->"}), "Never");
  EXPECT_EQ(reasons.at({"one--\"&<", "third"}), "Always");
}

TEST(SrdfText, RatesAreRoundedUp) {
  EXPECT_EQ(rate_text(400), "0.75 %");
  EXPECT_EQ(rate_text(1000), "0.3 %");
  EXPECT_EQ(rate_text(1), "100 %");
}

}  // namespace
}  // namespace cyl
