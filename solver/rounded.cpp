// SPDX-License-Identifier: MIT
// The verdict on solids grown by balls. Derivation: rounded.md.
#include "solver/detail/rounded.hpp"

#include <algorithm>
#include <cmath>

#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

// The result of a quick test of a pair: 0 disjoint, 1 intersecting, as in Verdict.
enum class QuickVerdict : unsigned char { disjoint, intersecting, neither };

// A ball about the end of `to` from the middle of the core (rounded.md, section 2).
Verdict meets_point(const Prepared& core, const Vector3& to, double contact_distance) noexcept {
  const double along = dot(to, core.unit_axis);
  const Vector3 across = to - along * core.unit_axis;
  const double out = positive(std::fabs(along) - 0.5 * core.height);
  const double beside = positive(std::sqrt(dot(across, across)) - core.radius);
  return verdict_of(out * out + beside * beside <= contact_distance * contact_distance);
}

// Two segments in any position. A segment may be a point. Any two points of them give an upper bound of their
// distance. The direction between the points gives a lower bound.
QuickVerdict classify_segments(const Scaled& p, double contact_distance) noexcept {
  const double c = dot(p.w0, p.w1), d0 = dot(p.delta, p.w0), d1 = dot(p.delta, p.w1);
  const double determinant = 1 - c * c;
  const double inner = p.h0 * p.h1 > 0 && determinant > 0 ? (d0 - c * d1) / determinant : d0;
  const double t = std::clamp(c * std::clamp(inner, -p.h0, p.h0) - d1, -p.h1, p.h1);
  const double s = std::clamp(d0 + c * t, -p.h0, p.h0);
  const Vector3 e = p.delta + t * p.w1 - s * p.w0;
  const double most2 = dot(e, e);
  if (most2 <= square(contact_distance)) return QuickVerdict::intersecting;
  const double least = dot(e, p.delta) - p.h0 * std::fabs(dot(e, p.w0)) - p.h1 * std::fabs(dot(e, p.w1));
  if (least > 0 && square(least) > square(contact_distance) * most2) return QuickVerdict::disjoint;
  return QuickVerdict::neither;
}

// By the five directions of the separating-axis filter, and by its first slice without any rounding.
QuickVerdict classify_by_filter(const Scaled& p, double contact_distance) noexcept {
  const Couple<double> couple = p.couple();
  const Products<double> q = products(couple);
  if (!(magnitude(q.cosine) <= steep_cosine)) return QuickVerdict::neither;
  const Sections<double> f = sections(couple, q);
  const double contact_distance_s = f.s * contact_distance;
  const bool apart = (f.z_s - f.s * (f.r0 + f.r1) > contact_distance_s) |
                     (f.k0 - f.s * f.r1 > contact_distance) | (f.k1 - f.s * f.r0 > contact_distance) |
                     (f.k2_s - f.s * (f.r0 + f.c * f.r1) > contact_distance_s) |
                     (f.k3_s - f.s * (f.c * f.r0 + f.r1) > contact_distance_s);
  const auto filter = separating_axis_filter(f);
  const bool overlaps = filter.overlaps & !filter.apart & !apart;
  // Without a branch: QuickVerdict has its words in this order.
  static_assert(static_cast<int>(QuickVerdict::intersecting) == 1 &&
                static_cast<int>(QuickVerdict::neither) == 2);
  return static_cast<QuickVerdict>(2 - 2 * static_cast<int>(apart) - static_cast<int>(overlaps));
}

// From a point of the first core to the nearest of the other and back, so many times. Each step shows two
// points, and a direction with the gap that it separates. `on0` is the last point.
QuickVerdict alternate_projections(const Scaled& p, double contact_distance, Vector3& on0,
                                   int steps) noexcept {
  for (int i = 0; i < steps; ++i) {
    const Vector3 on1 = p.delta + nearest(on0 - p.delta, p.w1, p.r1, p.h1), e = on1 - on0;
    const double most2 = dot(e, e);
    if (most2 <= square(contact_distance)) return QuickVerdict::intersecting;
    const double least = dot(e, p.delta) - p.r0 * length(e.cross(p.w0)) - p.h0 * std::fabs(dot(e, p.w0)) -
                         p.r1 * length(e.cross(p.w1)) - p.h1 * std::fabs(dot(e, p.w1));
    if (least > 0 && square(least) > square(contact_distance) * most2) return QuickVerdict::disjoint;
    on0 = nearest(on1, p.w0, p.r0, p.h0);
  }
  return QuickVerdict::neither;
}

