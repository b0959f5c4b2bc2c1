// SPDX-License-Identifier: MIT
#include "scenes/shown_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scenes/scene_files.hpp"

namespace cyl {
namespace {

SceneQuestion question(double clearance) {
  SceneQuestion q;
  q.clearance = clearance;
  q.configurations = 60;
  return q;
}

std::size_t index_of(Rung rung) { return static_cast<std::size_t>(rung); }

class KeptOfTwenty : public testing::TestWithParam<double> {
 protected:
  const Scene scene = read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/twenty.urdf");
  const SceneQuestion q = question(GetParam());
  const SceneStudy study = study_scene(scene, q);
  const std::vector<Kept> kept = kept_configurations(scene, q, study);
};

TEST_P(KeptOfTwenty, EachOnceWithAllItsReasons) {
  std::set<std::size_t> seen;
  std::array<std::size_t, 4> count{};
  for (const Kept& k : kept) {
    EXPECT_TRUE(seen.insert(k.configuration).second) << k.configuration;
    EXPECT_LT(k.configuration, study.configurations);
    EXPECT_FALSE(k.reasons.empty());
    EXPECT_EQ(k.placed.size(), scene.bodies.size());
    EXPECT_EQ(k.pairs.size(), study.pairs.size());
    for (const Reason& reason : k.reasons) ++count[static_cast<std::size_t>(reason.why)];
  }
  EXPECT_EQ(kept.front().configuration, 0u);
  EXPECT_EQ(count[0], first_kept_cap);
  EXPECT_EQ(count[1], 1u);
  EXPECT_GE(count[2], 2 * worst_kept_cap) << "spheres and capsules raise false alarms in this scene";
  EXPECT_GE(count[3], worst_kept_cap) << "and inner capsules miss";
}

// The reason that is told is what is seen there.
TEST_P(KeptOfTwenty, TheReasonIsSeenInTheConfiguration) {
  for (const Kept& k : kept) {
    for (const Reason& reason : k.reasons) {
      if (reason.why == Why::first) continue;
      const SeenPair& seen = k.pairs[reason.pair];
      const double beyond = seen.distance - q.clearance;
      EXPECT_EQ(reason.length, reason.why == Why::missed ? -beyond : beyond);
      if (reason.why == Why::closest) continue;
      EXPECT_TRUE(seen.wrong[index_of(reason.model)]);
      EXPECT_EQ(seen.within, reason.why == Why::missed);
      const Score& score = study.pairs[reason.pair].alone[index_of(reason.model)];
      EXPECT_EQ(reason.length, reason.why == Why::missed ? score.missed : score.alarm);
    }
  }
}

TEST_P(KeptOfTwenty, NoOtherPairIsWorse) {
  for (const Rung rung : all_rungs) {
    double worst = 0, told = 0;
    for (const PairStudy& pair : study.pairs) worst = std::max(worst, pair.alone[index_of(rung)].alarm);
    for (const Kept& k : kept)
      for (const Reason& reason : k.reasons)
        if (reason.why == Why::alarm && reason.model == rung) told = std::max(told, reason.length);
    EXPECT_EQ(told, worst) << to_string(rung);
  }
}

// Apart, the two points are as far from each other as the distance says.
TEST_P(KeptOfTwenty, PointsAreAsFarApartAsTold) {
  std::size_t apart = 0;
  for (const Kept& k : kept) {
    for (const SeenPair& seen : k.pairs) {
      if (seen.distance <= 0) continue;
      ++apart;
      EXPECT_NEAR((seen.on_b - seen.on_a).norm(), seen.distance, 1e-12);
      EXPECT_EQ(seen.within, seen.distance <= q.clearance);
    }
  }
  EXPECT_GT(apart, 500u);
}

INSTANTIATE_TEST_SUITE_P(Clearance, KeptOfTwenty, testing::Values(0.0, 0.02));

TEST(Kept, WhatStandsStillIsKeptOnce) {
  const Scene scene =
      still_scene({{"low", {{0, 0, 0}, {0, 0, 1}, 1, 10}}, {"high", {{0, 0, 11.5}, {0, 0, 1}, 1, 10}}});
  const SceneQuestion q = question(0);
  const std::vector<Kept> kept = kept_configurations(scene, q, study_scene(scene, q));
  ASSERT_EQ(kept.size(), 1u);
  ASSERT_EQ(kept[0].reasons.size(), 3u);
  EXPECT_EQ(kept[0].reasons[1].why, Why::closest);
  EXPECT_EQ(kept[0].reasons[2].why, Why::alarm);
  EXPECT_EQ(kept[0].reasons[2].model, Rung::outer);
  EXPECT_NEAR(kept[0].reasons[2].length, 1.5, 1e-12);
}

TEST(Kept, NothingToCheckIsStillSeen) {
  const Scene scene = still_scene({{"alone", {{1, 2, 3}, {0, 0, 1}, 1, 10}}});
  const SceneQuestion q = question(0);
  const std::vector<Kept> kept = kept_configurations(scene, q, study_scene(scene, q));
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].placed[0].center, Vector3(1, 2, 3));
}

}  // namespace
}  // namespace cyl
