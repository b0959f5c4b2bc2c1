// SPDX-License-Identifier: MIT
#include "solver/literature/separation_2017.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/detail/frame.hpp"
#include "solver/solver_test.hpp"

namespace cyl::literature {
namespace {

constexpr double half = 0.5;

class Draw : public Numbers {
 public:
  Draw() : Numbers(2017) {}
  double next() { return either_sign(); }
  double length() { return 1.5 + next(); }
};

Quarter some_quarter(Draw& n) {
  const double c = n.next();
  Quarter q{};
  q.r0 = n.length();
  q.r1 = n.length();
  q.h1b1 = n.length();
  q.c1_square = c * c;
  q.a2 = n.next();
  q.b2 = n.next();
  return q;
}

/// Equation (8), in more digits.
long double wide_value(const Quarter& q, long double t) {
  const long double u = 1 - t;
  return q.r0 * std::sqrt(u * u + t * t) + q.r1 * std::sqrt(u * u + q.c1_square * t * t) + q.h1b1 * t -
         std::fabs(u * q.a2 + t * q.b2);
}

// Equation (10) is printed with 3 r0 for r0. At t = 1/2 of two equal solids it would give 2.83 r0 (3 + c^2
// ...).
TEST(Quarter2017, TheCoefficientOfEquation10IsOne) {
  const Quarter q{.r0 = 1, .r1 = 0, .h1b1 = 0, .c1_square = 0, .a2 = 0, .b2 = 0};
  constexpr long double step = 0x1p-16L;
  const long double second =
      (wide_value(q, half + step) - 2 * wide_value(q, half) + wide_value(q, half - step)) / (step * step);
  EXPECT_NEAR(static_cast<double>(second), std::sqrt(8.0), 1e-5);
}

// The slope of the term beside the kink changes sign with (1-t) a2 + t b2, not with (1-t) a2 + b2.
TEST(Quarter2017, TheKinkIsWhereDeltaIsSquareToD) {
  const Quarter q{.r0 = 0, .r1 = 0, .h1b1 = 0, .c1_square = 0, .a2 = 1, .b2 = -half};
  EXPECT_NEAR(q.value(2 / 3.0), 0, 1e-15);
  EXPECT_EQ(q.sign(0.6), 1);
  EXPECT_EQ(q.sign(0.7), -1);
  EXPECT_EQ(q.slope(0.6), 1.5);
  EXPECT_EQ(q.slope(0.7), -1.5);
}

// F is not convex there, and it is below 0 only at an end, if at all. With the kink at t = 0, Equation (9)
// is not a slope. It gives 1 for a function that falls.
TEST(Quarter2017, AKinkHidesNoSeparation) {
  const Quarter at_end{.r0 = 1, .r1 = 1, .h1b1 = 3, .c1_square = 0.25, .a2 = 0, .b2 = 4};
  EXPECT_EQ(at_end.slope(0), 1);
  EXPECT_NEAR((at_end.value(0x1p-20) - at_end.value(0)) * 0x1p20, -3, 1e-5);
  EXPECT_EQ(at_end.value(0), 2);
  EXPECT_EQ(at_end.value(1), half);
  EXPECT_LT(at_end.value(0.85), 0.47);
  Draw n;
  int kinks = 0;
  for (int i = 0; i < 20000; ++i) {
    Quarter q = some_quarter(n);
    q.a2 *= i % 2 * 4;
    q.b2 *= 4;
    if (q.sign(0) == q.sign(1) || q.value(0) < 0 || q.value(1) < 0) continue;
    ++kinks;
    for (int k = 0; k <= 32; ++k) EXPECT_GE(q.value(k / 32.0), 0);
  }
  EXPECT_GT(kinks, 1000);
}

// The equation of section 7 is Q^3 (eta_ss eta_tt - eta_st^2) = (2 Q Q_ss - Q_s^2)(2 Q Q_tt - Q_t^2) - (2 Q
// Q_st - Q_s Q_t)^2. As 4 Q^(3/2) eta_ss = 2 Q Q_ss - Q_s^2, the right side is 16 times the left. Both are 0
// for unit axes.
TEST(Octant2017, TheDeterminantNeedsASixteenth) {
  const double a = 0.3, b = 0.4, c = half;  // not of unit length
  const double s = 0.2, t = 0.3, u = half;
  const double l = a * s + b * t + c * u, q = s * s + t * t + u * u - l * l;
  const double qs = 2 * s - 2 * u - 2 * (a - c) * l, qt = 2 * t - 2 * u - 2 * (b - c) * l;
  const double qss = 4 - 2 * (a - c) * (a - c), qst = 2 - 2 * (a - c) * (b - c),
               qtt = 4 - 2 * (b - c) * (b - c);
  const auto eta = [&](long double x, long double y) {
    const long double z = 1 - x - y, along = a * x + b * y + c * z;
    return std::sqrt(x * x + y * y + z * z - along * along);
  };
  constexpr long double e = 0x1p-16L;
  const long double here = eta(s, t), ss = (eta(s + e, t) - 2 * here + eta(s - e, t)) / (e * e),
                    tt = (eta(s, t + e) - 2 * here + eta(s, t - e)) / (e * e),
                    st = (eta(s + e, t + e) - eta(s + e, t - e) - eta(s - e, t + e) + eta(s - e, t - e)) /
                         (4 * e * e);
  const double left = q * q * q * static_cast<double>(ss * tt - st * st);
  const double right =
      (2 * q * qss - qs * qs) * (2 * q * qtt - qt * qt) - (2 * q * qst - qs * qt) * (2 * q * qst - qs * qt);
  EXPECT_GT(std::fabs(right), 0.01);
  EXPECT_NEAR(16 * left, right, 1e-6);
}

// By section 3.1, touching solids may count as apart or as meeting. The text's code mixes both.
TEST(Separation2017, TouchingIsApartWhereAsked) {
  const Solid a{{0, 0, 0}, {0, 0, 1}, 1, 2};
  const Solid above{{0, 0, 2}, {0, 0, 1}, 1, 2}, beside{{2, 0, 0}, {0, 0, 1}, 1, 2},
      on_top{{0, 0, 2}, {1, 0, 0}, 1, 2}, disk{{3, 0, 0}, {0, 1, 0}, 2, 0};
  // In one plane: f(D) = 0 for the D square to it, though D.Delta = 0, and though Delta = 0.
  const Solid flat{{0, 0, 0}, {0, 0, 1}, 1, 0}, flat_beside{{1, 0, 0}, {0, 0, 1}, 2, 0},
      rod{{0, 0, 0}, {0, 0, 1}, 0, 2}, cross{{0, 0, 0}, {1, 0, 0}, 0, 2}, in_it{{0, 0, 0}, {1, 0, 0}, 0, 1};
  const Options apart{.touching_apart = true},
      mixed{.faults = Fault::mixed_strictness, .touching_apart = true};
  const auto ask = [](const Solid& x, const Solid& y, const Options& options) {
    return separated_cylinders(prepare(x), prepare(y), options).verdict;
  };
  for (const auto& [x, y] : {std::pair(a, above),
                             {a, beside},
                             {a, on_top},
                             {a, disk},
                             {flat, flat},
                             {flat, flat_beside},
                             {flat, in_it},
                             {rod, cross},
                             {rod, rod}}) {
    EXPECT_EQ(ask(x, y, {}), Verdict::intersecting);
    EXPECT_EQ(ask(x, y, apart), Verdict::disjoint);
  }
  for (const Solid& b : {above, beside}) EXPECT_EQ(ask(a, b, mixed), Verdict::intersecting);
  EXPECT_EQ(ask(a, disk, mixed), Verdict::disjoint);
}

}  // namespace
}  // namespace cyl::literature
