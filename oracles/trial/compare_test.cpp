// SPDX-License-Identifier: MIT
#include "oracles/trial/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "corpus/pairs/truth_io.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// Size 8: two upright cylinders of radius 1 and height 3, `gap` apart along x.
Pair upright(double gap) { return {{{0, 0, 0}, {0, 0, 1}, 1, 3}, {{2 + gap, 0, 0}, {0, 0, 1}, 1, 3}}; }
constexpr double size = 8;

Truth truth_of(Verdict verdict) {
  Truth truth;
  truth.verdict = verdict;
  return truth;
}

MethodAnswer said_distance(Verdict verdict, double distance) {
  MethodAnswer answer = answered(verdict);
  answer.has_distance = true;
  answer.distance = distance;
  return answer;
}

/// A distance known to +- relative_width * size / 2. It counts how often it was asked for.
struct Known {
  double distance;
  int asked = 0;
  Trial trial(Verdict truth) {
    Trial of(upright(distance), truth_of(truth));
    of.enclose = [this](double width) {
      ++asked;
      return Enclosure{distance - width * size / 2, distance + width * size / 2};
    };
    return of;
  }
};

std::optional<Finding> judged(Verdict truth, double distance, const Claim& claim,
                              const MethodAnswer& answer) {
  Known known{distance};
  Trial trial = known.trial(truth);
  return compare(trial, claim, answer);
}

const Claim none{0, 0, ""};

using Found = std::pair<FindingKind, Severity>;
std::optional<Found> found(const std::optional<Finding>& finding) {
  return finding ? std::optional(Found(finding->kind, finding->severity)) : std::nullopt;
}

constexpr Verdict apart = Verdict::disjoint, meet = Verdict::intersecting, touch = Verdict::touching;
constexpr double largest = std::numeric_limits<double>::max();

TEST(Compare, HoldsAnAnswerToTruthAndClaim) {
  using enum FindingKind;
  constexpr Severity contract = Severity::contract, resolution = Severity::resolution;
  const Claim claim{1e-3, 1e-3, ""};  // reaches to 9e-3
  const struct {
    Verdict truth;
    double distance;
    Claim claim;
    MethodAnswer said;
    std::optional<Found> found;
    std::optional<double> margin = {};  ///< times the size
  } rows[] = {
      {apart, 0.5, none, answered(apart), {}},
      {meet, -0.5, none, answered(meet), {}},
      {touch, 0, none, answered(meet), {}},
      {touch, 0, none, answered(touch), {}},
      {meet, -0.01, claim, answered(apart), Found(wrong_disjoint, contract), 0.01},
      {apart, 0.01, claim, answered(meet), Found(wrong_intersecting, contract), 0.01},
      {meet, -0.0089, claim, answered(apart), Found(wrong_disjoint, resolution)},
      {apart, 0.0089, claim, answered(touch), Found(wrong_intersecting, resolution)},
      // The first enclosure shows neither.
      {apart, 1e-11, {1e-13, 0, ""}, answered(meet), Found(wrong_intersecting, contract)},
      {apart, 1e-11, {1e-11, 0, ""}, answered(meet), Found(wrong_intersecting, resolution)},
      {touch, 0, {0, 1e-9, ""}, answered(apart), Found(wrong_disjoint, resolution), 0},
      {touch, 0, none, answered(apart), Found(wrong_disjoint, contract), 0},
      // The distance is not certainly other than 0.
      {meet, -1e-8, none, answered(touch), {}},
      {meet, -0.5, none, answered(touch), Found(wrong_touching, contract)},
      {apart, 1, none, answered(Verdict::undecided), {}},
      {Verdict::undecided, 0, none, answered(apart), {}},
      {Verdict::undecided, 0, none, said_distance(meet, 9), {}},
      {apart, 1, {1, 1, ""}, answered(Verdict::invalid), Found(wrong_invalid, contract)},
      {apart, 0.5, claim, said_distance(apart, 0.5089), {}},
      {apart, 0.5, claim, said_distance(apart, 0.4911), {}},
      {apart, 0.5, claim, said_distance(apart, 0.51), Found(distance_outside, contract), 0.01},
      {apart, 0.5, claim, said_distance(apart, 0.49), Found(distance_outside, contract), 0.01},
      // A rounded distance is not a fault of a method that claims exactness.
      {apart, 0.1, none, said_distance(apart, std::nextafter(0.1, 1)), {}},
      {apart, 0.1, none, said_distance(apart, 0.1 + 1e-12), Found(distance_outside, contract)},
      {apart, 0.5, {0, 1e-6, ""}, said_distance(apart, largest), Found(non_finite, contract)},
      {meet, -0.5, {0, 1e-6, ""}, said_distance(meet, -largest), Found(non_finite, contract)},
      {apart, 0.5, none, said_distance(meet, -3), Found(wrong_intersecting, contract)},
      // A verdict within the claim excuses no distance.
      {apart, 0.5, {0, 0.6, ""}, said_distance(meet, -0.01), Found(wrong_intersecting, resolution)},
      {apart, 0.5, {0, 0.6, ""}, said_distance(meet, -3), Found(distance_outside, contract)},
      {apart, 0.5, {0, 0.6, ""}, said_distance(meet, -largest), Found(non_finite, contract)},
  };
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    const auto& row = rows[i];
    const auto finding = judged(row.truth, row.distance, row.claim, row.said);
    EXPECT_EQ(found(finding), row.found) << i;
    if (!row.margin || !finding) continue;
    EXPECT_LE(finding->margin->lo, *row.margin / size) << i;
    EXPECT_GE(finding->margin->hi, *row.margin / size) << i;
    EXPECT_NEAR(finding->margin->lo, *row.margin / size, 1e-5) << i;
  }
}

