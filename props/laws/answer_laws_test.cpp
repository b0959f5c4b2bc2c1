// SPDX-License-Identifier: MIT
// Each law of one answer catches a method with a fault planted, and what else catches it has a reason.
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

// The distance is wrong, as well, and a gap where there is none no triangle knows.
TEST(AnswerLaws, CatchADistanceOfTheOtherSign) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair&, MethodAnswer& answer) {
                                   if (answer.distance < 0) answer.distance = -answer.distance;
                                 })),
            (Numbers{23, 33, 34}));
}

// To ask from another thread is to ask again.
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

// Half a picometre on a metre: only what is said of parallel axes is so fine.
TEST(AnswerLaws, CatchWhoIsUndecidedBesideAParallelWall) {
  const auto upright = [](double x) { return Cylinder{Vector3(x, 0, 0), Vector3(0, 0, 1), 1, 2}; };
  Planted method = plant(
      "decide",
      [](const Pair&, MethodAnswer& answer) {
        answer = {};
        answer.status = Status::answered;
      },
      of_everything);
  EXPECT_TRUE(broken_by(method, law_numbered(39), {upright(0), upright(2 + 5e-13)}));
  Pair askew{upright(0), upright(2 + 5e-13)};
  askew.b.axis.x() = 1e-13;
  EXPECT_FALSE(broken_by(method, law_numbered(39), askew));
}

}  // namespace
}  // namespace cyl
