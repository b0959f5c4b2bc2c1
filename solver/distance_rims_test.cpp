// SPDX-License-Identifier: MIT
// The distance between rims that are hard to bring near: small on large, nearly tangent, at the border of a
// cap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/distance.hpp"
#include "solver/solver_test.hpp"

namespace cyl {
namespace {

// On these pairs Newton once ended at a point that is not a minimum. Or rounding hid the y component beside
// tangents that are nearly parallel. If the solids are apart, a direction and two points enclose the value,
// evaluated to 60 digits. The depth is the referee's, or minus the offset by which the pair was put
// together.
TEST(Distance, SmallRimsAndSquareAxes) {
  const struct {
    Pair pair;
    double value, within;
  } all[] = {
      // A small rim on a large one: apart
      {{{{0, 0, 0}, {0.1837, -0.878, -0.44201}, 100, 89.89},
        {{-54.05, 72.26, -63.69}, {0.3308, -0.9004, -0.2826}, 0.7356, 0.57}},
       0.127549373410939,
       0},
      {{{{0, 0, 0},
         {-0.8389184817084105, 0.5440517134473581, 0.01495038939455838},
         0.5268852178886755,
         0.04400862499006849},
        {{0.30095879302822165, 0.4197724716161029, 0.10785258075573816},
         {-0.932296959775015, 0.36105375706871196, 0.021507284831693875},
         0.0018329794088248962,
         0.000890346739918793}},
       6.14906795e-12,
       0},
      // with points that were far from near
      {{{{0, 0, 0},
         {-0.1589747528877893, -0.9862981191318759, -0.04408001975033986},
         4.91313560348984,
         22.30256266265774},
        {{5.869565134306877, 10.456920418857935, -2.1661364359060773},
         {0.37005236947877557, 0.9208258775449714, -0.12304855580898665},
         0.0006670614144995772,
         2.9466956848995144e-05}},
       1.07122954e-09,
       0},
      // and deeper than the offset.
      {{{{0, 0, 0},
         {0.18366616220396434, -0.8780057539132201, -0.4420097702048507},
         0.01194690333189838,
         0.010704932914954886},
        {{-0.006388478579346178, 0.008604470766151959, -0.007591690600788815},
         {0.5921967904036941, -0.8001298288691671, 0.09600997679729466},
         0.00011367474015959495,
         4.6438252407998336e-05}},
       -6.501262156e-6,
       1.1e-11},
      // Square axes: a wall on the border of a cap, a segment over the border of a disk.
      {{{{0, 0, 0},
         {0.7808603589341332, 0.38308706998653913, 0.4934586068297777},
         0.7061452875395611,
         0.6933681565296432},
        {{-1.388220888750376, 0.7818358346324705, -2.3901987013622117},
         {-0.5320382091031516, 0.8217972215591312, 0.2039231980231858},
         2.602371264855791,
         0.3750696429489104}},
       0,
       5e-14},
      {{{{2.79854699301362, -2.966946955420244, -3.3099485589909095},
         {0.6048725658515149, 0.6658237042342142, 0.43681572082519426},
         0,
         4.951707320710586},
        {{3.847804645521855, -4.298522252147915, -2.7332128418191957},
         {0.4764264462115886, 0.1369569939974139, -0.8684817920632466},
         1.781302328198025,
         0.36671784774327104}},
       7.007602e-10,
       0},
      {{{{-3.0051461693109545, 2.1356173086599277, -1.4952543266585625},
         {-0.31073939315450694, 0.7751416775285321, -0.5500876378362103},
         0,
         0.16611590630250017},
        {{-0.9218379208843901, -0.9323993778755355, -7.0841256453367825},
         {0.8975252030408405, 0.4297921292652436, 0.09862674854290833},
         6.707160010440291,
         0}},
       2.815238642e-08,
       0},
  };
  for (const auto& k : all) {
    const auto which = &k - all;
    const Distance d = distance(k.pair.a, k.pair.b);
    EXPECT_NEAR(d.value, k.value, k.within + 8e-15 * reach_of(k.pair)) << "pair " << which;
    EXPECT_LE(d.error, 1e-14 * reach_of(k.pair)) << "pair " << which;
    if (k.value > 0) {
      EXPECT_EQ(d.verdict, Verdict::disjoint) << "pair " << which;
    }
  }
}

// One search starts on a saddle, by symmetry: if it stayed there, the answer would be 0.002 too deep.
TEST(Distance, SaddleIsLeft) {
  const Distance d = distance(Solid{{-1, 2, 1}, {0, 0, -2}, 3, 2}, Solid{{-1, 0, 1}, {-1, 0, 2}, 3, 2});
  EXPECT_NEAR(d.value, -3.2336479117, 1e-9);
}

// Two minima in one patch: a search from its lowest point known ends at the other one. A direction of f as
// low is known in rationals.
TEST(Distance, SquareAxesHaveTwoMinimaInOnePatch) {
  const struct {
    Pair pair;
    double depth;
  } all[] = {{{{{0, 0, 0}, {0, 0, 1}, 7, 8}, {{-7, -10, 10}, {-10, -1, 0}, 11, 11}}, 4.32811},
             {{{{0, 0, 0}, {14, 14, -1}, 15, 4}, {{-13, 6, -7}, {11, -13, -11}, 9, 0}}, 6.24063}};
  for (const auto& [pair, depth] : all) {
    const Distance d = distance(pair.a, pair.b);
    EXPECT_LE(-d.value, depth);
    EXPECT_GE(-d.value, depth - 3e-5);
  }
}

// Rims nearly equal, axes at 60 to 83 degrees. A search that ended early once left the direction beside the
// minimum. The depths were larger by up to 7e-4 of the reach, and points lay outside their solids.
TEST(Distance, NearlyEqualRimsAtObliqueAxes) {
  const struct {
    Pair pair;
    double depth;
  } all[] = {
      {{{{0, 0, 0},
         {0.18133535965845501, 0.30383064146529676, 0.93530980356474669},
         0.12702752991192912,
         0.17562605564114292},
        {{-0.073029142714919601, 0.07733274794392403, -0.09561795317548516},
         {0.7197499523472457, 0.24808105428121652, -0.64839478452780419},
         0.12701457830509125,
         0.0053015671786509552}},
       0.12523531462880511},
      {{{{0, 0, 0},
         {-0.7545763991975903, -0.00600862277282119, 0.6573347162285029},
         0.19218066042144974,
         0.8527686786225984},
        {{-0.41433489394004375, 0.0620916308994823, 0.1472369485614918},
         {-0.5435111029947447, -0.8201987967735465, 0.1255710084974204},
         0.1941768028341776,
         0.000904561994824203}},
       0.18538800582668807},
  };
  const auto expect_points_inside = [](const Pair& p, const Distance& d) {
    EXPECT_LE(outside(p.a, d.on_a), 1e-13 * reach_of(p));
    EXPECT_LE(outside(p.b, d.on_b), 1e-13 * reach_of(p));
  };
  for (const auto& [pair, depth] : all) {
    const Distance d = distance(pair.a, pair.b);
    EXPECT_NEAR(d.value, -depth, 1e-14 * reach_of(pair));
    expect_points_inside(pair, d);
  }
  Numbers random(20261128);
  int overlaps = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vector3 w0 = random.vector().normalized(), across = w0.cross(random.vector()).normalized();
    const double cosine = random.between(0.12, 0.7);
    const Vector3 w1 = cosine * w0 + std::sqrt(1 - cosine * cosine) * across;
    const double radius = 1 + std::pow(10, -random.between(2, 16));
    const double h0 = std::pow(10, random.between(-4, 1)), h1 = std::pow(10, random.between(-4, 1));
    const Vector3 off =
        h0 / 2 * random.either_sign() * w0 + h1 / 2 * random.either_sign() * w1 + random.vector();
    const Pair p = {{Vector3(0, 0, 0), w0, 1, h0}, {off, w1, radius, h1}};
    const Distance d = distance(p.a, p.b);
    if (!(d.value < 0)) continue;
    ++overlaps;
    expect_points_inside(p, d);
  }
  EXPECT_GT(overlaps, 3000);
}

struct Together {
  Pair pair;
  double offset;  // apart the distance; overlapping at least minus the depth
};

// Two rims put together at a point of each with the normal n, by an offset along n. `most`: of the second
// radius and of the offset over it, in powers of two.
Together put_together(Numbers& random, int i, int most) {
  auto unit = [&] {
    Vector3 v(0, 0, 0);
    while (!(v.norm() > 0.1))
      for (double& x : v) x = random.either_sign();
    return Vector3(v.normalized());
  };
  auto small = [&](int from, int to) {
    const double mantissa = random.between(0.5, 1);
    return std::ldexp(mantissa, -static_cast<int>(random.between(from, to)));
  };
  const Vector3 first = unit(), second = unit(), third = unit();
  const double slant = random.between(0.035, 0.577), near = small(0, 12);
  Vector3 w0 = first, w1 = (w0 + slant * w0.cross(second).normalized()).normalized();
  const Vector3 n = i % 3 ? third : Vector3((w0 + near * third).normalized());
  if (n.dot(w0) < 0) w0 = -w0;
  if (n.dot(w1) > 0) w1 = -w1;
  const double r0 = 1, r1 = small(-most, 10 - most), h0 = small(-3, 6);
  const double h1 = r1 * small(-4, 6), offset = (i % 2 ? 1 : -1) * r1 * small(-2, 5);
  // By way of the tangents, so as to be square to the axes to the last digit.
  const Vector3 u0 = w0.cross(n.cross(w0).normalized()), u1 = w1.cross((-n).cross(w1).normalized());
  const Vector3 off0 = h0 / 2 * w0 + r0 * u0, off1 = h1 / 2 * w1 + r1 * u1;
  return {{{Vector3(0, 0, 0), w0, r0, h0}, {off0 + offset * n - off1, w1, r1, h1}}, offset};
}

TEST(Distance, SmallRimsPutTogether) {
  Numbers random(20261122);
  int wrong = 0, wide = 0, deep = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto [p, offset] = put_together(random, i, -3);
    const Distance d = distance(p.a, p.b);
    const double rounding = 1e-14 * reach_of(p);
    if (offset > 0) {
      wrong += d.verdict != Verdict::disjoint || std::fabs(d.value - offset) > d.error + rounding;
      wide += d.error > rounding;
    } else {
      deep += d.value < offset - d.error - rounding;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(wide, 0);
  EXPECT_EQ(deep, 0);
}

// A depth that is reported as least is not deeper than the offset by which the pair was put together. Nor is
// it deeper than the depth in other directions.
TEST(Distance, LeastDepthIsNoDeeperThanAnyKnown) {
  Numbers random(20261123);
  int least = 0, deep = 0;
  for (int i = 0; i < 80000; i += 2) {
    const auto [p, offset] = put_together(random, i, 1);
    const Distance d = distance(p.a, p.b);
    if (!d.least) continue;
    ++least;
    deep += d.value < offset - 4 * d.error - 1e-14 * reach_of(p);
  }
  EXPECT_GT(least, 4000);
  EXPECT_EQ(deep, 0);
}

// By caps, by sides, of parallel solids; of two capsules whose segments are apart.
TEST(Distance, SaysWhetherADepthIsLeast) {
  const Solid a{{0, 0, 0}, {0, 0, 1}, 1, 2};
  EXPECT_TRUE(distance(a, Solid{{0.3, 0.1, 1.9}, {0, 0.1, 1}, 0.2, 2}).least);
  EXPECT_TRUE(distance(a, Solid{{1.5, 0, 0}, {0, 1, 0}, 1, 2}).least);
  EXPECT_TRUE(distance(a, Solid{{1, 0, 0.5}, {0, 0, 1}, 1, 2}).least);
  EXPECT_FALSE(distance(a, Solid{{5, 0, 0}, {0, 1, 0}, 1, 2}).least);
  EXPECT_TRUE(distance(Solid{{0, 0, 0}, {0, 0, 1}, 0, 2, 1}, Solid{{1, 0, 0}, {0, 1, 0}, 0, 2, 1}).least);
}

}  // namespace
}  // namespace cyl
