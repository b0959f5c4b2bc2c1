// SPDX-License-Identifier: MIT
#include "oracles/trial/room.hpp"

#include <gtest/gtest.h>

#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

Pair walls(double offset) { return {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{offset, 0, 0}, {0, 0, 1}, 1, 2}}; }

TEST(Room, IsTheGapOrTheLargestBallInCommon) {
  Trial apart(walls(2.5));
  EXPECT_DOUBLE_EQ(likely_room(apart.pair), 0.5 / 6);
  EXPECT_NEAR(proved_room(apart), 0.5 / 6, 1e-9);
  Trial into(walls(1));  // a lens 1 wide
  for (const double room : {likely_room(into.pair), proved_room(into)}) {
    EXPECT_LE(room, 0.5 / 6);
    EXPECT_GT(room, 0.5 / 6 / 1.34);  // 8 a decade
  }
}

TEST(Room, NothingIsPromisedOfTwoFlatSolidsThatMeet) {
  Pair segments = walls(0);
  segments.a.radius = segments.b.radius = 0;
  EXPECT_EQ(likely_room(segments), 0);
  Trial crossing(segments);
  EXPECT_FALSE(owes_verdict(Decides::beyond_rounding, crossing));
  EXPECT_TRUE(owes_verdict(Decides::all, crossing));
  segments.b.center.x() = 1;
  EXPECT_EQ(likely_room(segments), 1 / size_of(segments));
}

TEST(Room, AVerdictIsOwedBeyondRounding) {
  for (const double margin : {1.1e-13, 0.9e-13}) {
    Trial apart(walls(2 + 6 * margin)), into(walls(2 - 12 * margin));
    EXPECT_EQ(owes_verdict(Decides::beyond_rounding, apart), margin > 1e-13);
    EXPECT_EQ(owes_verdict(Decides::beyond_rounding, into), margin > 1e-13);
    EXPECT_FALSE(owes_verdict(Decides::not_promised, apart));
  }
}

}  // namespace
}  // namespace cyl
