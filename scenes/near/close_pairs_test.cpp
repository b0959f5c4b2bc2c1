// SPDX-License-Identifier: MIT
#include "scenes/near/close_pairs.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/usage_error.hpp"
#include "oracles/referee/referee.hpp"
#include "scenes/near/broad_phase.hpp"
#include "scenes/near/nearest_pairs.hpp"
#include "scenes/near/scene_generators.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// Returns all pairs that the referee proves within the clearance, one by one.
std::vector<std::pair<std::uint32_t, std::uint32_t>> by_referee(const std::vector<Solid>& c,
                                                                double clearance) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  for (std::uint32_t i = 0; i < c.size(); ++i) {
    for (std::uint32_t j = i + 1; j < c.size(); ++j) {
      const Pair pair{c[i], c[j]};
      const Truth truth = judge(pair);
      EXPECT_NE(truth.verdict, Verdict::undecided);
      if (truth.verdict != Verdict::disjoint ||
          (clearance > 0 && enclose_distance(pair, truth, 1e-6).lo <= clearance))
        found.emplace_back(i, j);
    }
  }
  return found;
}

TEST(ClosePairs, FindsAllClosePairsAndNoOthers) {
  for (const char* kind : {"rods", "pipes"}) {
    for (const double clearance : {0.0, 0.01}) {
      const std::vector<Solid> c = generate_cylinders(kind, 120, 3);
      const ClosePairs s = find_close_pairs(c, clearance);
      const ClosePairsCheck check = check_close_pairs(c, clearance, s);
      EXPECT_EQ(check.referee.asked, s.candidates.size());
      EXPECT_EQ(check.referee.wrong + check.referee.undecided, 0u);
      EXPECT_EQ(check.certificates.checked, s.candidates.size());
      EXPECT_EQ(check.certificates.failed + check.certificates.undecided, 0u);
      const auto expected = by_referee(c, clearance);
      EXPECT_EQ(s.within, expected) << kind << ", clearance " << clearance;
      EXPECT_EQ(s.undecided, 0u);
      if (clearance > 0) {
        EXPECT_GT(expected.size(), 5u) << kind;
      }
    }
  }
}

TEST(ClosePairs, SolidsInOnePlaceAreRefusedBeforeTheyFillTheMemory) {
  const std::vector<Solid> same(4000, generate_cylinders("rods", 1, 1).front());
  EXPECT_THROW(find_close_pairs(same, 0), InputError);
  EXPECT_EQ(find_close_pairs(std::span(same).first(1000), 0).within.size(), 999u * 500);
}

TEST(ClosePairs, AnswersOneQuestionForEachPairOfBoxes) {
  const ClosePairs s = find_close_pairs(generate_cylinders("rods", 3000, 1), 0);
  std::size_t decided = s.undecided;
  for (const std::size_t n : s.decided) decided += n;
  EXPECT_EQ(decided, s.candidates.size());
  EXPECT_GT(s.candidates.size(), 2 * s.within.size());
}

/// Three spheres in a row. The first two overlap, and the third is 0.5 from the second.
std::vector<Solid> three_spheres() {
  const Vector3 up(0, 0, 1);
  return {{{0, 0, 0}, up, 0, 0, 1}, {{1.5, 0, 0}, up, 0, 0, 1}, {{4, 0, 0}, up, 0, 0, 1}};
}

TEST(ClosePairsCheck, FindsAnswersThatAreWrong) {
  const std::vector<Solid> c = three_spheres();
  for (const double clearance : {0.25, 0.75}) {
    ClosePairs said = find_close_pairs(c, clearance);
    said.candidates = {{0, 1}, {1, 2}};
    EXPECT_EQ(said.within.size(), clearance < 0.5 ? 1u : 2u);
    ClosePairsCheck check = check_close_pairs(c, clearance, said);
    EXPECT_EQ(check.referee.wrong + check.certificates.failed, 0u) << clearance;
    EXPECT_EQ(check.certificates.checked, 2u) << clearance;
    said.within = {{1, 2}};
    check = check_close_pairs(c, clearance, said);
    const std::size_t wrong = clearance < 0.5 ? 2 : 1;
    EXPECT_EQ(check.referee.wrong, wrong) << clearance;
    EXPECT_EQ(check.certificates.failed, wrong) << clearance;
    EXPECT_EQ(check.certificates.checked, 2u) << clearance;
  }
}

