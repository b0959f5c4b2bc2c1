// SPDX-License-Identifier: MIT
#include "reports/explain/explain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/json.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

using json = nlohmann::json;

/// Answers intersecting for solids nearer than `tolerance`, if the distance of the first centre from the
/// origin is at least `place`.
std::unique_ptr<Method> blurred(std::string name, double tolerance, double place = 0) {
  const auto ask = [=](const Pair& pair) {
    const double blur = pair.a.center.norm() >= place ? tolerance : 0;
    return answered(distance(pair.a, pair.b).value <= blur ? Verdict::intersecting : Verdict::disjoint);
  };
  return fake_method(std::move(name), ask, {.claim = {.absolute = tolerance / 100, .source = "this test"}});
}

std::vector<std::unique_ptr<Method>> blurred_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(blurred("blurred-way", 1e-3));
  methods.push_back(blurred("blurred-way-fine", 1e-9));
  methods.push_back(blurred("blurred-far", 1e-3, 1e3));
  return methods;
}

/// Two solids 1e-4 apart, of size 8.
Pair stacked() {
  Pair pair;
  pair.a = {{0, 0, 0}, {0, 0, 1}, 1, 2};
  pair.b = {{0.25, 0.5, 2.0001}, {0, 0, 1}, 1, 2};
  return pair;
}

Pair far_away() {
  Pair pair = stacked();
  pair.a.center.x() += 5e3;
  pair.b.center.x() += 5e3;
  return pair;
}

/// A point 1e-4 below a disc.
Pair point_and_disc() {
  Pair pair;
  pair.a = {{0, 0, 0}, {0, 0, 1}, 0, 0};
  pair.b = {{0, 0, 1e-4}, {0, 0, 1}, 1, 0};
  return pair;
}

constexpr FindingKind kind = FindingKind::wrong_intersecting;

const FailingRegion& region(const std::vector<FailingRegion>& regions, Parameter parameter) {
  return regions[static_cast<std::size_t>(parameter)];
}

TEST(FailingRegion, EndsWhereTheToleranceDoes) {
  const auto methods = blurred_methods();
  const auto regions = failing_regions(methods[0], try_method(methods[0], stacked()));
  const FailingRegion& r = region(regions, Parameter::distance);
  EXPECT_NEAR(r.at, 1e-4, 1e-12);
  EXPECT_GE(r.high.fails_at, 0.98e-3);
  EXPECT_LE(r.high.fails_at, 1e-3);
  ASSERT_TRUE(r.high.beyond);
  EXPECT_GT(*r.high.ends_at, 1e-3);
  EXPECT_TRUE(r.high.beyond->right());
  EXPECT_EQ(r.high.beyond->truth.verdict, Verdict::disjoint);
  // Below, the region ends because the solids meet.
  EXPECT_LT(r.low.fails_at, 1e-13);
  ASSERT_TRUE(r.low.beyond);
  EXPECT_NE(r.low.beyond->truth.verdict, Verdict::disjoint);

  Pair points = point_and_disc();
  points.b.radius = 0;
  EXPECT_NEAR(failing_regions(methods[0], try_method(methods[0], points))[0].high.fails_at, 1e-3, 2e-5);
}

TEST(FailingRegion, EveryEndWasAskedAboutAndProved) {
  const auto methods = blurred_methods();
  auto regions = failing_regions(methods[0], try_method(methods[0], stacked()));
  for (FailingRegion& r : failing_regions(methods[0], try_method(methods[0], point_and_disc())))
    regions.push_back(std::move(r));
  for (const FailingRegion& r : regions) {
    for (const RegionEnd* end : {&r.low, &r.high}) {
      EXPECT_TRUE(try_method(methods[0], end->failing.pair).fails(kind)) << to_string(r.parameter);
      EXPECT_EQ(end->ends_at.has_value(), end->beyond.has_value());
      if (end->beyond) {
        EXPECT_FALSE(end->beyond->fails(kind)) << to_string(r.parameter);
        EXPECT_TRUE(end->beyond->decided());
      }
    }
    EXPECT_LE(r.low.fails_at, r.at);
    EXPECT_GE(r.high.fails_at, r.at);
  }
}