TEST(Compare, ARightAnswerAsksNoDistance) {
  Known known{0.5};
  Trial trial = known.trial(apart);
  EXPECT_FALSE(compare(trial, none, answered(apart)));
  EXPECT_EQ(known.asked, 0);
}

TEST(Compare, AtTheClaimItselfTheMethodPromises) {
  Trial trial(upright(0.5), truth_of(Verdict::disjoint));
  trial.enclose = [](double) { return Enclosure{0.5, 0.5}; };
  const auto severity = [&](double absolute) {
    return compare(trial, {0, absolute, ""}, answered(Verdict::intersecting))->severity;
  };
  EXPECT_EQ(severity(0.5 * (1 - 0x1p-30)), Severity::contract);
  EXPECT_EQ(severity(0.5 * (1 + 0x1p-40)), Severity::resolution);
  trial.forget_distance();
  trial.enclose = [](double) { return Enclosure{0.1, 0.9}; };
  EXPECT_EQ(severity(0.5), Severity::resolution) << "it cannot be narrowed";
}

TEST(Compare, NoLengthIsAskedBelowTheRoundingOfWhatIsMeasured) {
  const double size = 0x1p70;
  EXPECT_EQ(reach({0, 1e-6, ""}, size), reach({claim_floor, 1e-6, ""}, size));
  EXPECT_GT(reach({0, 1e-6, ""}, size), 0x1p26) << "one in ten million million of it";
  EXPECT_EQ(reach({0, 0, ""}, size), 0) << "always right is always right";
  EXPECT_NEAR(reach({0, 1e-6, ""}, 5), 1e-6, 1e-12);
}

