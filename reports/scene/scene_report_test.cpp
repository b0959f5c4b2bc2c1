// SPDX-License-Identifier: MIT
#include "reports/scene/scene_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "scenes/read/bounding_solid.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

const std::string folder = DAYLIGHT_SOURCE_DIR "/corpus/scenes/";

SceneOptions question(double clearance, double tolerated, std::size_t configurations) {
  SceneOptions q;
  q.clearance = clearance;
  q.tolerated = tolerated;
  q.configurations = configurations;
  return q;
}

TEST(Study, WhatItRecommendsTheRefereeConfirms) {
  for (const char* file : {"twenty.urdf", "crane.urdf", "crane.xml", "shelf.jsonl"}) {
    const Scene scene = read_scene(folder + file);
    for (const double clearance : {0.0, 0.02}) {
      const SceneStudy s = study_scene(scene, question(clearance, 0, 20));
      EXPECT_EQ(s.verification.asked, s.pairs.size() * s.configurations) << file;
      EXPECT_EQ(s.verification.wrong, 0u) << file << ", clearance " << clearance;
      EXPECT_EQ(s.verification.tolerated, 0u);
      for (const PairStudy& pair : s.pairs) {
        EXPECT_EQ(pair.cascade_wrong, 0u);
        EXPECT_NE(pair.cascade.last, Level::inner);
        EXPECT_EQ(pair.alone[0].missed, 0) << "a ball apart and they are not";
        EXPECT_EQ(pair.alone[1].missed, 0);
        EXPECT_EQ(pair.alone[2].alarm, 0);
      }
    }
  }
}

TEST(Study, ToleratedFalseAlarmsMakeItCheaper) {
  const Scene scene = read_scene(folder + "twenty.urdf");
  const auto costly = [&](double tolerated) {
    const SceneStudy s = study_scene(scene, question(0, tolerated, 50));
    EXPECT_EQ(s.verification.wrong, 0u);
    return std::ranges::count_if(s.pairs, [](const PairStudy& p) { return p.cascade.last > Level::outer; });
  };
  const auto strict = costly(0), lax = costly(0.5);
  EXPECT_GT(strict, 0);
  EXPECT_EQ(lax, 0);  // 0.5 exceeds the height of two rounded ends
}

// Two rods end to end, 1.5 apart. The round ends of their capsules overlap, the balls around them do not.
TEST(Study, ShowsHowWrongAModelAloneIs) {
  const Scene scene =
      still_scene({{"low", {{0, 0, 0}, {0, 0, 1}, 1, 10}}, {"high", {{0, 0, 11.5}, {0, 0, 1}, 1, 10}}});
  const SceneStudy s = study_scene(scene, question(0, 0, 7));
  EXPECT_EQ(s.configurations, 1u);
  ASSERT_EQ(s.pairs.size(), 1u);
  const PairStudy& pair = s.pairs[0];
  EXPECT_EQ(pair.alone[0].wrong, 0u);
  EXPECT_NEAR(pair.least, 1.5, 1e-12);
  EXPECT_EQ(pair.alone[1].wrong, 1u);
  EXPECT_NEAR(pair.alone[1].alarm, 1.5, 1e-12);
  EXPECT_EQ(pair.cascade.last, Level::sphere);
}

TEST(Study, NeedsTheSimplestThatSuffices) {
  const Scene scene = read_scene(folder + "twenty.urdf");
  const SceneStudy s = study_scene(scene, question(0, 0, 100));
  std::array<std::size_t, level_count> count{};
  for (const PairStudy& pair : s.pairs) {
    const Level level = needed(pair, 0);
    ++count[index_of(level)];
    EXPECT_TRUE(suffices(pair, level, 0));
    EXPECT_EQ(suffices(pair, Level::sphere, 0), level == Level::sphere);
    EXPECT_TRUE(level == Level::sphere || suffices(pair, Level::outer, 0) == (level == Level::outer));
  }
  EXPECT_EQ(count[0], total_of(s, Level::sphere, 0).suffices);
  EXPECT_GT(count[1], 0u);
  EXPECT_EQ(count[2], 0u);
  EXPECT_GT(count[3], 0u);
}

TEST(Study, SaysWhatSavesNothing) {
  const Scene scene = read_scene(folder + "crane.urdf");
  const SceneOptions q = question(0, 0, 30);
  SceneStudy s = study_scene(scene, q);
  for (const auto& [ns, saves] : {std::pair(130.0, false), {95.0, false}, {50.0, true}}) {
    s.cascade_ns = ns;
    s.alone_ns[static_cast<std::size_t>(Level::cylinder)] = 100;
    EXPECT_EQ(study_text(scene, q, s).find("SAVES NOTHING") == std::string::npos, saves) << ns;
  }
}

/// Returns the recommendation with its remarks.
std::string recommended(const Scene& scene, const SceneOptions& q) {
  const std::string text = study_text(scene, q, study_scene(scene, q)), before = "recommended: ";
  const std::size_t from = text.find(before) + before.size(), cost = text.find(" us per configuration", from);
  return std::regex_replace(text.substr(from, text.rfind("\n  ", cost) - from), std::regex("\n  "), "; ");
}