// If both solids are rounded, the clearance is added to a rounding. 1.1 + 0.3 is not a double, 1 + 0.5 is.
TEST(ClosePairsCheck, AddsTheClearanceToARounding) {
  const Vector3 up(0, 0, 1);
  CertificateCheck check;
  for (const double gap : {0.29, 0.31}) {
    check.add({{{0, 0, 0}, up, 0, 0, 1.1}, {{2.2 + gap, 0, 0}, up, 0, 0, 1.1}}, 0.3, gap < 0.3);
    check.add({{{0, 0, 0}, up, 1, 2, 1.1}, {{4.2 + gap, 0, 0}, up, 1, 2, 1.1}}, 0.3, gap < 0.3);
  }
  EXPECT_EQ(check.checked, 4u);
  EXPECT_EQ(check.failed, 0u);
}

TEST(ClosePairsCheck, CountsPairsWithoutACertificate) {
  const Vector3 up(0, 0, 1);
  CertificateCheck check;
  check.add({{{0, 0, 0}, up, 1, 2}, {{2, 0, 0}, up, 1, 2}}, 0, true);
  EXPECT_EQ(check.undecided, 1u);
  EXPECT_EQ(check.checked + check.failed, 0u);
}

TEST(NearestPairs, AreThoseOfTheLeastDistance) {
  const std::vector<Solid> c = generate_cylinders("rods", 400, 5);
  const ClosePairs s = find_close_pairs(c, 0.01);
  ASSERT_GT(s.candidates.size(), 100u);
  const std::vector<NearPair> all = nearest_pairs(c, 0.01, s, s.candidates.size());
  EXPECT_EQ(all.size(), s.candidates.size());
  std::size_t within = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const NearPair& pair = all[i];
    const Distance d = distance(c[pair.bodies.first], c[pair.bodies.second]);
    EXPECT_EQ(pair.distance, d.value);
    EXPECT_EQ(pair.within, pair.distance <= 0.01);
    EXPECT_EQ(pair.proof == Proof::direction, !pair.within);
    EXPECT_NE(pair.proof, Proof::none);
    if (pair.distance > 0) {
      EXPECT_NEAR((pair.on_b - pair.on_a).norm(), pair.distance, 1e-12);
    }
    if (i > 0) {
      EXPECT_LE(all[i - 1].distance, pair.distance);
    }
    within += pair.within;
  }
  EXPECT_EQ(within, s.within.size());
  const std::vector<NearPair> few = nearest_pairs(c, 0.01, s, 7);
  ASSERT_EQ(few.size(), 7u);
  EXPECT_EQ(few.back().bodies, all[6].bodies);
}

TEST(Boxes, AreAsTightAsTheyMayBe) {
  const Box upright = box_around(prepare({{1, 2, 3}, {0, 0, -2}, 0.5, 4}), 0);
  EXPECT_TRUE(upright.low.isApprox(Vector3(0.5, 1.5, 1), 1e-13));
  EXPECT_TRUE(upright.high.isApprox(Vector3(1.5, 2.5, 5), 1e-13));
  EXPECT_TRUE((upright.low.array() <= Eigen::Array3d(0.5, 1.5, 1)).all());
  const Box grown = box_around(prepare({{1, 2, 3}, {0, 0, -2}, 0.5, 4}), 0.2);
  EXPECT_TRUE(grown.high.isApprox(Vector3(1.6, 2.6, 5.1), 1e-13));
}

TEST(Generators, AreFunctionsOfTheirSeed) {
  const auto text = [](const char* kind, std::uint64_t seed) {
    std::string all;
    for (const Solid& c : generate_cylinders(kind, 40, seed)) all += std::to_string(c.center.x()) + ' ';
    return all;
  };
  EXPECT_EQ(text("rods", 1), text("rods", 1));
  EXPECT_NE(text("rods", 1), text("rods", 2));
  EXPECT_NE(text("pipes", 1), text("pipes", 2));
  EXPECT_THROW(generate_cylinders("bricks", 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace cyl
