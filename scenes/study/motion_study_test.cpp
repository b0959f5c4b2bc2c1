// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scenes/read/scene_files.hpp"
#include "scenes/study/scene_study.hpp"

namespace cyl {
namespace {

SceneStudy study(const Scene& scene, unsigned threads, bool late = false) {
  SceneOptions q;
  q.configurations = 50;
  q.prove = q.prove_others = true;
  q.workforce.threads = threads;
  if (late) q.workforce.deadline = std::chrono::steady_clock::now();
  return study_scene(scene, q);
}

TEST(MotionStudy, ItsResultsDoNotDependOnTheNumberOfThreads) {
  const Scene scene = read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/arm.urdf");
  const SceneStudy one = study(scene, 1), many = study(scene, 5);
  ASSERT_EQ(one.pairs.size(), many.pairs.size());
  for (std::size_t i = 0; i < one.pairs.size(); ++i) {
    EXPECT_EQ(one.pairs[i].within, many.pairs[i].within);
    EXPECT_EQ(one.pairs[i].least, many.pairs[i].least);
    EXPECT_EQ(one.pairs[i].cascade, many.pairs[i].cascade);
  }
  EXPECT_EQ(one.closest->configuration, many.closest->configuration);
  EXPECT_EQ(one.verification.asked, many.verification.asked);
  EXPECT_EQ(one.verification.asked, 50 * one.pairs.size());
  EXPECT_GT(one.motions->others.size(), 0u);
  for (const auto proofs : {&MotionStudy::pairs, &MotionStudy::others}) {
    for (std::size_t i = 0; i < ((*one.motions).*proofs).size(); ++i) {
      const MotionProof &p = ((*one.motions).*proofs)[i], &r = ((*many.motions).*proofs)[i];
      EXPECT_EQ(std::tie(p.a, p.b, p.verdict, p.bound, p.least, p.joints, p.boxes),
                std::tie(r.a, r.b, r.verdict, r.bound, r.least, r.joints, r.boxes));
    }
  }
}

// A pair that needs many boxes comes last, with the result that it would have alone.
TEST(MotionStudy, HardPairsComeLast) {
  const Scene scene = read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/twenty.urdf");
  MotionQuestion q;
  q.box_cap = 1500;
  BodyPairs pairs;
  std::size_t hard = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) pairs.emplace_back(a, b);
  const MotionStudy all = prove_motions(scene, pairs, std::vector<double>(pairs.size(), 1e9), q);
  for (const MotionProof& proof : all.pairs) {
    if (proof.boxes <= 1000 || proof.verdict != MotionVerdict::open) continue;
    ++hard;
    EXPECT_EQ(proof.open_share, prove_motion(scene, proof.a, proof.b, q).open_share);
  }
  EXPECT_GT(hard, 0u);
}

TEST(MotionStudy, WhatIsLeftAtTheDeadlineIsOpen) {
  const Scene scene = read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/arm.urdf");
  const SceneStudy late = study(scene, 0, true);
  for (const MotionProof& proof : late.motions->pairs) {
    EXPECT_EQ(proof.verdict, MotionVerdict::open);
    EXPECT_TRUE(proof.out_of_time);
    EXPECT_EQ(proof.open_share, 1);
  }
  for (const PairStudy& pair : late.pairs) EXPECT_EQ(pair.samples, late.configurations);
}

// A proof that has begun ends at the deadline too.
TEST(MotionStudy, ABoxAfterTheDeadlineIsNotCut) {
  const Scene scene = read_scene(DAYLIGHT_SOURCE_DIR "/corpus/scenes/twenty.urdf");
  MotionQuestion q;
  q.workforce.deadline = std::chrono::steady_clock::now();
  std::size_t late = 0;
  for (std::size_t b = 2; b < scene.bodies.size(); ++b) {
    const MotionProof proof = prove_motion(scene, 0, b, q);
    EXPECT_LE(proof.boxes, 500u);
    late += proof.out_of_time && proof.verdict == MotionVerdict::open && proof.open_share > 0;
  }
  EXPECT_GT(late, 0u);
}

}  // namespace
}  // namespace cyl
