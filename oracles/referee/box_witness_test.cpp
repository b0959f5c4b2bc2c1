// SPDX-License-Identifier: MIT
// The referee's checks of witnesses for boxes, and boxes with half-spaces.
#include <gtest/gtest.h>

#include <algorithm>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/referee/tangency.hpp"
#include "oracles/referee/witness_miss.hpp"

namespace cyl {
namespace {

MethodAnswer offer(CertificateKind kind, const Vector3& head, const Vector3& other = {0, 0, 0}) {
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.witness = kind;
  std::copy_n(head.data(), 3, answer.head);
  std::copy_n(other.data(), 3, answer.other_head);
  return answer;
}

const Solid cube{.shape = Shape::box, .edges = {2, 2, 2}};
/// A rectangle. Its middle is the only point of its plane that is known in doubles.
const Solid oblique{.shape = Shape::box, .edges = {2, 2, 0}, .quaternion = {0.1, 0.2, 0.3, 0.7}};

Solid at(Solid s, const Vector3& center) {
  s.center = center;
  return s;
}
Solid rounded(Solid s, double rounding) {
  s.rounding = rounding;
  return s;
}

TEST(BoxWitness, ProvesOnlyWhatIsSo) {
  const Pair apart{cube, at(cube, {3, 0, 0})}, meet{cube, at(cube, {1, 1, 1})},
      smooth{rounded(cube, 1), at(rounded(cube, 0.5), {3, 3, 0})};
  using enum CertificateKind;
  EXPECT_EQ(check_witness(apart, offer(direction, {1, 0.1, 0})), Verdict::disjoint);
  EXPECT_EQ(check_witness(apart, offer(direction, {1, 1, 0})), Verdict::undecided);
  EXPECT_EQ(check_witness(apart, offer(point, {1.5, 0, 0})), Verdict::undecided);
  EXPECT_EQ(check_witness(meet, offer(point, {0.5, 0.5, 0.5})), Verdict::intersecting);
  EXPECT_EQ(check_witness(meet, offer(point, {0, 0, 0})), Verdict::intersecting);
  EXPECT_EQ(check_witness(meet, offer(point, {-0.25, 0, 0})), Verdict::undecided);
  EXPECT_EQ(check_witness(meet, offer(direction, {1, 1, 1})), Verdict::undecided);
  EXPECT_EQ(check_witness(smooth, offer(points, {1, 1, 0}, {2, 2, 0})), Verdict::intersecting);
  EXPECT_EQ(check_witness(smooth, offer(points, {1, 1, 0.5}, {2, 2, -1})), Verdict::undecided);
  EXPECT_EQ(check_witness(smooth, offer(points, {1.25, 1, 0}, {2, 2, 0})), Verdict::undecided);
}

TEST(BoxWitness, PointsOfFlatBoxesAreTakenInTheirHulls) {
  const Pair crossing{oblique, {.axis = {1, 2, 3}, .height = 4}}, inside{oblique, cube},
      beside{oblique, at(cube, {0, 0, 3})};
  // A hull that the answer names for the box changes nothing.
  for (const Hull named : {Hull::space, Hull::plane, Hull::center}) {
    MethodAnswer answer = offer(CertificateKind::point, {0x1p-60, 0.25, 0.25});
    answer.hulls[0] = named;
    answer.hulls[1] = Hull::line;
    EXPECT_EQ(check_witness(crossing, answer), Verdict::intersecting);
    const Truth truth = judge(crossing, {&answer, 1});
    EXPECT_TRUE(truth.witnessed);
    EXPECT_TRUE(in_both_exact(crossing, exact(truth.certificate.vector)));
  }
  for (const Pair& pair : {crossing, inside}) {
    const Truth truth = judge(pair);
    EXPECT_EQ(truth.verdict, Verdict::intersecting);
    EXPECT_TRUE(in_both_exact(pair, exact(truth.certificate.vector)));
    EXPECT_EQ(judge_verdict(pair).verdict, Verdict::intersecting);
  }
  EXPECT_EQ(check_witness(beside, offer(CertificateKind::point, {0, 0, 1})), Verdict::undecided);
}

TEST(BoxWitness, MissByALength) {
  const Pair meet{cube, at(cube, {1, 0, 0})}, apart{cube, at(cube, {2.5, 0, 0})};
  EXPECT_EQ(witness_miss(meet, offer(CertificateKind::point, {0.5, 0, 0.75})), -0.25);
  EXPECT_EQ(witness_miss(meet, offer(CertificateKind::point, {0.5, 0, -1.75})), 0.75);
  EXPECT_EQ(witness_miss(meet, offer(CertificateKind::point, {2, 0, 0})), 1);
  EXPECT_EQ(witness_miss(apart, offer(CertificateKind::direction, {4, 0, 0})), -0.5);
  EXPECT_EQ(witness_miss(meet, offer(CertificateKind::direction, {4, 0, 0})), 1);
}

// The distance is below the rounding of the search. Then the certificate gives the sign of the enclosure.
TEST(BoxWitness, BoundsTheDistance) {
  Solid beam = cube;
  beam.edges[1] = 1024;
  const Pair thin{beam, at(cube, {2 + 0x1p-51, 0, 0})}, deep{beam, at(cube, {2 - 0x1p-52, 0, 0})};
  const Enclosure gap = enclose_distance(thin, judge(thin)), depth = enclose_distance(deep, judge(deep));
  EXPECT_GT(gap.lo, 0x1p-52);
  EXPECT_LT(depth.hi, -0x1p-54);
  EXPECT_LE(attain_distance(thin, judge(thin), gap_width_tol).distance.lo, 0);
  EXPECT_EQ(attain_distance(deep, judge(deep), depth_width_tol).distance.hi, 0);
}

TEST(BoxWitness, AHalfSpaceAndABox) {
  const Solid below{.axis = {0, 3, 4}, .shape = Shape::half_space};
  // The lowest corner of a cube along (0, 3, 4)/5 is 7/5 below its middle.
  const auto raised = [&](double by, double rounding) {
    return at(rounded(cube, rounding), {9, 3 * by, 4 * by});
  };
  const auto verdict = [&](const Solid& box) {
    const Pair pair{box, below};
    const Truth truth = judge(pair);
    const Certificate& c = truth.certificate;
    if (truth.verdict == Verdict::disjoint) {
      EXPECT_LT(support_gap_sign(pair, exact(c.vector)), 0);
    } else if (c.kind == CertificateKind::point) {
      EXPECT_TRUE(in_both_exact(pair, exact(c.vector)));
    } else {
      EXPECT_EQ(c.kind, CertificateKind::points);
      EXPECT_TRUE(in_each_exact(pair, exact(c.vector), exact(c.second)));
    }
    EXPECT_EQ(judge_verdict({below, box}).verdict, truth.verdict);
    return truth.verdict;
  };
  EXPECT_EQ(verdict(at(cube, {0, 1, 1})), Verdict::touching);
  EXPECT_EQ(verdict(at(cube, {0, 1, 1 + 0x1p-52})), Verdict::disjoint);
  EXPECT_EQ(verdict(at(cube, {0, 1, 1 - 0x1p-53})), Verdict::intersecting);
  EXPECT_EQ(verdict(raised(0.5, 1)), Verdict::disjoint);
  EXPECT_EQ(verdict(raised(0.5, 1.25)), Verdict::intersecting);
  EXPECT_EQ(verdict(raised(-9, 0)), Verdict::intersecting);
}

}  // namespace
}  // namespace cyl
