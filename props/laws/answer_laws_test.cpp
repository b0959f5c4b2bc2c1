// SPDX-License-Identifier: MIT
// Each law of one answer catches a planted fault. If other laws catch it too, there is a reason.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "oracles/referee/referee.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

TEST(AnswerLaws, CatchAFailure) {
  EXPECT_EQ(laws_broken_by(plant("intersect",
                                 [](const Pair&, MethodAnswer& answer) {
                                   answer.status = Status::failed;
                                   answer.failure = Failure::crash;
                                 })),
            Numbers{30});
}

TEST(AnswerLaws, CatchAWrongVerdict) {
  EXPECT_EQ(laws_broken_by(plant("intersect",
                                 [](const Pair&, MethodAnswer& answer) {
                                   if (answer.verdict == Verdict::intersecting)
                                     answer.verdict = Verdict::touching;
                                 })),
            Numbers{31});
}

TEST(AnswerLaws, CatchADirectionThatDoesNotSeparate) {
  EXPECT_EQ(laws_broken_by(plant("decide",
                                 [](const Pair&, MethodAnswer& answer) {
                                   if (answer.witness == CertificateKind::direction)
                                     answer.set_direction(Vector3(1, 0, 0));
                                 })),
            Numbers{32});
}

TEST(AnswerLaws, CatchADistanceTooLarge) {
  EXPECT_EQ(laws_broken_by(plant(
                "distance",
                [](const Pair& pair, MethodAnswer& answer) { answer.distance += 1e-9 * size_of(pair); })),
            Numbers{33});
}

// The distance is wrong too, and no triangle shows a gap if there is none.
TEST(AnswerLaws, CatchADistanceOfTheOtherSign) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair&, MethodAnswer& answer) {
                                   if (answer.distance < 0) answer.distance = -answer.distance;
                                 })),
            (Numbers{23, 33, 34}));
}

// A question from another thread is a second question.
TEST(AnswerLaws, CatchAnAnswerThatChanges) {
  int calls = 0;
  EXPECT_EQ(laws_broken_by(plant("decide",
                                 [&](const Pair&, MethodAnswer& answer) {
                                   if (++calls % 3 == 0) answer.witness = CertificateKind::none;
                                 })),
            (Numbers{35, 36}));
}

TEST(AnswerLaws, CatchACrashTheSecondTime) {
  int calls = 0;
  EXPECT_EQ(laws_broken_by(plant("decide",
                                 [&](const Pair&, MethodAnswer& answer) {
                                   if (++calls % 3 != 0) return;
                                   answer.status = Status::failed;
                                   answer.failure = Failure::crash;
                                 })),
            (Numbers{30, 35, 36}));
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

TEST(AnswerLaws, CatchMoreStepsThanAllowed) {
  EXPECT_EQ(laws_broken_by(plant(
                "decide", [](const Pair&, MethodAnswer& answer) { answer.steps = answer.step_cap + 1; })),
            Numbers{38});
}

TEST(AnswerLaws, CatchWhoIsUndecidedWithoutNeed) {
  EXPECT_EQ(laws_broken_by(plant(
                "decide",
                [](const Pair& pair, MethodAnswer& answer) {
                  if (pair.a.radius < 2 * pair.b.radius) return;
                  answer = {};
                  answer.status = Status::answered;
                },
                of_everything)),
            (Numbers{1, 39, 41}));
}

TEST(AnswerLaws, CatchWhoTakesABadSolid) {
  EXPECT_EQ(laws_broken_by(plant(
                "decide",
                [](const Pair& pair, MethodAnswer& answer) {
                  if (pair.b.radius < 0) answer.verdict = Verdict::disjoint;
                },
                of_everything)),
            Numbers{41});
}

TEST(AnswerLaws, CatchADirectionTheWrongWay) {
  EXPECT_EQ(laws_broken_by(plant(
                "decide",
                [](const Pair&, MethodAnswer& answer) {
                  if (answer.witness == CertificateKind::direction)
                    for (double& x : answer.head) x = -x;
                },
                of_everything)),
            Numbers{40});
}

// The border is a gap or a common ball of 1e-13 of the size. A coin has room for a disk, and a needle for a
// segment. The law does not apply to two flat solids, or to a solid that is thinner than the ball and not
// flat.
TEST(AnswerLaws, CatchWhoIsUndecidedWhereThereIsRoom) {
  Planted method = plant(
      "decide",
      [](const Pair&, MethodAnswer& answer) {
        answer = {};
        answer.status = Status::answered;
      },
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

// Three other laws see it too. The enclosure disagrees, a solid moved on along the direction is nearer than
// that proves, and the distance jumps from a gap to none.
TEST(AnswerLaws, CatchADistanceBelowWhatADirectionProves) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   if (answer.distance > 0) answer.distance -= 1e-9 * size_of(pair);
                                 })),
            (Numbers{13, 22, 33, 42}));
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
