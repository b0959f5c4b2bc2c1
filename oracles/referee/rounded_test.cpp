// SPDX-License-Identifier: MIT
#include "oracles/referee/rounded.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

Pair pair_from(const std::string& a, const std::string& b) {
  return parse_case("{\"a\":{" + a + "},\"b\":{" + b + "}}", 1).value.value().pair;
}

// Two pairs touch at rational points, and one at irrational ones. Any point of both cores is enough.
TEST(RefereeOfRounded, CoresThatTouchMeetHoweverSmallTheRounding) {
  const char* const touching[][2] = {{R"("center":[12,4,3],"axis":[-25,48,36],"radius":13,"height":0)",
                                      R"("center":[-3,0,1],"axis":[0,0,1],"radius":3,"height":8)"},
                                     {R"("center":[0,0,0],"axis":[0,0,1],"radius":1,"height":4)",
                                      R"("center":[5,-3,0],"axis":[3,4,0],"radius":5,"height":0)"},
                                     {R"("center":[0,0,0],"axis":[1,1,0],"radius":1,"height":6)",
                                      R"("center":[0,0,2],"axis":[1,-1,0],"radius":1,"height":4)"}};
  for (const auto& [a, b] : touching) {
    EXPECT_EQ(judge(pair_from(a, b)).verdict, Verdict::touching) << a;
    for (const char* rounding : {"1e-300", "1e-200", "1e-30", "5e-324"}) {
      const Pair pair = pair_from(a, std::string(b) + ",\"rounding\":" + rounding);
      const Truth truth = judge(pair);
      EXPECT_EQ(truth.verdict, Verdict::intersecting) << a << rounding;
      EXPECT_EQ(truth.bits, 128) << a << rounding;
    }
  }
}

// The overlap is half the size deep. Each core has a part that no double of the point resolves.
TEST(RefereeOfRounded, CoresWithATinyPartAreNoHarderThanFlatOnes) {
  for (const char* height : {"1e-154", "5e-324", "1e-60", "1e-17", "0"}) {
    const Truth truth = judge(pair_from(
        std::string(R"("center":[-1.0783926993080015,1,3],"axis":[-2,0.025874133134828003,-2],"radius":1,)"
                    R"("rounding":4.173455697349122,"height":)") +
            height,
        std::string(
            R"("center":[-2.3386298142220014,2,1.7340593800649353],"axis":[2,-0.25164527112050017,2],)"
            R"("radius":0.293479715029382,"rounding":0.1169080273822276,"height":)") +
            height));
    EXPECT_EQ(truth.verdict, Verdict::intersecting) << height;
    EXPECT_LE(truth.bits, 128) << height;
  }
}

// The nearest points are at a corner of the area that one face hides of the other.
TEST(RefereeOfRounded, FacesAtATinyAngleAreReported) {
  const std::pair<const char*, const char*> faces[] = {
      {R"("center":[0,0,0],"axis":[-0.3919077812736112,0.90993462739085651,0.13574706203914061],
          "radius":1.9710960281861707,"height":1.8650528874609782,"rounding":0.29999999999999999)",
       R"("center":[-1.4424609547597274,-3.9554105221322033,-0.058624562499192998],
          "axis":[-0.39190822269765518,0.90993435730578465,0.1357475980525216],
          "radius":1.5587898099174935,"height":1.6185677436838586,"rounding":1)"},
      {R"("center":[0,0,0],"axis":[0,0,-1],
          "radius":0.59966418261768639,"height":1.8512604394490242,"rounding":0.039929094685480448)",
       R"("center":[1.7107191655477878,-1.3487541138819197,-1.4886753379161906],
          "axis":[-4.0068457457414986e-08,-2.3428479377716995e-08,-1],
          "radius":1.5788013684849296,"height":1.0462319932926591)"},
      {R"("center":[0,0,0],"axis":[-2,1,0],
          "radius":1.966856381965179,"height":1.6547690797032126,"rounding":0.17859033639117317)",
       R"("center":[-2.0235867631328599,-1.6049178958974919,-2.3258883372353858],
          "axis":[-0.89442719414628047,0.4472135892072287,3.7081381958283481e-09],
          "radius":1.3329453862382308,"height":0.17247009631001908)"}};
  for (const auto& [a, b] : faces) {
    const Pair pair = pair_from(a, b);
    EXPECT_EQ(judge(pair).verdict, distance(pair.a, pair.b).verdict) << format_pair(pair);
  }
}

