// SPDX-License-Identifier: MIT
#include "base/stopwatch.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace cyl {
namespace {

TEST(Stopwatch, EveryRunHasAnotherOrder) {
  for (const std::size_t count : {1u, 2u, 7u, 60u}) {
    std::vector<std::size_t> all(count), order(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::set<std::vector<std::size_t>> seen;
    std::size_t stride = 0;
    for (int i = 0; i < 5; ++i) {
      shuffle(order, stride);
      EXPECT_TRUE(std::is_permutation(order.begin(), order.end(), all.begin()));
      seen.insert(order);
    }
    EXPECT_GE(seen.size(), count < 7 ? 1u : 5u) << count;
  }
}

TEST(Stopwatch, ASeriesMakesEveryCallAndAtLeastOnce) {
  std::size_t calls = 0, runs = 0;
  const auto series = [&](std::span<const std::size_t> order) {
    calls += order.size();
    ++runs;
  };
  series_cost(series, 10, std::chrono::duration<double>(0));
  EXPECT_EQ(calls, 10u) << "a first series that fills the time is the measurement";
  runs = 0;
  series_cost(series, 10, std::chrono::duration<double>(1e-3));
  EXPECT_GE(runs, 2u) << "and else a warm-up";
  std::vector<int> times(10);
  const CallTimes of_each = time_calls([&](std::size_t i) { ++times[i]; }, times.size(), 9);
  EXPECT_EQ(times, std::vector<int>(10, 9));
  EXPECT_TRUE(of_each.p50_ns <= of_each.p99_ns && of_each.p99_ns <= of_each.max_ns);
}

}  // namespace
}  // namespace cyl
