// SPDX-License-Identifier: MIT
#include "fuzz/worst/worst.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/methods/own_answers.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// Wrong of a pair whose |distance| in sizes is below `wrong_up_to`, which depends on its shape.
using Reach = std::function<double(const Pair&, double margin)>;
std::unique_ptr<Method> faulty(Reach wrong_up_to, Claim claim = {.source = "planted"}) {
  const auto ask = [wrong_up_to = std::move(wrong_up_to)](const Pair& pair) {
    const double margin = approximate_distance(pair).value / size_of(pair);
    const bool wrong = std::abs(margin) < wrong_up_to(pair, margin);
    return answered((margin > 0) != wrong ? Verdict::disjoint : Verdict::intersecting);
  };
  return fake_method("faulty", ask, {.claim = claim});
}

double decades_from(double x, double goal) { return std::abs(std::log10(x / goal)); }

/// Apart: at most `most`, of a solid a eight times as high as wide and axes at 1e-3 of each other.
constexpr double most = 2e-3;
double sharp_reach(const Pair& pair, double margin) {
  if (margin < 0) return 0;
  const double sine = pair.a.axis.normalized().cross(pair.b.axis.normalized()).norm();
  const double off =
      decades_from(pair.a.height / (2 * pair.a.radius), 8) + 0.5 * decades_from(std::max(sine, 1e-17), 1e-3);
  return most * std::pow(10, -off);
}

WorstOptions shapes(std::size_t evaluations) {
  WorstOptions options;
  options.seed = 2;
  options.evaluation_cap = evaluations;
  return options;
}

Worst search(const std::unique_ptr<Method>& method, std::optional<ContactFeature> feature,
             const WorstOptions& options) {
  return worst_of(method, drawn_starts(feature, options.seed), {feature, {}}, options);
}

TEST(Worst, NineTenthsOfAKnownWorstAreFound) {
  const auto method = faulty(sharp_reach);
  for (const ContactFeature feature : {ContactFeature::side_side, ContactFeature::side_rim}) {
    const Worst worst = search(method, feature, shapes(1000));
    ASSERT_TRUE(worst.wrong) << to_string(feature);
    EXPECT_EQ(worst.wrong->finding.kind, FindingKind::wrong_intersecting);
    EXPECT_GE(worst.wrong->finding.margin->lo, 0.9 * most) << to_string(feature);
    EXPECT_LE(worst.wrong->finding.margin->lo, most);
    EXPECT_EQ(contact_feature(worst.wrong->pair), feature);
  }
}

TEST(Worst, CapsStayOnCapsAndWhatIsInsideInside) {
  for (const ContactFeature feature :
       {ContactFeature::cap_cap, ContactFeature::cap_side, ContactFeature::containment}) {
    const bool inside = feature == ContactFeature::containment;
    const auto method = faulty([&](const Pair& pair, double margin) {
      if ((margin < 0) != inside) return 0.0;
      return most * std::pow(10, -decades_from(pair.a.radius / pair.b.radius, inside ? 500 : 2));
    });
    const Worst worst = search(method, feature, shapes(1000));
    ASSERT_TRUE(worst.wrong) << to_string(feature);
    EXPECT_EQ(worst.wrong->finding.kind,
              inside ? FindingKind::wrong_disjoint : FindingKind::wrong_intersecting);
    EXPECT_GE(worst.wrong->finding.margin->lo, 0.9 * most) << to_string(feature);
    EXPECT_EQ(contact_feature(worst.wrong->pair), feature);
  }
}

TEST(Worst, TheSameSeedGivesTheSamePair) {
  const auto method = faulty(sharp_reach);
  const auto pair_of = [&](std::uint64_t seed) {
    WorstOptions options = shapes(300);
    options.seed = seed;
    const Worst worst = search(method, ContactFeature::side_side, options);
    return worst.wrong ? format_pair(worst.wrong->pair) : "";
  };
  EXPECT_EQ(pair_of(1), pair_of(1));
  EXPECT_NE(pair_of(1), pair_of(2));
}

