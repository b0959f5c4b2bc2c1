// SPDX-License-Identifier: MIT
#include "fuzz/campaign/schedule.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

TEST(Schedule, EqualWeightsAreTheOrderOfTheFamilies) {
  const Schedule schedule({1, 1, 1});
  for (std::uint64_t i = 0; i < 100; ++i) {
    EXPECT_EQ(schedule.at(i).family, i % 3);
    EXPECT_EQ(schedule.at(i).index, i / 3);
  }
}

TEST(Schedule, EveryFamilyDrawsItsPairsInOrderAsOftenAsItsWeight) {
  const std::vector<unsigned> weights{5, 1, 3};
  const Schedule schedule(weights);
  std::vector<std::uint64_t> next(3);
  for (std::uint64_t i = 0; i < 900; ++i) {
    const auto [family, index] = schedule.at(i);
    EXPECT_EQ(index, next[family]++);
    if (i % 9 != 8) continue;
    for (std::size_t f = 0; f < 3; ++f) EXPECT_EQ(next[f], weights[f] * (i / 9 + 1));
  }
}

}  // namespace
}  // namespace cyl
