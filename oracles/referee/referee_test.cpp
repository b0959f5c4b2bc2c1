// SPDX-License-Identifier: MIT
#include "oracles/referee/referee.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/decide_exactly.hpp"
#include "oracles/referee/root_sum.hpp"
#include "oracles/referee/tangency.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

// Every certificate of any stage is checked again, in the widest arithmetic.
void expect_proved(const Pair& pair, const Truth& truth, const std::string& what) {
  const Certificate& c = truth.certificate;
  switch (truth.verdict) {
    case Verdict::disjoint:
      EXPECT_TRUE(separates_in_multiprecision(pair, exact(c.vector), 2048)) << what;
      break;
    case Verdict::intersecting:
      if (c.kind == CertificateKind::points) {
        const Rational3 x = exact(c.vector), y = exact(c.second), between = y - x;
        const mpq_class contact_distance = contact_distance_of(pair);
        EXPECT_TRUE(in_each_exact(pair, x, y) && dot(between, between) <= contact_distance * contact_distance)
            << what;
      } else {
        EXPECT_TRUE(in_both_exact(pair, exact(c.vector))) << what;
      }
      break;
    case Verdict::touching:
      if (c.kind == CertificateKind::point) {
        EXPECT_TRUE(in_both_exact(pair, exact(c.vector))) << what;
      }
      break;
    default:
      break;
  }
}

TEST(Referee, ProvesEveryFamily) {
  std::map<Verdict, int> seen;
  std::map<Stage, int> stages;
  int beyond_algebra = 0;  // of verdicts that 512 bits and more would show too
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < (family.name == "lattice" ? 600 : 60); ++i) {
      const Pair pair = family.generate(20261121, i);
      Truth truth = prove_in_double(pair);
      if (truth.verdict == Verdict::undecided) truth = prove_exactly(pair, {}, 512);
      const std::string what = std::string(family.name) + " " + std::to_string(i) + " " + format_pair(pair);
      expect_proved(pair, truth, what);
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
  EXPECT_EQ(beyond_algebra, 0);
}

TEST(Referee, SaysTouchingWhereAlgebraShowsIt) {
  const Pair touching[] = {
      // caps, then walls, parallel and crossing, then a cap and a wall, segments, points, a rim point, rims
      {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{0, 0, 2}, {0, 0, 1}, 1, 2}},
      {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2, 0, 0}, {0, 0, 1}, 1, 2}},
      {{{0, 0, 0}, {1, 1, 0}, 1, 2}, {{0, 0, 2}, {1, -1, 0}, 1, 2}},
      {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{0, 0, 2}, {1, 0, 0}, 1, 2}},
      {{{0, 0, 0}, {0, 0, 1}, 0, 2}, {{0, 0, 0}, {1, 0, 0}, 0, 2}},
      {{{1, 2, 3}, {1, 2, 3}, 0, 0}, {{1, 2, 3}, {1, 0, 0}, 0, 0}},
      {{{0, 0, 0}, {0, 0, 1}, 5, 2}, {{3, 4, 1}, {1, 0, 1}, 0, 0}},
      {{{0, 0, 0}, {0, 0, 1}, 5, 2}, {{6, 8, 2}, {0, 0, 1}, 5, 2}},
      // one segment along another; a disk on itself
      {{{0, 0, 0}, {1, 1, 1}, 0, 2}, {{0, 0, 0}, {1, 1, 1}, 0, 4}},
      {{{0, 0, 0}, {0, 0, 1}, 2, 0}, {{0, 0, 0}, {0, 0, 1}, 2, 0}}};
  for (const Pair& pair : touching) {
    const Truth truth = judge(pair);
    EXPECT_EQ(truth.verdict, Verdict::touching) << format_pair(pair);
    expect_proved(pair, truth, format_pair(pair));
    EXPECT_EQ(decide_exactly(pair.a, pair.b).verdict, Verdict::touching) << format_pair(pair);
    EXPECT_EQ(judge_verdict(pair).verdict, Verdict::touching) << format_pair(pair);
    // A witness that is the very point of contact shows that they meet, and no more.
    if (truth.certificate.kind != CertificateKind::point) continue;
    MethodAnswer witness;
    witness.status = Status::answered;
    witness.witness = CertificateKind::point;
    std::copy_n(truth.certificate.vector.head.begin(), 3, witness.head);
    std::copy_n(truth.certificate.vector.tail.begin(), 3, witness.tail);
    EXPECT_EQ(check_witness(pair, witness), Verdict::intersecting) << format_pair(pair);
    EXPECT_EQ(judge(pair, {&witness, 1}).verdict, Verdict::touching) << format_pair(pair);
  }
}

