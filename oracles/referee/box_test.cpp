// SPDX-License-Identifier: MIT
// The referee on boxes: known verdicts, the sign of the distance, a proof of each verdict, and witnesses.
#include "oracles/referee/box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/box_distance.hpp"
#include "oracles/referee/box_search.hpp"
#include "oracles/referee/proof_check_test.hpp"
#include "oracles/referee/witness_miss.hpp"

namespace cyl {
namespace {

Solid box(const Vector3& center, const std::array<double, 3>& edges,
          const std::array<double, 4>& quaternion = {1, 0, 0, 0}, double rounding = 0) {
  return {.center = center,
          .axis = {0, 0, 1},
          .rounding = rounding,
          .shape = Shape::box,
          .edges = edges,
          .quaternion = quaternion};
}
Solid rod(const Vector3& center, const Vector3& axis, double radius, double height, double rounding = 0) {
  return {.center = center, .axis = axis, .radius = radius, .height = height, .rounding = rounding};
}

/// All ways to ask for the verdict must agree, and certificates must prove it.
Verdict verdict_of(const Pair& pair) {
  const Truth truth = judge(pair);
  EXPECT_EQ(judge_verdict(pair).verdict, truth.verdict) << format_pair(pair);
  EXPECT_EQ(judge({pair.b, pair.a}).verdict, truth.verdict) << format_pair(pair);
  EXPECT_EQ(prove_exactly(pair).verdict, truth.verdict) << format_pair(pair);
  EXPECT_TRUE(is_proof(pair, truth)) << format_pair(pair) << to_string(truth.verdict);
  EXPECT_TRUE(is_proof(pair, prove_exactly(pair))) << format_pair(pair);
  if (const Truth quick = prove_in_double(pair); quick.verdict != Verdict::undecided) {
    EXPECT_EQ(quick.verdict, truth.verdict) << format_pair(pair);
  }
  if (truth.verdict == Verdict::touching && !has_half_space(pair) && has_box_relation(pair)) {
    EXPECT_TRUE(is_nearly_tangent(pair, box_relation(pair, near_bits).direction)) << format_pair(pair);
  }
  return truth.verdict;
}

constexpr Verdict apart = Verdict::disjoint, touch = Verdict::touching, meet = Verdict::intersecting;

struct Known {
  const char* what;
  Pair pair;
  Verdict verdict;
};

TEST(Box, KnownVerdicts) {
  constexpr double long_number = 51234567890123 * 0x1p-46;  // its small multiples are exact
  const Vector3 o(0, 0, 0), z(0, 0, 1);
  constexpr std::array<double, 4> even{1, 0, 0, 0};
  const Solid sheet = box(o, {2, 2, 0}), cube = box(o, {2, 2, 2}), smooth = box(o, {2, 2, 2}, even, 1),
              below{.axis = {0, 3, 4}, .shape = Shape::half_space};
  const std::array<double, 4> wild{1e200, 1e200, 1e200, 1e200};  // turns x to y to z
  const Known known[] = {
      // Ties of points, segments and boxes are drawn below. These differ from one by less than is drawn.
      {"next to it", {cube, box({2 + 0x1p-50, 0, 0}, {2, 2, 2})}, apart},
      {"into it", {cube, box({2 - 0x1p-50, 0, 0}, {2, 2, 2})}, meet},
      {"turned by thirds, long", {box(o, {2, 4, 6}, wild), box({4, 0, 0}, {2, 2, 2})}, touch},
      {"far away", {box({1e15, 0, 0}, {2, 2, 2}), box({1e15 + 2, 0, 0}, {2, 2, 2})}, touch},
      {"rectangles of parallel planes", {sheet, box({0, 0, 1e-300}, {2, 2, 0})}, apart},
      {"segments beside", {box(o, {2, 0, 0}), box({0, 0x1p-1070, 0}, {2, 0, 0})}, apart},
      {"sphere near a vertex", {cube, rod({2, 3, 3}, z, 0, 0, 3 - 0x1p-50)}, apart},
      {"sphere in a vertex", {cube, rod({2, 3, 3}, z, 0, 0, 3 + 0x1p-50)}, meet},
      {"capsule with an irrational end", {cube, rod({0, 0, 5}, {1, 1, 0}, 0, 1, 4)}, touch},
      {"segment beside an edge", {cube, rod({1, 1 + 0x1p-52, 0}, {1, -1, 5}, 0, 9)}, apart},
      {"rounded boxes apart",
       {box(o, {2, 2, 2}, even, 2), box({5, 6, 0x1p-40}, {2, 2, 2}, even, 3 - 0x1p-50)},
       apart},
      {"beyond the largest double",
       {box({1.7e308, 0, 0}, {1e300, 1e300, 1e300}, wild), box({-1.7e308, 0, 0}, {1e300, 1e300, 1e300})},
       apart},
      {"box in a tube", {box(o, {6, 8, 2}), rod(o, z, 5, 2)}, meet},
      {"cap on a face", {cube, rod({0, 0, 2}, z, 3, 2)}, touch},
      {"side on a face", {cube, rod({3, 0, 0}, {0, 1, 5}, 2, 9)}, touch},
      {"side on an edge", {cube, rod({4, 5, 0}, {0, 0, 3}, 5, 1)}, touch},
      {"side across an edge", {cube, rod({4, 5, 0}, {4, -3, 5}, 5, 1)}, touch},
      {"side beside an edge", {cube, rod({4, 5, 0}, {0, 0, 3}, 5 - 0x1p-50, 1)}, apart},
      {"side in an edge", {cube, rod({4, 5, 0}, {0, 0, 3}, 5 + 0x1p-50, 1)}, meet},
      {"rim on a vertex", {cube, rod({4, 5, 2}, z, 5, 2)}, touch},
      {"rim on a face", {cube, rod({5, 0, 0}, {4, 3, 0}, 5, 1.25)}, apart},
      {"rim on a tilted face", {box(o, {2, 9, 9}), rod({6, 0, 0}, {4, 3, 0}, 5, 5)}, touch},
      {"disk on a face", {cube, rod({0, 0, 1}, z, 3, 0)}, touch},
      {"disk through", {cube, rod({0, 0, 0.5}, {0, 1, 1}, 3, 0)}, meet},
      {"disk and rectangle of one plane", {sheet, rod(o, z, 1, 0)}, touch},
      {"disk and rectangle beside", {sheet, rod({2 + 0x1p-50, 0, 0}, z, 1, 0)}, apart},
      {"disk and rectangle that cross", {sheet, rod(o, {1, 0, 0}, 1, 0)}, meet},
      {"disk and a segment in its plane", {box(o, {2, 0, 0}), rod(o, z, 1, 0)}, touch},
      {"disk and a segment through it", {box({0.5, 0, 0}, {0, 0, 2}), rod(o, z, 1, 0)}, meet},
      {"a point on the rim", {box({3, 4, 0}, {0, 0, 0}), rod(o, z, 5, 0)}, touch},
      {"a point in a cylinder", {box({3, 3, 0}, {0, 0, 0}), rod(o, z, 5, 1)}, meet},
      {"a cap on a rectangle", {box({0, 0, 1}, {9, 9, 0}), rod(o, z, 5, 2)}, touch},
      {"a disk at an irrational height", {box(o, {2, 2, 2}), rod({1, 2, 3}, {1, 2, 3}, 0.1, 0)}, apart},
      {"oblique cap on a vertex", {box({-1, -1, -1}, {2, 2, 2}), rod({2, 1, 2}, {2, 1, 2}, 1, 6)}, touch},
      {"oblique cap on a vertex, irrational",
       {box({-1, -1, -1}, {2, 2, 2}), rod({2, 1, 2}, {2, 1, 1}, 1, 6)},
       meet},
      // The lowest corner of a cube along (0, 3, 4)/5 is 7/5 below its middle.
      {"on a half-space", {box({0, 1, 1}, {2, 2, 2}), below}, touch},
      {"above a half-space", {box({0, 1, 1 + 0x1p-52}, {2, 2, 2}), below}, apart},
      {"in a half-space", {box({0, 1, 1 - 0x1p-53}, {2, 2, 2}), below}, meet},
      {"smooth above a half-space", {box({9, 1.5, 2}, {2, 2, 2}, even, 1), below}, apart},
      {"smooth in a half-space", {box({9, 1.5, 2}, {2, 2, 2}, even, 1.25), below}, meet},
      {"deep in a half-space", {box({9, -27, -36}, {2, 2, 2}), below}, meet},
      // With rounded cylinders.
      {"cap on a face", {cube, rod({0.5, 0, 4}, z, 2, 2, 2)}, touch},
      {"cap on an edge", {box(o, {2, 50, 50}, {3, 4, 0, 0}), rod({0, 17, 33}, z, 2, 2, 1)}, touch},
      {"cap on an edge of a smooth box", {smooth, rod({2, 0, 5}, z, 2, 2, 2)}, touch},
      {"side on a face", {cube, rod({6, 0.5, 0}, {0, 1, 1}, 2, 2, 3)}, touch},
      {"side on an edge", {cube, rod({4, 5, 0}, {0, 0, 3}, 2, 1, 3)}, touch},
      {"side across an edge", {cube, rod({4, 5, 0}, {4, -3, 5}, 2, 1, 3)}, touch},
      {"side across a smooth edge", {smooth, rod({4, 5, 0}, {4, -3, 5}, 2, 1, 2)}, touch},
      {"side on a corner", {box(o, {2, 2, 2}, {1, 1, 0, 0}), rod({4, 5, 1}, {0, 0, 3}, 2, 1, 3)}, touch},
      {"rim on a face", {box(o, {2, 9, 9}), rod({7, 0, 0}, {4, 3, 0}, 5, 5, 1)}, touch},
      {"rim on a corner", {cube, rod({10, 1, 6}, z, 5, 2, 4)}, apart},
      {"rim on a corner 3-4-5", {cube, rod({10, 1, 5}, z, 5, 2, 5)}, touch},
      {"rim on a corner obliquely", {cube, rod({3, 4, 5}, z, 2, 2, 3)}, apart},
      {"rim on an edge 3-4-5", {cube, rod({9, 0, 6}, z, 5, 2, 5)}, touch},
      {"rim on an edge, too far", {cube, rod({9, 0, 6 + 0x1p-48}, z, 5, 2, 5)}, apart},
      {"rim on an edge, too near", {cube, rod({9, 0, 6 - 0x1p-48}, z, 5, 2, 5)}, meet},
      {"side beside a face by next to nothing",
       {box({0, -1, 0}, {2, 2, 2}), rod({6, 0x1p-300, 0}, z, 2, 2, 3)},
       apart},
      {"rim on a corner, long numbers",
       {cube, rod({4 + 3 * long_number, 1, 2 + 4 * long_number}, z, 3, 2, 5 * long_number)},
       touch},
      {"disk on a face", {cube, rod({0, 0, 3}, z, 3, 0, 2)}, touch},
      {"rectangle on a disk", {box(o, {2, 2, 0}, even, 1), rod({0, 0, 3}, z, 3, 0, 2)}, touch},
      {"a smooth box in a tube", {smooth, rod(o, z, 5, 2)}, meet},
      {"a smooth box beside a tube", {smooth, rod({7, 0.25, 0}, z, 5, 2)}, touch},
      {"a smooth box below a tube", {smooth, rod({1, 0.25, 3}, z, 5, 2)}, touch},
  };
  for (const Known& k : known) {
    SCOPED_TRACE(k.what);
    EXPECT_STREQ(to_string(verdict_of(k.pair)), to_string(k.verdict));
  }
}

class SmallNumbers {
 public:
  int whole(int lo, int hi) { return random_.integer(lo, hi); }
  Solid polytope() {
    const int kind = whole(0, 3);
    Solid c = rod({0, 0, 0}, {0, 0, 1}, 0, kind == 3 ? whole(0, 4) : 0);
    if (kind < 3) c = box({0, 0, 0}, {0, 0, 0});
    for (double& x : c.center) x = whole(-4, 4) / 2.0;
    if (kind < 3) {
      for (double& x : c.edges) x = whole(0, 4);
      for (double& x : c.quaternion) x = whole(-1, 1);
      if (c.quaternion == std::array<double, 4>{}) c.quaternion[0] = 1;
      if (whole(0, 2) == 0) c.quaternion = {1, 0, 0, 0};
    } else {
      const Vector3 axes[] = {{0, 0, 1}, {3, 4, 0}, {0, -4, 3}, {2, 1, 2}, {1, 1, 0}, {1, 1, 1}};
      c.axis = axes[whole(0, 5)];
    }
    if (whole(0, 1) == 0) c.rounding = whole(0, 4) / 2.0;
    return c;
  }