TEST(Compare, ALowerBoundOfTheDistanceIsWrongOnlyIfTheDistanceIsLess) {
  const auto bound = [](Verdict truth, double distance, double said, const Claim& claim = none) {
    MethodAnswer answer = said_distance(truth, said);
    answer.has_distance = false;
    answer.at_least = true;
    return judged(truth, distance, claim, answer);
  };
  EXPECT_FALSE(bound(Verdict::disjoint, 0.75, 0.5)) << "apart by more than 0.5";
  EXPECT_FALSE(bound(Verdict::intersecting, -0.5, -0.75)) << "a depth of at most 0.75";
  const auto apart = bound(Verdict::disjoint, 0.25, 0.5), deep = bound(Verdict::intersecting, -0.75, -0.5);
  for (const auto& wrong : {apart, deep}) {
    ASSERT_EQ(found(wrong), Found(FindingKind::distance_outside, Severity::contract));
    EXPECT_LE(wrong->margin->lo, 0.25 / size);
    EXPECT_GE(wrong->margin->hi, 0.25 / size);
  }
  EXPECT_FALSE(bound(Verdict::intersecting, -0.75, -0.5, {0, 0.26, ""})) << "within the claim";
  EXPECT_FALSE(bound(Verdict::touching, 0, 0));
  EXPECT_TRUE(bound(Verdict::touching, 0, 0.5));
}

TEST(Compare, TwoBoundsAreTheSameOnlyIfTheirLengthsAre) {
  MethodAnswer x = said_distance(Verdict::disjoint, 0.5), y = x;
  y.has_distance = false;
  y.at_least = true;
  EXPECT_FALSE(same_answer(x, y));
  x = y;
  EXPECT_TRUE(same_answer(x, y));
  x.distance = 0.25;
  EXPECT_FALSE(same_answer(x, y));
}

TEST(Compare, AFailureIsAContractFindingWhateverTheTruthAndADeclinedPairIsNone) {
  MethodAnswer answer;
  EXPECT_FALSE(judged(Verdict::disjoint, 1, none, answer));
  answer.status = Status::failed;
  for (const auto& [failure, kind] : {std::pair{Failure::exception, FindingKind::exception},
                                      std::pair{Failure::reported, FindingKind::reported},
                                      {Failure::crash, FindingKind::crash},
                                      {Failure::hang, FindingKind::hang},
                                      {Failure::non_finite, FindingKind::non_finite}}) {
    answer.failure = failure;
    for (const Verdict truth : {Verdict::disjoint, Verdict::undecided}) {
      const auto finding = judged(truth, 1, {1, 1, ""}, answer);
      ASSERT_EQ(found(finding), Found(kind, Severity::contract));
      EXPECT_EQ(finding->margin.has_value(), truth == Verdict::disjoint);  // the pair's own
    }
  }
}

TEST(Compare, ANumberThatIsNotFiniteIsAFinding) {
  const double bad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(judged(Verdict::disjoint, 1, none, said_distance(Verdict::disjoint, bad))->kind,
            FindingKind::non_finite);
  MethodAnswer answer = answered(Verdict::disjoint);
  answer.head[1] = bad;
  EXPECT_FALSE(judged(Verdict::disjoint, 1, none, answer));  // no witness offered: the bytes mean nothing
  answer.witness = CertificateKind::direction;
  EXPECT_EQ(judged(Verdict::disjoint, 1, none, answer)->kind, FindingKind::non_finite);
}

TEST(Compare, WhatIsFoundDoesNotDependOnHowNarrowTheEnclosureIsAlready) {
  const Claim claim{0, 1e-3, ""};
  for (const double beyond : {1e-9, -1e-9}) {
    MethodAnswer answer = said_distance(Verdict::disjoint, 0.5 + 1e-3 + beyond);
    answer.witness = CertificateKind::direction;
    answer.head[1] = 1;  // proves nothing
    const FindingKind kind = beyond > 0 ? FindingKind::distance_outside : FindingKind::bad_witness;
    for (const double width : {1.0, 1e-6, 1e-9, 1e-12, 1e-18}) {
      Known known{0.5};
      Trial trial = known.trial(Verdict::disjoint);
      trial.distance_at(width);
      const auto finding = compare(trial, claim, answer);
      ASSERT_TRUE(finding);
      EXPECT_EQ(finding->kind, kind) << width;
    }
  }
}

