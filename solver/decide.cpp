// SPDX-License-Identifier: MIT
// The verdict with its proof. Symbols as in derivation.md. Whatever the search does here, what is handed out
// has passed a check with a rounding bound; what has not is `undecided`.
#include "solver/decide.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <utility>

#include "solver/detail/optimum.hpp"
#include "solver/detail/prove_with_room.hpp"
#include "solver/detail/rounded.hpp"

namespace cyl {
namespace {

void prove_parallel(const Question& q, const Parallel& found) noexcept {
  const Scaled& p = q.solids;
  if (found.stacked && try_direction(p, found.w, q.answer)) return;
  if (found.beside && try_direction(p, found.across(), q.answer)) return;
  if (found.stacked | found.beside) return;
  Vector3 x = middle_of_both(p.h0, found.along, p.h1) * found.w;
  if (found.distance > 0) x += middle_of_both(p.r0, found.distance, p.r1) * found.across();
  try_point(p, q.base, x, q.answer);
}

// The filter's own numbers as proof that the solids are apart, where they show it by more than rounding.
[[gnu::always_inline]] inline bool prove_apart_by_filter(const Couple<double>& p, const Products<double>& q,
                                                         const Sections<double>& f, double reach,
                                                         Answer& answer) noexcept {
  const double error = filter_error * reach;
  const unsigned beyond = (f.z_s - f.s * (p.r0 + p.r1) > error ? 1u : 0u) |
                          (f.k0 - f.s * p.r1 > error ? 2u : 0u) | (f.k1 - f.s * p.r0 > error ? 4u : 0u) |
                          (f.k2_s - f.s * (p.r0 + f.c * p.r1) > error ? 8u : 0u) |
                          (f.k3_s - f.s * (f.c * p.r0 + p.r1) > error ? 16u : 0u);
  if (beyond == 0) return false;
  // n, w0, w1, m0 and m1 as sums of w0, w1 and n. A table, since which of them it is nobody can predict.
  const double weights[5][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {q.cosine, -1, 0}, {-1, q.cosine, 0}};
  const double along[5] = {q.dn, q.d0, q.d1, q.cosine * q.d0 - q.d1, q.cosine * q.d1 - q.d0};
  const int j = std::countr_zero(beyond);
  const double sign = std::copysign(1.0, along[j]);
  const double a = sign * weights[j][0], b = sign * weights[j][1], n = sign * weights[j][2];
  answer.verdict = Verdict::disjoint;
  answer.proof = Proof::direction;
  answer.direction = {a * p.w0x + b * p.w1x + n * q.nx, a * p.w0y + b * p.w1y + n * q.ny,
                      a * p.w0z + b * p.w1z + n * q.nz};
  return true;
}

// The common case, where the separating-axis filter decides by more than rounding and the numbers it compared
// are proof enough (section 8): ordinary solids, axes at an angle.
[[gnu::always_inline]] inline bool prove_on_fast_path(const Couple<double>& p, const Base& base,
                                                      Answer& answer) noexcept {
  const Products<double> q = products(p);
  if (!(magnitude(q.cosine) <= steep_cosine)) return false;
  const Sections<double> f = sections(p, q);
  const auto filter = separating_axis_filter(f);
  const double radii = p.r0 + p.r1;
  const double reach = radii + p.h0 + p.h1 + std::fabs(p.dx) + std::fabs(p.dy) + std::fabs(p.dz);
  if (filter.apart) return prove_apart_by_filter(p, q, f, reach, answer);
  if (!filter.met) return false;
  // The slice at u, in coordinates along w0 and along (w1 - C w0)/s, in units of r0 + r1.
  const double inverse = 1 / f.s, unit = 1 / radii;
  const double h0 = p.h0 * unit, r0 = p.r0 * unit, h1 = p.h1 * unit, r1 = p.r1 * unit;
  const double z = f.z_s * inverse * unit, u = z * r0, v = z - u;
  const double along = q.d0 * unit, across = (q.d1 - q.cosine * q.d0) * inverse * unit;
  // The point where the squares of its coordinates in both rectangles, in units of their half lengths, sum up
  // to least: of the candidates tried the best that needs no case distinction. Weights times all squares, so
  // that there is one division.
  const double q2 = (1 - z) * (1 + z);
  const double hh0 = h0 * h0, bb0 = q2 * r0 * r0, hh1 = h1 * h1, bb1 = q2 * r1 * r1;
  const double first = hh0 * bb0, second = hh1 * bb1;
  const double along0 = bb0 * second, across0 = hh0 * second, along1 = bb1 * first, across1 = hh1 * first;
  const double c2 = f.c * f.c, xx = along1 * c2 + across1 * f.s2, yy = along1 * f.s2 + across1 * c2;
  const double xy = (along1 - across1) * (q.cosine * f.s);
  const double gx = xx * along + xy * across, gy = xy * along + yy * across;
  const double mx = xx + along0, my = yy + across0, solve = 1 / (mx * my - xy * xy);
  const double error = point_error * (reach * unit), room0 = r0 - error, room1 = r1 - error;
  const auto inside = [&](const PlanePoint<double>& at) {
    const double dx = at.x - along, dy = at.y - across;
    const double x1 = dx * q.cosine + dy * f.s, y1 = dy * q.cosine - dx * f.s;
    return (std::fabs(at.x) < h0 - error) & (std::fabs(x1) < h1 - error) & (room0 > 0) & (room1 > 0) &
           (at.y * at.y + u * u < room0 * room0) & (y1 * y1 + v * v < room1 * room1);
  };
  PlanePoint<double> at{(my * gx - xy * gy) * solve, (mx * gy - xy * gx) * solve};
  if (!inside(at)) {
    const double b = std::sqrt(positive(q2));
    const Rectangle<double> rectangle0{0, 0, 1, 0, h0, b * r0},
        rectangle1{along, across, q.cosine, f.s, h1, b * r1};
    at = on_long_side(rectangle0, rectangle1);
    if (!inside(at)) at = on_long_side(rectangle1, rectangle0);
    if (!inside(at)) return false;
  }
  const double w1 = at.y * inverse * radii, w0 = at.x * radii - w1 * q.cosine;
  const double n = u * radii * std::copysign(inverse, q.dn);
  answer.verdict = Verdict::intersecting;
  answer.proof = Proof::point;
  answer.point_head = base.center;
  answer.point_tail = {w0 * p.w0x + w1 * p.w1x + n * q.nx, w0 * p.w0y + w1 * p.w1y + n * q.ny,
                       w0 * p.w0z + w1 * p.w1z + n * q.nz};
  return true;
}

// Everything else.
[[gnu::noinline]] void prove_in_full(const Prepared& first, const Prepared& second, Answer& answer) noexcept {
  if ((first.defect != Defect::none) | (second.defect != Defect::none)) {
    answer.verdict = Verdict::invalid;
    return;
  }
  const Scaled p = scale(first, second);
  const Base base{first.center, p.exponent};
  // As decide() does with ordinary solids, so that the scene's unit cannot be seen in the answer; but where
  // it is so small that a point may lose bits when it goes back into it.
  if (!(first.ordinary & second.ordinary) && p.exponent > -900 &&
      prove_on_fast_path(p.couple(), base, answer)) {
    answer.point_tail = times_power(answer.point_tail, p.exponent);
    if (answer.point_tail.allFinite()) return;
    answer = Answer{};  // the largest double is near: other points may be nearer
  }
  const Question question{p, base, answer};
  const Axes axes(first.unit_axis, second.unit_axis);
  if (axes.parallel()) {
    prove_parallel(question, Parallel(p.delta, p.h0 + p.h1, p.r0 + p.r1, axes.sum));
  } else {
    const Frame frame(p, axes);
    if (!prove_by_filter(question, p, frame)) prove_at_optimum(question, p, frame);
    if (answer.proof == Proof::none) prove_with_room(question, axes);
  }
  if (answer.proof == Proof::none && first.center == second.center) {
    answer.verdict = Verdict::intersecting;
    answer.proof = Proof::point;
    answer.point_head = first.center;
  }
}

template <bool ordinary>
[[gnu::always_inline]] inline Answer decide_cores(const Prepared& a, const Prepared& b) noexcept {
  Answer answer;
  bool swapped = a.radius > b.radius;
  if (a.radius == b.radius) swapped = out_of_order(a, b);
  // Looked up, since nobody can predict it.
  const Prepared* const roles[] = {&a, &b};
  const Prepared &first = *roles[swapped], &second = *roles[!swapped];
  if (!ordinary || !prove_on_fast_path(as_it_is(first, second).couple(), {first.center, 0}, answer)) {
    prove_in_full(first, second, answer);
    if (swapped) std::swap(answer.hull_a, answer.hull_b);
  }
  answer.direction *= 1 - 2 * static_cast<double>(swapped);
  return answer;
}

// Apart, so that solids that are not ordinary cost others nothing.
[[gnu::noinline]] Answer decide_other(const Prepared& a, const Prepared& b) noexcept {
  if (a.rounding + b.rounding > 0 && a.defect == Defect::none && b.defect == Defect::none)
    return decide_rounded(a, b, room_of(a, b, 0));
  return decide_cores<false>(a, b);
}

}  // namespace

Answer decide(const Prepared& a, const Prepared& b) noexcept {
  return (a.ordinary & b.ordinary) ? decide_cores<true>(a, b) : decide_other(a, b);
}

Answer decide(const Cylinder& a, const Cylinder& b) noexcept { return decide(prepare(a), prepare(b)); }

}  // namespace cyl
