// SPDX-License-Identifier: MIT
#include "fuzz/guided/fuzz_judge.hpp"

#include <gtest/gtest.h>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/methods/own_answers.hpp"

namespace cyl {
namespace {

/// Judges an answer of a method that promises what `decide` or `distance` do, and returns the findings.
std::size_t found(const Pair& pair, const MethodAnswer& answer) {
  Claim claim;
  claim.relative = 1e-13;
  claim.decides = DecisionScope::above_1e13;
  const auto method = fake_method("planted", [](const Pair&) { return MethodAnswer{}; }, {.claim = claim});
  FindingSink sink;
  FuzzJudge(pair, {}, false, sink).record(*method, answer);
  return sink.findings();
}

/// Two sides square to each other, apart by so much of their size, 6.
Pair apart_by(double margin) {
  return {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2 + 6 * margin, 0, 0}, {0, 1, 0}, 1, 2}};
}

TEST(FuzzJudge, UndecidedIsAFindingBeyondRoundingOnly) {
  for (const double margin : {1e-2, 1e-9, 1.1e-13}) {
    EXPECT_EQ(found(apart_by(margin), answered(Verdict::undecided)), 1u) << margin;
    EXPECT_EQ(found(apart_by(-margin), answered(Verdict::undecided)), margin > 1e-12) << margin;
  }
  for (const double margin : {0.9e-13, 0.0, -0.9e-13})
    EXPECT_EQ(found(apart_by(margin), answered(Verdict::undecided)), 0u) << margin;
}

TEST(FuzzJudge, ADistanceIsHeldToTheErrorReportedWithIt) {
  for (const double margin : {1e-2, 1e-9, -1e-2}) {
    const Pair pair = apart_by(margin);
    MethodAnswer answer = answer_of(pair, distance(pair.a, pair.b));
    EXPECT_EQ(found(pair, answer), 0u) << margin;
    answer.distance += 2 * answer.error_bound;  // far within what is claimed
    EXPECT_EQ(found(pair, answer), 1u) << margin;
  }
}

TEST(FuzzJudge, OursShowTheirDistancesWithinTheErrorReported) {
  for (const CloseContact& contact : draw_close_round(7, 0)) {
    const Distance d = distance(contact.pair.a, contact.pair.b);
    EXPECT_EQ(found(contact.pair, answer_of(contact.pair, d)), 0u);
  }
}

}  // namespace
}  // namespace cyl