TEST(Compare, WhoShowsAnErrorIsHeldToIt) {
  const Claim claim{1e-3, 0, ""};
  for (const double stated : {1e-6, 1e-4}) {
    for (const double off : {1e-5, -1e-5}) {
      MethodAnswer apart = said_distance(Verdict::disjoint, 0.5 + off);
      apart.error_bound = stated;
      EXPECT_EQ(judged(Verdict::disjoint, 0.5, claim, apart).has_value(), stated < 1e-5);
      // If they overlap, a smaller depth is not ruled out.
      MethodAnswer into = said_distance(Verdict::intersecting, -0.5 + off);
      into.error_bound = stated;
      EXPECT_EQ(judged(Verdict::intersecting, -0.5, claim, into).has_value(), stated < 1e-5 && off > 0);
    }
  }
}

TEST(Compare, UndecidedIsAFaultWhereAVerdictIsPromised) {
  const auto of = [](DecisionScope promised, double gap) {
    Claim claim;
    claim.decides = promised;
    return judged(Verdict::disjoint, gap, claim, answered(Verdict::undecided));
  };
  EXPECT_FALSE(of(DecisionScope::not_promised, 0.5));
  EXPECT_FALSE(of(DecisionScope::above_1e13, 1e-14));
  for (const auto& finding : {of(DecisionScope::above_1e13, 1e-11), of(DecisionScope::all, 1e-14)}) {
    ASSERT_EQ(found(finding), Found(FindingKind::left_undecided, Severity::contract));
  }
}

TEST(Compare, AWitnessMustProveWhatWasSaid) {
  MethodAnswer direction = answered(Verdict::disjoint);
  direction.witness = CertificateKind::direction;
  direction.head[0] = 1;
  EXPECT_FALSE(judged(Verdict::disjoint, 0.5, none, direction));
  direction.head[0] = 0;
  direction.head[1] = 1;
  const auto finding = judged(Verdict::disjoint, 0.5, none, direction);
  ASSERT_EQ(found(finding), Found(FindingKind::bad_witness, Severity::contract));
  EXPECT_EQ(judged(Verdict::disjoint, 0.5, {0, 1e-9, ""}, direction)->severity, Severity::contract);
  direction.has_distance = true;
  direction.distance = 3;
  EXPECT_EQ(judged(Verdict::disjoint, 0.5, {0, 1e-9, ""}, direction)->kind, FindingKind::distance_outside);

  MethodAnswer point = answered(Verdict::intersecting);
  point.witness = CertificateKind::point;
  point.head[0] = 1;
  point.tail[0] = -0x1p-60;
  EXPECT_FALSE(judged(Verdict::intersecting, -0.5, none, point));
  point.head[1] = 1;
  EXPECT_EQ(judged(Verdict::intersecting, -0.5, none, point)->kind, FindingKind::bad_witness);
  // A verdict with the other kind of witness proves nothing either.
  point.verdict = Verdict::disjoint;
  EXPECT_EQ(judged(Verdict::disjoint, 0.5, none, point)->kind, FindingKind::bad_witness);
}

// upright(): the diameters are hypot(2, 3) each, so W = 7.21. The true direction is x.
TEST(Compare, AClaimExplainsADirectionThatIsOffByTwiceTheClaimOverTheGap) {
  const auto severity = [](double gap, double claim, double x, double y, double z) {
    MethodAnswer answer = answered(Verdict::disjoint);
    answer.set_direction({x, y, z});
    const auto finding = judged(Verdict::disjoint, gap, {0, claim, ""}, answer);
    EXPECT_TRUE(finding && finding->kind == FindingKind::bad_witness);
    return finding ? finding->severity : Severity::contract;
  };
  // The gap is less than twice the claim: any direction may come of it, but not none.
  EXPECT_EQ(severity(0.01, 0.006, 0, 0, 1), Severity::resolution);
  EXPECT_EQ(severity(0.01, 0.006, 0, 0, 0), Severity::contract);
  // At a gap of 0.01, a tilt of 0.01 towards z gives f = 0.01 * 3 - 0.01 > 0. The claim explains a sine of
  // 2e-4, then of 0.016.
  EXPECT_EQ(severity(0.01, 1e-6, 1, 0, 0.01), Severity::contract);
  EXPECT_EQ(severity(0.01, 8e-5, 1, 0, 0.01), Severity::resolution);
  // Far above the claim nothing goes.
  EXPECT_EQ(severity(0.5, 1e-12, 0, 1, 0), Severity::contract);
  EXPECT_EQ(severity(0.5, 1e-6, 0, 0, 1), Severity::contract);
}

