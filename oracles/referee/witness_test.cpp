// SPDX-License-Identifier: MIT
// The referee's checks of witnesses, and its work without them.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "corpus/pairs/pair_io.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

MethodAnswer point_in(Hull hull_a, Hull hull_b, const Vector3& at) {
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.witness = CertificateKind::point;
  std::copy_n(at.data(), 3, answer.head);
  answer.hulls[0] = hull_a;
  answer.hulls[1] = hull_b;
  return answer;
}

Pair swapped(const Pair& pair) { return {pair.b, pair.a}; }

// Returns the pair with its coordinates in another order, and with one of them mirrored.
Pair turned(Pair pair, int how) {
  for (Solid* c : {&pair.a, &pair.b})
    for (Vector3* v : {&c->center, &c->axis}) {
      for (int i = 0; i < how % 3; ++i) *v = Vector3(v->z(), v->x(), v->y());
      if (how >= 3) v->y() = -v->y();
    }
  return pair;
}

template <class Check>
void in_all_positions(const Pair& pair, Check check) {
  for (int how = 0; how < 6; ++how) {
    check(turned(pair, how));
    check(swapped(turned(pair, how)));
  }
}

// A segment along (1, 1, 1) crosses a disk in (1, 1, 1)/3, which no doubles are. The guess is beside it.
const Vector3 x(1, 0, 0), z(0, 0, 1), diagonal(1, 1, 1), beside(0.3125, 0.375, 0.34375);
const Solid segment{Vector3(0, 0, 0), diagonal, 0, 4};
const Solid disk{Vector3(0.5, 0.5, 0), diagonal, 2, 0};

TEST(HullWitness, StandsForARationalPoint) {
  const Pair pair{segment, disk};
  for (const Hull a : {Hull::space, Hull::line})
    for (const Hull b : {Hull::space, Hull::plane}) {
      const MethodAnswer witness = point_in(a, b, beside);
      const bool named = a != Hull::space || b != Hull::space;
      EXPECT_EQ(check_witness(pair, witness), named ? Verdict::intersecting : Verdict::undecided);
      const Truth truth = judge(pair, {&witness, 1});
      EXPECT_EQ(truth.witnessed, named);
      if (named) {
        EXPECT_EQ(truth.stage, Stage::filter);
      }
      EXPECT_EQ(truth.verdict, Verdict::intersecting);
      const Rational3 common = exact(truth.certificate.vector);
      EXPECT_TRUE(in_both_exact(pair, common));
      EXPECT_EQ(common.x, mpq_class(1, 3));
      EXPECT_EQ(common.y, mpq_class(1, 3));
      EXPECT_EQ(common.z, mpq_class(1, 3));
      EXPECT_EQ(truth.certificate.hulls, Hulls{});
      EXPECT_EQ(judge_verdict(pair, {&witness, 1}).verdict, Verdict::intersecting);
      EXPECT_EQ(judge_verdict(pair, {&witness, 1}).witnessed, named);
    }
}

TEST(Witness, OfAGapFarBelowTheLastPlaceHolds) {
  const Solid disk{{0, 0, 0}, {1, 2, 3}, 1, 0};
  Solid above = disk;
  MethodAnswer witness;
  witness.status = Status::answered;
  witness.set_direction({1, 2, 3});
  EXPECT_EQ(check_witness({disk, above}, witness), Verdict::undecided);
  above.center = {0, 0, 0x1p-900};
  EXPECT_EQ(check_witness({disk, above}, witness), Verdict::disjoint);
  above.axis = {1, 2, 4};
  EXPECT_EQ(check_witness({disk, above}, witness), Verdict::undecided);
}

TEST(Witness, OfAnInfinitePointProvesNothing) {
  const Solid ball{{0, 0, 0}, {0, 0, 1}, 0, 0, 1};
  MethodAnswer two;
  two.status = Status::answered;
  two.witness = CertificateKind::points;
  EXPECT_EQ(check_witness({ball, ball}, two), Verdict::intersecting);
  two.other_tail[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check_witness({ball, ball}, two), Verdict::undecided);
}

// The best slice ends the range. There one disk's width is 0, and two of the four functions tie.
TEST(Referee, ProvesGapsWhereTwoFunctionsTieAtARim) {
  const Pair apart[] = {{{{0, 0, 0}, z, 5, 4}, {{8, 7, 4}, x, 3, 6}},
                        {{{0, 0, 0}, z, 10, 2}, {{-8, 19, -3}, {0, 1, 0}, 2, 18}}};
  for (const Pair& pair : apart)
    in_all_positions(pair, [](const Pair& p) {
      const Truth truth = judge(p);
      EXPECT_EQ(truth.verdict, Verdict::disjoint) << format_pair(p);
      EXPECT_EQ(truth.bits, 53) << format_pair(p);
    });
}

// A segment goes through a rational point of a rim. D is square to it and to the rim's tangent.
TEST(Referee, ProvesThatASegmentTouchesARim) {
  const Pair touching[] = {{{{0, 0, 0}, z, 5, 6}, {{4, 3, -3}, {1, 2, 2}, 0, 8}},
                           {{{-2, -2, -3}, {2, 2, -1}, 2, 2}, {{-2, -4, -4}, {-2, 1, 0}, 0, 2}},
                           {{{0, 0, 0}, {2, 9, -6}, 4, 2}, {{2, -3, -2}, {-8, 1, 4}, 0, 4}}};
  for (const Pair& pair : touching)
    in_all_positions(pair, [](const Pair& p) {
      const Truth truth = judge(p);
      EXPECT_EQ(truth.verdict, Verdict::touching) << format_pair(p);
      EXPECT_EQ(truth.bits, 128) << format_pair(p);
      EXPECT_EQ(truth.certificate.kind, CertificateKind::point) << format_pair(p);
      EXPECT_TRUE(in_both_exact(p, exact(truth.certificate.vector))) << format_pair(p);
    });
}

// These contacts are within 2^-500 of a rim or of a tie. They once took 200 to 2000 slices.
TEST(Referee, FindsExtremeContactsInFewSlices) {
  const Pair extreme[] = {{{{1, 0, 0}, {12, 0, 1.03904747e-316}, 1, 0}, {{1, 1, 1}, {12, 0, 5}, 1, 0}},
                          {{{0, -1, 0}, {3, 6.664204317189761e-213, 0}, 1, 0},
                           {{0, 6.664204317189761e-213, -1}, {3, 4, 1.3479489305571723e-167}, 1, 0}},
                          {{{0, -3, -2}, {0, 0, -2}, 3, 3.007273164814324e+244},
                           {{-3, -1, 3}, {9.182927232626564e+164, -6.781125439384204e-282, 3}, 2, 0}},
                          {{{-2, 1, 1}, {-1.35554224573e-313, 4, 3}, 1.6137099473647703e-232, 2},
                           {{-2, 0, -1}, {0, 4, 3}, 1, 2}}};
  for (const Pair& pair : extreme)
    for (int bits = 128; bits <= precision_cap; bits *= 2) {
      const PrecisionScope precision(bits);
      EXPECT_LE(search(multiprecision_pair(pair), bits).slices, 40) << bits << " " << format_pair(pair);
    }
}

}  // namespace
}  // namespace cyl
