// SPDX-License-Identifier: MIT
// A box and a segment or point, grown by balls. Derivation: boxes.md, sections 2 and 6.
#include <cmath>

#include "solver/detail/along_edges.hpp"
#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

// The point d + t w shows the way to it from the nearest point of the box, the square of the way, half of the
// derivative of that, and -f(way).
struct Look {
  [[gnu::always_inline]] Look(Seen half, Seen d, Seen w, double h, double t) noexcept
      : way((d + t * w) - clamped(d + t * w, half)),
        square(dot(way, way)),
        slope(dot(way, w)),
        gap(square - t * slope - h * std::fabs(slope)) {}
  Seen way;
  double square, slope, gap;
};

// From the point of the segment that is nearest to the centre of the box to the nearest point of the box, and
// back. Without a branch.
[[gnu::always_inline]] inline double first_step(Seen half, Seen d, Seen w, double h) noexcept {
  return clamped(dot(clamped(d + clamped(-dot(d, w), h) * w, half) - d, w), h);
}

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
    const auto [e, square, slope, gap] = Look(half, d, w, h, t);
    const bool near = asked & (square <= contact2);
    // Then this e shows it, and a shorter one before may not.
    const bool apart = asked & is_beyond(gap, square, contact);
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
    const Seen w = seen(p.b.unit_axis);
    t = first_step(half, d, w, h);
    const Look look(half, d, w, h, t);
    way = look.way, square_of_way = look.square, gap = look.gap;
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
  if (b.height == 0) {
    const Seen way = d - clamped(d, half);
    return verdict_of(dot(way, way) <= contact * contact);
  }
  const Seen w = seen(b.unit_axis);
  const double h = 0.5 * b.height, t = first_step(half, d, w, h);
  const Look look(half, d, w, h, t);
  const bool near = look.square <= contact * contact;
  return none_of(near, is_beyond(look.gap, look.square, contact)) ? search(a, b, contact, t)
                                                                  : verdict_of(near);
}

Answer decide_thin_and_box(const Prepared& box, const Prepared& thin, double clearance,
                           bool swapped) noexcept {
  return ask_in_order(
      box, thin, clearance, false, [&](const ShapePair& p) __attribute__((always_inline)) {
        return prove_thin_and_box(p, swapped, [&] { return decide_box(box, thin, clearance, swapped); });
      });
}

}  // namespace cyl