TEST(FailingRegion, TellsWhatMatters) {
  const auto methods = blurred_methods();
  const auto regions = failing_regions(methods[0], try_method(methods[0], stacked()));
  const FailingRegion& scale = region(regions, Parameter::scale);
  EXPECT_EQ(scale.high.fails_at, 3);
  EXPECT_EQ(*scale.high.ends_at, 4);
  EXPECT_TRUE(scale.high.beyond->right());
  EXPECT_FALSE(scale.low.ends_at);
  const FailingRegion& angle = region(regions, Parameter::angle);
  EXPECT_FALSE(angle.low.ends_at);
  EXPECT_FALSE(angle.high.ends_at);
  EXPECT_GT(angle.high.fails_at, 1.57);
  for (const Parameter p :
       {Parameter::radius_a, Parameter::height_a, Parameter::radius_b, Parameter::height_b}) {
    EXPECT_LT(region(regions, p).low.fails_at, 0.01) << to_string(p);
    EXPECT_GT(region(regions, p).high.fails_at, 1e3) << to_string(p);
  }

  const auto places = failing_regions(methods[2], try_method(methods[2], far_away()));
  const FailingRegion& offset = region(places, Parameter::offset);
  EXPECT_NEAR(offset.low.fails_at, 1e3, 20);
  EXPECT_TRUE(offset.low.beyond->right());
}

TEST(FailingRegion, EndsWhereItBreaksForAnotherReason) {
  const auto method = fake_method("breaks", [](const Pair& pair) {
    return failed_answer(Failure::reported, pair.a.radius < 1.5 ? "status 4: thin" : "status 9: no way");
  });
  const Trial failing = try_method(method, stacked());
  const auto regions = failing_regions(method, failing);
  EXPECT_NEAR(region(regions, Parameter::radius_a).high.fails_at, 1.5, 0.02);
  const auto curve = calibration_curve(method, failing, 7);
  EXPECT_LT(curve.value().points[5].failures, curve->points[5].trials);
}

TEST(CalibrationCurve, StepsAtTheTolerance) {
  const auto methods = blurred_methods();
  const Trial failing = try_method(methods[0], stacked());
  const auto curve = calibration_curve(methods[0], failing, 7);
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->feature, ContactFeature::cap_cap);
  std::uint64_t trials = 0;
  for (const CalibrationPoint& p : curve->points) {
    trials += p.trials;
    EXPECT_EQ(p.drawn, drawn_per_decade);
    // The sizes are from 2 to 16.
    if (p.decade <= 2) {
      EXPECT_EQ(p.failures, 0u) << p.decade;
    }
    if (p.decade >= 5 && p.decade < 14) {
      EXPECT_EQ(p.failures, p.trials) << p.decade;
    }
    EXPECT_LE(p.rate.lower, static_cast<double>(p.failures) / static_cast<double>(p.trials));
  }
  EXPECT_GT(trials, 15 * drawn_per_decade / 3);
}

WorkaroundOutcome outcome(const std::vector<Workaround>& tried, Transformation transformation) {
  for (const Workaround& w : tried)
    if (w.transformation == transformation) return w.outcome;
  return WorkaroundOutcome::no_change;
}

TEST(Cures, ToleranceScaleAndPlace) {
  const auto methods = blurred_methods();
  const auto near = try_workarounds(methods, methods[0], try_method(methods[0], stacked()));
  EXPECT_EQ(outcome(near, Transformation::setting), WorkaroundOutcome::right);
  EXPECT_EQ(outcome(near, Transformation::rescaled), WorkaroundOutcome::still_fails);
  EXPECT_EQ(outcome(near, Transformation::at_origin), WorkaroundOutcome::no_change);
  EXPECT_EQ(outcome(near, Transformation::exchanged), WorkaroundOutcome::still_fails);
  EXPECT_EQ(outcome(near, Transformation::unit_axes), WorkaroundOutcome::no_change);
  const auto far = try_workarounds(methods, methods[2], try_method(methods[2], far_away()));
  EXPECT_EQ(outcome(far, Transformation::setting), WorkaroundOutcome::no_change);
  EXPECT_EQ(outcome(far, Transformation::at_origin), WorkaroundOutcome::right);

  Pair tiny = stacked();
  for (Cylinder* c : {&tiny.a, &tiny.b}) {
    c->center *= 0x1p-20;
    c->radius *= 0x1p-20;
    c->height *= 0x1p-20;
  }
  tiny.b.center.z() = 0x1.2p-19;  // an eighth of the height apart: right at any other size
  EXPECT_EQ(
      outcome(try_workarounds(methods, methods[0], try_method(methods[0], tiny)), Transformation::rescaled),
      WorkaroundOutcome::right);
}

