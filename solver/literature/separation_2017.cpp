// SPDX-License-Identifier: MIT
#include "solver/literature/separation_2017.hpp"

#include <cmath>

#include "solver/detail/frame.hpp"

namespace cyl::literature {
namespace {

Vector3 axis0(const Couple<double>& p) noexcept { return {p.w0x, p.w0y, p.w0z}; }
Vector3 axis1(const Couple<double>& p) noexcept { return {p.w1x, p.w1y, p.w1z}; }
Vector3 delta_of(const Couple<double>& p) noexcept { return {p.dx, p.dy, p.dz}; }

/// The roles exchanged; f is the same.
Couple<double> exchanged(const Couple<double>& p) noexcept {
  return {p.w1x, p.w1y, p.w1z, p.w0x, p.w0y, p.w0z, p.dx, p.dy, p.dz, p.r1, p.h1, p.r0, p.h0};
}

/// Whether f(D) = 0 separates in sections 5 and 8: the text has "<" there, and "<=" elsewhere.
bool touching_by_axes(const Options& options) noexcept {
  return options.touching_apart && !options.faults.has(Fault::mixed_strictness);
}

/// Sections 5 and 8: W0, W1 and W0 x W1.
Direction separated_by_axes(const Couple<double>& p, const Options& options) noexcept {
  const Vector3 w0 = axis0(p), w1 = axis1(p);
  const Axes axes(w0, w1);
  const Vector3 directions[] = {
      w0, w1, options.faults.has(Fault::cancelling_sine) ? Vector3(w0.cross(w1)) : axes.cross};
  const auto reach = [&](int i) { return std::fabs(dot(directions[i], delta_of(p))); };
  const double sine = length(directions[2]), cosine = std::fabs(axes.cosine);
  const double printed[] = {p.r1 * sine + p.h0 + p.h1 * cosine - reach(0),
                            p.r0 * sine + p.h0 * cosine + p.h1 - reach(1), (p.r0 + p.r1) * sine - reach(2)};
  for (int i = 0; i < 3; ++i) {
    const double gap = options.literal ? printed[i] : f(p, directions[i]);
    if (touching_by_axes(options) ? gap <= 0 : gap < 0) return directions[i];
  }
  return {};
}

/// Sections 5 and 8: axes exactly parallel, or nearly (a sine below 2^-49).
Direction separated_in_parallel(const Couple<double>& p, const Options& options) noexcept {
  const double heights = p.h0 + p.h1, radii = p.r0 + p.r1;
  const Parallel axes(delta_of(p), heights, radii, Axes(axis0(p), axis1(p)).sum);
  const bool equal = touching_by_axes(options);
  if (axes.stacked || (equal && std::fabs(axes.along) == heights)) return axes.w;
  if (axes.beside || (equal && axes.distance == radii))
    return axes.distance > 0 ? axes.across() : Vector3(axes.w.unitOrthogonal());
  return {};
}

Direction search(const Couple<double>& p, const Options& options) noexcept {
  const Vector3 w0 = axis0(p), w1 = axis1(p);
  if (options.faults.has(Fault::cancelling_sine) ? w0.cross(w1) == Vector3::Zero() : Axes(w0, w1).parallel())
    return separated_in_parallel(p, options);
  if (const Direction d = separated_by_axes(p, options)) return d;
  if (const Direction d = separated_by_cylinder_perpendiculars(p, options)) return d;
  if (const Direction d = separated_by_cylinder_perpendiculars(exchanged(p), options)) return d;
  // If the solids share a centre, the least f(D) is 0. Two in one plane only touch, as sections 5 and 6
  // state.
  if (delta_of(p) == Vector3::Zero() && !options.faults.has(Fault::coincident_centers)) return {};
  return separated_by_other_directions(p, options);
}

Separation from_a_to_b(const Direction& d, const Couple<double>& p) noexcept {
  if (!d) return {Verdict::intersecting};
  return {Verdict::disjoint, dot(d.vector, delta_of(p)) < 0 ? Vector3(-d.vector) : d.vector};
}

}  // namespace

double f(const Couple<double>& p, const Vector3& d) noexcept {
  const Vector3 w0 = axis0(p), w1 = axis1(p);
  return p.r0 * length(d.cross(w0)) + p.r1 * length(d.cross(w1)) + p.h0 * std::fabs(dot(d, w0)) +
         p.h1 * std::fabs(dot(d, w1)) - std::fabs(dot(d, delta_of(p)));
}

Separation separated_cylinders(const Prepared& a, const Prepared& b, const Options& options) noexcept {
  if (a.defect != Defect::none || b.defect != Defect::none) return {Verdict::invalid};
  // A fixed order of the roles, so that swapping them changes nothing but the direction's sign.
  const bool swapped = !options.literal && out_of_order(a, b);
  const Couple<double> p = swapped ? scale(b, a).couple() : scale(a, b).couple();
  Separation found = from_a_to_b(search(p, options), p);
  if (swapped) found.direction = -found.direction;
  return found;
}

}  // namespace cyl::literature
