// SPDX-License-Identifier: MIT
// The verdict with its proof. Symbols as in derivation.md. Every returned verdict has passed a check with a
// rounding bound. Without such a check the verdict is `undecided`.
#include "solver/decide.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/detail/both_solids.hpp"
#include "solver/detail/optimum.hpp"
#include "solver/detail/prove_with_slack.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

void prove_parallel(ProofTask& q, const Parallel& found) noexcept {
  const Scaled& p = q.solids;
  if (found.stacked && try_direction(q, found.w)) return;
  if (found.beside && try_direction(q, found.across())) return;
  if (found.stacked | found.beside) return;
  Vector3 x = middle_of_both(p.h0, found.along, p.h1) * found.w;
  if (found.distance > 0) x += middle_of_both(p.r0, found.distance, p.r1) * found.across();
  try_point(q, x);
}

// The directions w0, w1, C w0 - w1, C w1 - w0 and w0 x w1 as sums: the weights of w0, w1 and w0 x w1, and the
// factor of C in the first two. It is a table, because a branch on the direction would be unpredictable.
struct Weights {
  double w0, w1, n, cosine_w0, cosine_w1;
};
constexpr Weights direction_weights[] = {
    {1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, -1, 0, 1, 0}, {-1, 0, 0, 0, 1}, {0, 0, 1, 0, 0}};

// The filter's own numbers as proof that the solids are apart, if they show it by more than `error`. Has a
// bit for each of the five directions.
[[gnu::always_inline]] inline unsigned shown_apart(const SectionsOfBoth& f, double error) noexcept {
  const Both most = f.most(), k = f.k - error, k_s = f.k_s - error;
  const double z_s = f.z_s - error, radii = f.radii();
  return bits(k * magnitude(k) > f.s2 * crosswise(f.r * f.r)) |
         bits(k_s * magnitude(k_s) > f.s2 * (most * most)) << 2 |
         static_cast<unsigned>(z_s * magnitude(z_s) > f.s2 * (radii * radii)) << 4;
}

[[gnu::always_inline]] inline Vector3 direction_of(unsigned j, const SectionsOfBoth& f, const Vector3& w0,
                                                   const Vector3& w1) noexcept {
  const Weights& w = direction_weights[j];
  double a = w.w0 + w.cosine_w0 * f.cosine, b = w.w1 + w.cosine_w1 * f.cosine;
  const double sign = std::copysign(1.0, a * f.d[0] + b * f.d[1] + w.n * f.dn), n = sign * w.n;
  a *= sign;
  b *= sign;
  return {a * w0.x() + b * w1.x() + n * f.nx, a * w0.y() + b * w1.y() + n * f.ny,
          a * w0.z() + b * w1.z() + n * f.nz};
}

// A point from C0 that the solids may share, as ab[0] w0 + ab[1] w1 + c (w0 x w1).
struct PlaneWeights {
  Both ab;
  double c;
};

// Whether it is in both, by more than `error`; inverse = 1/s^2.
[[gnu::always_inline]] inline bool in_both(const SectionsOfBoth& f, double inverse, double error,
                                           const PlaneWeights& x) noexcept {
  const Both room = f.r - error, along = x.ab + f.cosine * crosswise(x.ab) - Both{0, f.d[1]};
  const Both across{x.ab[1], x.ab[0] - (f.d[0] - f.cosine * f.d[1]) * inverse};
  const Both beside{x.c, x.c - f.dn * inverse};
  return (bits(magnitude(along) < f.h - error) & bits(room > both(0)) &
          bits(f.s2 * (across * across + beside * beside) < room * room)) == 3;
}

// The slice at u = z r0/(r0 + r1). Lengths are divided by a power of two that brings the radii near 1, so
// that products of so many lengths do not overflow. With A = x.w0, B = x.w1 and g_i = r_i^2 (s^2 - (dn/(r0 +
// r1))^2), the squares of the four coordinates, along and across both axes, in units of their half lengths,
// sum up to
//   A^2/h0^2 + (B - d1)^2/h1^2 + (B - C A)^2/g0 + (A - d0 - C (B - d1))^2/g1,
// with the weights 1/h_i^2 and 1/g_i times all denominators.
struct FirstSlice {
  [[gnu::always_inline]] explicit FirstSlice(const SectionsOfBoth& f) noexcept
      : radii(f.radii()), unit(power_of_two(-exponent_of(radii))), sum(radii * unit), square(sum * sum) {
    h = f.h * unit;
    r = f.r * unit;
    d = f.d * unit;
    dn = f.dn * unit;
    s2 = f.s2 * square;
    const Both hh = h * h;
    rr = r * r;
    along = crosswise(hh) * (rr[0] * rr[1] * (s2 - dn * dn));
    across = hh[0] * hh[1] * square * crosswise(rr);
  }
  double radii, unit, sum, square, dn, s2;
  Both h, r, rr, d;
  Both along, across;      // the weights
  Both at, axial, beside;  // A and B, and what is along and across the axes, times det
  double det;
};