 private:
  RandomStream random_{"polytopes", 20261129, 0};
};

// The distance is searched in other arithmetic, and along circles that the verdict does not know.
TEST(Box, VerdictsOfPolytopesAgreeWithTheDistance) {
  SmallNumbers draw;
  int seen[3] = {0, 0, 0};
  const std::uint64_t many = from_environment("DAYLIGHT_BOX_PAIRS", 3000);
  for (std::uint64_t i = 0; i < many; ++i) {
    const Pair pair{draw.polytope(), draw.polytope()};
    if (!has_box(pair)) continue;
    constexpr double tie_tol = 1e-10;
    const Enclosure distance = attain_box(pair, Verdict::undecided, 1e-12).distance;
    const Verdict expected = distance.lo > tie_tol ? apart : distance.hi < -tie_tol ? meet : touch;
    ++seen[static_cast<int>(expected)];
    ASSERT_STREQ(to_string(verdict_of(pair)), to_string(expected)) << format_pair(pair) << distance.lo;
  }
  for (const int count : seen) EXPECT_GT(count, static_cast<int>(many / 50));
}

/// Draws pairs of a box and any solid, and moves them almost together.
class AlmostTouching {
 public:
  double number(double lo, double hi) { return random_.between(lo, hi); }
  int whole(int lo, int hi) { return random_.integer(lo, hi); }
  double length() { return whole(0, 3) == 0 ? 0 : std::exp2(number(-4, 1)); }
  Solid solid(bool is_a_box) {
    const double x = length(), y = length(), z = length();
    Solid c = is_a_box ? box({0, 0, 0}, {x, y, z}) : rod({0, 0, 0}, {0, 0, 1}, x, y);
    for (double& u : is_a_box ? std::span<double>(c.quaternion) : std::span<double>(c.axis.data(), 3))
      u = number(-1, 1);
    for (double& u : c.center) u = number(-1, 1);
    if (whole(0, 1) == 0) c.rounding = length();
    return c;
  }
  Pair pair() {
    Pair p{solid(true), solid(whole(0, 2) == 0)};
    if (whole(0, 1) == 0) std::swap(p.a, p.b);
    p.b.center += random_.unit_vector() * 20;
    const TermsPair<double> t = terms_of_pair<double>(p);
    const Vec3<double> way = search_box(t, 53, false).nearest;
    const double distance = norm(way),
                 gaps[] = {1, 1e-2, 1e-6, 1e-12, 1e-15, 1e-16, 0, -1e-16, -1e-15, -1e-12, -1e-6, -1e-2, -1};
    const double gap = gaps[whole(0, 12)] * size_of(p);
    for (int i = 0; i < 3; ++i)
      p.b.center[i] -= (distance - gap - p.a.rounding - p.b.rounding) / distance *
                       (i == 0   ? way.x
                        : i == 1 ? way.y
                                 : way.z);
    return p;
  }