TEST(Referee, AgreesWithOurSolverOnEveryCase) {
  int decided = 0;
  for (const Case& c : read_case_folder(DAYLIGHT_SOURCE_DIR "/corpus/cases")) {
    const Truth truth = judge(c.pair);
    EXPECT_EQ(truth.verdict, *c.truth) << c.id;
    EXPECT_EQ(judge_verdict(c.pair).verdict, *c.truth) << c.id;
    expect_proved(c.pair, truth, c.id);
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
          expect_proved(pair, truth, format_pair(pair));
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
  // The point is inside both solids once they have grown by 2^-200 of the size. The plane separates them
  // once they have shrunk by it.
  const mpq_class slack = mpq_class(20) / (mpz_class(1) << 200);
  const Rational3 x = exact(truth.certificate.vector);
  for (const Solid* c : {&pair.a, &pair.b}) {
    const Rational3 r = x - exact(c->center), w = exact(c->axis), side = cross(r, w);
    const mpq_class ww = dot(w, w), half = mpq_class(c->height) / 2 + slack,
                    radius = mpq_class(c->radius) + slack;
    EXPECT_LE(dot(r, w) * dot(r, w), half * half * ww);
    EXPECT_LE(dot(side, side), radius * radius * ww);
  }
}

TEST(Referee, WitnessesCarryTheDayOrAreIgnored) {
  const Pair apart = {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2.5, 0, 0}, {0, 0, 1}, 1, 2}};
  MethodAnswer good, bad;
  good.status = bad.status = Status::answered;
  good.witness = bad.witness = CertificateKind::direction;
  good.head[0] = 1;
  bad.head[2] = 1;
  EXPECT_EQ(check_witness(apart, good), Verdict::disjoint);
  EXPECT_EQ(check_witness(apart, bad), Verdict::undecided);
  EXPECT_TRUE(judge(apart, {&good, 1}).witnessed);
  const Truth alone = judge(apart, {&bad, 1});
  EXPECT_FALSE(alone.witnessed);
  EXPECT_EQ(alone.verdict, Verdict::disjoint);
  MethodAnswer point = good;
  point.witness = CertificateKind::point;
  point.head[0] = 1.25;
  EXPECT_EQ(check_witness(apart, point), Verdict::undecided);
  point.head[0] = std::nan("");
  EXPECT_EQ(check_witness(apart, point), Verdict::undecided);
}

// A disk of radius 2 about (c, 0, 0) has its axis across x. A flat or thick solid is at the origin. We know
// on paper if they share more than a point of the border. The guess is off by far more than rounding.
template <class R>
void expect_overlaps(const char* what) {
  struct Known {
    Solid solid;
    double disk_at;
    bool overlap;
  };
  const Vector3 none(0, 0, 0), x(1, 0, 0), y(0, 3, 0), z(0, 0, 1);
  constexpr double gone = 1 + 0x1p-40, inside = 1 - 0x1p-5;
  const Known all[] = {{{none, z, 1, 0}, 3 * inside, true},  // two disks across each other
                       {{none, z, 1, 0}, 3, false},          // their rims in a point
                       {{none, z, 1, 0}, 3 * gone, false},
                       {{none, y, 1, 0}, 0.5, false},         // in one plane: no crossing
                       {{{0.5, 0, 0}, z, 1, 1}, 0.25, true},  // a thick solid
                       {{none, x, 1, 1}, 2.5 * inside, true},
                       {{none, x, 1, 1}, 2.5, false},
                       {{none, x, 1, 1}, 2.5 * gone, false},
                       {{none, Vector3(1, 1, 0), 0, 1}, 2 * inside, true},  // a segment through the disk
                       {{none, Vector3(1, 1, 0), 0, 1}, 2, false},
                       {{none, Vector3(1, 1, 0), 0, 1}, 2 * gone, false},
                       {{{0, 0.5, 0}, z, 0, 1}, 1, false},  // beside its plane
                       {{{0, 0.5, 0}, y, 0, 1}, 1, false},  // ends in it
                       {{{0, 0.5 * inside, 0}, y, 0, 1}, 1, true},
                       {{none, z, 0, 0}, 1, false}};  // a point in it
  for (const Known& k : all)
    for (const bool swap : {false, true}) {
      const Solid disk{Vector3(k.disk_at, 0, 0), y, 2, 0};
      const Pair pair = swap ? Pair{disk, k.solid} : Pair{k.solid, disk};
      const BasicFilter<R> filter(pair);
      bool overlap = false;
      for (double at = -1; at <= 1; at += 0x1p-7) {  // guesses along x, beside the common line
        const Vector3 guess = Vector3(at, 0, 1e-14) - pair.a.center;
        overlap = overlap || filter.overlap_at({R(std::ldexp(guess.x(), -filter.exponent())), 0,
                                                R(std::ldexp(guess.z(), -filter.exponent()))});
      }
      EXPECT_EQ(overlap, k.overlap) << what << " " << format_pair(pair);
      if (k.overlap) {
        EXPECT_EQ(judge(pair).verdict, Verdict::intersecting) << format_pair(pair);
      }
    }
}