// The point at which the sum of squares is least. Returns false if that is not inside both by more than
// `error` (section 8). It distinguishes no cases, and needs no root.
[[gnu::always_inline]] inline bool find_least(const SectionsOfBoth& f, double error, FirstSlice& s,
                                              PlaneWeights& x) noexcept {
  const double cosine = f.cosine;
  const Both m = s.along + crosswise(s.across) + cosine * cosine * s.across;
  const double turned = cosine * (s.across[0] + s.across[1]);  // the other element of the matrix, times -1
  const double g0 = s.across[1] * (s.d[0] - cosine * s.d[1]), g1 = s.along[1] * s.d[1] - cosine * g0;
  s.det = m[0] * m[1] - turned * turned;
  const Both right{g0, g1};
  s.at = crosswise(m) * right + turned * crosswise(right);  // {A, B} det
  const double inverse = 1 / (s.det * (f.s2 * s.sum));      // the one division
  // Whether it is in both: before the division, times det, and squares times (det s (r0 + r1))^2.
  const Both from1 = s.at - s.d * s.det, room_h = s.h - error * s.unit, room_r = s.r - error * s.unit;
  s.axial = __builtin_shufflevector(s.at, from1, 0, 3);
  s.beside = __builtin_shufflevector(s.at, from1, 1, 2) - cosine * s.axial;
  const double depth = s.det * s.dn;
  const unsigned inside = (s.det > least_det ? 3u : 0u) & bits(magnitude(s.axial) < room_h * s.det) &
                          bits(s.beside * s.beside * s.square + depth * depth * s.rr <
                               room_r * magnitude(room_r) * (s.s2 * (s.det * s.det)));
  const Both scaled = s.at * (inverse * s.radii);
  x = {scaled - cosine * crosswise(scaled), f.dn * s.r[0] * (inverse * s.det)};
  return inside == 3;
}

// A common point of the solids, if the separating-axis filter finds that they meet.
[[gnu::always_inline]] inline bool find_point(const SectionsOfBoth& f, double error,
                                              PlaneWeights& x) noexcept {
  FirstSlice slice(f);
  return find_least(f, error, slice, x);
}

constexpr int reweight_cap = 3;  // more save next to nothing

// The same once more, with each weight times the share of its half length that the first point used. So parts
// outside count for more, and the largest of the four becomes less (Lawson's way to the least maximum).
bool find_point_again(const SectionsOfBoth& f, double error, PlaneWeights& x) noexcept {
  FirstSlice s(f);
  find_least(f, error, s, x);
  const Both widths = s.r * (root(s.s2 - s.dn * s.dn) / s.sum);
  for (int i = 0; i < reweight_cap; ++i) {
    const double inverse = 1 / s.det;
    s.along = s.along * (magnitude(s.axial) * inverse / s.h);
    s.across = s.across * (magnitude(s.beside) * inverse / widths);
    if (find_least(f, error, s, x)) return true;
  }
  return false;
}

// If neither sum of squares has a common point: along the longer sides, then the whole
// overlap.
bool find_point_otherwise(const SectionsOfBoth& f, double error, PlaneWeights& x) noexcept {
  const double s = root(f.s2), inverse = 1 / s, z = f.dn * inverse, u = x.c * s, v = z - u;
  const double r0 = f.r[0], r1 = f.r[1], d0 = f.d[0], d1 = f.d[1];
  const Rectangle<double> rectangle0{0, 0, 1, 0, f.h[0], root(positive((r0 - u) * (r0 + u)))};
  const Rectangle<double> rectangle1{d0,     (d1 - f.cosine * d0) * inverse,     f.cosine, s,
                                     f.h[1], root(positive((r1 - v) * (r1 + v)))};
  const auto attempt = [&](const PlanePoint<double>& at) {
    const double b = at.y * inverse;
    x.ab = Both{at.x - f.cosine * b, b};
    return in_both(f, inverse * inverse, error, x);
  };
  PlanePoint<double> at;
  return attempt(on_long_side(rectangle0, rectangle1)) || attempt(on_long_side(rectangle1, rectangle0)) ||
         (middle_of_overlap(rectangle0, rectangle1, 0.0, at) && attempt(at));
}