TEST(Worst, WhoIsRightIsNotBlamed) {
  for (const auto& method : own_methods()) {
    const Worst worst = search(method, {}, shapes(60));
    EXPECT_FALSE(worst.wrong) << method->name();
    EXPECT_FALSE(worst.failed) << method->name();
    EXPECT_EQ(worst.evaluations, 60u) << "it goes on from mutations";
  }
}

TEST(Worst, NothingOutsideTheStratumCounts) {
  const auto method = faulty([](const Pair& pair, double margin) {
    return feature_along(pair, approximate_distance(pair).direction) == ContactFeature::side_rim && margin > 0
               ? most
               : 0;
  });
  EXPECT_FALSE(search(method, ContactFeature::rim_rim, shapes(200)).wrong);
  EXPECT_TRUE(search(method, ContactFeature::side_rim, shapes(50)).wrong);
  const Sought none{.also = [](const Pair&) { return false; }};
  EXPECT_FALSE(worst_of(method, drawn_starts({}, 1), none, shapes(100)).wrong);
}

TEST(Worst, OfTwoWaysToBeWrongTheOneSoughtCounts) {
  const auto method = faulty([](const Pair&, double margin) { return margin > 0 ? most : most / 10; });
  const auto worst = [&](FindingKind kind) {
    return worst_of(method, drawn_starts(ContactFeature::side_side, 1), {.kind = kind}, shapes(50)).wrong;
  };
  const auto apart = worst(FindingKind::wrong_intersecting), into = worst(FindingKind::wrong_disjoint);
  ASSERT_TRUE(apart && into);
  EXPECT_EQ(apart->finding.kind, FindingKind::wrong_intersecting);
  EXPECT_EQ(into->finding.kind, FindingKind::wrong_disjoint);
  EXPECT_LE(into->finding.margin->lo, most / 10);
}

TEST(Worst, BeyondAClaimComesBeforeALargerMarginWithin) {
  const auto claims_a_length = [](double small) {
    // Below size 1: wrong within the claim, by nearly all of a solid. From 10 on: a hair beyond it.
    const auto reach = [small](const Pair& pair, double) {
      const double size = size_of(pair);
      return size < 1 ? 0.9e-3 / size : size > 10 ? small / size : 0;
    };
    return faulty(reach, {0, 1e-3, "planted"});
  };
  const std::unique_ptr<Method> beyond = claims_a_length(1.5e-3), within = claims_a_length(0.5e-3);
  const Worst found = search(beyond, ContactFeature::side_side, shapes(600));
  ASSERT_TRUE(found.wrong);
  EXPECT_EQ(found.wrong->finding.severity, Severity::contract);
  EXPECT_TRUE(found.beyond_claim());
  const Worst not_beyond = search(within, ContactFeature::side_side, shapes(600));
  ASSERT_TRUE(not_beyond.wrong);
  EXPECT_EQ(not_beyond.wrong->finding.severity, Severity::resolution);
  EXPECT_FALSE(not_beyond.beyond_claim());
}

/// Aborts or throws if the axes are parallel, and is right otherwise.
std::unique_ptr<Method> breaking(bool abort) {
  return faulty([abort](const Pair& pair, double) {
    if (pair.a.axis.cross(pair.b.axis).norm() == 0) {
      if (abort) std::abort();
      throw std::runtime_error("parallel");
    }
    return 0.0;
  });
}

TEST(Worst, WhatBreaksIsKeptAndNotAskedAgain) {
  for (const bool abort : {false, true}) {
    const std::unique_ptr<Method> method = breaking(abort);
    const Worst worst = search(method, ContactFeature::cap_cap, shapes(100));
    ASSERT_TRUE(worst.failed);
    EXPECT_EQ(worst.failed->failure, abort ? Failure::crash : Failure::exception);
    EXPECT_EQ(worst.failed->pair.a.axis.cross(worst.failed->pair.b.axis).norm(), 0);
    EXPECT_TRUE(worst.beyond_claim());
    if (abort) {
      EXPECT_LT(worst.evaluations, 100u);
    }
  }
}

Worst climb(const std::unique_ptr<Method>& method, std::size_t evaluations) {
  WorstOptions options;
  options.objective = Objective::error;
  options.evaluation_cap = evaluations;
  options.domain.fine = true;
  constexpr ContactFeature feature = ContactFeature::side_rim;
  return worst_of(method, drawn_starts(feature, 1, Objective::error), {.feature = feature}, options);
}

