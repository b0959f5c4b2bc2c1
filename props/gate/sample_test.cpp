// SPDX-License-Identifier: MIT
#include "props/gate/sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"
#include "props/gate/gate.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

/// A guest with two kinds of solids of ordinary size.
class OfTwoKinds : public FakeMethod {
 public:
  OfTwoKinds(SolidKind one, SolidKind other, Ask ask)
      : FakeMethod("balls", std::move(ask),
                   {.claim = Claim{1e-12, 0, "planted"}, .foreign = false, .guest = true}),
        one_(one),
        other_(other) {}
  using FakeMethod::supports;
  bool supports(SolidKind kind) const override { return kind == one_ || kind == other_; }
  const SizeRange* sizes() const override { return &sizes_; }

 private:
  SolidKind one_, other_;
  SizeRange sizes_{.least = 0.01, .greatest = 100};
};

GateReport gate_on_balls(FakeMethod::Ask ask, std::uint64_t pairs, SolidKind one = SolidKind::sphere,
                         SolidKind other = SolidKind::capsule) {
  std::vector<Case> cases = read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases");
  cases.resize(40);
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<OfTwoKinds>(one, other, std::move(ask)));
  return run_gate(methods, cases, {.pairs = pairs, .as_found = true});
}

TEST(Gate, SharesThePairsAmongTheSolidsOfAGuest) {
  const GateAmount all = amount_of(30'000, {.cylinders = true, .rounded = 400});
  EXPECT_EQ(all.sample_rounds, amount_of(20'000).sample_rounds);
  EXPECT_EQ(all.rounded_rounds, amount_of(10'000, {.cylinders = false, .rounded = 400}).rounded_rounds);
  EXPECT_EQ(amount_of(20'000).rounded_rounds, 0u);
  EXPECT_EQ(amount_of(40 * 50 * 51 / 50, {.cylinders = false, .rounded = 40}).rounded_rounds, 50u);
}

TEST(Gate, TheAmountIsAFunctionOfTheNumberOfPairs) {
  const auto is = [](std::uint64_t pairs, std::uint64_t laws, std::uint64_t sample, std::uint64_t close) {
    const GateAmount amount = amount_of(pairs);
    EXPECT_FALSE(amount.cases_under_laws);
    EXPECT_EQ(amount.law_rounds, laws) << pairs;
    EXPECT_EQ(amount.sample_rounds, sample) << pairs;
    EXPECT_EQ(amount.close_law_rounds, laws) << pairs;
    EXPECT_EQ(amount.close_rounds, close) << pairs;
  };
  is(1, 1, 1, 1);
  is(2500, 1, 3, 4);
  is(2 * 51 * 64, 1, 8, 9);
  is(2 * 51 * 65, 2, 8, 10);
  is(250'000, 39, 292, 341);
  is(gate_pairs, 77, 584, 681);
}

TEST(Gate, AsksAGuestOfSpheresAndCapsulesAboutThese) {
  const auto right = [](const Pair& pair) { return answered(decide(pair.a, pair.b).verdict); };
  const GateReport report = gate_on_balls(right, 4000);
  EXPECT_EQ(exit_code(report), 0);
  const GateMethod& method = report.methods.at(0);
  EXPECT_GE(method.counts.asked, 3000u);
  EXPECT_EQ(method.counts.declined, 0u);
  EXPECT_GE(method.rounded.pairs, 3000u);
  EXPECT_EQ(method.rounded.wrong, 0u);
  for (const GatePhaseReport& phase : report.phases)
    EXPECT_TRUE(phase.phase != GatePhase::sample && phase.phase != GatePhase::close_sample);

  // The classic fault takes nearly parallel capsules for parallel ones.
  const GateReport parallel = gate_on_balls(
      [&](const Pair& pair) {
        Pair taken = pair;
        const Vector3 x = pair.a.axis.normalized(), y = pair.b.axis.normalized();
        if (1 - std::abs(x.dot(y)) < 1e-8) taken.b.axis = pair.a.axis;
        return right(taken);
      },
      4000);
  EXPECT_EQ(exit_code(parallel), 2);

  const GateReport wrong = gate_on_balls([](const Pair&) { return answered(Verdict::disjoint); }, 500);
  EXPECT_EQ(exit_code(wrong), 2);
  EXPECT_GT(wrong.methods.at(0).rounded.wrong, 0u);
}

TEST(Gate, AsksAGuestOfCylindersAndOtherSolidsAboutBoth) {
  for (const SolidKind other : {SolidKind::half_space, SolidKind::box}) {
    const GateReport report =
        gate_on_balls([](const Pair& pair) { return answered(decide_exactly(pair.a, pair.b).verdict); }, 4000,
                      SolidKind::cylinder, other);
    EXPECT_EQ(exit_code(report), 0);
    EXPECT_GE(report.methods.at(0).rounded.pairs, 1000u);
  }
}

TEST(Gate, StrataOfShapesAreAsBuilt) {
  for (const Kinds& kinds : drawn_kinds) {
    std::set<ContactFeature> features;
    for (std::uint64_t index = 0; index < 30 * drawn_decade_count; ++index) {
      const Pair pair = draw_in_stratum(kinds, 1, index);
      const std::uint64_t decade = first_decade + index % drawn_decade_count;
      const bool gap = index / drawn_decade_count % 2 == 0;
      if (decade > 12) continue;
      const Truth truth = judge(pair);
      if (gap || decade > 1) {  // an overlap of 1e-1 may be none
        EXPECT_EQ(truth.verdict, gap ? Verdict::disjoint : Verdict::intersecting) << format_pair(pair);
      }
      if (!gap) continue;
      const AttainedDistance found = attain_distance(pair, truth, 1e-15);
      EXPECT_LE(found.distance.lo / size_of(pair), tenths[decade] + 1e-14) << format_pair(pair);
      EXPECT_GE(found.distance.hi / size_of(pair), 0.1 * tenths[decade] - 1e-14) << format_pair(pair);
      features.insert(feature_along(pair, Vector3(found.direction.data())));
    }
    const bool has_all = kinds.first > SolidKind::capsule && kinds.first != SolidKind::half_space &&
                         kinds.second != SolidKind::half_space;
    if (has_all) {
      EXPECT_EQ(features.size(), 6u) << to_string(kinds.first) << ' ' << to_string(kinds.second);
    }
  }
}

}  // namespace
}  // namespace cyl
