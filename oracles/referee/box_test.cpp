// SPDX-License-Identifier: MIT
// The referee on boxes: known verdicts, a distance by brute force, and a proof of each verdict that uses only
// exact membership and exact supports.
#include "oracles/referee/box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/box_search.hpp"
#include "oracles/referee/box_sign.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/tangency.hpp"

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

/// Whether the point is in the core grown by the slack on all sides.
bool is_nearly_in(const Solid& c, const Rational3& point, const mpq_class& slack) {
  const Rational3 x = point - exact(c.center);
  if (is_box(c)) {
    const auto edges = edge_directions<mpq_class>(c.quaternion);
    for (std::size_t i = 0; i < 3; ++i)
      if (abs(dot(x, edges[i])) > mpq_class(c.edges[i]) / 2 + slack) return false;
    return true;
  }
  const Rational3 w = exact(c.axis), across = cross(x, w);
  const mpq_class ww = dot(w, w), along = dot(x, w), half = mpq_class(c.height) / 2 + slack,
                  radius = mpq_class(c.radius) + slack;
  return along * along <= half * half * ww && dot(across, across) <= radius * radius * ww;
}

/// Whether |f| <= 2^-200 size |direction|: it changes its sign if a rounding changes by as much.
bool is_nearly_tangent(const Pair& pair, const Rational3& direction) {
  const PrecisionScope precision(600);
  const auto wide = [](const Rational3& v) {
    return Vec3<MpInterval>{MpInterval(v.x), MpInterval(v.y), MpInterval(v.z)};
  };
  const MpInterval f = support_gap(terms_of<MpInterval>(pair.a), terms_of<MpInterval>(pair.b),
                                   wide(exact(pair.b.center) - exact(pair.a.center)), wide(direction));
  const MpInterval most = MpInterval(times_power(exact_size(pair), -200)) * norm(wide(direction));
  return !(abs(f) - most).positive();
}