/// A distance 2 % off at every size. If the claim allows it for small pairs, that does not cure large ones.
TEST(Cures, NotADistanceThatIsOffAsMuch) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("coarse",
                                [](const Pair& pair) {
                                  MethodAnswer answer = answered(Verdict::disjoint);
                                  answer.has_distance = true;
                                  answer.distance = 0.98 * distance(pair.a, pair.b).value;
                                  return answer;
                                },
                                {.claim = {.absolute = 1, .source = "this test"}}));
  Pair large = scaled(stacked(), 20);
  large.b.center.z() = 0x1p24;
  const Trial failing = try_method(methods[0], large);
  ASSERT_TRUE(failing.fails(FindingKind::distance_outside));
  EXPECT_EQ(outcome(try_workarounds(methods, methods[0], failing), Transformation::rescaled),
            WorkaroundOutcome::still_fails);
}

TEST(Explain, SumsUp) {
  const auto methods = blurred_methods();
  const Explanation e = explain(methods, "blurred-way", kind, stacked());
  EXPECT_EQ(e.mechanism.find("blurred-way calls solids up to 0.0"), 0u) << e.mechanism;
  EXPECT_NE(e.mechanism.find("blurred-way-fine is right"), std::string::npos) << e.mechanism;
  EXPECT_NE(e.mechanism.find("right once scaled up to a size of 96 ("), std::string::npos) << e.mechanism;
  EXPECT_NE(e.mechanism.find(" do not matter."), std::string::npos) << e.mechanism;
  const Failing failing{0, kind, stacked()};
  const Mechanism triaged = classify(methods, {&failing, 1}, {})[0].mechanism;
  EXPECT_NE(e.mechanism.find(in_words(triaged)), std::string::npos) << e.mechanism;
  const std::string text = explanation_text(e);
  EXPECT_NE(text.find(e.mechanism), std::string::npos);
  EXPECT_NE(text.find("they meet"), std::string::npos) << text;
  EXPECT_EQ(text.find(", within its claim"), text.find(", within its claim", text.find("\n1e-06 ")));
  const json all = parse_json(explanation_json(e));
  EXPECT_EQ(all["regions"].size(), 8u);
  EXPECT_EQ(all["regions"][0]["high"]["beyond"]["truth"]["verdict"], "disjoint");
  EXPECT_EQ(all["curve"]["feature"], "cap-cap");
  EXPECT_EQ(all["cures"].size(), 5u);
  EXPECT_EQ(all["mechanism"], e.mechanism);
}

/// Answers intersecting for solids whose axes are square to 1e-5, and whose distance is at most a hundredth
/// of the size.
std::vector<std::unique_ptr<Method>> square_blind() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("square-blind", [](const Pair& pair) {
    const bool square = std::abs(pair.a.axis.normalized().dot(pair.b.axis.normalized())) < 1e-5;
    return answered(distance(pair.a, pair.b).value <= (square ? 0.01 * size_of(pair) : 0)
                        ? Verdict::intersecting
                        : Verdict::disjoint);
  }));
  return methods;
}

/// Two rims 0.01 apart with square axes.
Pair square() {
  Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{0, 0, 0}, {0, 1, 0}, 1, 2}};
  double low = 1, high = 3;
  for (int i = 0; i < 50; ++i) {
    const double t = (low + high) / 2;
    pair.b.center = {t, t, t};
    (distance(pair.a, pair.b).value > 0.01 ? high : low) = t;
  }
  return pair;
}