[[gnu::always_inline]] inline void hand_out(const Prepared& a, const Prepared& b, const SectionsOfBoth& f,
                                            const PlaneWeights& x, Answer& answer) noexcept {
  answer.verdict = Verdict::intersecting;
  answer.proof = Proof::point;
  answer.point_head = a.center;
  const Vector3 &v = a.unit_axis, &w = b.unit_axis;
  answer.point_tail = {x.ab[0] * v.x() + x.ab[1] * w.x() + x.c * f.nx,
                       x.ab[0] * v.y() + x.ab[1] * w.y() + x.c * f.ny,
                       x.ab[0] * v.z() + x.ab[1] * w.z() + x.c * f.nz};
}

// For axes that are one: along it, across it, or a point that divides the way across in the ratio of the
// radii. Each must hold beyond the effect of rounding (section 8). If one of them only just holds, nothing is
// returned.
[[gnu::noinline]] bool prove_with_one_axis(const Prepared& a, const Prepared& b, Answer& answer) noexcept {
  const Vector3 &w = a.unit_axis, delta = b.center - a.center;
  const double r0 = a.radius, r1 = b.radius, h0 = a.height * 0.5, h1 = b.height * 0.5, radii = r0 + r1;
  const double reach = radii + h0 + h1 + std::fabs(delta.x()) + std::fabs(delta.y()) + std::fabs(delta.z());
  const double along = dot(delta, w), error = parallel_error * reach;
  const Vector3 off = delta - along * w;
  const double square = dot(off, off), rest = square - error * reach;
  const bool stacked = std::fabs(along) - h0 - h1 > error;
  if (stacked | ((rest > 0) & (rest * rest > radii * radii * square))) {
    // A direction has no unit.
    hand_out(stacked ? Vector3(std::copysign(1.0, along) * w)
                     : Vector3(power_of_two(-exponent_of(max_abs(off))) * off),
             answer);
    return true;
  }
  const double share = r0 / radii, room0 = r0 - error, room1 = r1 - error, other = 1 - share;
  const double t = middle_of_both(h0, along, h1);
  if (!((std::fabs(t) < h0 - error) & (std::fabs(along - t) < h1 - error) & (room0 > 0) & (room1 > 0) &
        (share * share * square < room0 * room0) & (other * other * square < room1 * room1)))
    return false;
  hand_out(Proof::point, a.center, t * w + share * off, Hull::space, Hull::space, answer);
  return true;
}

// The state after the five directions and the first point, if they leave the pair open: axes at an angle or
// not, and the known facts.
struct Unresolved {
  bool steep;
  SectionsOfBoth f;
  double error;
  PlaneWeights x;
};

// The common case. The separating-axis filter decides by more than rounding, and the numbers that it compared
// are proof enough (section 8). It is for ordinary solids, with axes at an angle or one axis. If it returns
// false, `open` has the known facts.
[[gnu::always_inline]] inline bool prove_by_filter(const Prepared& a, const Prepared& b, Unresolved& open,
                                                   Answer& answer) noexcept {
  const double cosine = cosine_of(a, b);
  open.steep = magnitude(cosine) <= steep_cosine;
  if (!open.steep) return a.unit_axis == b.unit_axis && prove_with_one_axis(a, b, answer);
  open.f = sections_of_both(a, b, cosine);
  const SectionsOfBoth& f = open.f;
  const double reach =
      f.r[0] + f.r[1] + f.h[0] + f.h[1] + magnitude(f.dx) + magnitude(f.dy) + magnitude(f.dz);
  const unsigned apart = shown_apart(f, filter_error * reach);
  if (apart != 0) {
    hand_out(direction_of(static_cast<unsigned>(std::countr_zero(apart)), f, a.unit_axis, b.unit_axis),
             answer);
    return true;
  }
  open.error = point_error * reach;
  if (!find_point(f, open.error, open.x)) return false;
  hand_out(a, b, f, open.x, answer);
  return true;
}

bool prove_steep(const Prepared& a, const Prepared& b, Unresolved& open, Answer& answer) noexcept {
  const SectionsOfBoth& f = open.f;
  const auto filter = separating_axis_filter(f);
  if (filter.apart) return false;
  if (filter.overlaps) {
    // Flat solids have no such point.
    if ((bits(f.r <= both(open.error)) | bits(f.h <= both(open.error))) != 0) return false;
    if (!find_point_again(f, open.error, open.x) && !find_point_otherwise(f, open.error, open.x))
      return false;
    hand_out(a, b, f, open.x, answer);
    return true;
  }
  const Scaled p = as_it_is(a, b);
  const Frame frame(p, f.d[0], f.d[1], {f.nx, f.ny, f.nz}, f.of_each());
  const Base base{a.center, 0};
  ProofTask q(p, base, answer);
  prove_at_optimum(q, p, frame);
  return answer.proof != Proof::none;
}