// A pole stands 0.1 beside a mesh's bound: it is clear of it, or nothing is known. Never "spheres suffice".
TEST(Study, NearABoundNothingIsKnown) {
  Scene scene = still_scene({{"pole", {{1.6, 0, 0}, {0, 0, 1}, 0.1, 4}}, {"crate", {}}});
  scene.bodies[1] = bounded_body("crate", 1, "mesh", bound_of(corners_of({2, 2, 2})), Pose::Identity());
  EXPECT_NEAR(scene.bodies[1].solid.radius, std::sqrt(2), 1e-12);
  EXPECT_EQ(recommended(scene, question(0, 0, 1)), "capsules for 1 pair");
  const SceneStudy near = study_scene(scene, question(0.2, 0, 1));
  ASSERT_EQ(near.pairs.size(), 1u);
  EXPECT_FALSE(is_known(near.pairs[0]));
  EXPECT_EQ(recommended(scene, question(0.2, 0, 1)), "nothing");
  const std::string text = study_text(scene, question(0.2, 0, 1), near);
  EXPECT_EQ(total_of(near, Level::cylinder, 0).suffices, 0u);
  EXPECT_EQ(text.find("suffice for"), text.npos) << text;
  EXPECT_TRUE(text.starts_with("clear    0 of 0 known pairs ")) << text;
  EXPECT_NE(text.find("\nwithin   0 in some, 0 in all\nopen     1, because the bounding solid of a mesh or "
                      "ellipsoid comes within the clearance (pole - crate)\n"),
            text.npos)
      << text;
  bound_ellipsoid(scene.bodies[1], {2, 2, 2}, Pose::Identity());
  EXPECT_TRUE(is_known(study_scene(scene, question(0, 0, 1)).pairs[0])) << "its inner solid meets the pole";
}

// Samples never prove "never".
TEST(Study, NeverIsSaidOfProofsAlone) {
  for (const char* file : {"crane.urdf", "arm.urdf", "porter.urdf"}) {
    const Scene scene = read_scene(folder + file);
    const SceneOptions q = question(0, 0, 30);
    const std::string text = study_text(scene, q, study_scene(scene, q));
    EXPECT_EQ(text.find("never"), text.npos) << text;
  }
}

TEST(Study, SaysThatNothingMayCollide) {
  Scene scene = still_scene({{"a", {}}, {"b", {}}, {"c", {}}});
  for (Body& body : scene.bodies) body.type = 0;
  const SceneOptions q = question(0, 0, 1);
  EXPECT_NE(
      study_text(scene, q, study_scene(scene, q)).find("contype and conaffinity let no two shapes collide\n"),
      std::string::npos);
}

// The verdict comes first, then what is refuted, and all that fits into 40 lines.
TEST(Study, TheVerdictFirstThenWhatIsRefuted) {
  const Scene scene = read_scene(folder + "twenty.urdf");
  SceneOptions q = question(0, 0, 20);
  q.prove = true;
  const SceneStudy s = study_scene(scene, q);
  const std::string text = study_text(scene, q, s), all = study_text(scene, q, s, true);
  EXPECT_TRUE(std::regex_search(
      text, std::regex(
                "^never    [0-9]+ of 171 pairs, .*\nrefuted  [0-9]+, .*\nopen     [0-9]+: [0-9]+ after up to "
                ".*\nnot read 0 shapes\n  refuted  ")))
      << text;
  EXPECT_EQ(std::ranges::count(text, '\n'), 40) << text;
  std::size_t refuted = 0, listed = 0;
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) {
    listed +=
        line.starts_with("  never    ") || line.starts_with("  refuted  ") || line.starts_with("  open     ");
    refuted += line.starts_with("  refuted  ");
  }
  EXPECT_GT(refuted, 10u);
  EXPECT_EQ(listed, 171u);
}

// Refuted and open pairs of an SRDF come first.
TEST(Study, OfAnSrdfWhatIsRefutedFirst) {
  Scene scene = read_scene(folder + "crane.urdf");
  for (const char* other : {"tower", "hook"}) {
    const auto link = [&](const std::string& name) {
      return static_cast<std::size_t>(std::ranges::find(scene.links, name, &Link::name) -
                                      scene.links.begin());
    };
    scene.exemptions.push_back({link("trolley"), link(other), "Never"});
    scene.left_out.push_back({"mesh", "hook"});
  }
  SceneOptions q = question(0, 0, 20);
  q.prove = true;
  const SceneStudy s = study_scene(scene, q);
  const std::string text = study_text(scene, q, s);
  const std::size_t counts =
                        text.find("\n\"Never\" in the SRDF, 3 link pairs: 0 proved, 1 REFUTED, 2 open\n"),
                    first = text.find("\n  refuted  trolley - tower, \"Never\" in the SRDF: distance -"),
                    then = text.find("\n  open     hook - counterweight, \"Never\""),
                    pairs = text.find("\n  refuted  tower - ");
  EXPECT_TRUE(counts < first && first < then && then < pairs && pairs < text.npos) << text;
}

}  // namespace
}  // namespace cyl
