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

Worst climb(const std::unique_ptr<Method>& method, Objective objective, std::size_t evaluations,
            std::optional<ContactFeature> feature = ContactFeature::side_rim) {
  WorstOptions options;
  options.objective = objective;
  options.evaluation_cap = evaluations;
  options.domain.fine = true;
  return worst_of(method, close_starts(feature, 1), {.feature = feature}, options);
}

std::unique_ptr<Method> own(std::string_view name) {
  return std::move(select_methods(own_methods(), name).front());
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
  const Worst small = climb(lying(1e-6, 1e-7), Objective::error, 30);
  ASSERT_TRUE(small.scored);
  EXPECT_TRUE(small.scored->beyond && small.beyond_claim());
  EXPECT_NEAR(small.scored->score, 10, 1);
  const Worst honest = climb(lying(1e-7, 1e-6), Objective::error, 30);
  ASSERT_TRUE(honest.scored);
  EXPECT_FALSE(honest.beyond_claim());
  EXPECT_NEAR(honest.scored->score, 0.1, 0.01);
}

TEST(Score, ABoundToldBeyondTheClaimIsFound) {
  const auto bound = [](double told) {
    const auto ask = [=](const Pair& pair) {
      MethodAnswer answer = answer_of(pair, distance(pair.a, pair.b));
      answer.error_bound = told * size_of(pair);
      return answer;
    };
    return climb(fake_method("vague", ask, {.claim = promising(1e-3), .foreign = false}), Objective::bound,
                 30);
  };
  EXPECT_TRUE(bound(1e-2).beyond_claim());
  EXPECT_FALSE(bound(1e-4).beyond_claim());
}

/// Undecided of everything within `reach` of touching, and of rims only.
std::unique_ptr<Method> timid(double reach) {
  const auto ask = [=](const Pair& pair) {
    const double margin = distance(pair.a, pair.b).value / size_of(pair);
    return answered(std::abs(margin) < reach ? Verdict::undecided
                    : margin > 0             ? Verdict::disjoint
                                             : Verdict::intersecting);
  };
  return fake_method("timid", ask, {.claim = promising(0), .foreign = false});
}

TEST(Score, AnUndecidedPairBeyondRoundingIsFound) {
  const Worst worst = climb(timid(1e-9), Objective::undecided, 200);
  ASSERT_TRUE(worst.scored);
  EXPECT_TRUE(worst.beyond_claim());
  EXPECT_GT(worst.scored->score, 1e-10);
  EXPECT_LE(worst.scored->score, 1e-9);
  const Worst within = climb(timid(0.9e-13), Objective::undecided, 1000);
  ASSERT_TRUE(within.scored);
  EXPECT_FALSE(within.beyond_claim()) << within.scored->score;
}

TEST(Score, TheMostStepsAreFound) {
  const auto ask = [](const Pair& pair) {
    MethodAnswer answer = answered(Verdict::disjoint);
    answer.step_cap = 100;
    answer.steps = static_cast<int>(90 - 30 * std::abs(std::log10(pair.a.height / pair.a.radius / 30)));
    return answer;
  };
  const Worst worst = climb(fake_method("steps", ask, {.foreign = false}), Objective::steps, 400);
  ASSERT_TRUE(worst.scored);
  EXPECT_GE(worst.scored->score, 88);
  EXPECT_FALSE(worst.beyond_claim());
}

TEST(Score, OursKeepWhatTheyPromise) {
  for (const auto& [name, search] : {std::pair{"decide", Objective::undecided},
                                     {"decide", Objective::steps},
                                     {"distance", Objective::error},
                                     {"distance", Objective::bound},
                                     {"distance", Objective::steps}}) {
    const Worst worst = climb(own(name), search, 150);
    ASSERT_TRUE(worst.scored) << name << ' ' << to_string(search);
    EXPECT_FALSE(worst.beyond_claim()) << name << ' ' << format_pair(worst.scored->pair);
    EXPECT_EQ(worst.evaluations, 150u);
  }
  const Worst bits = climb(judge_method(), Objective::steps, 20);
  ASSERT_TRUE(bits.scored);
  EXPECT_GT(bits.scored->score, 53);
}

TEST(Score, TheSameSeedGivesTheSamePair) {
  const auto found = [] { return format_pair(climb(own("decide"), Objective::undecided, 150).scored->pair); };
  EXPECT_EQ(found(), found());
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