/// Whether the certificate proves contact or a gap, by exact arithmetic.
bool is_proof(const Pair& pair, const Truth& truth) {
  const Certificate& c = truth.certificate;
  if (truth.verdict == Verdict::disjoint)
    return c.kind == CertificateKind::direction && support_gap_sign(pair, exact(c.vector)) < 0;
  if (c.kind == CertificateKind::point) return in_both_exact(pair, exact(c.vector));
  const bool near = truth.verdict == Verdict::touching && c.kind == CertificateKind::near;
  const bool near_points = truth.verdict == Verdict::touching && c.kind == CertificateKind::near_points;
  if (c.kind != CertificateKind::points && !near && !near_points) return false;
  const mpq_class slack =
      c.kind == CertificateKind::points ? mpq_class(0) : times_power(exact_size(pair), -200);
  const Rational3 x = exact(c.vector), y = near ? x : exact(near_points ? c.third : c.second),
                  between = y - x;
  const mpq_class reach = contact_distance_of(pair) + slack;
  return is_nearly_in(pair.a, x, slack) && is_nearly_in(pair.b, y, slack) &&
         dot(between, between) <= reach * reach &&
         (c.kind == CertificateKind::points || is_nearly_tangent(pair, exact(c.second)));
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
  if (truth.verdict == Verdict::touching && has_box_relation(pair)) {
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
  const Solid cube = box({0, 0, 0}, {2, 2, 2});
  const std::array<double, 4> wild{1e200, 1e200, 1e200, 1e200};  // turns x to y to z
  const Known known[] = {
      // Ties of points, segments and boxes are drawn below. These differ from one by less than is drawn.
      {"next to it", {cube, box({2 + 0x1p-50, 0, 0}, {2, 2, 2})}, apart},
      {"into it", {cube, box({2 - 0x1p-50, 0, 0}, {2, 2, 2})}, meet},
      {"turned by thirds, long", {box({0, 0, 0}, {2, 4, 6}, wild), box({4, 0, 0}, {2, 2, 2})}, touch},
      {"far away", {box({1e15, 0, 0}, {2, 2, 2}), box({1e15 + 2, 0, 0}, {2, 2, 2})}, touch},
      {"rectangles of parallel planes", {box({0, 0, 0}, {2, 2, 0}), box({0, 0, 1e-300}, {2, 2, 0})}, apart},
      {"segments beside", {box({0, 0, 0}, {2, 0, 0}), box({0, 0x1p-1070, 0}, {2, 0, 0})}, apart},
      {"sphere near a vertex", {cube, rod({2, 3, 3}, {0, 0, 1}, 0, 0, 3 - 0x1p-50)}, apart},
      {"sphere in a vertex", {cube, rod({2, 3, 3}, {0, 0, 1}, 0, 0, 3 + 0x1p-50)}, meet},
      {"capsule with an irrational end", {cube, rod({0, 0, 5}, {1, 1, 0}, 0, 1, 4)}, touch},
      {"segment beside an edge", {cube, rod({1, 1 + 0x1p-52, 0}, {1, -1, 5}, 0, 9)}, apart},
      {"rounded boxes apart",
       {box({0, 0, 0}, {2, 2, 2}, {1, 0, 0, 0}, 2),
        box({5, 6, 0x1p-40}, {2, 2, 2}, {1, 0, 0, 0}, 3 - 0x1p-50)},
       apart},
      {"beyond the largest double",
       {box({1.7e308, 0, 0}, {1e300, 1e300, 1e300}, wild), box({-1.7e308, 0, 0}, {1e300, 1e300, 1e300})},
       apart},
      {"box in a tube", {box({0, 0, 0}, {6, 8, 2}), rod({0, 0, 0}, {0, 0, 1}, 5, 2)}, meet},
      {"cap on a face", {cube, rod({0, 0, 2}, {0, 0, 1}, 3, 2)}, touch},
      {"side on a face", {cube, rod({3, 0, 0}, {0, 1, 5}, 2, 9)}, touch},
      {"side on an edge", {cube, rod({4, 5, 0}, {0, 0, 3}, 5, 1)}, touch},
      {"side across an edge", {cube, rod({4, 5, 0}, {4, -3, 5}, 5, 1)}, touch},
      {"side beside an edge", {cube, rod({4, 5, 0}, {0, 0, 3}, 5 - 0x1p-50, 1)}, apart},
      {"side in an edge", {cube, rod({4, 5, 0}, {0, 0, 3}, 5 + 0x1p-50, 1)}, meet},
      {"rim on a vertex", {cube, rod({4, 5, 2}, {0, 0, 1}, 5, 2)}, touch},
      {"rim on a face", {cube, rod({5, 0, 0}, {4, 3, 0}, 5, 1.25)}, apart},
      {"rim on a tilted face", {box({0, 0, 0}, {2, 9, 9}), rod({6, 0, 0}, {4, 3, 0}, 5, 5)}, touch},
      {"disk on a face", {cube, rod({0, 0, 1}, {0, 0, 1}, 3, 0)}, touch},
      {"disk through", {cube, rod({0, 0, 0.5}, {0, 1, 1}, 3, 0)}, meet},
      {"disk and rectangle of one plane",
       {box({0, 0, 0}, {2, 2, 0}), rod({0, 0, 0}, {0, 0, 1}, 1, 0)},
       touch},
      {"disk and rectangle beside",
       {box({0, 0, 0}, {2, 2, 0}), rod({2 + 0x1p-50, 0, 0}, {0, 0, 1}, 1, 0)},
       apart},
      {"disk and rectangle that cross", {box({0, 0, 0}, {2, 2, 0}), rod({0, 0, 0}, {1, 0, 0}, 1, 0)}, meet},
      {"disk and a segment in its plane",
       {box({0, 0, 0}, {2, 0, 0}), rod({0, 0, 0}, {0, 0, 1}, 1, 0)},
       touch},
      {"disk and a segment through it", {box({0.5, 0, 0}, {0, 0, 2}), rod({0, 0, 0}, {0, 0, 1}, 1, 0)}, meet},
      {"a point on the rim", {box({3, 4, 0}, {0, 0, 0}), rod({0, 0, 0}, {0, 0, 1}, 5, 0)}, touch},
      {"a point in a cylinder", {box({3, 3, 0}, {0, 0, 0}), rod({0, 0, 0}, {0, 0, 1}, 5, 1)}, meet},
      {"a cap on a rectangle", {box({0, 0, 1}, {9, 9, 0}), rod({0, 0, 0}, {0, 0, 1}, 5, 2)}, touch},
      {"a disk at an irrational height",
       {box({0, 0, 0}, {2, 2, 2}), rod({1, 2, 3}, {1, 2, 3}, 0.1, 0)},
       apart},
      {"oblique cap on a vertex", {box({-1, -1, -1}, {2, 2, 2}), rod({2, 1, 2}, {2, 1, 2}, 1, 6)}, touch},
      {"oblique cap on a vertex, irrational",
       {box({-1, -1, -1}, {2, 2, 2}), rod({2, 1, 2}, {2, 1, 1}, 1, 6)},
       meet},
  };
  for (const Known& k : known) {
    SCOPED_TRACE(k.what);
    EXPECT_STREQ(to_string(verdict_of(k.pair)), to_string(k.verdict));
  }
}

TEST(Box, KnownVerdictsWithRoundedCylinders) {
  constexpr double long_number = 51234567890123 * 0x1p-46;  // its small multiples are exact
  const Solid cube = box({0, 0, 0}, {2, 2, 2}), smooth = box({0, 0, 0}, {2, 2, 2}, {1, 0, 0, 0}, 1);
  const Known known[] = {
      {"cap on a face", {cube, rod({0.5, 0, 4}, {0, 0, 1}, 2, 2, 2)}, touch},
      {"cap on an edge",
       {box({0, 0, 0}, {2, 50, 50}, {3, 4, 0, 0}), rod({0, 17, 33}, {0, 0, 1}, 2, 2, 1)},
       touch},
      {"cap on an edge of a smooth box", {smooth, rod({2, 0, 5}, {0, 0, 1}, 2, 2, 2)}, touch},
      {"side on a face", {cube, rod({6, 0.5, 0}, {0, 1, 1}, 2, 2, 3)}, touch},
      {"side on an edge", {cube, rod({4, 5, 0}, {0, 0, 3}, 2, 1, 3)}, touch},
      {"side across an edge", {cube, rod({4, 5, 0}, {4, -3, 5}, 2, 1, 3)}, touch},
      {"side across a smooth edge", {smooth, rod({4, 5, 0}, {4, -3, 5}, 2, 1, 2)}, touch},
      {"side on a corner",
       {box({0, 0, 0}, {2, 2, 2}, {1, 1, 0, 0}), rod({4, 5, 1}, {0, 0, 3}, 2, 1, 3)},
       touch},
      {"rim on a face", {box({0, 0, 0}, {2, 9, 9}), rod({7, 0, 0}, {4, 3, 0}, 5, 5, 1)}, touch},
      {"rim on a corner", {cube, rod({10, 1, 6}, {0, 0, 1}, 5, 2, 4)}, apart},
      {"rim on a corner 3-4-5", {cube, rod({10, 1, 5}, {0, 0, 1}, 5, 2, 5)}, touch},
      {"rim on a corner obliquely", {cube, rod({3, 4, 5}, {0, 0, 1}, 2, 2, 3)}, apart},
      {"rim on an edge 3-4-5", {cube, rod({9, 0, 6}, {0, 0, 1}, 5, 2, 5)}, touch},
      {"rim on an edge, too far", {cube, rod({9, 0, 6 + 0x1p-48}, {0, 0, 1}, 5, 2, 5)}, apart},
      {"rim on an edge, too near", {cube, rod({9, 0, 6 - 0x1p-48}, {0, 0, 1}, 5, 2, 5)}, meet},
      {"side beside a face by next to nothing",
       {box({0, -1, 0}, {2, 2, 2}), rod({6, 0x1p-300, 0}, {0, 0, 1}, 2, 2, 3)},
       apart},
      {"rim on a corner, long numbers",
       {cube, rod({4 + 3 * long_number, 1, 2 + 4 * long_number}, {0, 0, 1}, 3, 2, 5 * long_number)},
       touch},
      {"disk on a face", {cube, rod({0, 0, 3}, {0, 0, 1}, 3, 0, 2)}, touch},
      {"rectangle on a disk",
       {box({0, 0, 0}, {2, 2, 0}, {1, 0, 0, 0}, 1), rod({0, 0, 3}, {0, 0, 1}, 3, 0, 2)},
       touch},
      {"a smooth box in a tube", {smooth, rod({0, 0, 0}, {0, 0, 1}, 5, 2)}, meet},
      {"a smooth box beside a tube", {smooth, rod({7, 0.25, 0}, {0, 0, 1}, 5, 2)}, touch},
      {"a smooth box below a tube", {smooth, rod({1, 0.25, 3}, {0, 0, 1}, 5, 2)}, touch},
  };
  for (const Known& k : known) {
    SCOPED_TRACE(k.what);
    EXPECT_STREQ(to_string(verdict_of(k.pair)), to_string(k.verdict));
  }
}

/// The distance of two polytopes in long double: the least over all faces of the cube of the bars' lengths.
long double distance_by_faces(const std::vector<Vec3<long double>>& bars, const Vec3<long double>& delta) {
  std::size_t faces = 1;
  for (std::size_t i = 0; i < bars.size(); ++i) faces *= 3;
  long double best = dot(delta, delta);
  bool first = true;
  for (std::size_t face = 0; face < faces; ++face) {
    Vec3<long double> rest = delta;
    std::vector<Vec3<long double>> open;
    for (std::size_t i = 0, code = face; i < bars.size(); ++i, code /= 3) {
      if (code % 3 == 2) open.push_back(bars[i]);
      if (code % 3 == 0) rest = rest - bars[i];
      if (code % 3 == 1) rest = rest + bars[i];
    }
    const std::size_t n = open.size();
    if (n > 3) continue;
    long double m[3][4]{};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) m[i][j] = dot(open[i], open[j]);
      m[i][3] = dot(open[i], rest);
    }
    bool usable = true;
    for (std::size_t i = 0; i < n && usable; ++i) {
      std::size_t pivot = i;
      for (std::size_t row = i; row < n; ++row)
        if (std::fabs(m[row][i]) > std::fabs(m[pivot][i])) pivot = row;
      std::swap(m[i], m[pivot]);
      usable = std::fabs(m[i][i]) > 1e-9L;
      for (std::size_t row = 0; row < n && usable; ++row) {
        if (row == i) continue;
        const long double share = m[row][i] / m[i][i];
        for (int k = 0; k < 4; ++k) m[row][k] -= share * m[i][k];
      }
    }
    for (std::size_t i = 0; i < n && usable; ++i) {
      const long double t = m[i][3] / m[i][i];
      usable = std::fabs(t) <= 1 + 1e-12L;
      rest = rest - t * open[i];
    }
    if (!usable) continue;
    best = first ? dot(rest, rest) : std::min(best, dot(rest, rest));
    first = false;
  }
  return std::sqrt(best);
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