TEST(Filter, ShowsWhereFlatSolidsOverlap) {
  expect_overlaps<double>("double");
  expect_overlaps<long double>("long double");
}

template <class R>
void expect_rounding_outwards() {
  using Limits = std::numeric_limits<R>;
  constexpr R infinity = Limits::infinity();
  std::vector<R> all{0, 1, R(1.5), std::nextafter(R(2), R(0)), Limits::denorm_min(), Limits::max(), infinity};
  for (int exponent = Limits::min_exponent - Limits::digits; exponent < Limits::max_exponent; ++exponent)
    for (const R mantissa : {R(1), std::nextafter(R(1), R(2)), R(1.25), R(1.75), std::nextafter(R(2), R(1))})
      all.push_back(std::ldexp(mantissa, exponent));
  for (const R x : all)
    for (const R y : {x, -x}) {
      const R up = std::nextafter(y, infinity), down = std::nextafter(y, -infinity);
      EXPECT_GE(interval_detail::next_up(y), up);
      EXPECT_LE(interval_detail::next_up(y), std::nextafter(up, infinity));
      EXPECT_LE(interval_detail::next_down(y), down);
      EXPECT_GE(interval_detail::next_down(y), std::nextafter(down, -infinity));
    }
}

TEST(Filter, RoundsOutwardsByOneNumberOrTwo) {
  expect_rounding_outwards<double>();
  expect_rounding_outwards<long double>();
}

// Solids on either side of one plane, z = 0, whose faces in it are apart.
TEST(Tangency, FacesOfOnePlaneNeedNotMeet) {
  const auto flat = [](double x, double y, const Vector3& axis, double radius, double height) {
    return Solid{Vector3(x, y, 0), axis, radius, height};
  };
  const Vector3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const Solid disk = flat(0, 0, z, 1, 0), along_x = flat(0, 0, x, 0, 2);
  const auto meet = [&](const Solid& a, const Solid& b) {
    const auto there = prove_tangency({a, b}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1});
    const auto back = prove_tangency({b, a}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1});
    EXPECT_TRUE(there && back);
    if (!there || !back) return false;
    EXPECT_EQ(there->meet, back->meet);
    return there->meet;
  };
  EXPECT_TRUE(meet(disk, flat(3, 0, z, 2, 0)));
  EXPECT_FALSE(meet(disk, flat(3.0625, 0, z, 2, 0)));
  EXPECT_TRUE(meet(disk, flat(0.6, 0.7, z, 0, 0)));
  EXPECT_FALSE(meet(disk, flat(0.75, 0.75, z, 0, 0)));
  EXPECT_TRUE(meet(disk, flat(2, 0, x, 0, 2)));
  EXPECT_FALSE(meet(disk, flat(2.5, 0, x, 0, 2)));
  EXPECT_TRUE(meet(along_x, flat(0.5, 1, y, 0, 2)));
  EXPECT_FALSE(meet(along_x, flat(0.5, 1.5, y, 0, 2)));
  EXPECT_FALSE(meet(along_x, flat(1.5, 0.5, y, 0, 2)));
  EXPECT_FALSE(meet(disk, {Vector3(0, 0, 0x1p-900), z, 1, 0}));
}

TEST(RootSum, KnowsWhenItIs0) {
  const auto root = [](const mpq_class& c, const mpq_class& q) { return RootSum::root(c, q); };
  EXPECT_EQ((root(1, 8) - root(2, 2)).sign(), 0);
  EXPECT_EQ((root(1, 2) - root(mpq_class(1, 2), 8)).sign(), 0);
  EXPECT_EQ((root(3, 8) - root(2, 18)).sign(), 0);
  EXPECT_EQ((root(1, mpq_class(4, 3)) * root(1, mpq_class(4, 3)) - RootSum(mpq_class(4, 3))).sign(), 0);
  EXPECT_EQ((root(1, mpq_class(4, 3)) - RootSum(2)).sign(), -1);
  EXPECT_EQ((root(1, 2) + root(1, 3) - root(1, 10)).sign(), -1);
}

TEST(SimplestWithin, FindsTheFractionBehindADecimal) {
  EXPECT_EQ(simplest_within(mpq_class(0.333333333333), mpq_class(1, 1000000)), mpq_class(1, 3));
  EXPECT_EQ(simplest_within(mpq_class(-2.5), mpq_class(1, 1000)), mpq_class(-5, 2));
  EXPECT_EQ(simplest_within(mpq_class(7), mpq_class(0)), mpq_class(7));
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
  EXPECT_EQ(prove_in_long_double(close).verdict, Verdict::undecided);
  EXPECT_EQ(prove_exactly(close, {}, 128).verdict, Verdict::disjoint);
  const Pair deep = above({0, 0, 2 - 0x1p-51});
  EXPECT_EQ(prove_in_double(deep).verdict, Verdict::undecided);
  EXPECT_EQ(prove_in_long_double(deep).verdict, Verdict::intersecting);
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