TEST(Explain, DrawsWhereItFails) {
  const auto methods = square_blind();
  const Explanation e = explain(methods, "square-blind", kind, square());
  EXPECT_EQ(e.curve->feature, ContactFeature::rim_rim);
  EXPECT_NE(e.mechanism.find("It fails only with angle from 1.57."), std::string::npos) << e.mechanism;
  ASSERT_TRUE(e.curve);
  for (const CalibrationPoint& p : e.curve->points) {
    if (p.decade < 3 || p.decade > 12) continue;
    EXPECT_GT(p.trials, drawn_within_per_decade / 10) << p.decade;
    EXPECT_EQ(p.failures, p.trials) << p.decade;
  }
  EXPECT_NE(explanation_text(e).find("pairs of the same size with angle from 1.57 (seed"), std::string::npos)
      << explanation_text(e);
  EXPECT_EQ(parse_json(explanation_json(e))["curve"]["within"][0]["parameter"], "angle");
}

TEST(Explain, SeesThatAFailureHangsOnTheAngle) {
  EXPECT_TRUE(hangs_on_angle(square_blind()[0], square(), kind));
  EXPECT_FALSE(hangs_on_angle(blurred_methods()[0], stacked(), kind));
}

TEST(Explain, WhatOnlyTouchesDoesNotOverlap) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("strict", [](const Pair&) { return answered(Verdict::disjoint); }));
  const Pair point{{{0, 0, 1}, {0, 0, 1}, 0, 0}, {{0, 0, 1}, {0, 0, 1}, 0, 0}};
  const Explanation e = explain(methods, "strict", FindingKind::wrong_disjoint, point);
  EXPECT_EQ(e.mechanism.find("strict calls solids that touch disjoint. Cause: "), 0u) << e.mechanism;
  EXPECT_THROW(explain(methods, "strict", FindingKind::state_dependent, point), std::invalid_argument);
}

TEST(Explain, TheSameTwice) {
  const auto methods = blurred_methods();
  EXPECT_EQ(explanation_json(explain(methods, "blurred-far", kind, far_away())),
            explanation_json(explain(methods, "blurred-far", kind, far_away())));
}

TEST(Explain, RefusesWhatDoesNotFail) {
  const auto methods = blurred_methods();
  EXPECT_THROW(explain(methods, "blurred-way-fine", kind, stacked()), std::invalid_argument);
  EXPECT_THROW(explain(methods, "blurred-way", FindingKind::wrong_disjoint, stacked()),
               std::invalid_argument);
  EXPECT_THROW(explain(methods, "nobody", kind, stacked()), std::invalid_argument);
}

/// A method that does not return if a is the lower solid.
TEST(Explain, AHangIsAskedAboutSeldom) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("hanging", [](const Pair& pair) {
    volatile unsigned spins = 0;
    while (pair.a.center.z() < pair.b.center.z()) spins = spins + 1;
    return answered(Verdict::disjoint);
  }));
  const Explanation e = explain(methods, "hanging", FindingKind::hang, stacked());
  EXPECT_TRUE(e.regions.empty());
  EXPECT_EQ(outcome(e.workarounds, Transformation::exchanged), WorkaroundOutcome::right);
  EXPECT_EQ(outcome(e.workarounds, Transformation::rescaled), WorkaroundOutcome::still_fails);
  EXPECT_NE(explanation_text(e).find("Cause: the order ("), std::string::npos) << explanation_text(e);
  EXPECT_TRUE(parse_json(explanation_json(e))["curve"].is_null());
}

// A real library: FCL's own GJK stops at an absolute tolerance.
TEST(Explain, AFinding) {
  Pair pair;
  pair.a = {{0, 0, 0}, {0, 0, 1}, 1, 2};
  pair.b = {{0, 0, 2.0000005}, {0, 0, 1}, 1, 2};
  const Explanation e = explain(fcl_methods(), "fcl-indep", kind, pair);
  EXPECT_NE(e.mechanism.find("a fixed length in it"), std::string::npos) << e.mechanism;
}

}  // namespace
}  // namespace cyl