// A rim or a small coin lies over a face, parallel but for rounding. A segment crosses the rim of a face, at
// rational points. The search for the nearest points does not depend on the unit either.
TEST(RefereeOfRounded, FacesParallelButForRoundingAreProvedInFewBits) {
  struct Stated {
    const char *a, *b;
    Verdict verdict;
    CertificateKind kind;
  };
  const Stated all[] = {
      {R"("center":[-81.084618159597653,-56.245092624110562,15.737273997194123],
          "axis":[0.43643578047197901,0.87287156094397012,0.21821789023600183],
          "radius":61.312614230114775,"height":139.9148533899683,"rounding":7.6508029855704562e-11)",
       R"("center":[-72.129898760782154,29.091661845631027,-21.882451103528961],"axis":[2,4,1],
          "radius":0.74858938322850188,"height":0.45892458329740393,"rounding":1.7775608965778503e-10)",
       Verdict::disjoint, CertificateKind::direction},
      {R"("center":[0,0,0],"axis":[-0.21521349823009212,-0.83217654629054283,-0.51104338953117279],
          "radius":1,"height":1,"rounding":1.6782674260904012e-07)",
       R"("center":[1.2877128580426385,0.42182219181239416,-0.16225573090849105],
          "axis":[0.21521349823009214,0.83217654629054294,0.5110433895311729],
          "radius":0.25107002805319245,"height":0.090487674210591174)",
       Verdict::disjoint, CertificateKind::direction},
      {R"("center":[0,0,0],"axis":[0.58380619991245597,0.5068632195656787,-0.63423970042507749],
          "radius":1,"height":0.00061552625801199667,"rounding":3.534007195982616e-13)",
       R"("center":[0.70234979324712665,-0.70736967744881418,0.080674374085807896],
          "axis":[0.58380620021921847,0.50686321947183888,-0.63423970042770182],
          "radius":8.7665697125901285e-05,"height":4.3675376877115376e-05,"rounding":1.2726025135420318e-13)",
       Verdict::intersecting, CertificateKind::points},
      {R"("center":[-7,5.5,-11],"axis":[2,-2,1],"radius":6,"height":9)",
       R"("center":[0,0,0],"axis":[2,1,-2],"radius":6,"height":12,"rounding":1.5)", Verdict::touching,
       CertificateKind::points}};
  for (const Stated& stated : all)
    for (const int exponent : {0, -80, 80}) {
      const auto pair = scaled_exactly(pair_from(stated.a, stated.b), exponent);
      ASSERT_TRUE(pair);
      const Truth truth = judge(*pair);
      EXPECT_EQ(truth.verdict, stated.verdict) << stated.a << exponent;
      EXPECT_EQ(truth.certificate.kind, stated.kind) << stated.a << exponent;
      EXPECT_LE(truth.bits, 256) << stated.a << exponent;
      EXPECT_EQ(judge_verdict(*pair).verdict, stated.verdict) << stated.a << exponent;
    }
}

class RefereeOfFamilies : public testing::TestWithParam<std::size_t> {};

TEST_P(RefereeOfFamilies, EveryPairIsJudgedAndEveryAnswerOfOursHolds) {
  const Family& family = rounded_families()[GetParam()];
  constexpr std::uint64_t count = 1500, seed = 20261123;
  std::size_t undecided = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Pair pair = family.generate(seed, i);
    const Truth truth = judge(pair);
    ASSERT_NE(truth.verdict, Verdict::undecided) << format_pair(pair);
    ASSERT_EQ(judge_verdict(pair).verdict, truth.verdict) << format_pair(pair);
    if (i < 200) {
      const Enclosure e = enclose_distance(pair, truth);
      const Distance d = distance(pair.a, pair.b);
      const double size = size_of(pair) + (pair.b.center - pair.a.center).norm();
      ASSERT_LE(e.lo, e.hi) << format_pair(pair);
      ASSERT_GE(d.value > 0 ? d.value + d.error - e.lo : 0, 0) << format_pair(pair);
      ASSERT_LE(d.value - d.error, e.hi) << format_pair(pair);
      ASSERT_LE(truth.verdict == Verdict::disjoint ? e.hi - e.lo : 0, 4 * gap_width_tol * size)
          << format_pair(pair);
    }
    const Verdict yes_or_no = truth.verdict == Verdict::touching ? Verdict::intersecting : truth.verdict;
    const Answer said = decide(pair.a, pair.b);
    if (said.verdict == Verdict::undecided) {
      ++undecided;
      const Enclosure off = enclose_distance(pair, truth);
      ASSERT_LT(std::min(std::fabs(off.lo), std::fabs(off.hi)), 1e-13 * size_of(pair)) << format_pair(pair);
      continue;
    }
    ASSERT_EQ(said.verdict, yes_or_no) << format_pair(pair);
    MethodAnswer witness;
    witness.status = Status::answered;
    witness.verdict = said.verdict;
    witness.set_witness(certificate_of(said, pair.a, pair.b));
    ASSERT_EQ(check_witness(pair, witness), said.verdict) << format_pair(pair);
    // It proves nothing of other solids.
    if (said.proof != Proof::points) continue;
    Pair other = pair;
    other.b.center += Vector3(0, 0, 4 * size_of(pair) + std::numeric_limits<double>::min());
    ASSERT_EQ(check_witness(other, witness), Verdict::undecided) << format_pair(other);
  }
  EXPECT_LT(undecided, count / 10);
}

TEST(RefereeOfRounded, SmallIntegersTouchAndAreProvedTo) {
  std::size_t touching = 0;
  for (const Family& family : rounded_families())
    for (std::uint64_t i = 3; i < 4000; i += 8)
      touching += judge(family.generate(20261123, i)).verdict == Verdict::touching;
  EXPECT_GT(touching, 20u);
}

INSTANTIATE_TEST_SUITE_P(Each, RefereeOfFamilies, testing::Range<std::size_t>(0, rounded_families().size()),
                         [](const auto& info) { return std::string(rounded_families()[info.param].name); });

}  // namespace
}  // namespace cyl
