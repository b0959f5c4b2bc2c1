// SPDX-License-Identifier: MIT
// A box and a segment or point, grown by balls. Derivation: boxes.md, sections 2 and 6.
#include <cmath>

#include "solver/detail/along_edges.hpp"
#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

// Newton's method on the derivative of the square, which is piecewise linear and rises. It starts at t. With
// `asked`, `contact` is >= 0.
template <bool asked>
[[gnu::always_inline]] inline SegmentPoint look_on_segment(Seen half, Seen d, Seen w, double h,
                                                           double contact, double t) noexcept {
  constexpr int step_cap = 100;
  const double contact2 = contact * contact;
  double lo = -h, hi = h;
  bool saw_lo = false, saw_hi = false;
  SegmentPoint best{t, {0, 0, 0}, 0, false};
  double least = 0x1p1000;
  for (int i = 0; i < step_cap; ++i) {
    const Seen x = d + t * w, e = x - clamped(x, half);
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
    const Both bends = Both(BothBits(w.xy * w.xy) & (magnitude(e.xy) > both(0)));
    const double bend = bends[0] + bends[1] + (std::fabs(e.z) > 0 ? w.z * w.z : 0);
    double next = t - slope / bend;
    if (!((next > lo) & (next < hi))) next = (saw_lo & saw_hi) ? 0.5 * (lo + hi) : rises ? lo : hi;
    if (next == t) break;
    t = next;
  }
  return best;
}

// Not inlined, to keep the common path small. If rounding exceeds the contact, it hides that a segment
// pierces a flat box.
[[gnu::noinline]] Verdict search(const Prepared& a, const Prepared& b, double contact, double t) noexcept {
  const BoxView v(a, b);
  const SegmentPoint found = look_on_segment<true>(Seen(v.half), Seen(v.d), Seen(v.e[0]), v.h, contact, t);
  return verdict_of(found.near ||
                    (!is_beyond(found.gap, dot(found.way, found.way), contact) && separating_axis(v) < 0));
}

// If there is no proof, the answer is `otherwise`.
template <class Otherwise>
[[gnu::always_inline]] inline Answer prove_thin_and_box(const ShapePair& p, bool swapped,
                                                        Otherwise otherwise) noexcept {
  const SeenFrom seen(p.a);
  const Vector3 delta = p.b.center - p.a.center;
  const Seen half = half_of(p.a), d = seen(delta);
  const double h = 0.5 * p.b.height, reach = core_size(p.a) + h + p.contact + length_bound(delta),
               error = quick_error * reach + underflow_error, within = p.contact - error;
  const Seen inner = half - Seen(both(error), error);
  Seen way = d - clamped(d, half), on1 = d;
  double t = 0, square_of_way = dot(way, way), gap = square_of_way;
  if (h > 0) {
    // The step of intersect().
    const Seen w = seen(p.b.unit_axis);
    t = clamped(dot(clamped(d + clamped(-dot(d, w), h) * w, half) - d, w), h);
    const Seen x = d + t * w;
    way = x - clamped(x, half);
    square_of_way = dot(way, way);
    const double slope = dot(way, w);
    gap = square_of_way - t * slope - h * std::fabs(slope);
    if (none_of(square_of_way <= p.contact * p.contact, is_beyond(gap, square_of_way, p.contact))) {
      const SegmentPoint found = look_on_segment<true>(half, d, w, h, p.contact, t);
      t = found.t, way = Seen(found.way), square_of_way = dot(way, way), gap = found.gap;
    }
    t = clamped(t, h - error);
    on1 = d + t * w;
  }
  const Seen on0 = clamped(on1, inner), between = on1 - on0;
  const bool near = dot(between, between) <= within * std::fabs(within),
             fits = (smaller(smaller(inner.xy[0], inner.xy[1]), inner.z) > 0) & (within > 0) &
                    ((h == 0) | (h > error));
  if (!fits || none_of(near, is_beyond(gap, square_of_way, p.contact + error))) {
    // Nothing can be proved if the points are so near, and the way between them separates so much.
    const double least = error * (box_error / quick_error), most = p.contact + 0.5 * least;
    const bool separates = is_beyond(gap, square_of_way, p.contact - least);
    return (fits & separates & (p.contact > least) & (square_of_way <= most * most)) ? Answer() : otherwise();
  }
  const Vector3 of_box = either(mask_of(near), on0, mask_of(!near), without_unit(way, reach, swapped));
  const Vector3 found = seen.world(p.a, Seen(of_box));
  Vector3 head, tail;
  if (!brought_to_scene(found, p.exponent, head) || !brought_to_scene(t * p.b.unit_axis, p.exponent, tail))
    return otherwise();
  return proof_of(near, Proof::points, found, head, tail, Hull::space, h > 0 ? Hull::line : Hull::center,
                  swapped);
}

}  // namespace

SegmentPoint nearest_on_segment(const BoxView& v, double contact) noexcept {
  const Seen half(v.half), d(v.d), w(v.e[0]);
  const double t = clamped(-dot(d, w), v.h);
  return contact < 0 ? look_on_segment<false>(half, d, w, v.h, contact, t)
                     : look_on_segment<true>(half, d, w, v.h, contact, t);
}

Verdict intersect_thin_and_box(const Prepared& a, const Prepared& b, double contact) noexcept {
  const SeenFrom seen(a);
  const Seen half = half_of(a), d = seen(b.center - a.center);
  const double contact2 = contact * contact;
  if (b.height == 0) {
    const Seen way = d - clamped(d, half);
    return verdict_of(dot(way, way) <= contact2);
  }
  // One step: the point of the box that is nearest to a point of the segment, and back. Without a branch.
  const Seen w = seen(b.unit_axis);
  const double h = 0.5 * b.height, from = clamped(-dot(d, w), h);
  const double t = clamped(dot(clamped(d + from * w, half) - d, w), h);
  const Seen x = d + t * w, e = x - clamped(x, half);
  const double square = dot(e, e), slope = dot(e, w), gap = square - t * slope - h * std::fabs(slope);
  const unsigned near = square <= contact2, apart = (gap > 0) & (gap * gap > contact2 * square);
  return near + apart != 0 ? verdict_of(near != 0) : search(a, b, contact, t);
}

Answer decide_thin_and_box(const Prepared& box, const Prepared& thin, double clearance,
                           bool swapped) noexcept {
  return ask_in_order(
      box, thin, clearance, false, [&](const ShapePair& p) __attribute__((always_inline)) {
        return prove_thin_and_box(p, swapped, [&] { return decide_box(box, thin, clearance, swapped); });
      });
}

}  // namespace cyl
