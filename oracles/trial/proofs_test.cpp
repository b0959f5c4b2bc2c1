// SPDX-License-Identifier: MIT
// Checks every certificate of many pairs again in wide and rational arithmetic. Compares every verdict with
// the verdicts of the methods that carry proofs. A daily run has few pairs.
// DAYLIGHT_PROOF_PAIRS=10000000 DAYLIGHT_SEED=n makes a long run.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

Pair upright_pair(double apart) {
  return {{Vector3(0, 0, 0), Vector3(0, 0, 1), 1, 2}, {Vector3(apart, 0, 0), Vector3(0, 0, 1), 1, 2}};
}

TEST(Proofs, OffersWitnessesOfItsOwnPairAlone) {
  const Pair own = upright_pair(3), other = upright_pair(4);
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = Verdict::disjoint;
  answer.set_direction(Vector3(1, 0, 0));
  Proofs proofs(own, {&answer, 1});
  EXPECT_TRUE(proofs.of(own).truth.witnessed);
  EXPECT_FALSE(proofs.of(other).truth.witnessed);
}

TEST(Proofs, ReachAClaimOrNot) {
  const Pair pair = upright_pair(3);  // a gap of 1, size 6
  Proofs proofs(pair, {});
  EXPECT_TRUE(beyond_claim(proofs.of(pair), {.relative = 1e-13, .source = "the test"}));
  EXPECT_TRUE(beyond_claim(proofs.of(pair), {.absolute = 0.99, .source = "the test"}));
  EXPECT_FALSE(beyond_claim(proofs.of(pair), {.relative = 0.5, .source = "the test"}));
}

}  // namespace
}  // namespace cyl
