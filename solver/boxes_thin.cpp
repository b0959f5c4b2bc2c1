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

// Not inlined, to keep the common path small.
[[gnu::noinline]] Verdict search(Seen half, Seen d, Seen w, double h, double contact, double t) noexcept {
  return verdict_of(look_on_segment<true>(half, d, w, h, contact, t).near);
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
  return near + apart != 0 ? verdict_of(near != 0) : search(half, d, w, h, contact, t);
}

bool prove_thin_and_box(const ShapePair& p, double error, Answer& answer) noexcept {
  if (!(p.contact > error)) return false;
  const Edges edges(p.a);
  const double h = 0.5 * p.b.height, beyond = p.contact + error, within = p.contact - error;
  const Vector3 half = 0.5 * p.a.edges, d = edges.seen(p.b.center - p.a.center),
                w = edges.seen(p.b.unit_axis);
  const SegmentPoint found =
      look_on_segment<true>(Seen(half), Seen(d), Seen(w), h, p.contact, clamped(-dot(d, w), h));
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
