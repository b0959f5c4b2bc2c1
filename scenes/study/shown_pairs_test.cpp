// SPDX-License-Identifier: MIT
#include "scenes/study/shown_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scenes/read/scene_files.hpp"

namespace cyl {
namespace {

SceneOptions question(double clearance) {
  SceneOptions q;
  q.clearance = clearance;
  q.configurations = 60;
  return q;
}

class ShownOfTwenty : public testing::TestWithParam<double> {
 protected:
  const Scene scene = read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/twenty.urdf");
  const SceneOptions q = question(GetParam());
  const SceneStudy study = study_scene(scene, q);
  const std::vector<Shown> shown = shown_configurations(scene, q, study);
};

TEST_P(ShownOfTwenty, EachOnceWithAllItsReasons) {
  std::set<std::size_t> seen;
  std::array<std::size_t, 4> count{};
  for (const Shown& k : shown) {
    EXPECT_TRUE(seen.insert(k.configuration).second) << k.configuration;
    EXPECT_LT(k.configuration, study.configurations);
    EXPECT_FALSE(k.highlights.empty());
    EXPECT_EQ(k.placed.size(), scene.bodies.size());
    EXPECT_EQ(k.pairs.size(), study.pairs.size());
    for (const Highlight& highlight : k.highlights) ++count[static_cast<std::size_t>(highlight.reason)];
  }
  EXPECT_EQ(shown.front().configuration, 0u);
  EXPECT_EQ(count[0], first_shown_cap);
  EXPECT_EQ(count[1], 1u);
  EXPECT_GE(count[2], 2 * worst_shown_cap) << "spheres and capsules raise false alarms in this scene";
  EXPECT_GE(count[3], worst_shown_cap) << "and inner capsules miss";
}

// The stated reason can be seen in the configuration.
TEST_P(ShownOfTwenty, TheReasonIsSeenInTheConfiguration) {
  for (const Shown& k : shown) {
    for (const Highlight& highlight : k.highlights) {
      if (highlight.reason == Reason::first) continue;
      const Sample& sample = k.pairs[highlight.pair];
      const double beyond = sample.distance - q.clearance;
      EXPECT_EQ(highlight.length, highlight.reason == Reason::missed ? -beyond : beyond);
      if (highlight.reason == Reason::closest) continue;
      EXPECT_TRUE(sample.wrong[index_of(highlight.model)]);
      EXPECT_EQ(sample.within, highlight.reason == Reason::missed);
      const Score& score = study.pairs[highlight.pair].alone[index_of(highlight.model)];
      EXPECT_EQ(highlight.length,
                highlight.reason == Reason::missed ? score.missed.length : score.alarm.length);
    }
  }
}

TEST_P(ShownOfTwenty, NoOtherPairIsWorse) {
  for (const Level level : enum_values<Level>) {
    double worst = 0, reported = 0;
    for (const PairStudy& pair : study.pairs)
      worst = std::max(worst, pair.alone[index_of(level)].alarm.length);
    for (const Shown& k : shown)
      for (const Highlight& highlight : k.highlights)
        if (highlight.reason == Reason::alarm && highlight.model == level)
          reported = std::max(reported, highlight.length);
    EXPECT_EQ(reported, worst) << to_string(level);
  }
}

// If the solids are apart, the two points are as far from each other as the distance.
TEST_P(ShownOfTwenty, PointsAreAsFarApartAsTold) {
  std::size_t apart = 0;
  for (const Shown& k : shown) {
    for (const Sample& sample : k.pairs) {
      if (sample.distance <= 0) continue;
      ++apart;
      EXPECT_NEAR((sample.on_b - sample.on_a).norm(), sample.distance, 1e-12);
      EXPECT_EQ(sample.within, sample.distance <= q.clearance);
    }
  }
  EXPECT_GT(apart, 500u);
}

INSTANTIATE_TEST_SUITE_P(Clearance, ShownOfTwenty, testing::Values(0.0, 0.02));

TEST(Shown, WhatStandsStillIsKeptOnce) {
  const Scene scene =
      still_scene({{"low", {{0, 0, 0}, {0, 0, 1}, 1, 10}}, {"high", {{0, 0, 11.5}, {0, 0, 1}, 1, 10}}});
  const SceneOptions q = question(0);
  const std::vector<Shown> shown = shown_configurations(scene, q, study_scene(scene, q));
  ASSERT_EQ(shown.size(), 1u);
  ASSERT_EQ(shown[0].highlights.size(), 3u);
  EXPECT_EQ(shown[0].highlights[1].reason, Reason::closest);
  EXPECT_EQ(shown[0].highlights[2].reason, Reason::alarm);
  EXPECT_EQ(shown[0].highlights[2].model, Level::outer);
  EXPECT_NEAR(shown[0].highlights[2].length, 1.5, 1e-12);
}

TEST(Shown, NothingToCheckIsStillSeen) {
  const Scene scene = still_scene({{"alone", {{1, 2, 3}, {0, 0, 1}, 1, 10}}});
  const SceneOptions q = question(0);
  const std::vector<Shown> shown = shown_configurations(scene, q, study_scene(scene, q));
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].placed[0].center, Vector3(1, 2, 3));
}

}  // namespace
}  // namespace cyl
