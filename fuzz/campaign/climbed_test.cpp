// SPDX-License-Identifier: MIT
#include "fuzz/campaign/climbed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "fuzz/campaign/batch.hpp"
#include "oracles/trial/decidable_margin.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 5;

Pair pair_at(std::uint64_t climb, std::uint64_t step) {
  return climbed_family().generate(seed, climb * climb_size + step);
}

double highest(std::uint64_t climb, std::uint64_t first, std::uint64_t next) {
  double most = 0;
  for (std::uint64_t i = first; i < next; ++i)
    most = std::max(most, height_of(goal_of_climb(climb), pair_at(climb, i)));
  return most;
}

TEST(Climbed, EveryPairIsLegalAndAFunctionOfSeedAndIndexWhateverCameBefore) {
  const std::string late = format_pair(pair_at(1, 200)), early = format_pair(pair_at(0, 200));
  EXPECT_EQ(format_pair(pair_at(1, 200)), late);
  EXPECT_EQ(format_pair(pair_at(0, 200)), early);
  EXPECT_NE(late, early);
  EXPECT_NE(format_pair(climbed_family().generate(seed + 1, 200)), early);
  for (std::uint64_t climb = 0; climb < 8; ++climb)
    for (std::uint64_t i = 0; i < climb_size; ++i) EXPECT_TRUE(is_legal(pair_at(climb, i)));
}

// Over the climbs of each goal together: one alone may begin at its top.
TEST(Climbed, WhatIsChangedIsHigherThanWhatWasDrawn) {
  for (const std::uint64_t first : {0, 1, 2, 5, 7}) {
    const ClimbGoal& goal = goal_of_climb(first);
    double drawn = 0, changed = 0;
    int climbs = 0;
    for (std::uint64_t climb = 0; climbs < 6; ++climb) {
      if (goal_of_climb(climb) != goal) continue;
      ++climbs;
      drawn += highest(climb, 0, climb_starts);
      changed += highest(climb, climb_starts, climb_size);
    }
    EXPECT_GT(changed, drawn) << to_string(goal.objective) << " of climb " << first;
  }
}

TEST(Climbed, OursStayWithinWhatTheyPromise) {
  for (std::uint64_t climb = 0; climb < 8; ++climb) {
    const double most = highest(climb, 0, climb_size);
    if (goal_of_climb(climb).objective == Objective::undecided) {
      EXPECT_LT(most, resolved_margin);
    }
    if (goal_of_climb(climb).objective == Objective::bound) {
      EXPECT_LT(most, 1e-13);
    }
  }
}

TEST(Climbed, ThePairsOfOneClimbCountAsOne) {
  EXPECT_EQ(independent_draws("climbed", 74), 1u);
  EXPECT_EQ(independent_draws("climbed", climb_size + 1), 2u);
  EXPECT_EQ(independent_draws("climbed", 0), 0u);
  EXPECT_EQ(independent_draws("random", 74), 74u);
}

TEST(Climbed, ACampaignDrawsFromItInItsTurn) {
  EXPECT_EQ(campaign_families().size(), families().size() + rounded_families().size() + 2);
  EXPECT_EQ(campaign_families().back().name, "derived");
  const auto methods = own_methods();
  const std::uint64_t turns = 3;
  const BatchRecord batch =
      run_batch({methods, campaign_families(), {}}, seed, 0, turns * campaign_families().size());
  std::uint64_t asked = 0;
  for (const TallyRecord& t : batch.tallies)
    if (t.method == "decide" && t.family == "climbed") asked += t.counts.asked;
  EXPECT_EQ(asked, turns);
}

}  // namespace
}  // namespace cyl
