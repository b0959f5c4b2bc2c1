// SPDX-License-Identifier: MIT
#include "reports/explain/explain.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {
namespace {

/// Answers intersecting for solids nearer than `tolerance`.
std::unique_ptr<Method> blurred(std::string name, double tolerance) {
  const auto ask = [=](const Pair& pair) {
    const bool near = approximate_distance(pair).value <= tolerance;
    return answered(near ? Verdict::intersecting : Verdict::disjoint);
  };
  return fake_method(std::move(name), ask, {.claim = {.absolute = tolerance / 100, .source = "this test"}});
}

std::vector<std::unique_ptr<Method>> blurred_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(blurred("blurred-way", 1e-3));
  methods.push_back(blurred("blurred-way-fine", 1e-9));
  return methods;
}

/// Two solids 1e-4 apart, of size 8.
Pair stacked() {
  Pair pair;
  pair.a = {{0, 0, 0}, {0, 0, 1}, 1, 2};
  pair.b = {{0.25, 0.5, 2.0001}, {0, 0, 1}, 1, 2};
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
  // Below, the region ends because the claim allows the answer.
  EXPECT_NEAR(r.low.fails_at, 1e-5, 2e-7);
  ASSERT_TRUE(r.low.beyond && r.low.beyond->finding());
  EXPECT_EQ(r.low.beyond->finding()->severity, Severity::resolution);

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
        EXPECT_FALSE(end->beyond->fails(kind) && end->beyond->finding()->severity == Severity::contract)
            << to_string(r.parameter);
        EXPECT_TRUE(end->beyond->decided());
      }
    }
    EXPECT_LE(r.low.fails_at, r.at);
    EXPECT_GE(r.high.fails_at, r.at);
  }
}

TEST(FailingRegion, ShowsWhatMatters) {
  const auto methods = blurred_methods();
  const auto regions = failing_regions(methods[0], try_method(methods[0], stacked()));
  const FailingRegion& angle = region(regions, Parameter::angle);
  EXPECT_FALSE(angle.low.ends_at);
  EXPECT_FALSE(angle.high.ends_at);
  EXPECT_GT(angle.high.fails_at, 1.57);
  for (const Parameter p :
       {Parameter::radius_a, Parameter::height_a, Parameter::radius_b, Parameter::height_b}) {
    EXPECT_LT(region(regions, p).low.fails_at, 0.01) << to_string(p);
    EXPECT_GT(region(regions, p).high.fails_at, 1e3) << to_string(p);
  }
}

struct OfBoxes : FakeMethod {
  using FakeMethod::FakeMethod;
  bool supports(SolidKind kind) const override { return kind == SolidKind::box; }
};

TEST(FailingRegion, BoxesHaveEdgesAndTurn) {
  const std::unique_ptr<Method> narrow = std::make_unique<OfBoxes>("narrow", [](const Pair& pair) {
    const bool near = approximate_distance(pair).value <= 1e-3;
    return answered(near && pair.b.edges[1] < 3 ? Verdict::intersecting : Verdict::disjoint);
  });
  const Solid box{.center = {0, 0, 0}, .shape = Shape::box, .edges = {2, 2, 2}, .quaternion = {1, 0, 0, 0}};
  Pair pair{box, box};
  pair.b.center = {0.25, 0.5, 2.0001};
  const auto regions = failing_regions(narrow, try_method(narrow, pair));
  EXPECT_EQ(regions.size(), 8u);
  const auto of = [&](Parameter p) { return *std::ranges::find(regions, p, &FailingRegion::parameter); };
  EXPECT_NEAR(of(Parameter::second_edge_b).high.fails_at, 3, 0.04);
  EXPECT_GT(of(Parameter::first_edge_b).high.fails_at, 100);
  EXPECT_GT(of(Parameter::third_edge_a).high.fails_at, 100);
  EXPECT_EQ(of(Parameter::angle).at, 0);
  EXPECT_GT(of(Parameter::angle).high.fails_at, 1.57);
}

// Steps from an infinite distance, and steps below the least double, would not end.
TEST(FailingRegion, EndsAtTheEndsOfTheDoubles) {
  const auto method = fake_method("all", [](const Pair&) { return answered(Verdict::intersecting); });
  for (const auto& [at, size] : {std::pair(1.5e308, 1e306), std::pair(1e-310, 1e-313)}) {
    const Pair pair{{{at, 0, 0}, {0, 0, 1}, size, size}, {{-at, 0, 0}, {0, 0, 1}, size, size}};
    EXPECT_EQ(failing_regions(method, try_method(method, pair)).size(), 6u);
  }
}

TEST(FailingRegion, EndsWhereItBreaksForAnotherReason) {
  const auto method = fake_method("breaks", [](const Pair& pair) {
    return failed_answer(Failure::reported, pair.a.radius < 1.5 ? "status 4: thin" : "status 9: no way");
  });
  const Trial failing = try_method(method, stacked());
  const auto regions = failing_regions(method, failing);
  EXPECT_NEAR(region(regions, Parameter::radius_a).high.fails_at, 1.5, 0.02);
}

