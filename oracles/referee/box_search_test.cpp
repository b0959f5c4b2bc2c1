// SPDX-License-Identifier: MIT
// The search for nearest points against duality. Points of the cores are the nearest if the gap between the
// cores along their difference is as wide as they are apart.
#include "oracles/referee/box_search.hpp"

#include <gtest/gtest.h>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/multiprecision.hpp"

namespace cyl {
namespace {

class Draw {
 public:
  double number(double lo, double hi) { return random_.between(lo, hi); }
  Solid solid() {
    Solid c;
    for (double& x : c.center) x = number(-2, 2);
    const int kind = random_.integer(0, 3);
    if (kind < 2) {
      c.shape = Shape::box;
      for (double& x : c.edges) x = number(-0.5, 3);
      for (double& x : c.edges) x = x < 0 ? 0 : x;
      for (double& x : c.quaternion) x = number(-1, 1);
      c.axis = {0, 0, 0};
    } else {
      for (double& x : c.axis) x = number(-1, 1);
      c.height = number(0, 2);
      if (kind == 2) c.radius = number(0, 1);
    }
    return c;
  }

 private:
  RandomStream random_{"box search", 20261129, 0};
};

/// Checks a result and returns whether the cores are apart.
template <class R>
bool check(const Pair& pair, int bits, const R& accuracy) {
  const TermsPair<R> p = terms_of_pair<R>(pair);
  const Simplex<R> s = search_box(p, bits, false);
  const auto outside = [](const Terms<R>& t, const Vec3<R>& x) {
    const auto [caps, wall] = beyond(t, x);
    return caps > wall ? caps : wall;
  };
  const R apart = norm(s.nearest);
  EXPECT_TRUE(outside(p.a, s.on_a()) < accuracy) << format_pair(pair);
  EXPECT_TRUE(outside(p.b, s.on_b() - p.delta) < accuracy) << format_pair(pair);
  if (!(apart > accuracy)) return false;
  const R gap = support_gap(p.a, p.b, p.delta, Vec3<R>(s.nearest / apart));
  EXPECT_TRUE(gap + apart < accuracy) << format_pair(pair);
  const Simplex<R> sign = search_box(p, bits, true);
  EXPECT_TRUE(support_gap(p.a, p.b, p.delta, sign.nearest) < R(0.0)) << format_pair(pair);
  return true;
}

TEST(BoxSearch, FindsTheNearestPoints) {
  Draw draw;
  int apart = 0;
  constexpr int pairs = 2000;
  for (int i = 0; i < pairs; ++i) {
    Pair pair{draw.solid(), draw.solid()};
    if (!has_box(pair)) continue;
    apart += check<double>(pair, 53, 1e-9);
    if (i % 20 != 0) continue;
    const PrecisionScope precision(128);
    check<MpFloat>(pair, 128, MpFloat(1e-25));
  }
  EXPECT_GT(apart, pairs / 5);
  EXPECT_LT(apart, 4 * pairs / 5);
}

TEST(BoxSearch, ScalesWildPairs) {
  const Solid big{.center = {1.7e308, 0, 0},
                  .shape = Shape::box,
                  .edges = {1e300, 1e300, 1e300},
                  .quaternion = {1e200, 1e200, 0, 0}};
  Solid other = big;
  other.center.x() = -1.7e308;
  int exponent = 0;
  const TermsPair<double> p = double_terms({big, other}, exponent);
  EXPECT_NEAR(std::ldexp(p.delta.x, exponent - 1024), -1.7e308 * 0x1p-1023, 1e-9);
  EXPECT_LT(search_box(p, 53, true).nearest.x, -1);
}

}  // namespace
}  // namespace cyl
