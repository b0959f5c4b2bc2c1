// SPDX-License-Identifier: MIT
// Yes or no.
#include "solver/decide.hpp"
#include "solver/detail/both_solids.hpp"
#include "solver/detail/iteration_cap.hpp"
#include "solver/detail/sections.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

// After separating_axis_filter has seen neither.
[[gnu::noinline]] Verdict resolve_at_edge(const Sections<double>& f) noexcept {
  const auto at = corner(in_order(f));
  if (at.overlaps | at.cannot_improve | !(at.rises2 | at.rises3)) return verdict_of(at.overlaps);
  const Edge<double> e = edge(at);
  const auto end = top(e);
  if (end.here) return verdict_of(end.overlaps);
  const auto [low, first] = start(e);
  double t = first;
  // not covered: no pair that was ever seen comes to the cap
  for (int i = 0; i < iteration_cap; ++i) {
    const auto now = step(e, low, t);
    if (now.apart | now.overlaps) return verdict_of(now.overlaps);
    t = now.t;
  }
  return Verdict::undecided;
}

Verdict intersect_sections(const Sections<double>& f) noexcept {
  const auto filter = separating_axis_filter(f);
  // One branch for both.
  if (static_cast<unsigned>(filter.apart) + static_cast<unsigned>(filter.overlaps) != 0)
    return verdict_of(!filter.apart);
  return resolve_at_edge(f);
}

[[gnu::noinline]] Verdict intersect_shallow(const Couple<double>& p) noexcept {
  if ((p.w0x == p.w1x) & (p.w0y == p.w1y) & (p.w0z == p.w1z)) return verdict_of(!apart_in_parallel(p));
  const Sections<double> f = shallow_sections(p);
  if (f.s2 >= parallel_square) return intersect_sections(f);
  return verdict_of(!apart_in_parallel(p));
}

[[gnu::always_inline]] inline Verdict intersect_steep(const Prepared& a, const Prepared& b,
                                                      double cosine) noexcept {
  const SectionsOfBoth f = sections_of_both(a, b, cosine);
  const auto filter = separating_axis_filter(f);
  // One branch for both.
  if (filter.apart | filter.overlaps) return verdict_of(!filter.apart);
  return resolve_at_edge(f.of_each());
}

Verdict intersect_couple(const Couple<double>& p) noexcept {
  const double cosine = p.w0x * p.w1x + p.w0y * p.w1y + p.w0z * p.w1z;
  return magnitude(cosine) <= steep_cosine ? intersect_sections(sections(p)) : intersect_shallow(p);
}

// Spheres and capsules. Not inlined, as the next one, to keep each path small.
[[gnu::noinline]] Verdict intersect_thin_pair(const Prepared& a, const Prepared& b) noexcept {
  Verdict found = Verdict::undecided;
  return intersect_thin(a, b, a.rounding + b.rounding, found) ? found : intersect_rounded(a, b, 0);
}

// A box or a half-space first.
Verdict intersect_in_order(const Prepared& a, const Prepared& b, double contact) noexcept {
  if (a.shape == Shape::half_space) return intersect_half_space(a, b, contact);
  const bool thin = (b.shape == Shape::cylinder) & (b.radius == 0) & ((contact > 0) | (b.height == 0));
  return thin ? intersect_thin_and_box(a, b, contact) : intersect_box(a, b, contact);
}

[[gnu::noinline]] Verdict intersect_moderate_shapes(const Prepared& a, const Prepared& b) noexcept {
  const Prepared* const roles[] = {&a, &b};
  const bool swapped = shapes_out_of_order(a, b);
  return intersect_in_order(*roles[swapped], *roles[!swapped], a.rounding + b.rounding);
}

[[gnu::noinline]] Verdict intersect_other(const Prepared& a, const Prepared& b) noexcept {
  if ((a.defect != Defect::none) | (b.defect != Defect::none)) return Verdict::invalid;
  if (has_other_shape(a, b)) return intersect_shapes(a, b, 0);
  if (a.rounding + b.rounding > 0) return intersect_rounded(a, b, 0);
  if (Verdict there = Verdict::undecided; intersect_at_moderate_scale(a, b, 0, there)) return there;
  return intersect_couple(scale(a, b).couple());
}

}  // namespace

Verdict intersect_shapes(const Prepared& a, const Prepared& b, double clearance) noexcept {
  return ask_in_order(a, b, clearance, shapes_out_of_order(a, b),
                      [](const ShapePair& p) { return intersect_in_order(p.a, p.b, p.contact); });
}

Verdict intersect(const Prepared& a, const Prepared& b) noexcept {
  if (!both_are(Prepared::ordinary, a, b)) {
    if (both_are(Prepared::moderate, a, b) & has_other_shape(a, b)) return intersect_moderate_shapes(a, b);
    return both_are(Prepared::thin, a, b) ? intersect_thin_pair(a, b) : intersect_other(a, b);
  }
  const double cosine = cosine_of(a, b);
  return magnitude(cosine) <= steep_cosine ? intersect_steep(a, b, cosine)
                                           : intersect_shallow(as_it_is(a, b).couple());
}

Verdict intersect(const Solid& a, const Solid& b) noexcept { return intersect(prepare(a), prepare(b)); }

}  // namespace cyl
