// SPDX-License-Identifier: MIT
// Section 8 (and 5) of the text of 2008: the directions perpendicular to one axis.
#pragma once

#include "solver/seeds/separation_2008.hpp"
#include "solver/seeds/solids.hpp"

namespace cyl::seeds {

/// f on the circle D = x U0 + y V0, with U0 = n x W0 and V0 = n ("0" is the solid whose axis is meant):
///
///     r0 sqrt(x^2 + y^2) + r1 sqrt(c^2 x^2 + y^2) + side |x| - |a2 x + b2 y|.
///
/// The text's line is y = 1; its A0, B0, a1, b1 are here P1 U0 of length c, n, +-s and 0.
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
  /// G'(x) + k, where k = sigma2 a2 - sigma1 side is what the signs make of the last two terms.
  double rise(double x) const noexcept {
    return r0 * x / std::sqrt(1 + x * x) + r1 * c * c * x / std::sqrt(1 + c * c * x * x);
  }
  /// G''(x).
  double bend(double x) const noexcept;

  double r0, r1, c;
  double side;    ///< half the height of solid 1, seen along U0
  double a2, b2;  ///< Delta along U0 and V0
  Vector3 u0, v0;
};

/// The square of both sides, twice, of G'(x) = 0, as c[0] + c[1] X + .. + c[4] X^4 in X = x^2.
std::array<double, 5> critical_polynomial(const Circle& circle, double k) noexcept;

/// The vector from the projection of solid 1 to that of the centre of solid 0, onto the plane of the circle;
/// (0, 0) where it is inside. `of` is the part of the projection that was asked.
struct PlaneVector {
  double x = 0, y = 0;
};
PlaneVector from_rectangle(const Circle& circle) noexcept;
/// From the elliptical cap on the centre's side; its direction alone, the length is 1.
PlaneVector from_ellipse(const Circle& circle, const Options& options) noexcept;

/// Whether a direction perpendicular to W_i separates.
bool separated_on_circle(const Solids& solids, int i, CircleWay way, const Options& options,
                         Finder& finder) noexcept;

}  // namespace cyl::seeds
