// SPDX-License-Identifier: MIT
// Each exact law catches a method with a fault that no other exact law can see.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "oracles/referee/referee.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

/// Keeps every exact law. It takes each solid for a cube around its centre.
MethodAnswer cubes(const Pair& pair) {
  const Vector3 delta = pair.b.center - pair.a.center;
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = Verdict::intersecting;
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(delta[i]) <= pair.a.radius + pair.b.radius) continue;
    answer.verdict = Verdict::disjoint;
    answer.witness = CertificateKind::direction;
    answer.head[i] = delta[i] > 0 ? 1 : -1;
  }
  return answer;
}

/// Returns the broken exact laws. Cubes are not cylinders, so other laws are broken too.
Numbers exact_laws_broken_by(const Planted::Ask& ask, const Claim& claim = of_everything) {
  Numbers numbers = laws_broken_by(Planted(ask, "planted", claim));
  std::erase_if(numbers, [](int number) { return number >= 10; });
  return numbers;
}

TEST(ExactLaws, AreKeptByAMethodThatKeepsThem) { EXPECT_EQ(exact_laws_broken_by(cubes), Numbers{}); }

TEST(ExactLaws, CatchAVerdictThatFavoursOneRoleWhereOnlyVerdictsMustAgree) {
  const auto favours = [](const Pair& pair) {
    MethodAnswer answer = cubes(pair);
    if (pair.a.radius < pair.b.radius) answer.verdict = Verdict::undecided;
    answer.head[0] = pair.a.axis.x();
    return answer;
  };
  EXPECT_EQ(exact_laws_broken_by(favours, of_verdicts), Numbers{1});
}

TEST(ExactLaws, CatchADirectionThatAlwaysPointsUp) {
  EXPECT_EQ(exact_laws_broken_by([](const Pair& pair) {
              MethodAnswer answer = cubes(pair);
              for (double& x : answer.head) x = std::fabs(x);
              return answer;
            }),
            Numbers{1});
}

TEST(ExactLaws, CatchAnAbsoluteTolerance) {
  EXPECT_EQ(exact_laws_broken_by([](const Pair& pair) {
              MethodAnswer answer = cubes(pair);
              if ((pair.b.center - pair.a.center).lpNorm<Eigen::Infinity>() < 1e-6)
                answer.verdict = Verdict::undecided;
              return answer;
            }),
            Numbers{2});
}

TEST(ExactLaws, CatchAnAnswerThatLooksAtTheSenseOfAnAxis) {
  EXPECT_EQ(exact_laws_broken_by([](const Pair& pair) {
              MethodAnswer answer = cubes(pair);
              if (pair.a.axis.dot(pair.b.axis) < 0) answer.verdict = Verdict::undecided;
              return answer;
            }),
            Numbers{3});
}

// At the first scale that is asked, the solids are below an absolute claim. At the last scale they are not.
TEST(ExactLaws, FindABreakBeyondTheClaimBehindOneWithinIt) {
  const auto turns = [](const Pair& pair) {
    MethodAnswer answer = ask_ours("intersect", pair);
    const double size = size_of(pair);
    if (size < 1e-50 || size > 1e50) answer.verdict = Verdict::disjoint;
    return answer;
  };
  Planted method(turns, "planted", {0, 1e-6, "planted"});
  const Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{1, 0, 0}, {0, 1, 0}, 1, 2}};
  const auto violation = violation_of(method, law_numbered(2), pair);
  ASSERT_TRUE(violation);
  EXPECT_EQ(violation->severity, Severity::contract) << violation->what;
}

}  // namespace
}  // namespace cyl