// For solids in their order (frame.hpp).
QuickVerdict classify_by_projection(const Prepared& a, const Prepared& b, double contact_distance) noexcept {
  const Scaled p = as_it_is(a, b);
  if (both_are(Prepared::thin, a, b)) return classify_segments(p, contact_distance);
  Vector3 on0 = nearest(p.delta, p.w0, p.r0, p.h0);
  const QuickVerdict seen = alternate_projections(p, contact_distance, on0, first_steps);
  if (seen != QuickVerdict::neither) return seen;
  if (intersect(core_of(a), core_of(b)) == Verdict::intersecting) return QuickVerdict::intersecting;
  return alternate_projections(p, contact_distance, on0, more_steps);
}

constexpr double moderate_length = power_of_two(moderate_exponent);

// The least e with x <= 2^e.
int exponent_above(double x) noexcept {
  int exponent = 0;
  return std::frexp(x, &exponent) == 0.5 ? exponent - 1 : exponent;
}

// The solid with all lengths times 2^exponent. It is not moderate if a length vanishes.
Prepared rescaled(Prepared c, int exponent) noexcept {
  const auto moved = [exponent](double x) { return std::ldexp(x, exponent); };
  const Prepared before = c;
  c.center = times_power(c.center, exponent);
  c.radius = moved(c.radius), c.height = moved(c.height), c.rounding = moved(c.rounding);
  mark_traits(c);
  const auto lost = [](double x, double y) { return x == 0 && y != 0; };
  if (lost(c.radius, before.radius) || lost(c.height, before.height) || lost(c.rounding, before.rounding))
    c.traits = 0;
  for (int i = 0; i < 3; ++i)
    if (lost(c.center[i], before.center[i])) c.traits = 0;
  return c;
}

}  // namespace

// The largest length comes to its limit, which leaves the most room for small lengths.
bool intersect_at_moderate_scale(const Prepared& a, const Prepared& b, double clearance,
                                 Verdict& verdict) noexcept {
  int largest = -2000;  // below every exponent
  for (const Prepared* const c : {&a, &b}) {
    for (const double x : {c->radius, c->height, c->rounding, clearance})
      if (x > 0) largest = std::max(largest, exponent_above(x));
    if (const double x = max_abs(c->center); x > 0)
      largest = std::max(largest, exponent_above(x) - center_exponent);
  }
  const int exponent = moderate_exponent - largest;
  const Prepared first = rescaled(a, exponent), second = rescaled(b, exponent);
  const double moved = std::ldexp(clearance, exponent);
  if (!both_are(Prepared::moderate, first, second) || std::ldexp(moved, -exponent) != clearance) return false;
  verdict = within(first, second, moved);
  return true;
}

Verdict intersect_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const double contact_distance = contact_distance_of(a, b, clearance);
  if (both_are(Prepared::moderate, a, b) & (clearance <= moderate_length)) {
    if (both_are(Prepared::thin, a, b)) {
      if (Verdict there = Verdict::undecided; intersect_thin(a, b, contact_distance, there)) return there;
    } else if (one_is_ball(a, b)) {
      return meets_point(not_ball(a, b), b.center - a.center, contact_distance);
    }
    QuickVerdict seen = both_are(Prepared::thin, a, b) ? QuickVerdict::neither
                                                       : classify_by_filter(as_it_is(a, b), contact_distance);
    if (seen == QuickVerdict::neither)
      seen = out_of_order(a, b) ? classify_by_projection(b, a, contact_distance)
                                : classify_by_projection(a, b, contact_distance);
    if (seen != QuickVerdict::neither) return verdict_of(seen == QuickVerdict::intersecting);
  } else if (Verdict there = Verdict::undecided; intersect_at_moderate_scale(a, b, clearance, there)) {
    return there;
  }
  if (contact_distance >= huge_distance)
    return intersect_rounded(shrunk(a), shrunk(b), huge_shrink * clearance);
  return verdict_of(distance_of_cores(core_of(a), core_of(b), false).value <= contact_distance);
}

Verdict within(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const double contact_distance = contact_distance_of(a, b, clearance);
  if (!is_valid_question(a, b, clearance, contact_distance)) return Verdict::invalid;
  if (has_other_shape(a, b)) return intersect_shapes(a, b, clearance);
  return contact_distance > 0 ? intersect_rounded(a, b, clearance) : intersect(a, b);
}

}  // namespace cyl