Claim promising(double relative) {
  Claim claim;
  claim.relative = relative;
  claim.decides = DecisionScope::above_1e13;
  return claim;
}

/// Reports a distance that is too long by a part of the size, and an error that is `stated` of that part.
std::unique_ptr<Method> lying(double off, double stated) {
  const auto ask = [=](const Pair& pair) {
    MethodAnswer answer = answer_of(pair, distance(pair.a, pair.b));
    answer.distance += off * size_of(pair);
    answer.error_bound = stated * size_of(pair);
    return answer;
  };
  return fake_method("lying", ask, {.claim = promising(1), .foreign = false});
}

TEST(Score, AnErrorBeyondTheOneReportedIsFound) {
  const Worst small = climb(lying(1e-6, 1e-7), 30);
  ASSERT_TRUE(small.scored);
  EXPECT_TRUE(small.scored->beyond && small.beyond_claim());
  EXPECT_NEAR(small.scored->score, 10, 1);
  const Worst honest = climb(lying(1e-7, 1e-6), 30);
  ASSERT_TRUE(honest.scored);
  EXPECT_FALSE(honest.beyond_claim());
  EXPECT_NEAR(honest.scored->score, 0.1, 0.01);
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
  EXPECT_NEAR(approximate_distance(near).value, 1e-3 * approximate_distance(start).value, 1e-15);
  EXPECT_EQ(PairChart(start, {}, {}).low()[PairChart::dimensions - 3], 0);
}

TEST(PairChart, ItsOriginIsTheStartBitForBit) {
  for (const Pair& start : drawn_starts({}, 7)) {
    const auto pair = bring_into({}, start);
    if (!pair) continue;
    EXPECT_TRUE(is_in({}, *pair)) << format_pair(start);
    const PairChart::Point x{};
    EXPECT_EQ(format_pair(PairChart(*pair, {}, {}).pair(x)), format_pair(*pair));
  }
}

TEST(PairChart, AnAngleIsCountedInDecadesFromParallelAndFromPerpendicular) {
  const Pair start{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {1e-3, 0, 1}, 1, 2}};
  const PairChart chart(start, {}, {});
  PairChart::Point x{};
  const std::size_t angle = PairChart::dimensions - 2;
  const auto sine = [&](double decades) {
    x[angle] = decades;
    const Pair p = chart.pair(x);
    return p.a.axis.cross(p.b.axis).norm();
  };
  EXPECT_NEAR(sine(-3) / 1e-6, 1, 1e-6);
  EXPECT_EQ(sine(chart.low()[angle]), 0);
  x[angle] = chart.high()[angle];
  EXPECT_EQ(chart.pair(x).b.axis.z(), 0);
}

std::vector<Pair> with_boxes() {
  std::vector<Pair> pairs;
  for (const Family& family : box_families())
    for (std::uint64_t i = 0; i < 20; ++i)
      if (const auto pair = bring_into({}, family.generate(1, i))) pairs.push_back(*pair);
  return pairs;
}

TEST(PairChart, BoxesHaveCoordinatesForEdgesAndTurns) {
  std::array<int, PairChart::dimensions> changed{};
  for (const Pair& start : with_boxes()) {
    const PairChart chart(start, {}, {});
    PairChart::Point x{};
    EXPECT_EQ(format_pair(chart.pair(x)), format_pair(start));
    for (std::size_t i = 0; i < PairChart::dimensions; ++i) {
      x = {};
      x[i] = std::clamp(0.2, chart.low()[i], chart.high()[i]);
      const Pair p = chart.pair(x);
      EXPECT_TRUE(is_legal(p) && is_in({}, p)) << format_pair(start);
      changed[i] += x[i] != 0 && format_pair(p) != format_pair(start);
    }
  }
  for (std::size_t i = 0; i < PairChart::dimensions; ++i)
    EXPECT_EQ(changed[i] > 40, i != PairChart::dimensions - 3)
        << i;  // the distance, which only fine ones have
}

}  // namespace
}  // namespace cyl
