// SPDX-License-Identifier: MIT
#include "oracles/trial/depends_on_last_bit.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

// Disjoint by 1/3. libccd's GJK reports intersecting if our sums go from the left.
TEST(DependsOnLastBit, TwoCoins) {
  const Pair coins{{Vector3(0, 0, 0), Vector3(1, 2, 2), 3, 1}, {Vector3(-4, -2, 2), Vector3(1, 2, 2), 3, 1}};
  const auto methods = ccd_methods();
  ASSERT_TRUE(try_method(methods[0], coins).fails(FindingKind::wrong_intersecting));
  EXPECT_EQ(depends_on_last_bit("libccd-gjk", FindingKind::wrong_intersecting, coins), true);
  EXPECT_EQ(depends_on_last_bit("ode", FindingKind::wrong_intersecting, coins), std::nullopt);
}

// GJK takes the distance for zero, with sums in any order.
TEST(DependsOnLastBit, NotAnAbsoluteLength) {
  const Pair tiny{{Vector3(0, 0, 0), Vector3(0, 0, 1), 1e-9, 2e-9},
                  {Vector3(3e-9, 1e-10, 0), Vector3(0, 0, 1), 1e-9, 2e-9}};
  EXPECT_EQ(depends_on_last_bit("libccd-gjk", FindingKind::wrong_intersecting, tiny), false);
}

}  // namespace
}  // namespace cyl
