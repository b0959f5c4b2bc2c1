// SPDX-License-Identifier: MIT
#include "oracles/referee/referee.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/proof_check_test.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

MethodAnswer witness_of(const Answer& answer, const Pair& pair) {
  MethodAnswer witness;
  witness.status = Status::answered;
  witness.verdict = answer.verdict;
  witness.set_witness(certificate_of(answer, pair.a, pair.b));
  return witness;
}

// DAYLIGHT_PROOF_PAIRS=100000 DAYLIGHT_SEED=n makes a long run.
TEST(Referee, ProvesEveryFamily) {
  const std::uint64_t seed = from_environment("DAYLIGHT_SEED", 20261121);
  const std::uint64_t many = from_environment("DAYLIGHT_PROOF_PAIRS", 60);
  std::map<Verdict, int> seen;
  std::map<Stage, int> stages;
  int in_hulls = 0, beyond_algebra = 0;  // of verdicts that 512 bits and more would show too
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < (family.name == "lattice" ? 10 * many : many); ++i) {
      const Pair pair = family.generate(seed, i);
      Truth truth = prove_in_double(pair);
      if (truth.verdict == Verdict::undecided) truth = prove_exactly(pair, {}, 512);
      const std::string what = std::string(family.name) + " " + std::to_string(i) + " " + format_pair(pair);
      EXPECT_TRUE(truth.verdict == Verdict::undecided || is_proof(pair, truth)) << what;
      const Truth alone = judge_verdict(pair);
      if (truth.verdict != Verdict::undecided) {
        EXPECT_EQ(alone.verdict, truth.verdict) << what;
      }
      if (family.name == "whiskers") beyond_algebra += alone.bits > 128;
      ++seen[truth.verdict];
      ++stages[truth.stage];
      // Our solver reports the verdicts that it is sure of. The referee does not know them.
      const Answer said = decide(pair.a, pair.b);
      if (said.verdict != Verdict::undecided && truth.verdict != Verdict::undecided) {
        EXPECT_EQ(said.verdict == Verdict::disjoint, truth.verdict == Verdict::disjoint) << what;
      }
      if (said.proof != Proof::none) {
        EXPECT_EQ(check_witness(pair, witness_of(said, pair)), said.verdict) << what;
        in_hulls += said.hull_a != Hull::space || said.hull_b != Hull::space;
      }
      if (truth.stage != Stage::filter) {
        EXPECT_EQ(decide_exactly(pair.a, pair.b).verdict, alone.verdict) << what;
      }
      // An undecided pair cannot be separated from touching.
      if (truth.verdict == Verdict::undecided) {
        const Enclosure e = enclose_distance(pair, truth);
        EXPECT_LE(e.lo, 1e-13 * size_of(pair)) << what;
        EXPECT_GE(e.hi, -1e-13 * size_of(pair)) << what;
      }
    }
  EXPECT_GT(seen[Verdict::disjoint], 300);
  EXPECT_GT(seen[Verdict::intersecting], 300);
  EXPECT_GT(seen[Verdict::touching], 10);
  for (const Stage s : {Stage::filter, Stage::multiprecision, Stage::exact})
    EXPECT_GT(stages[s], 10) << static_cast<int>(s);
  EXPECT_GT(in_hulls, 30);
  EXPECT_EQ(beyond_algebra, 0);
}

TEST(Referee, AgreesWithOurSolverOnEveryCase) {
  int decided = 0;
  for (const Case& c : read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases")) {
    const Truth truth = judge(c.pair);
    EXPECT_EQ(truth.verdict, *c.truth) << c.id;
    EXPECT_EQ(judge_verdict(c.pair).verdict, *c.truth) << c.id;
    EXPECT_TRUE(truth.verdict >= Verdict::undecided || is_proof(c.pair, truth)) << c.id;
    const Verdict said = decide(c.pair.a, c.pair.b).verdict;
    if (said == Verdict::undecided || said == Verdict::invalid) continue;  // it takes cylinders alone
    ++decided;
    EXPECT_EQ(said == Verdict::disjoint, truth.verdict == Verdict::disjoint) << c.id;
    EXPECT_EQ(said, intersect(c.pair.a, c.pair.b)) << c.id;
  }
  EXPECT_GT(decided, 100);
}

