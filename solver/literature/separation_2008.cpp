// SPDX-License-Identifier: MIT
#include "solver/literature/separation_2008.hpp"

#include "solver/literature/separation_2008_circle.hpp"
#include "solver/literature/separation_2008_interior.hpp"
#include "solver/literature/solids.hpp"

namespace cyl::literature {
namespace {

// Section 7, f(W_i) < 0 without a root. The other solid's radius counts.
bool separated_by_axis(const Solids& p, int i, Faults faults) noexcept {
  const double radius = p.r[1 - i];
  const double rho = std::fabs(dot(p.w[i], p.delta)) - p.h[i] - p.h[1 - i] * std::fabs(p.cosine);
  if (rho <= 0) return false;
  return (faults.has(Fault::radius_not_squared) ? radius : radius * radius) * p.square < rho * rho;
}

// Section 7, f(W0 x W1) < 0 without a root.
bool separated_by_cross(const Solids& p) noexcept {
  const double radii = p.r[0] + p.r[1], beside = dot(p.cross, p.delta);
  return radii * radii * p.square < beside * beside;
}

Separation separation_parallel(const Couple<double>& p, const Vector3& sum, Faults faults) noexcept {
  const Parallel q({p.dx, p.dy, p.dz}, p.h0 + p.h1, p.r0 + p.r1, sum);
  if (q.stacked) return {Verdict::disjoint, q.along < 0 ? Vector3(-q.w) : q.w};
  bool beside = q.beside;
  if (faults.has(Fault::cancelling_distance)) {
    const double radii = p.r0 + p.r1;
    beside = dot(q.delta, q.delta) - q.along * q.along > radii * radii;
  }
  if (beside) return {Verdict::disjoint, q.across()};
  return {Verdict::intersecting, {0, 0, 0}};
}

}  // namespace

Separation separation_2008(const Prepared& a, const Prepared& b, CircleWay circle,
                           const Options& options) noexcept {
  if (a.defect != Defect::none || b.defect != Defect::none) return {Verdict::invalid, {0, 0, 0}};
  const Couple<double> couple = scale(a, b).couple();
  const Vector3 w0(couple.w0x, couple.w0y, couple.w0z), w1(couple.w1x, couple.w1y, couple.w1z);
  const Axes axes(w0, w1);
  if (options.literal ? axes.cross == Vector3::Zero() : axes.parallel())
    return separation_parallel(couple, axes.sum, options.faults);

  const Solids solids(couple, axes);
  const auto disjoint = [&](const Vector3& d) {
    return Separation{Verdict::disjoint, dot(d, solids.delta) < 0 ? Vector3(-d) : d};
  };
  for (int i = 0; i < 2; ++i)
    if (separated_by_axis(solids, i, options.faults)) return disjoint(solids.w[i]);
  if (separated_by_cross(solids)) return disjoint(solids.n);

  Finder finder(solids);
  if (separated_on_circle(solids, 0, circle, options, finder) ||
      separated_on_circle(solids, 1, circle, options, finder) || separated_inside(solids, options, finder))
    return {Verdict::disjoint, finder.direction};
  return {Verdict::intersecting, {0, 0, 0}};
}

}  // namespace cyl::literature
