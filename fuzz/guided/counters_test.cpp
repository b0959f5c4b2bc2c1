// SPDX-License-Identifier: MIT
#include "fuzz/guided/counters.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

TEST(Strata, TellAnglesAndMarginsApart) {
  Pair p{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {0, 0, 2}, 1, 2}};
  EXPECT_EQ(to_string(stratum_of(p, approximate_distance(p))), "side-side parallel 1e-0");
  p.b.axis = {0, 1e-10, 1};
  EXPECT_EQ(stratum_of(p, approximate_distance(p)).angle, AngleClass::within_1e_7);
  p.b.axis = {0, 1, 0};
  p.b.center = {2 + 0x1p-40, 0, 0};
  EXPECT_EQ(to_string(stratum_of(p, approximate_distance(p))), "side-side 90 1e-12");
  p.b.center = {2, 0, 0};
  EXPECT_EQ(stratum_of(p, approximate_distance(p)).decade, 16);
}

TEST(Strata, OfModeratePairsAreNotOwedToOneHugeSolid) {
  Pair p{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {0, 0, 2}, 0, 1e-3}};
  EXPECT_TRUE(is_moderate(p));
  p.a.height = 1e30;
  EXPECT_FALSE(is_moderate(p));
  p.a.height = 2;
  p.b.center.x() = 1e5;
  EXPECT_FALSE(is_moderate(p));
  p.b = {};
  p.b.shape = Shape::box;
  p.b.edges = {1, 2, 0};
  EXPECT_TRUE(is_moderate(p));
  for (const double edge : {1e30, 1e-30}) {
    p.b.edges[1] = edge;
    EXPECT_FALSE(is_moderate(p));
  }
}

}  // namespace
}  // namespace cyl