testing::AssertionResult says(const std::string& text, const std::string& words) {
  if (text.find(words) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no '" << words << "' in " << text;
}

TEST(Explain, SumsUp) {
  const auto methods = blurred_methods();
  const std::string text = explain(methods, "blurred-way", kind, stacked());
  EXPECT_TRUE(says(text, "blurred-way-fine is right"));
  EXPECT_TRUE(says(text, "If angle, radii or heights change, b moves so that the distance stays the same."));
  EXPECT_TRUE(says(text, "within the claim"));
  EXPECT_FALSE(says(text, "right (0 samples)"));
  const auto groups = algorithm_groups(methods);
  Asker asker(methods, {});
  const std::string key = find_cause({methods, groups}, {0, kind, stacked()}, Severity::contract, "", asker);
  EXPECT_TRUE(says(text, "Triage calls the cause " + key + " (a fixed length in it"));
  EXPECT_EQ(text, explain(methods, "blurred-way", kind, stacked()));
}

/// Answers intersecting for solids whose distance is at most a hundredth of the size, at some angles between
/// their axes.
std::vector<std::unique_ptr<Method>> blind(std::function<bool(double angle)> at) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("blind", [at = std::move(at)](const Pair& pair) {
    const Vector3 a = pair.a.axis.normalized(), b = pair.b.axis.normalized();
    const bool near = approximate_distance(pair).value <= 0.01 * size_of(pair);
    const bool fails = near && at(std::atan2(a.cross(b).norm(), std::abs(a.dot(b))));
    return answered(fails || approximate_distance(pair).value <= 0 ? Verdict::intersecting
                                                                   : Verdict::disjoint);
  }));
  return methods;
}

constexpr double right_angle = 1.57079632679489661923;
std::vector<std::unique_ptr<Method>> square_blind() {
  return blind([](double angle) { return angle > right_angle - 1e-5; });
}

/// Two rims 0.01 apart with square axes.
Pair square() {
  Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{0, 0, 0}, {0, 1, 0}, 1, 2}};
  double low = 1, high = 3;
  for (int i = 0; i < 50; ++i) {
    const double t = (low + high) / 2;
    pair.b.center = {t, t, t};
    (approximate_distance(pair).value > 0.01 ? high : low) = t;
  }
  return pair;
}

TEST(Explain, ARangeIsNamedIfSamplesOnBothSidesShowIt) {
  EXPECT_TRUE(says(explain(square_blind(), "blind", kind, square()),
                   "In the samples, it fails only with angle from 1.57."));
  Pair tilted = stacked();
  tilted.b.center.z() = 2.01;
  tilted.b.axis = {std::sin(1e-3), 0, std::cos(1e-3)};
  const auto ranges = [&](std::function<bool(double)> at) {
    const auto methods = blind(std::move(at));
    return supported_ranges(failing_regions(methods[0], try_method(methods[0], tilted)));
  };
  const auto wide = ranges([](double angle) { return angle > 1e-5 && angle < 1e-2; });
  ASSERT_EQ(wide.size(), 1u);
  EXPECT_TRUE(says(wide[0], "angle 1"));
  EXPECT_TRUE(says(wide[0], "e-05 to 0.0"));
  EXPECT_TRUE(ranges([](double angle) { return angle > 0.9e-3 && angle < 1.1e-3; }).empty()) << "one sample";
  const auto again = ranges([](double angle) { return (angle > 1e-5 && angle < 1e-2) || angle > 0.03; });
  ASSERT_EQ(again.size(), 1u);
  EXPECT_TRUE(says(again[0], "angle from 1")) << "above, it fails again";
}

// No random pair has an angle of exactly 90 degrees.
TEST(Explain, WhatFailsAtOneValueOnlyHasNoRange) {
  const std::string text =
      explain(blind([](double angle) { return angle >= right_angle; }), "blind", kind, square());
  EXPECT_FALSE(says(text, "it fails only with angle"));
}

// A point has nowhere to go but away.
TEST(Explain, AsFarAsTriedNeedsSamples) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("all", [](const Pair&) { return answered(Verdict::intersecting); }));
  const std::string text = explain(methods, "all", kind, point_and_disc());
  for (const char* words : {"as far as tried", "nothing was tried"}) EXPECT_TRUE(says(text, words));
}

TEST(Explain, RefusesWhatOnlyOtherPairsShow) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("strict", [](const Pair&) { return answered(Verdict::disjoint); }));
  const Pair point{{{0, 0, 1}, {0, 0, 1}, 0, 0}, {{0, 0, 1}, {0, 0, 1}, 0, 0}};
  EXPECT_THROW(explain(methods, "strict", FindingKind::state_dependent, point), std::invalid_argument);
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
  EXPECT_TRUE(says(explain(methods, "hanging", FindingKind::hang, stacked()), "no similar pair was asked"));
}

// A real library: FCL's own GJK stops at an absolute tolerance.
TEST(Explain, AFinding) {
  Pair pair;
  pair.a = {{0, 0, 0}, {0, 0, 1}, 1, 2};
  pair.b = {{0, 0, 2.0000005}, {0, 0, 1}, 1, 2};
  EXPECT_TRUE(says(explain(fcl_methods(), "fcl-indep", kind, pair), "a fixed length in it"));
}

}  // namespace
}  // namespace cyl
