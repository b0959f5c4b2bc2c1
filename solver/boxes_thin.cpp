// SPDX-License-Identifier: MIT
// A box and a segment or point, grown by balls. Derivation: boxes.md, sections 2 and 6.
#include <cmath>

#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

// Newton's method on the derivative of the square, which is piecewise linear and rises. With `asked`,
// `contact` is >= 0.
template <bool asked>
[[gnu::always_inline]] inline SegmentPoint look_on_segment(const Vector3& half, const Vector3& d,
                                                           const Vector3& w, double h,
                                                           double contact) noexcept {
  constexpr int step_cap = 100;
  const double contact2 = contact * contact;
  double lo = -h, hi = h, t = clamped(-dot(d, w), h);
  bool saw_lo = false, saw_hi = false;
  SegmentPoint best{t, {0, 0, 0}, 0, false};
  double least = 0x1p1000;
  for (int i = 0; i < step_cap; ++i) {
    const Vector3 x = d + t * w, e = x - clamped(x, half);
    const double square = dot(e, e), slope = dot(e, w);
    const bool near = asked & (square <= contact2);
    const double gap = square - t * slope - h * std::fabs(slope);
    // Then this e shows it, and a shorter one before may not.
    const bool apart = asked & (gap > 0) & (gap * gap > contact2 * square);
    if ((square < least) | apart) {
      least = square;
      best = {t, e, gap, near};
    }
    if (near | apart | (slope == 0)) return best;
    const bool rises = slope > 0;
    hi = pick(rises, t, hi);
    lo = pick(rises, lo, t);
    saw_hi |= rises;
    saw_lo |= !rises;
    // One of them is not 0 if the slope is not. Compared so that no branch is needed.
    const double bend = (std::fabs(e[0]) > 0 ? w[0] * w[0] : 0) + (std::fabs(e[1]) > 0 ? w[1] * w[1] : 0) +
                        (std::fabs(e[2]) > 0 ? w[2] * w[2] : 0);
    double next = t - slope / bend;
    if (!((next > lo) & (next < hi))) next = saw_lo & saw_hi ? 0.5 * (lo + hi) : rises ? lo : hi;
    if (next == t) break;
    t = next;
  }
  return best;
}

}  // namespace

SegmentPoint nearest_on_segment(const BoxView& v, double contact) noexcept {
  return contact < 0 ? look_on_segment<false>(v.half, v.d, v.e[0], v.h, contact)
                     : look_on_segment<true>(v.half, v.d, v.e[0], v.h, contact);
}

Verdict intersect_thin_and_box(const Prepared& a, const Prepared& b, double contact) noexcept {
  const Edges edges(a);
  const Vector3 half = 0.5 * a.edges, d = edges.seen(b.center - a.center);
  if (b.height == 0) {
    const Vector3 way = d - clamped(d, half);
    return verdict_of(dot(way, way) <= contact * contact);
  }
  return verdict_of(look_on_segment<true>(half, d, edges.seen(b.unit_axis), 0.5 * b.height, contact).near);
}

bool prove_thin_and_box(const ShapePair& p, double error, Answer& answer) noexcept {
  if (!(p.contact > error)) return false;
  const Edges edges(p.a);
  const double h = 0.5 * p.b.height, beyond = p.contact + error, within = p.contact - error;
  const Vector3 half = 0.5 * p.a.edges, d = edges.seen(p.b.center - p.a.center),
                w = edges.seen(p.b.unit_axis);
  const SegmentPoint found = look_on_segment<true>(half, d, w, h, p.contact);
  const double square_of_way = dot(found.way, found.way);
  if (!found.near) {
    if ((found.gap > 0) & (found.gap * found.gap > beyond * beyond * square_of_way)) {
      hand_out(edges.world(found.way * power_of_two(-exponent_of(max_abs(found.way)))), answer);
      return true;
    }
  } else {
    const Vector3 inner = half - Vector3(error, error, error);
    if ((smaller(smaller(inner[0], inner[1]), inner[2]) <= 0) | ((h > 0) & (h <= error))) return false;
    const double t = h > 0 ? clamped(found.t, h - error) : 0;
    const Vector3 on1 = d + t * w, on0 = clamped(on1, inner), way = on1 - on0;
    Vector3 head, tail;
    if (dot(way, way) <= within * within && brought_to_scene(edges.world(on0), p.exponent, head) &&
        brought_to_scene(t * p.b.unit_axis, p.exponent, tail)) {
      hand_out(Proof::points, head, tail, Hull::space, h > 0 ? Hull::line : Hull::center, answer);
      return true;
    }
  }
  // Nothing can be proved if the points are so near, and the way between them separates so much.
  const double least = error * (box_error / quick_error), size = std::sqrt(square_of_way);
  return (p.contact > least) & (size <= p.contact + 0.5 * least) & (found.gap > (p.contact - least) * size);
}

}  // namespace cyl