 private:
  RandomStream random_{"almost touching", 20261130, 0};
};

TEST(Box, EveryVerdictNearTouchingIsProved) {
  AlmostTouching draw;
  const std::uint64_t many = from_environment("DAYLIGHT_BOX_PAIRS", 2000);
  for (std::uint64_t i = 0; i < many; ++i) {
    const Pair pair = draw.pair();
    const Verdict verdict = verdict_of(pair);
    ASSERT_LE(verdict, Verdict::touching) << format_pair(pair);
  }
}

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
TEST(BoxWitness, ProvesOnlyWhatIsSo) {
  const Pair apart{cube, at(cube, {3, 0, 0})}, meet{cube, at(cube, {1, 1, 1})},
      smooth{box({0, 0, 0}, {2, 2, 2}, {1, 0, 0, 0}, 1), box({3, 3, 0}, {2, 2, 2}, {1, 0, 0, 0}, 0.5)};
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
  const Pair in_plane{{.shape = Shape::half_space}, box({0, 0, 1.5}, {2, 2, 2}, {1, 0, 0, 0}, 1)};
  EXPECT_EQ(check_witness(in_plane, offer(points, {0, 0, -0.125}, {0, 0, 0.75})), Verdict::intersecting);
  EXPECT_EQ(check_witness(in_plane, offer(points, {0, 0, 0.25}, {0, 0, 0.75})), Verdict::undecided);
  EXPECT_EQ(check_witness(in_plane, offer(points, {0, 0, -0.25}, {0, 0, 0.25})), Verdict::undecided);
  EXPECT_EQ(check_witness(in_plane, offer(direction, {0, 0, 2})), Verdict::undecided);
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
  EXPECT_EQ(attain_distance(deep, judge(deep), depth_width_tol).distance.hi, 0);
}

}  // namespace
}  // namespace cyl
