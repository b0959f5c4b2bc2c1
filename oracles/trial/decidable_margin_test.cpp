// SPDX-License-Identifier: MIT
#include "oracles/trial/decidable_margin.hpp"

#include <gtest/gtest.h>

#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

Pair walls(double offset) { return {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{offset, 0, 0}, {0, 0, 1}, 1, 2}}; }

TEST(Room, IsTheGapOrTheLargestBallInCommon) {
  EXPECT_DOUBLE_EQ(estimated_margin(walls(2.5)), 0.5 / 6);
  const double into = estimated_margin(walls(1));  // a lens 1 wide
  EXPECT_LE(into, 0.5 / 6);
  EXPECT_GT(into, 0.5 / 6 / 1.34);  // 8 steps per decade
}

TEST(Room, NothingIsPromisedOfTwoFlatSolidsThatMeet) {
  Pair segments = walls(0);
  segments.a.radius = segments.b.radius = 0;
  EXPECT_EQ(estimated_margin(segments), 0);
  Trial crossing(segments);
  EXPECT_FALSE(must_decide(DecisionScope::above_1e13, crossing));
  EXPECT_TRUE(must_decide(DecisionScope::all, crossing));
  segments.b.center.x() = 1;
  EXPECT_EQ(estimated_margin(segments), 1 / size_of(segments));
}

TEST(Room, AVerdictIsOwedBeyondRounding) {
  for (const double margin : {1.1e-13, 0.9e-13}) {
    Trial apart(walls(2 + 6 * margin)), into(walls(2 - 12 * margin));
    EXPECT_EQ(must_decide(DecisionScope::above_1e13, apart), margin > 1e-13);
    EXPECT_EQ(must_decide(DecisionScope::above_1e13, into), margin > 1e-13);
    EXPECT_FALSE(must_decide(DecisionScope::not_promised, apart));
  }
}

TEST(Room, OfBoxes) {
  Pair pair{{}, {{1.5, 0, 0}, {0, 0, 1}, 1, 2}};
  pair.a.shape = Shape::box;
  pair.a.edges = {2, 2, 2};
  const double margin = estimated_margin(pair) * size_of(pair);  // 0.5 in common, a ball of radius 0.25
  EXPECT_LE(margin, 0.25);
  EXPECT_GT(margin, 0.25 / 1.34);
  const Solid less = core(pair.a, 0.25).value();
  EXPECT_EQ(less.edges, (std::array<double, 3>{1.5, 1.5, 1.5}));
  pair.a.edges = {2, 2, 0.125};
  EXPECT_EQ(core(pair.a, 0.25).value().edges, (std::array<double, 3>{1.5, 1.5, 0}));
  EXPECT_FALSE(core(pair.a, 0.1));
  EXPECT_FALSE(core(pair.a, 4));
}

}  // namespace
}  // namespace cyl