TEST(Referee, RightAtMarginsFarBelowDoubles) {
  // A wall of radius 3 touches the origin in the plane with normal (2, 2, 1). The other solid comes near it
  // from the other side, moved by t (2, 2, 1). That is a gap of exactly 3 t, or a depth of 3 |t| (the wall's
  // own depth for a segment or a disk).
  const Vector3 normal(2, 2, 1);
  const Solid wall{-normal, Vector3(1, 0, -2), 3, 8};
  const Solid cap{-normal, normal, 5, 6};
  const Solid guests[] = {{Vector3(0, 0, 0), Vector3(1, -1, 0), 0, 2},  // segment
                          {Vector3(0, 0, 0), normal, 0.5, 0},           // disk
                          {Vector3(0, 0, 0), Vector3(1, 1, 1), 0, 0}};  // point
  for (const Solid& host : {wall, cap})
    for (const Solid& guest : guests)
      for (const int exponent : {-47, -66, -100, -133, -400}) {
        for (const double side : {1.0, -1.0}) {
          Pair pair{host, guest};
          pair.b.center = std::ldexp(side, exponent) * normal;
          const Truth truth = judge(pair);
          EXPECT_EQ(truth.verdict, side > 0 ? Verdict::disjoint : Verdict::intersecting) << format_pair(pair);
          EXPECT_EQ(judge_verdict(pair).verdict, truth.verdict) << format_pair(pair);
          EXPECT_TRUE(is_proof(pair, truth)) << format_pair(pair);
          const Enclosure e = enclose_distance(pair, truth, 1e-6);
          const double known = side * std::ldexp(3.0, exponent);
          EXPECT_LE(e.lo, known) << format_pair(pair);
          EXPECT_GE(e.hi, known) << format_pair(pair);
        }
      }
  // Two fat walls can only be separated as finely as the doubles of their centres allow.
  for (const double side : {1.0, -1.0}) {
    Pair pair{wall, wall};
    pair.b.axis = Vector3(1, -1, 0);
    pair.b.center = normal * (1 + side * 0x1p-51);
    EXPECT_EQ(judge(pair).verdict, side > 0 ? Verdict::disjoint : Verdict::intersecting);
  }
}

TEST(Referee, ContactWhoseMiddleIsIrrationalIsShownByAPointNearBy) {
  // A wall along (1, 4, 1) lies on a cap. The point of the contact nearest to the cap's middle is the wall's
  // end, whose coordinates are irrational.
  const Pair pair = {{{0, 0, 0}, {2, -1, 2}, 3, 6}, {{5, 2, 5}, {1, 4, 1}, 3, 8}};
  const Truth truth = judge(pair);
  ASSERT_EQ(truth.verdict, Verdict::touching);
  ASSERT_EQ(truth.certificate.kind, CertificateKind::near);
  EXPECT_TRUE(is_proof(pair, truth));
}

// The search in double offers directions that are not finite, or none.
TEST(Judge, OfExtremeNumbersIsNoFault) {
  const std::pair<const char*, Verdict> all[] = {
      {R"({"a":{"center":[0,7,1e-309],"axis":[1,0,0],"radius":5,"height":30},)"
       R"("b":{"center":[0,0,0],"axis":[0,0,1],"radius":2,"height":0}})",
       Verdict::disjoint},
      {R"({"a":{"center":[0,7,1e-309],"axis":[1,0,0],"radius":5,"height":30},)"
       R"("b":{"center":[0,0,0],"axis":[0,0,1],"radius":2,"height":0,"rounding":0.5}})",
       Verdict::intersecting},
      {R"({"a":{"center":[0,1.797e308,0],"axis":[1,0,0],"radius":1.797e308,"height":1},)"
       R"("b":{"center":[0,0,0],"axis":[0,0,1],"radius":0,"height":1e308}})",
       Verdict::touching},
      {R"({"a":{"center":[-1.797e308,7,1e-309],"axis":[1,0,0],"radius":5,"height":30},)"
       R"("b":{"center":[1.797e308,0,0],"axis":[0,0,1],"radius":1.797e308,"height":0,"rounding":1}})",
       Verdict::disjoint}};
  for (const auto& [text, verdict] : all) {
    const Pair pair = parse_case(text, 1).value.value().pair;
    const Truth truth = judge_verdict(pair);
    EXPECT_EQ(truth.verdict, verdict) << text;
    EXPECT_EQ(judge(pair).verdict, verdict) << text;
    const Enclosure e = enclose_distance(pair, truth);
    EXPECT_LE(e.lo, e.hi) << text;
  }
}

// Unit disks' prisms, one above the other, apart by 2^-70: each stage knows more than the one before.
TEST(Judge, IsACascadeOfStages) {
  const Solid lower{{0, 0, -0x1p-70}, {0, 0, 1}, 1, 2};
  const auto above = [&](const Vector3& center) { return Pair{lower, {center, {0, 0, 1}, 1, 2}}; };
  const Pair apart = above({0, 0, 2.5}), close = above({0, 0, 2});
  EXPECT_EQ(prove_in_double(apart).verdict, Verdict::disjoint);
  EXPECT_EQ(prove_in_double(close).verdict, Verdict::undecided);
  EXPECT_EQ(prove_exactly(close, {}, 128).verdict, Verdict::disjoint);
  EXPECT_EQ(judge_verdict(close).bits, twin_bits);
  const Pair deep = above({0, 0, 2 - 0x1p-51});
  EXPECT_EQ(prove_in_double(deep).verdict, Verdict::undecided);
  EXPECT_EQ(judge(deep).verdict, Verdict::intersecting);
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = Verdict::disjoint;
  answer.set_direction({0, 0, 1});
  EXPECT_EQ(prove_in_double(close, {&answer, 1}).verdict, Verdict::undecided);
  EXPECT_FALSE(prove_exactly(close).witnessed);
  EXPECT_TRUE(prove_exactly(close, {&answer, 1}).witnessed);
}

}  // namespace
}  // namespace cyl
