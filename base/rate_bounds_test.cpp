// SPDX-License-Identifier: MIT
#include "base/rate_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cyl {
namespace {

TEST(RateBounds, NoFailureAndNothingElseHaveClosedForms) {
  for (const std::uint64_t n : {1, 10, 400, 10000}) {
    const double rest = std::pow(0.025, 1 / static_cast<double>(n));
    EXPECT_EQ(rate_bounds(n, 0).lower, 0);
    EXPECT_NEAR(rate_bounds(n, 0).upper, 1 - rest, 1e-11);
    EXPECT_NEAR(rate_bounds(n, n).lower, rest, 1e-11);
    EXPECT_EQ(rate_bounds(n, n).upper, 1);
  }
}

// The values of R's binom.test(5, 100) and binom.test(3, 10).
TEST(RateBounds, AreThoseOfTables) {
  EXPECT_NEAR(rate_bounds(100, 5).lower, 0.01643, 5e-6);
  EXPECT_NEAR(rate_bounds(100, 5).upper, 0.11283, 6e-6);
  EXPECT_NEAR(rate_bounds(10, 3).lower, 0.06674, 5e-6);
  EXPECT_NEAR(rate_bounds(10, 3).upper, 0.65245, 5e-6);
}

TEST(RateBounds, HoldTheShareAndAreMirrored) {
  for (std::uint64_t k = 0; k <= 400; k += 7) {
    const RateBounds bounds = rate_bounds(400, k), mirrored = rate_bounds(400, 400 - k);
    const double share = static_cast<double>(k) / 400;
    EXPECT_LE(bounds.lower, share);
    EXPECT_GE(bounds.upper, share);
    EXPECT_NEAR(bounds.lower, 1 - mirrored.upper, 1e-10);
  }
}

TEST(RateBounds, NothingIsKnownWithoutTrials) {
  EXPECT_EQ(rate_bounds(0, 0).lower, 0);
  EXPECT_EQ(rate_bounds(0, 0).upper, 1);
}

}  // namespace
}  // namespace cyl
