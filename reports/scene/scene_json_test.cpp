// SPDX-License-Identifier: MIT
// The JSON of a study, and the page that is drawn from it.
#include <gtest/gtest.h>

#include "base/json.hpp"
#include "reports/scene/scene_report.hpp"
#include "reports/schemas/schema_check_test.hpp"
#include "reports/web/page_data_test.hpp"
#include "reports/web/page_template.hpp"
#include "scenes/read/scene_files.hpp"
#include "scenes/study/shown_pairs.hpp"

namespace cyl {
namespace {

using json = nlohmann::json;

const std::string hostile = "</script></style><img src=x onerror=alert(1)>\"'&\x01\xff<!--@@STYLE@@$&";

SceneOptions question(const char* file) {
  SceneOptions q;
  q.file = file;
  q.configurations = 20;
  q.verify = true;
  return q;
}

Scene crane() { return read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/crane.urdf"); }

std::string written(const Scene& scene, const SceneOptions& q) {
  return study_json(scene, q, study_scene(scene, q));
}

TEST(SceneJson, KeepsToItsSchema) {
  if (schema_python().empty()) SKIP_WITHOUT("python3-jsonschema");
  const std::string document = written(crane(), question("crane.urdf"));
  EXPECT_TRUE(keeps_to("scene.json", document)) << document;
  EXPECT_TRUE(keeps_to("scene.json", written(read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/hand.xml"),
                                             question("hand.xml"))));
  EXPECT_TRUE(keeps_to("scene.json", written(still_scene({{"alone", {}}}), question("alone.csv"))));
  SceneOptions proving = question("crane.urdf");
  proving.prove = true;
  const std::string proofs = written(crane(), proving);
  EXPECT_TRUE(keeps_to("scene.json", proofs));
  EXPECT_EQ(parse_json(proofs)["motions"].size(), parse_json(proofs)["pairs"].size());
  EXPECT_EQ(parse_json(proofs)["exemptions"].size(), 1u);
  const json good = parse_json(document);
  for (const char* planted :
       {R"([{"op":"remove","path":"/kept/0/cylinders/0/axis"}])",
        R"([{"op":"replace","path":"/kept/0/cylinders/0/radius","value":-1}])",
        R"([{"op":"replace","path":"/kept/0/reasons/0/why","value":"by chance"}])",
        R"([{"op":"remove","path":"/kept/0/pairs/0/on_a/2"}])",
        R"([{"op":"replace","path":"/pairs/0/needs","value":"inner capsule"}])",
        R"([{"op":"remove","path":"/pairs/0/models/5"}])", R"([{"op":"remove","path":"/words/capsules"}])",
        R"([{"op":"remove","path":"/kept/0/boxes/0/axes/2"}])",
        R"([{"op":"remove","path":"/links/1/limits"}])",
        R"([{"op":"remove","path":"/links/1/origin/center"}])",
        R"([{"op":"replace","path":"/links/1/motion","value":"wave"}])",
        R"([{"op":"remove","path":"/bodies/0/solid"}])", R"([{"op":"remove","path":"/pairs/0/known"}])",
        R"([{"op":"add","path":"/colour","value":"red"}])"})
    EXPECT_FALSE(keeps_to("scene.json", good.patch(parse_json(planted)).dump())) << planted;
}

// Other programs can draw the kept data: every number comes back, in the order of the bodies and pairs.
TEST(SceneJson, HoldsTheKeptConfigurationsToTheBit) {
  const Scene scene = crane();
  const SceneOptions q = question("crane.urdf");
  const SceneStudy study = study_scene(scene, q);
  const json all = parse_json(study_json(scene, q, study));
  const std::vector<Shown> shown = shown_configurations(scene, q, study);
  ASSERT_EQ(all["kept"].size(), shown.size());
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const json& reported = all["kept"][k];
    EXPECT_EQ(reported["configuration"], shown[k].configuration);
    EXPECT_EQ(reported["joints"].size(), 3u) << "free ones alone, for --at";
    ASSERT_EQ(reported["cylinders"].size(), scene.bodies.size());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      EXPECT_EQ(all["bodies"][i]["name"], scene.bodies[i].name);
      const Cylinder& c = shown[k].placed[i];
      EXPECT_EQ(reported["cylinders"][i]["center"], json({c.center.x(), c.center.y(), c.center.z()}));
      EXPECT_EQ(reported["cylinders"][i]["axis"], json({c.axis.x(), c.axis.y(), c.axis.z()}));
      EXPECT_EQ(reported["cylinders"][i]["radius"], c.radius);
      EXPECT_EQ(reported["cylinders"][i]["height"], c.height);
    }
    for (std::size_t i = 0; i < study.pairs.size(); ++i) {
      EXPECT_EQ(all["pairs"][i]["bodies"], json({study.pairs[i].a, study.pairs[i].b}));
      EXPECT_EQ(reported["pairs"][i]["distance"], shown[k].pairs[i].distance);
    }
  }
}

// A box is drawn from its middle and directions. This one is the crane's ground, which stands still.
TEST(SceneJson, HoldsTheBoxes) {
  const json all = parse_json(written(crane(), question("crane.urdf")));
  std::size_t ground = 0;
  while (!all["bodies"].at(ground).contains("holds")) ++ground;
  EXPECT_EQ(all["bodies"][ground]["holds"],
            parse_json(R"({"shape":"box","size":[4.0,4.0,0.1],"pose":{"center":[0.0,0.0,-0.05],
                           "axes":[[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]]}})"));
  for (const json& kept : all["kept"]) {
    ASSERT_EQ(kept["boxes"].size(), 1u);
    EXPECT_EQ(kept["boxes"][0]["body"], ground);
    EXPECT_EQ(kept["boxes"][0]["center"], json({0.0, 0.0, -0.05}));
    EXPECT_EQ(kept["boxes"][0]["axes"], parse_json("[[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]]"));
  }
}

