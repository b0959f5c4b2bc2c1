// SPDX-License-Identifier: MIT
#include "solver/literature/separation_2008_interior.hpp"

#include <Eigen/LU>

namespace cyl::literature {
namespace {

Matrix2 outer(const Vector2& a) noexcept { return a * a.transpose(); }

/// Section 13: whether a + b < c of three lengths, from their squares and without a root.
bool below_by_squares(double a_squared, double b_squared, double c_squared) noexcept {
  const double rho = c_squared - a_squared - b_squared;
  return rho > 0 && 4 * a_squared * b_squared < rho * rho;
}

bool negative_by_squares(const SmoothGap& g, const Vector3& d) noexcept {
  const Solids& p = g.solids;
  const Vector3 x0 = p.r[0] * d.cross(p.w[0]), x1 = p.r[1] * d.cross(p.w[1]);
  return below_by_squares(dot(x0, x0), dot(x1, x1), dot(g.phi, g.phi));
}

// Newton's steps on the convex g0 as long as it falls: the etas of nearly singular systems are blurred.
bool separated_near(const SmoothGap& g, Vector3 d, int steps, Finder& finder) noexcept {
  if (!(dot(d, g.w) > 0)) return false;
  d /= dot(d, g.w);
  if (negative_by_squares(g, d) && finder.separates(d)) return true;
  double value = g.value(d);
  for (int i = 0; i < steps; ++i) {
    const Vector3 next = d + g.newton_step(d);
    const double lower = g.value(next);
    if (!(lower < value)) break;
    if (negative_by_squares(g, next) && finder.separates(next)) return true;
    d = next;
    value = lower;
  }
  return false;
}

}  // namespace

SmoothGap::SmoothGap(const Solids& p, double s0, double s1) noexcept
    : solids(p), sign0(s0), sign1(s1), phi(p.delta - s0 * p.h[0] * p.w[0] - s1 * p.h[1] * p.w[1]) {
  const double size = length(phi);
  no_phi = !(size > 0);
  if (no_phi) return;
  w = phi / size;
  u = w.unitOrthogonal();
  v = w.cross(u);
  const auto planar = [&](const Vector3& x) { return Vector2(dot(x, u), dot(x, v)); };
  system.b0 << planar(p.u[0]), planar(p.n);
  system.b1 << planar(p.u[1]), planar(p.n);
  system.det0 = dot(w, p.w[0]);
  system.det1 = dot(w, p.w[1]);
  system.r0 = p.r[0];
  system.r1 = p.r[1];
}

// eta_i^perp . A_i^T D = 0 for both i: D is perpendicular to A_0 eta_0^perp and A_1 eta_1^perp.
Vector3 SmoothGap::direction(const Vector2& eta0, const Vector2& eta1) const noexcept {
  const Vector2 p0 = perpendicular(eta0), p1 = perpendicular(eta1);
  return (p0.x() * solids.u[0] + p0.y() * solids.n).cross(p1.x() * solids.u[1] + p1.y() * solids.n);
}

// Row i is (A_i eta_i^perp) . (x U + y V + W) = 0. Returns 0 if C is not invertible.
Vector3 SmoothGap::direction_by_equations(const Vector2& eta0, const Vector2& eta1) const noexcept {
  const Vector2 eta[2] = {eta0, eta1};
  Matrix2 c;
  Vector2 d;
  for (int i = 0; i < 2; ++i) {
    const double a = eta[i].x(), b = eta[i].y();
    const auto row = [&](const Vector3& axis) {
      return b * dot(axis, solids.u[i]) - a * dot(axis, solids.n);
    };
    c(i, 0) = row(u);
    c(i, 1) = row(v);
    d[i] = -row(w);
  }
  const double det = c.determinant();
  if (det == 0) return {0, 0, 0};
  return (d[0] * c(1, 1) - c(0, 1) * d[1]) / det * u + (c(0, 0) * d[1] - d[0] * c(1, 0)) / det * v + w;
}

double SmoothGap::value(const Vector3& d) const noexcept {
  return solids.r[0] * length(d.cross(solids.w[0])) + solids.r[1] * length(d.cross(solids.w[1])) -
         dot(d, phi);
}

// P_i D has the length |D x W_i| and turns at the rate 1/|D x W_i| towards D x W_i.
Vector3 SmoothGap::newton_step(const Vector3& d) const noexcept {
  Vector2 gradient(0, 0);
  Matrix2 hessian = Matrix2::Zero();
  for (int i = 0; i < 2; ++i) {
    const Vector3 across = d.cross(solids.w[i]);
    const double size = length(across);
    if (!(size > 0)) return {0, 0, 0};
    const Vector3 tangent = across / size, normal = solids.w[i].cross(tangent);
    gradient += solids.r[i] * Vector2(dot(normal, u), dot(normal, v));
    hessian += solids.r[i] / size * outer({dot(tangent, u), dot(tangent, v)});
  }
  const double det = hessian.determinant();
  if (!(det > 0)) return {0, 0, 0};
  const Vector2 step = Vector2(hessian(1, 1) * gradient.x() - hessian(0, 1) * gradient.y(),
                               hessian(0, 0) * gradient.y() - hessian(1, 0) * gradient.x()) /
                       -det;
  return step.x() * u + step.y() * v;
}

bool separated_inside(const Solids& p, const Options& options, Finder& finder) noexcept {
  for (const double sign0 : {1.0, -1.0}) {
    for (const double sign1 : {1.0, -1.0}) {
      const SmoothGap g(p, sign0, sign1);
      if (g.no_phi) return false;  // two rims' centres coincide
      const CriticalSystem& s = g.system;
      // The segment between two rims' centres is square to both axes, so the end disks reach along the whole
      // segment. The solids are separated if and only if |phi|^2 > (r0 + r1)^2. No other case of signs
      // contradicts this.
      if (s.det0 == 0 && s.det1 == 0) return finder.separates(g.w);
      const CriticalPairs pairs =
          s.det0 == 0 || s.det1 == 0 ? solve_singular(s) : solve_adjugate(s, options.faults);
      if (pairs.equal && finder.separates(g.w)) return true;
      for (int i = 0; i < pairs.count; ++i) {
        Vector3 d = options.literal ? g.direction_by_equations(pairs.eta0[i], pairs.eta1[i])
                                    : g.direction(pairs.eta0[i], pairs.eta1[i]);
        if (dot(d, g.w) < 0) d = -d;
        if (options.literal && !(sign0 * dot(d, p.w[0]) >= 0 && sign1 * dot(d, p.w[1]) >= 0)) continue;
        // The signs of eta_i . A_i^T D: both positive, or both negative, which is the negated pair.
        const auto along = [&](const Vector2& eta, int k) {
          return eta.x() * dot(p.u[k], d) + eta.y() * dot(p.n, d);
        };
        const double along0 = along(pairs.eta0[i], 0), along1 = along(pairs.eta1[i], 1);
        if (options.faults.has(Fault::negated_pair_ignored) ? !(along0 > 0 && along1 > 0)
                                                            : !(along0 * along1 > 0))
          continue;
        if (separated_near(g, d, options.literal ? 0 : options.step_cap, finder)) return true;
      }
    }
  }
  return false;
}

}  // namespace cyl::literature
