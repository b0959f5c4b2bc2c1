// SPDX-License-Identifier: MIT
#include "solver/seeds/separation_2008_circle.hpp"

#include <algorithm>

#include "solver/seeds/real_roots.hpp"

namespace cyl::seeds {
namespace {

// G' rises: Newton's steps from a root of the polynomial, which the squarings have blurred.
double polish(const Circle& q, double x, double k, int steps) noexcept {
  for (int i = 0; i < steps; ++i) {
    const double step = (q.rise(x) - k) / q.bend(x);
    if (!(std::fabs(step) > 0x1p-53 * std::fabs(x))) break;
    x -= step;
  }
  return x;
}

bool separated_at(const Circle& q, double x, double k, const Options& options, Finder& finder) noexcept {
  // G'(x) = 0 asks that x and k have one sign.
  x = polish(q, x, std::copysign(k, x), options.step_cap);
  return finder.separates(q.direction(x, 1));
}

// (a) The four sign cases have two values of |k|; the squared equation does not see its sign. That a critical
// point has the signs assumed need not be tested: f itself is asked there.
bool separated_by_roots(const Circle& q, bool even, const Options& options, Finder& finder) noexcept {
  if (!options.faults.has(Fault::tangent_line_misses_u0) && finder.separates(q.u0)) return true;
  const double along = options.faults.has(Fault::derivative_of_the_wrong_term) ? q.b2 : q.a2;
  for (const double sigma1 : {1.0, -1.0}) {
    const double k = along - sigma1 * q.side;
    const auto c = critical_polynomial(q, k);
    if (even) {
      const auto squares = real_roots<4>(c, options.tolerance);
      for (int i = 0; i < squares.count; ++i) {
        const double square = squares.x[static_cast<std::size_t>(i)];
        if (!(square > 0)) continue;
        for (const double sign : {1.0, -1.0})
          if (separated_at(q, sign * std::sqrt(square), k, options, finder)) return true;
      }
    } else {
      const auto roots = real_roots<8>({c[0], 0, c[1], 0, c[2], 0, c[3], 0, c[4]}, options.tolerance);
      for (int i = 0; i < roots.count; ++i)
        if (separated_at(q, roots.x[static_cast<std::size_t>(i)], k, options, finder)) return true;
    }
  }
  return false;
}

// (b) A disk about the origin against what is left of the other solid about (a2, b2).
bool separated_in_projection(const Circle& q, const Options& options, Finder& finder) noexcept {
  for (const PlaneVector v : {from_rectangle(q), from_ellipse(q, options)})
    if (finder.separates(q.direction(v.x, v.y))) return true;
  return false;
}

// (c) On the line D = e + t e', e along Delta's projection, the last term is constant and F convex.
bool separated_in_valley(const Circle& q, const Options& options, Finder& finder) noexcept {
  const double reach = std::hypot(q.a2, q.b2);
  if (!(reach > 0)) return false;
  const Eigen::Vector2d e(q.a2 / reach, q.b2 / reach);
  Eigen::Vector2d low(e.y(), -e.x()), high = -low, d = e;
  for (int i = 0; i < options.step_cap; ++i) {
    if (finder.separates(q.direction(d.x(), d.y()))) return true;
    if ((high - low).cwiseAbs().maxCoeff() <= options.tolerance) break;
    // The gradient of the first three terms; of a term that vanishes, the subgradient 0.
    const double length0 = std::hypot(d.x(), d.y()), length1 = std::hypot(q.c * d.x(), d.y());
    const double share1 = length1 > 0 ? q.r1 / length1 : 0;
    const double sign = d.x() > 0 ? 1 : d.x() < 0 ? -1 : 0;
    const double gx = d.x() * (q.r0 / length0 + q.c * q.c * share1) + sign * q.side - q.a2;
    const double gy = d.y() * (q.r0 / length0 + share1) - q.b2;
    (gy * e.x() - gx * e.y() > 0 ? high : low) = d;
    d = (low + high).normalized();
  }
  return false;
}

}  // namespace

double Circle::bend(double x) const noexcept {
  const double q0 = 1 + x * x, q1 = 1 + c * c * x * x;
  return r0 / (q0 * std::sqrt(q0)) + r1 * c * c / (q1 * std::sqrt(q1));
}

// L0 = r0 x, L1 = r1 c^2 x, Q0 = 1 + x^2, Q1 = 1 + c^2 x^2:
// 4 L0^2 L1^2 Q0 Q1 - (k^2 Q0 Q1 - L0^2 Q1 - L1^2 Q0)^2, in the unit of its largest length.
std::array<double, 5> critical_polynomial(const Circle& q, double k) noexcept {
  const double unit = std::max({q.r0, q.r1, std::fabs(k)});
  if (!(unit > 0)) return {};
  const double c2 = q.c * q.c, r0 = q.r0 / unit, r1 = c2 * (q.r1 / unit);
  const double r02 = r0 * r0, r12 = r1 * r1, k2 = (k / unit) * (k / unit);
  const double i0 = k2, i1 = k2 * (1 + c2) - r02 - r12, i2 = c2 * (k2 - r02) - r12;
  const double g = 4 * r02 * r12;
  return {-i0 * i0, -2 * i0 * i1, g - i1 * i1 - 2 * i0 * i2, g * (1 + c2) - 2 * i1 * i2, g * c2 - i2 * i2};
}

PlaneVector from_rectangle(const Circle& q) noexcept {
  return {std::copysign(larger(std::fabs(q.a2) - q.side, 0), q.a2),
          std::copysign(larger(std::fabs(q.b2) - q.r1, 0), q.b2)};
}

// In the unit r1 the ellipse about (side, 0) has half axes c and 1. The point of it nearest to an outer (u,
// v) is (c^2 u/(t + c^2), v/(t + 1)) with the one t > 0 that puts it there, the largest root.
PlaneVector from_ellipse(const Circle& q, const Options& options) noexcept {
  if (!(q.r1 > 0) || !(q.c > 0)) return {};
  const double u = (std::fabs(q.a2) - q.side) / q.r1, v = std::fabs(q.b2) / q.r1;
  if (!(u > 0)) return {};  // the rectangle is nearer
  const double c2 = q.c * q.c, u2 = c2 * u * u, v2 = v * v;
  const auto roots = real_roots<4>({u2 + c2 * c2 * (v2 - 1), 2 * u2 + 2 * c2 * (v2 - 1 - c2),
                                    u2 + v2 - 1 - c2 * (4 + c2), -2 - 2 * c2, -1},
                                   options.tolerance);
  double t = 0;
  for (int i = 0; i < roots.count; ++i) t = larger(t, roots.x[static_cast<std::size_t>(i)]);
  for (int i = 0; i < options.step_cap; ++i) {
    const double m = 1 / (t + c2), n = 1 / (t + 1);
    const double step = (u2 * m * m + v2 * n * n - 1) / (2 * (u2 * m * m * m + v2 * n * n * n));
    const double next = larger(t + step, 0);
    if (!(std::fabs(next - t) > 0x1p-53 * t)) break;
    t = next;
  }
  const double x = u / (t + c2), y = v / (t + 1), size = std::hypot(x, y);
  return {std::copysign(x / size, q.a2), std::copysign(y / size, q.b2)};
}

bool separated_on_circle(const Solids& solids, int i, CircleWay way, const Options& options,
                         Finder& finder) noexcept {
  const Circle circle(solids, i);
  switch (way) {
    case CircleWay::polynomial:
      return separated_by_roots(circle, false, options, finder);
    case CircleWay::even_polynomial:
      return separated_by_roots(circle, true, options, finder);
    case CircleWay::projection:
      return separated_in_projection(circle, options, finder);
    case CircleWay::minimise:
      return separated_in_valley(circle, options, finder);
  }
  return false;
}

}  // namespace cyl::seeds