TEST(Compare, AClaimExplainsAPointThatIsOutsideByTheClaim) {
  const auto severity = [](double y, double claim) {
    MethodAnswer answer = answered(Verdict::intersecting);
    answer.witness = CertificateKind::point;
    answer.head[0] = 1 - 0.25;
    answer.head[1] = y;
    return judged(Verdict::intersecting, -0.5, {0, claim, ""}, answer)->severity;
  };
  // The walls meet at y = sqrt(1 - 0.75^2) = 0.6614.
  EXPECT_EQ(severity(0.6615, 1e-3), Severity::resolution);
  EXPECT_EQ(severity(0.6615, 1e-6), Severity::contract);
  EXPECT_EQ(severity(100, 1e-12), Severity::contract);
}

TEST(Compare, OfTwoPointsTheMarginIsZeroOrInfinite) {
  const Pair points{{{0, 0, 0}, {0, 0, 1}, 0, 0}, {{1, 0, 0}, {0, 0, 1}, 0, 0}};
  Trial trial(points, truth_of(Verdict::disjoint));
  trial.enclose = [](double) { return Enclosure{1, 1}; };
  const auto finding = compare(trial, {1e-3, 0, ""}, answered(Verdict::intersecting));
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, Severity::contract);
  EXPECT_EQ(finding->margin->lo, std::numeric_limits<double>::infinity());
}

TEST(SameAnswer, ComparesWhatWasSaidBitForBit) {
  const MethodAnswer x = said_distance(Verdict::disjoint, 0.0);
  EXPECT_TRUE(same_answer(x, x));
  EXPECT_FALSE(same_answer(x, said_distance(Verdict::disjoint, -0.0)));
  EXPECT_FALSE(same_answer(x, answered(Verdict::disjoint)));
  EXPECT_FALSE(same_answer(x, MethodAnswer{}));
  EXPECT_TRUE(same_answer(x, failed_answer(Failure::hang, "")));  // time is not a function of the pair
  MethodAnswer point = answered(Verdict::intersecting), elsewhere = point;
  point.witness = elsewhere.witness = CertificateKind::point;
  EXPECT_TRUE(same_answer(point, elsewhere));
  elsewhere.hulls[1] = Hull::line;
  EXPECT_FALSE(same_answer(point, elsewhere));
}

TEST(FormatMethodAnswer, SaysWhatWasSaidAsJson) {
  MethodAnswer answer = said_distance(Verdict::disjoint, 0.25);
  answer.witness = CertificateKind::direction;
  answer.head[0] = 0.1;
  answer.tail[0] = 1e-20;
  EXPECT_EQ(format_method_answer(answer),
            R"({"verdict":"disjoint","distance":0.25,"direction":[[0.1,1e-20],0,0]})");
  answer.distance = -std::numeric_limits<double>::infinity();
  answer.witness = CertificateKind::none;
  EXPECT_EQ(format_method_answer(answer), R"({"verdict":"disjoint","distance":"-inf"})");
  EXPECT_EQ(format_method_answer(failed_answer(Failure::crash, "\"")), R"({"failed":"crash","reason":"\""})");
}

}  // namespace
}  // namespace cyl
