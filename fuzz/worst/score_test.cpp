// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "fuzz/worst/worst.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/methods/own_answers.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

Worst climb(const std::unique_ptr<Method>& method, std::size_t evaluations) {
  WorstOptions options;
  options.objective = Objective::error;
  options.evaluation_cap = evaluations;
  options.domain.fine = true;
  constexpr ContactFeature feature = ContactFeature::side_rim;
  return worst_of(method, close_starts(feature, 1), {.feature = feature}, options);
}

Claim promising(double relative) {
  Claim claim;
  claim.relative = relative;
  claim.decides = DecisionScope::above_1e13;
  return claim;
}

/// Reports a distance that is too long by a part of the size, and an error that is `told` of that part.
std::unique_ptr<Method> lying(double off, double told) {
  const auto ask = [=](const Pair& pair) {
    MethodAnswer answer = answer_of(pair, distance(pair.a, pair.b));
    answer.distance += off * size_of(pair);
    answer.error_bound = told * size_of(pair);
    return answer;
  };
  return fake_method("lying", ask, {.claim = promising(1), .foreign = false});
}

TEST(Score, AnErrorBeyondTheOneToldIsFound) {
  const Worst small = climb(lying(1e-6, 1e-7), 30);
  ASSERT_TRUE(small.scored);
  EXPECT_TRUE(small.scored->beyond && small.beyond_claim());
  EXPECT_NEAR(small.scored->score, 10, 1);
  const Worst honest = climb(lying(1e-7, 1e-6), 30);
  ASSERT_TRUE(honest.scored);
  EXPECT_FALSE(honest.beyond_claim());
  EXPECT_NEAR(honest.scored->score, 0.1, 0.01);
}

TEST(Score, OursKeepWhatTheyPromiseAndTheSameSeedGivesTheSamePair) {
  const auto found = [] {
    const auto distance_method = std::move(select_methods(own_methods(), "distance").front());
    const Worst worst = climb(distance_method, 150);
    EXPECT_FALSE(worst.beyond_claim());
    EXPECT_EQ(worst.evaluations, 150u);
    return worst.scored ? format_pair(worst.scored->pair) : "";
  };
  const std::string first = found();
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(found(), first);
}

TEST(PairChart, WhereItIsFineLengthsBecomeZeroAndMarginsChangeByDecades) {
  const Pair start{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {1, 0, 1}, 0.5, 1}};
  const Domain fine{.fine = true};
  const PairChart chart(start, {}, fine);
  PairChart::Point x{};
  x[4] = chart.low()[4];
  EXPECT_EQ(chart.pair(x).b.height, 0);
  for (std::size_t i = 1; i < 4; ++i) x[i] = chart.low()[i];
  EXPECT_GT(size_of(chart.pair(x)), 0);
  x = {};
  x[PairChart::dimensions - 3] = -3;
  const Pair near = chart.pair(x);
  EXPECT_NEAR(distance(near.a, near.b).value, 1e-3 * distance(start.a, start.b).value, 1e-15);
  EXPECT_EQ(PairChart(start, {}, {}).low()[PairChart::dimensions - 3], 0);
}

}  // namespace
}  // namespace cyl