// Everything else.
[[gnu::noinline]] void prove_in_full(const Prepared& first, const Prepared& second, Answer& answer) noexcept {
  if ((first.defect != Defect::none) | (second.defect != Defect::none)) {
    answer.verdict = Verdict::invalid;
    return;
  }
  const Scaled p = scale(first, second);
  const Base base{first.center, p.exponent};
  // Does the same as decide() for ordinary solids, so that the answer does not depend on the scene's unit.
  // The exception is a unit so small that a point may lose bits on the way back into it.
  if (!both_are(Prepared::ordinary, first, second) && p.exponent > coarse_exponent) {
    Prepared a = first, b = second;
    a.center = {0, 0, 0}, b.center = p.delta;
    a.radius = p.r0, a.height = 2 * p.h0, b.radius = p.r1, b.height = 2 * p.h1;
    if (Unresolved open;
        prove_by_filter(a, b, open, answer) || (open.steep && prove_steep(a, b, open, answer))) {
      answer.point_head = first.center;
      answer.point_tail = times_power(answer.point_tail, p.exponent);
      if (answer.point_tail.allFinite()) return;
      answer = Answer{};  // the largest double is near: other points may be nearer
    }
  }
  ProofTask question(p, base, answer);
  const Axes axes(first.unit_axis, second.unit_axis);
  if (axes.parallel()) {
    prove_parallel(question, Parallel(p.delta, p.h0 + p.h1, p.r0 + p.r1, axes.sum));
  } else {
    const Frame frame(p, axes);
    if (!prove_by_filter(question, p, frame)) prove_at_optimum(question, p, frame);
    if (answer.proof == Proof::none) prove_with_slack(question, axes);
  }
  if (answer.proof == Proof::none && first.center == second.center) {
    answer.verdict = Verdict::intersecting;
    answer.proof = Proof::point;
    answer.point_head = first.center;
  }
}

// By value, so that no other function has to keep `open` in memory.
[[gnu::noinline]] void prove_unresolved(const Prepared& first, const Prepared& second, Unresolved open,
                                        Answer& answer) noexcept {
  if (!open.steep || !prove_steep(first, second, open, answer)) prove_in_full(first, second, answer);
}

template <bool ordinary>
[[gnu::always_inline]] inline Answer decide_cores(const Prepared& a, const Prepared& b) noexcept {
  Answer answer;
  bool swapped = a.radius > b.radius;
  if (a.radius == b.radius) swapped = out_of_order(a, b);
  // A table, because a branch would be unpredictable.
  constexpr double turns[] = {1, -1};
  const Prepared* const roles[] = {&a, &b};
  const Prepared &first = *roles[swapped], &second = *roles[!swapped];
  Unresolved open;
  if (!ordinary || !prove_by_filter(first, second, open, answer)) {
    if (ordinary)
      prove_unresolved(first, second, open, answer);
    else
      prove_in_full(first, second, answer);
    if (swapped) std::swap(answer.hull_a, answer.hull_b);
  }
  // A direction that proves nothing stays +0.
  answer.direction = turns[swapped & (answer.proof == Proof::direction)] * answer.direction;
  return answer;
}

// Not inlined, to keep the common path small.
[[gnu::noinline]] Answer decide_other(const Prepared& a, const Prepared& b) noexcept {
  if (a.defect == Defect::none && b.defect == Defect::none) {
    if (has_other_shape(a, b)) return decide_shapes(a, b, 0);
    if (a.rounding + b.rounding > 0) return decide_rounded(a, b, 0);
  }
  return decide_cores<false>(a, b);
}

}  // namespace

Answer decide(const Prepared& a, const Prepared& b) noexcept {
  if (both_are(Prepared::ordinary, a, b)) return decide_cores<true>(a, b);
  if (!both_are(Prepared::moderate, a, b)) return decide_other(a, b);
  return has_other_shape(a, b) ? decide_shapes(a, b, 0) : decide_rounded(a, b, 0);
}

Answer decide(const Solid& a, const Solid& b) noexcept { return decide(prepare(a), prepare(b)); }

}  // namespace cyl
