// SPDX-License-Identifier: MIT
// Section 8 (and 5) of the text of 2008: the directions perpendicular to one axis.
#pragma once

#include "solver/literature/separation_2008.hpp"
#include "solver/literature/solids.hpp"

namespace cyl::literature {

/// f on the circle D = x U0 + y V0 with U0 = n x W0 and V0 = n ("0" is the solid whose axis is meant):
///
///     r0 sqrt(x^2 + y^2) + r1 sqrt(c^2 x^2 + y^2) + side |x| - |a2 x + b2 y|.
struct Circle {
  Circle(const Solids& p, int i) noexcept
      : r0(p.r[i]),
        r1(p.r[1 - i]),
        c(std::fabs(p.cosine)),
        side(p.h[1 - i] * p.sine),
        a2(dot(p.delta, p.u[i])),
        b2(dot(p.delta, p.n)),
        u0(p.u[i]),
        v0(p.n) {}

  Vector3 direction(double x, double y) const noexcept { return x * u0 + y * v0; }

  double r0, r1, c;
  double side;    ///< half the height of solid 1, seen along U0
  double a2, b2;  ///< Delta along U0 and V0
  Vector3 u0, v0;
};

/// F(x) of section 8 on the tangent line D = x U + V of that circle, V = v[0] U0 + v[1] V0 of length 1:
///
///     r0 sqrt(x^2 + 1) + r1 sqrt(q2 x^2 + 2 q1 x + q0) + side |a1 x + b1| - |a2 x + b2|.
struct TangentLine {
  TangentLine(const Circle& circle, double v_x, double v_y) noexcept;

  /// The first two terms of G'(x).
  double rise(double x) const noexcept;
  /// G''(x).
  double bend(double x) const noexcept;
  /// G'(x) = 0, squared twice: coefficients of 1, x, .., x^8. With the signs sigma_i of the last two terms,
  /// G'(x) - rise(x) is -k, k = sigma2 a2 - sigma1 side a1. k counts by its square.
  std::array<double, 9> critical_polynomial(double k) const noexcept;
  Vector3 direction(double x) const noexcept { return x * u + v; }

  double r0, r1, side, q2, q1, q0, a1, b1, a2, b2;
  Vector3 u, v;
};

/// Whether a direction perpendicular to W_i separates.
bool separated_on_circle(const Solids& solids, int i, CircleWay way, const Options& options,
                         Finder& finder) noexcept;

}  // namespace cyl::literature