// Other programs can move the robot: they get the tree of joints to the bit, and what each joint follows.
TEST(SceneJson, HoldsTheJointTree) {
  std::size_t turns = 0, slides = 0, follow = 0;
  for (const char* file : {"crane.urdf", "porter.urdf", "hand.xml", "walker.xml"}) {
    const Scene scene = read_scene(std::string(DAYLIGHT_SOURCE_DIR "/corpus/scenes/") + file);
    const json all = parse_json(written(scene, question(file)));
    ASSERT_EQ(all["links"].size(), scene.links.size());
    for (std::size_t i = 0; i < scene.links.size(); ++i) {
      const Link& link = scene.links[i];
      const json& told = all["links"][i];
      EXPECT_EQ(told["name"], link.name);
      EXPECT_EQ(told.value("joint", ""), link.joint);
      EXPECT_EQ(told.contains("parent"), link.parent.has_value());
      if (link.parent) {
        EXPECT_EQ(told["parent"], *link.parent);
      }
      const auto three = [](const auto& v) { return json({v(0), v(1), v(2)}); };
      const auto& axes = link.origin.linear();
      EXPECT_EQ(told["origin"]["center"], three(link.origin.translation()));
      EXPECT_EQ(told["origin"]["axes"], json({three(axes.col(0)), three(axes.col(1)), three(axes.col(2))}));
      EXPECT_EQ(told.contains("axis"), link.motion != Motion::fixed);
      if (link.motion == Motion::fixed) continue;
      (link.motion == Motion::turn ? turns : slides) += 1;
      EXPECT_EQ(told["motion"], link.motion == Motion::turn ? "turn" : "slide");
      EXPECT_EQ(told["axis"], json({link.axis.x(), link.axis.y(), link.axis.z()}));
      EXPECT_EQ(told.contains("follows"), link.follow.has_value());
      if (!link.follow) {
        EXPECT_EQ(told["limits"], json({link.low, link.high}));
        continue;
      }
      follow += 1;
      EXPECT_EQ(told["follows"]["link"], link.follow->link);
      EXPECT_EQ(told["follows"]["multiplier"], link.follow->multiplier);
      EXPECT_EQ(told["follows"]["offset"], link.follow->offset);
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      EXPECT_EQ(all["bodies"][i]["on"], scene.bodies[i].link);
      EXPECT_EQ(all["bodies"][i]["solid"]["radius"], scene.bodies[i].solid.radius);
    }
  }
  EXPECT_GT(turns, 0u);
  EXPECT_GT(slides, 0u);
  EXPECT_GT(follow, 0u);
}

// The JSON has the same sentences as the text, so that their numbers cannot differ.
TEST(SceneJson, HasTheSentencesOfTheText) {
  const Scene scene = crane();
  const SceneOptions q = question("crane.urdf");
  const SceneStudy study = study_scene(scene, q);
  const std::string text = study_text(scene, q, study);
  const json words = parse_json(study_json(scene, q, study))["words"];
  EXPECT_EQ(words["left_out"].size(), 0u);
  for (const auto& [key, reported] : words.items()) {
    if (!reported.is_string()) continue;
    const auto sentence = reported.get<std::string>();
    EXPECT_EQ(sentence.empty(), key == "forgiven" || key == "motions") << key;
    EXPECT_NE(text.find(sentence), std::string::npos) << sentence;
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

TEST(ScenePage, HoldsTheDataAndAsksNothing) {
  const Scene scene =
      still_scene({{hostile, {{0, 0, 0}, {0, 0, 1}, 1, 10}}, {"high", {{0, 0, 11.5}, {0, 0, 1}, 1, 10}}});
  const std::string reported = written(scene, question(hostile.c_str()));
  const std::string page = fill_template(reported);
  EXPECT_EQ(parse_json(page_data(page)), parse_json(reported));
  for (const char* word : {"<img", "src=\"", "@import", "<link", "url(http", "@@DAYLIGHT"})
    EXPECT_EQ(page.find(word), page.npos) << word;
  EXPECT_NE(page.find("default-src 'none'; script-src 'sha256-"), page.npos);
}

}  // namespace
}  // namespace cyl
