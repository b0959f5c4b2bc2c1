// SPDX-License-Identifier: MIT
#include "solver/literature/separation_2008.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/literature/separation_2008_circle.hpp"
#include "solver/literature/separation_2008_interior.hpp"

namespace cyl::literature {
namespace {

constexpr Options careful{.faults = {}, .step_cap = 60, .tolerance = 1e-3};

Solids solids_of(const Solid& a, const Solid& b) {
  const Couple<double> p = scale(prepare(a), prepare(b)).couple();
  return Solids(p, Axes({p.w0x, p.w0y, p.w0z}, {p.w1x, p.w1y, p.w1z}));
}

Verdict ask(const Solid& a, const Solid& b, CircleWay circle, const Options& options) {
  return separation_2008(prepare(a), prepare(b), circle, options).verdict;
}

/// All ways agree, in either order, and the direction separates.
void expect(Verdict verdict, const Solid& a, const Solid& b) {
  for (const CircleWay circle : {CircleWay::polynomial, CircleWay::projection}) {
    const Separation found = separation_2008(prepare(a), prepare(b), circle, careful);
    EXPECT_EQ(found.verdict, verdict) << static_cast<int>(circle);
    EXPECT_EQ(ask(b, a, circle, careful), verdict);
    if (verdict != Verdict::disjoint) continue;
    EXPECT_LT(solids_of(a, b).gap(found.direction), 0);
    EXPECT_GT(found.direction.dot(b.center - a.center), 0);
  }
}

const Solid upright{{0, 0, 0}, {0, 0, 1}, 1, 2};

// G falls all along the text's line, to f(U0) = 0.
TEST(Separation2008, GapThatVanishesAtU0) {
  expect(Verdict::disjoint, {{-1, 1, 3}, {0, 0, -1}, 3, 3}, {{3, -3, 3}, {0, 1, 0}, 1, 2});
}

Verdict literally(const Solid& a, const Solid& b, Faults faults) {
  return ask(a, b, CircleWay::polynomial, {.faults = faults, .tolerance = 1e-3, .literal = true});
}

// For two segments in one plane, G' is 0 all along the line, and its polynomial has no roots. So V0 has to
// be tested.
TEST(Literal2008, VIsTested) {
  const Solid point{{0, 0, 0}, {0, 0, 1}, 0, 0}, segment{{0, 0, 1}, {0, 1, 1}, 0, 4};
  EXPECT_EQ(literally(point, segment, {}), Verdict::disjoint);
}

// As printed, except for the derivative. x = 0 is a root of this pair's polynomial.
TEST(Literal2008, ARootAtZeroIsARoot) {
  const Solid a{{0, 0, 0}, {0, 0, 1}, 2, 1}, b{{0, 6, -2}, {0, 1, 1}, 2, 7};
  EXPECT_EQ(literally(a, b, printed_2008.without(Fault::derivative_of_the_wrong_term)), Verdict::disjoint);
}

// A fault in the distance of parallel axes has no effect on axes at an angle, small as it may be.
TEST(Literal2008, AxesAreParallelIfTheirProductIsZero) {
  const Solid a{{0, 0, 0}, {0, 0, 1}, 1, 2e9};
  for (const double angle : {0.0, 1e-16})
    EXPECT_EQ(literally(a, {{3, 0, 1e9}, {angle, 0, 1}, 1, 2e9}, Fault::cancelling_distance),
              angle > 0 ? Verdict::disjoint : Verdict::intersecting);
}

// Separated if and only if |phi|^2 > (r0 + r1)^2, both ways: at any angle the end disks reach along phi.
TEST(Separation2008, BothDeterminantsZeroDecides) {
  for (const Vector3& axis : {Vector3(0, 1, 0), Vector3(0, 3, 4), Vector3(0, -4, 3)})
    for (const double distance : {0.5, 2.999, 3.0, 3.001, 7.0}) {
      const Vector3 w = axis.normalized();
      const Solid b{Vector3(distance, 0, 1) + 1.5 * w, w, 2, 3};
      const SmoothGap g(solids_of(upright, b), 1, dot(prepare(b).unit_axis, w) > 0 ? 1 : -1);
      EXPECT_NEAR(g.phi.norm(), distance, 1e-15);
      expect(distance > 3 ? Verdict::disjoint : Verdict::intersecting, upright, b);
    }
}

// phi along the bisector of the axes and equal radii: g0 is least on the whole arc from W0 to W1. If the
// radii differ, it is not least at W.
TEST(Separation2008, EqualEigenvalues) {
  const Vector3 axis0(std::sin(0.6), 0, std::cos(0.6)), axis1(std::sin(0.6), 0, -std::cos(0.6));
  const Solids unequal = solids_of({{0, 0, 0}, axis0, 1, 2}, {axis0 + axis1 + Vector3(0, 0, 3), axis1, 3, 2});
  const SmoothGap h(unequal, 1, 1);
  EXPECT_TRUE(solve_adjugate(h.system, {}).equal);
  const double size = h.phi.norm() / 3;  // a solid's unit is not ours
  EXPECT_NEAR((h.value(h.w) + h.phi.norm()) / size, 2.2585698935801415, 1e-9);
  EXPECT_NEAR((h.value(unequal.w[1] / dot(unequal.w[1], h.w)) + h.phi.norm()) / size, 1.1292849467900705,
              1e-9);
  const Vector3 w0 = Vector3(1, 0, 2).normalized(), w1 = Vector3(1, 0, -2).normalized();
  for (const double distance : {0.3, 3.0}) {
    const Solid a{{0, 0, 0}, w0, 1, 2}, b{w0 + w1 + Vector3(0, 0, distance), w1, 1, 2};
    const Solids solids = solids_of(a, b);
    const SmoothGap g(solids, 1, 1);
    const CriticalPairs pairs = solve_adjugate(g.system, {});
    EXPECT_TRUE(pairs.equal);
    EXPECT_EQ(pairs.count, 0);
    const double least = g.value(g.w), at_w0 = g.value(solids.w[0] / dot(solids.w[0], g.w));
    EXPECT_NEAR(least, at_w0, 1e-14 * (1 + std::fabs(least)));
    for (double x = -2; x <= 2; x += 0.25)
      for (double y = -2; y <= 2; y += 0.25) EXPECT_GE(g.value(g.w + x * g.u + y * g.v), least - 1e-14);
    EXPECT_EQ(ask(a, b, CircleWay::projection, careful),
              ask(a, b, CircleWay::projection, with(careful, Fault::equal_eigenvalues)));
  }
}

const Solid oblique{{3, -2, 1}, {1, 0.5, 0.3}, 0.7, 1.5};

// The term printed, sigma2 b2, is not the derivative.
TEST(Separation2008, LastTermOfTheDerivativeIsA2) {
  const TangentLine line(Circle(solids_of(upright, oblique), 0), 0.6, -0.8);
  const double x = 5, h = 1e-5, sigma1 = line.a1 * x + line.b1 > 0 ? 1 : -1,
               sigma2 = line.a2 * x + line.b2 > 0 ? 1 : -1;
  const auto f = [&](double t) { return solids_of(upright, oblique).gap(line.direction(t)); };
  const double slope = (f(x + h) - f(x - h)) / (2 * h);
  EXPECT_NEAR(slope, line.rise(x) + sigma1 * line.side * line.a1 - sigma2 * line.a2, 1e-8);
  EXPECT_GT(std::fabs(slope - (line.rise(x) + sigma1 * line.side * line.a1 - sigma2 * line.b2)), 0.1);
}

// |A0 x + B0| = 0 asks for perpendicular axes and is W1 itself, which section 7 has tested: no verdict hangs
// on the text's reason.
TEST(Separation2008, VanishingTermIsTheOtherAxis) {
  const Solids p = solids_of(upright, {{3, -2, 1}, {1, 0.5, 0}, 0.7, 1.5});
  const TangentLine line(Circle(p, 0), 0.6, -0.8);
  const double x = -line.q1 / line.q2;
  EXPECT_LT((line.q2 * x + 2 * line.q1) * x + line.q0, 1e-15);
  EXPECT_NEAR(std::fabs(line.direction(x).normalized().dot(p.w[1])), 1, 1e-15);
}

// If g0(D) < 0, D.W0 >= 0 and D.W1 >= 0, then D.Delta >= 0 follows. So step 4 is complete without it.
TEST(Separation2008, ThirdInequalityFollows) {
  const Solids p = solids_of(upright, oblique);
  for (const double sign0 : {1.0, -1.0})
    for (const double sign1 : {1.0, -1.0}) {
      const SmoothGap g(p, sign0, sign1);
      for (double x = -3; x <= 3; x += 0.125)
        for (double y = -3; y <= 3; y += 0.125) {
          const Vector3 d = g.w + x * g.u + y * g.v;
          const bool inside = sign0 * d.dot(p.w[0]) >= 0 && sign1 * d.dot(p.w[1]) >= 0;
          EXPECT_TRUE(g.value(d) >= 0 || !inside || d.dot(p.delta) > 0);
        }
    }
}

// A pair (eta0, eta1) and its negative have the same direction; the same signs along both A_i^T D, either
// two, make it critical.
TEST(Separation2008, CriticalPointsComeWithEitherSign) {
  int positive = 0, negative = 0;
  const auto count = [&](const Solids& p) {
    for (const double sign1 : {1.0, -1.0}) {
      const SmoothGap g(p, 1, sign1);
      const CriticalPairs pairs = solve_adjugate(g.system, {});
      for (int i = 0; i < pairs.count; ++i) {
        Vector3 d = g.direction(pairs.eta0[i], pairs.eta1[i]);
        EXPECT_LT((d - g.direction(-pairs.eta0[i], -pairs.eta1[i])).norm(), 1e-14);
        d /= d.dot(g.w);
        const double along0 = pairs.eta0[i].dot(Vector2(p.u[0].dot(d), p.n.dot(d)));
        const double along1 = pairs.eta1[i].dot(Vector2(p.u[1].dot(d), p.n.dot(d)));
        if (along0 * along1 < 0) continue;
        EXPECT_LT(g.newton_step(d).norm(), 1e-9 * d.norm());
        ++(along0 > 0 ? positive : negative);
        SmoothGap companion = g;  // with xi = (x, y, -1) the same pair has -D, and the other signs
        companion.w = -g.w;
        EXPECT_LT((companion.direction_by_equations(pairs.eta0[i], pairs.eta1[i]) + d).norm(),
                  1e-9 * d.norm());
      }
    }
  };
  for (double angle = 0.2; angle < 1.5; angle += 0.1)
    count(solids_of({{0, 0, 0}, {0, 0, 1}, 5, 0.5}, {{-2, -9, 4}, {angle, -0.3, -0.7}, 6, 0.2}));
  for (double z = -5; z < 5; z += 0.25)
    count(solids_of({{0, 0, 0}, {-0.7, 0.64, -0.4}, 3.2, 0.1}, {{2.5, -0.8, z}, {1, 0.05, 0.03}, 2, 0.1}));
  EXPECT_GT(positive, 0);
  EXPECT_GT(negative, 0);
}

}  // namespace
}  // namespace cyl::literature
