// SPDX-License-Identifier: MIT
#include "scenes/close_pairs.hpp"

#include <gtest/gtest.h>

#include <string>

#include "oracles/referee/referee.hpp"
#include "scenes/broad_phase.hpp"
#include "scenes/scene_generators.hpp"

namespace cyl {
namespace {

/// All pairs that the referee proves within the clearance, one by one.
std::vector<std::pair<std::uint32_t, std::uint32_t>> by_referee(const std::vector<Cylinder>& c,
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
      const std::vector<Cylinder> c = generate_cylinders(kind, 120, 3);
      const ClosePairs s = find_close_pairs(c, clearance, true);
      ASSERT_TRUE(s.verification);
      EXPECT_EQ(s.verification->asked, s.candidates);
      EXPECT_EQ(s.verification->wrong + s.verification->undecided, 0u);
      const auto expected = by_referee(c, clearance);
      EXPECT_EQ(s.within, expected) << kind << ", clearance " << clearance;
      EXPECT_EQ(s.undecided, 0u);
      if (clearance > 0) {
        EXPECT_GT(expected.size(), 5u) << kind;
      }
    }
  }
}

TEST(ClosePairs, AnswersOneQuestionForEachPairOfBoxes) {
  const ClosePairs s = find_close_pairs(generate_cylinders("rods", 3000, 1), 0);
  std::size_t decided = s.undecided;
  for (const std::size_t n : s.decided) decided += n;
  EXPECT_EQ(decided, s.candidates);
  EXPECT_GT(s.candidates, 2 * s.within.size());
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
    for (const Cylinder& c : generate_cylinders(kind, 40, seed)) all += std::to_string(c.center.x()) + ' ';
    return all;
  };
  EXPECT_EQ(text("rods", 1), text("rods", 1));
  EXPECT_NE(text("rods", 1), text("rods", 2));
  EXPECT_NE(text("pipes", 1), text("pipes", 2));
  EXPECT_THROW(generate_cylinders("bricks", 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace cyl
