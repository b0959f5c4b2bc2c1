// SPDX-License-Identifier: MIT
#include "fuzz/worst/worst.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "fuzz/worst/shapes.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/methods/own_answers.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"

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

WorstOptions shapes(std::size_t evaluations, std::optional<ContactFeature> feature = {},
                    std::uint64_t seed = 2) {
  return {.feature = feature, .seed = seed, .evaluation_cap = evaluations};
}

Worst search(const std::unique_ptr<Method>& method, const WorstOptions& options) {
  return worst_of(method, drawn_starts(*method, options), options);
}

TEST(Worst, NineTenthsOfAKnownWorstAreFound) {
  const auto method = faulty(sharp_reach);
  for (const ContactFeature feature : {ContactFeature::side_side, ContactFeature::side_rim}) {
    const Worst worst = search(method, shapes(2000, feature));
    ASSERT_TRUE(worst.worst) << to_string(feature);
    EXPECT_EQ(worst.worst->kind, FindingKind::wrong_intersecting);
    EXPECT_GE(worst.worst->score, 0.9 * most) << to_string(feature);
    EXPECT_LE(worst.worst->score, most);
    EXPECT_EQ(contact_feature(worst.worst->pair), feature);
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
    const Worst worst = search(method, shapes(1000, feature));
    ASSERT_TRUE(worst.worst) << to_string(feature);
    EXPECT_EQ(worst.worst->kind, inside ? FindingKind::wrong_disjoint : FindingKind::wrong_intersecting);
    EXPECT_GE(worst.worst->score, 0.9 * most) << to_string(feature);
    EXPECT_EQ(contact_feature(worst.worst->pair), feature);
  }
}

TEST(Worst, TheSameSeedGivesTheSamePair) {
  const auto method = faulty(sharp_reach);
  const auto pair_of = [&](std::uint64_t seed) {
    const Worst worst = search(method, shapes(300, ContactFeature::side_side, seed));
    return worst.worst ? format_pair(worst.worst->pair) : "";
  };
  EXPECT_EQ(pair_of(1), pair_of(1));
  EXPECT_NE(pair_of(1), pair_of(2));
}

TEST(Worst, WhoIsRightIsNotBlamed) {
  for (const auto& method : own_methods()) {
    const Worst worst = search(method, shapes(60));
    EXPECT_FALSE(worst.worst) << method->name();
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
  EXPECT_FALSE(search(method, shapes(200, ContactFeature::rim_rim)).worst);
  EXPECT_TRUE(search(method, shapes(50, ContactFeature::side_rim)).worst);
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
  const Worst found = search(beyond, shapes(600, ContactFeature::side_side));
  ASSERT_TRUE(found.worst);
  EXPECT_EQ(found.worst->severity, Severity::contract);
  EXPECT_TRUE(found.beyond_claim());
  const Worst not_beyond = search(within, shapes(600, ContactFeature::side_side));
  ASSERT_TRUE(not_beyond.worst);
  EXPECT_EQ(not_beyond.worst->severity, Severity::resolution);
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
    const Worst worst = search(method, shapes(100, ContactFeature::cap_cap));
    ASSERT_TRUE(worst.failed);
    EXPECT_EQ(worst.failed->kind, abort ? FindingKind::crash : FindingKind::exception);
    EXPECT_EQ(worst.failed->pair.a.axis.cross(worst.failed->pair.b.axis).norm(), 0);
    EXPECT_TRUE(worst.beyond_claim());
    if (abort) {
      EXPECT_LT(worst.evaluations, 100u);
    }
  }
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

TEST(Worst, AnErrorBeyondTheOneReportedIsFound) {
  for (const auto& [off, stated] : {std::pair(1e-6, 1e-7), std::pair(1e-7, 1e-6)}) {
    WorstOptions options = shapes(30, ContactFeature::side_rim);
    options.objective = Objective::error;
    const Worst worst = search(lying(off, stated), options);
    ASSERT_TRUE(worst.worst);
    EXPECT_EQ(worst.beyond_claim(), off > stated);
    EXPECT_NEAR(worst.worst->score, off / stated, 0.1 * off / stated);
  }
}

TEST(Shapes, StartsAreBroughtIntoTheDomain) {
  const Pair wide{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {0, 0, 1}, 1, 2}};
  EXPECT_EQ(format_pair(*bring_into_domain(wide)), format_pair(wide));
  const Pair large = scaled(wide, 100), small = *bring_into_domain(scaled(wide, -100));
  EXPECT_FALSE(is_in_domain(large));
  EXPECT_TRUE(is_in_domain(small));
  EXPECT_TRUE(is_in_domain(*bring_into_domain(large)));
}

TEST(Shapes, ParallelAndPerpendicularAxesStaySo) {
  RandomStream stream("shapes_test", 1, 0);
  const auto sine_of = [](const Pair& p) { return unit_axis(p.a.axis).cross(unit_axis(p.b.axis)).norm(); };
  Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {0, 0, -3}, 1, 2}}, near = pair, square = pair;
  near.b.axis = {1e-9, 0, 1};
  square.b.axis = {1, 0, 0};
  for (int i = 0; i < 50; ++i) {
    EXPECT_LT(sine_of(nudged(pair, stream)), 1e-15);
    EXPECT_GT(sine_of(nudged(square, stream)), 1 - 1e-15);
    EXPECT_LT(sine_of(nudged(near, stream)), 1e-2);
  }
}

TEST(Shapes, BoxesAreTurned) {
  RandomStream stream("shapes_test", 1, 0);
  const Solid box{.shape = Shape::box, .edges = {1, 2, 3}, .quaternion = {4, 3, 2, 1}};
  int turned = 0;
  for (int i = 0; i < 50; ++i) {
    const Pair other = nudged({box, box}, stream);
    EXPECT_TRUE(is_legal(other));
    turned += other.a.quaternion != other.b.quaternion && other.b.quaternion != box.quaternion;
  }
  EXPECT_GT(turned, 10);
}

}  // namespace
}  // namespace cyl