std::vector<Vec3<long double>> bars_of(const Solid& c) {
  const Terms<long double> t = terms_of<long double>(c);
  std::vector<Vec3<long double>> bars;
  if (!t.box && t.half > 0) bars.push_back(t.half * t.axis);
  for (std::size_t i = 0; i < 3; ++i)
    if (t.box && t.halves[i] > 0) bars.push_back(t.halves[i] * t.edges[i]);
  return bars;
}

TEST(Box, PolytopesAgainstBruteForce) {
  SmallNumbers draw;
  int seen[3] = {0, 0, 0};
  const std::uint64_t many = from_environment("DAYLIGHT_BOX_PAIRS", 3000);
  for (std::uint64_t i = 0; i < many; ++i) {
    const Pair pair{draw.polytope(), draw.polytope()};
    if (!has_box(pair)) continue;
    std::vector<Vec3<long double>> bars = bars_of(pair.a);
    for (const auto& bar : bars_of(pair.b)) bars.push_back(bar);
    const Vec3<long double> delta = lifted<long double>(pair.b.center) - lifted<long double>(pair.a.center);
    const long double reach = static_cast<long double>(pair.a.rounding) + pair.b.rounding;
    constexpr long double tie_tol = 1e-10L;
    const long double distance = distance_by_faces(bars, delta) - reach;
    Verdict expected = distance > tie_tol ? apart : distance < -tie_tol ? meet : touch;
    if (reach == 0 && expected == touch) {
      // Inside the difference body, a body about 0, is what stays in it a bit farther from 0.
      long double volume = 0;
      for (const auto& x : bars)
        for (const auto& y : bars)
          for (const auto& z : bars) volume = std::max(volume, std::fabs(dot(cross(x, y), z)));
      const long double farther = distance_by_faces(bars, (1 + 1e-6L) * delta);
      if (volume > tie_tol && farther < tie_tol) expected = meet;
    }
    ++seen[static_cast<int>(expected)];
    ASSERT_STREQ(to_string(verdict_of(pair)), to_string(expected)) << format_pair(pair) << distance;
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

}  // namespace
}  // namespace cyl
