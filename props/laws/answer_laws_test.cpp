// SPDX-License-Identifier: MIT
// Each law of one answer catches a planted fault. If other laws catch it too, there is a reason.
#include <gtest/gtest.h>

#include <thread>

#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

// A question from another thread is a second question.
TEST(AnswerLaws, CatchAnAnswerThatChanges) {
  int calls = 0;
  EXPECT_EQ(laws_broken_by(plant("decide",
                                 [&](const Pair&, MethodAnswer& answer) {
                                   if (++calls % 3 == 0) answer.witness = CertificateKind::none;
                                 })),
            (Numbers{35, 36}));
}

TEST(AnswerLaws, CatchAnAnswerThatDependsOnTheThread) {
  const auto here = std::this_thread::get_id();
  EXPECT_EQ(laws_broken_by(plant("decide",
                                 [here](const Pair&, MethodAnswer& answer) {
                                   if (std::this_thread::get_id() != here)
                                     answer.verdict = Verdict::undecided;
                                 })),
            Numbers{36});
}

TEST(AnswerLaws, CatchAnotherVerdictOfPreparedSolids) {
  Planted method = plant("intersect", [](const Pair&, MethodAnswer&) {});
  method.prepared = [](const Pair&) { return Verdict::disjoint; };
  EXPECT_EQ(laws_broken_by(method), Numbers{37});
}

TEST(AnswerLaws, CatchAnotherVerdictInABatch) {
  Planted method = plant("intersect", [](const Pair&, MethodAnswer&) {});
  method.batch = [](const Pair&) { return Verdict::undecided; };
  EXPECT_EQ(laws_broken_by(method), Numbers{37});
}

TEST(AnswerLaws, TakeTouchingInOneWayForIntersectingInAnother) {
  Planted method = plant("intersect", [](const Pair&, MethodAnswer&) {});
  method.prepared = [](const Pair& pair) {
    const Verdict verdict = ask_ours("intersect", pair).verdict;
    return verdict == Verdict::intersecting ? Verdict::touching : verdict;
  };
  EXPECT_EQ(laws_broken_by(method), Numbers{});
}

// The border is a gap or a common ball of 1e-13 of the size. A coin has room for a disk, and a needle for a
// segment. The law does not apply to two flat solids, or to a solid that is thinner than the ball and not
// flat.
TEST(AnswerLaws, CatchWhoIsUndecidedWhereThereIsRoom) {
  Planted method = plant(
      "decide", [](const Pair&, MethodAnswer& answer) { answer = answered(Verdict::undecided); },
      of_everything);
  const auto violation = [&](const Solid& a, const Solid& b) {
    return violation_of(method, law_numbered(39), {a, b}).has_value();
  };
  const auto upright = [](double x, double radius = 1, double height = 2) {
    return Solid{Vector3(x, 0, 0), Vector3(0, 0, 1), radius, height};
  };
  EXPECT_TRUE(violation(upright(0), upright(2 + 7e-13)));
  EXPECT_FALSE(violation(upright(0), upright(2 + 5e-13)));
  EXPECT_TRUE(violation(upright(0), upright(2 - 13e-13)));
  EXPECT_FALSE(violation(upright(0), upright(2 - 11e-13)));
  EXPECT_TRUE(violation(upright(0, 1, 0), upright(1.5)));
  EXPECT_TRUE(violation(upright(0), upright(0.5, 0, 1)));
  EXPECT_FALSE(violation(upright(0), upright(0.5, 0, 0)));
  EXPECT_FALSE(violation(upright(0, 1, 0), upright(1.5, 1, 0)));
  EXPECT_FALSE(violation(upright(0), upright(0.5, 1, 6e-13)));
  EXPECT_TRUE(violation(upright(0), upright(0.5, 1, 3e-13)));
}

TEST(AnswerLaws, CatchARefereeThatNeedsAWitness) {
  Planted method = plant(
      "decide", [](const Pair&, MethodAnswer&) {}, of_everything);
  const Pair pair = find_family("random")->generate(family_seed, 0);
  const MethodAnswer first = method.ask(pair);
  Proofs proofs(pair, {&first, 1});
  const LawCase c{method, pair, first, {}, {}, proofs};
  EXPECT_FALSE(law_numbered(43).check(c));
  proofs.of(pair).truth.verdict = Verdict::undecided;
  EXPECT_EQ(law_numbered(43).check(c)->severity, Severity::contract);
}

}  // namespace
}  // namespace cyl
