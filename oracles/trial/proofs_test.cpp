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

bool holds(const Pair& pair, const Truth& truth) {
  if (truth.verdict == Verdict::undecided) return true;
  const Rational3 v = exact(truth.certificate.vector);
  if (truth.verdict == Verdict::disjoint)
    return separates_in_multiprecision(pair, v, 256) || separates_in_multiprecision(pair, v, 4096);
  return truth.certificate.kind == CertificateKind::near || in_both_exact(pair, v);
}

bool meets(Verdict v) { return v == Verdict::intersecting || v == Verdict::touching; }

struct Tally {
  std::uint64_t pairs = 0, failed_proofs = 0, contradictions = 0, undecided = 0, stages[3] = {0, 0, 0};
};

void run(const Family& family, std::uint64_t seed, std::uint64_t count, Tally& tally) {
  for (std::uint64_t i = 0; i < count; ++i) {
    const Pair pair = family.generate(seed, i);
    const Truth truth = judge(pair);
    ++tally.pairs;
    ++tally.stages[static_cast<int>(truth.stage)];
    tally.undecided += truth.verdict == Verdict::undecided;
    if (!holds(pair, truth)) {
      ++tally.failed_proofs;
      ADD_FAILURE() << "proof fails: " << format_pair(pair) << " " << format_truth(truth);
    }
    const Answer decided = decide(pair.a, pair.b);
    const Truth exact = decide_exactly(pair.a, pair.b);
    for (const Verdict said : {decided.verdict, exact.verdict})
      if (said != Verdict::undecided && truth.verdict != Verdict::undecided &&
          meets(said) != meets(truth.verdict)) {
        ++tally.contradictions;
        ADD_FAILURE() << "contradiction: " << format_pair(pair) << " " << format_truth(truth);
      }
  }
}

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

TEST(Proofs, HoldInRationalsAndContradictNobody) {
  const std::uint64_t seed = from_environment("DAYLIGHT_SEED", 20261121);
  const std::uint64_t many = from_environment("DAYLIGHT_PROOF_PAIRS", 20000);
  std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
  Tally random, touching;
  run(*find_family("random"), seed, many, random);
  int contacts = 0;
  for (const Family& family : families()) contacts += family.name.starts_with("touching_");
  for (const Family& family : families())
    if (family.name.starts_with("touching_"))
      run(family, seed, many / 10 / static_cast<std::uint64_t>(contacts) + 1, touching);
  for (const auto& [name, t] : {std::pair<const char*, Tally>{"random", random}, {"near touching", touching}})
    std::printf(
        "%s: %llu pairs, %llu proofs fail, %llu contradictions, %llu undecided; decided by the filter %llu, "
        "MPFI %llu, rationals %llu\n",
        name, static_cast<unsigned long long>(t.pairs), static_cast<unsigned long long>(t.failed_proofs),
        static_cast<unsigned long long>(t.contradictions), static_cast<unsigned long long>(t.undecided),
        static_cast<unsigned long long>(t.stages[0]), static_cast<unsigned long long>(t.stages[1]),
        static_cast<unsigned long long>(t.stages[2]));
  EXPECT_GT(touching.stages[1], 0u);
  EXPECT_GT(touching.stages[2], 0u);
}

}  // namespace
}  // namespace cyl
