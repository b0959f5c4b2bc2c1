// SPDX-License-Identifier: MIT
#include "base/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace cyl {
namespace {

TEST(RateBounds, NoFailureAndNothingElseHaveClosedForms) {
  for (const std::uint64_t n : {1u, 10u, 400u, 10000u}) {
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

TEST(RateBounds, NothingIsKnownWithoutTrials) {
  EXPECT_EQ(rate_bounds(0, 0).lower, 0);
  EXPECT_EQ(rate_bounds(0, 0).upper, 1);
}

TEST(ErrorRateBound, IsGarwoodsOneSided) {
  EXPECT_EQ(error_rate_bound(0, 0), 1);
  EXPECT_EQ(error_rate_bound(1, 0), 1);
  EXPECT_DOUBLE_EQ(error_rate_bound(3000, 0), 1e-3);
  // Garwood's table of Poisson means, 95 % one-sided: 4.744 at one, 6.296 at two, 16.962 at ten.
  EXPECT_NEAR(error_rate_bound(1000, 1), 4.744e-3, 1e-6);
  EXPECT_NEAR(error_rate_bound(1000, 2), 6.296e-3, 1e-6);
  EXPECT_NEAR(error_rate_bound(10000, 10), 16.962e-4, 1e-7);
  EXPECT_NEAR(error_rate_bound(100000, 300), 330.5e-5, 2e-5);
}

TEST(Quantile, IsTheValueOfARank) {
  std::vector<double> values(101);
  std::iota(values.rbegin(), values.rend(), 0.0);
  EXPECT_EQ(quantile(values, 0.5), 50);
  EXPECT_EQ(quantile(values, 0.99), 99);
  EXPECT_EQ(quantile(values, 1), 100);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_EQ(spread_percent({9, 1, 8, 2, 7, 3, 6, 4, 5}), 80);
  EXPECT_EQ(spread_percent({7}), 0);
}

}  // namespace
}  // namespace cyl
