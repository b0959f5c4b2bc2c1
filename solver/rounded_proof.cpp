// SPDX-License-Identifier: MIT
// The verdict on solids grown by balls with its proof. Derivation: rounded.md.
#include <cmath>
#include <limits>

#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

double scaled_length(double x, int exponent) noexcept { return std::ldexp(x, -exponent); }

// A point of a centred solid near x. For a flat solid it lies in the hull and needs no margin. Else it lies
// so far inside that rounding does not carry it out.
Vector3 inner_point(const Vector3& x, const Vector3& w, double r, double h, Hull hull,
                    double error) noexcept {
  const double along = dot(x, w);
  const Vector3 across = x - along * w;
  const double beside = length(across), most = larger(0, r - 2 * error);
  const double kept_along = in_plane(hull) ? 0 : larger(2 * error - h, smaller(h - 2 * error, along));
  const double part = on_line(hull) ? 0 : beside > most ? most / beside : 1;
  return kept_along * w + part * across;
}

// Two points, one of each solid, no farther apart than the contact distance beyond rounding. `on0`, `on1`
// from the first centre.
bool try_points(const Scaled& p, Vector3 on0, Vector3 on1, double contact_distance, Answer& answer) noexcept {
  const double reach = reach_of(p) + contact_distance;
  // Twice what in_both allows for, of a point no farther than `reach` from either centre; and what a
  // coordinate loses that is subnormal in the scene's unit.
  const double lost = p.exponent > coarse_exponent
                          ? 0
                          : 2 * scaled_length(std::numeric_limits<double>::denorm_min(), p.exponent);
  const double error = 4 * membership_error * reach + underflow_error + lost;
  // If the solids themselves meet, the two may be far apart. The point nearest to the one serves.
  const Vector3 nearer = nearest(on0 - p.delta, p.w1, p.r1, p.h1) + p.delta;
  if (length(nearer - on0) < length(on1 - on0)) on1 = nearer;
  const Hull hull0 = hull_of(p.r0, p.h0, reach), hull1 = hull_of(p.r1, p.h1, reach);
  // The returned certificate is the one that is checked: in the scene's unit, in which a subnormal coordinate
  // may have lost bits.
  const Vector3 point0 = times_power(inner_point(on0, p.w0, p.r0, p.h0, hull0, error), p.exponent);
  const Vector3 point1 = times_power(inner_point(on1 - p.delta, p.w1, p.r1, p.h1, hull1, error), p.exponent);
  const Vector3 at0 = times_power(point0, -p.exponent), at1 = times_power(point1, -p.exponent);
  const Place place0(at0, p.w0), place1(at1, p.w1);
  const double apart = length(p.delta + at1 - at0) + place0.off(hull0) + place1.off(hull1) + 2 * error;
  if (!place0.inside(p.r0, p.h0, hull0, error) || !place1.inside(p.r1, p.h1, hull1, error) ||
      !(apart + separation_error * reach <= contact_distance))
    return false;
  hand_out(Proof::points, point0, point1, hull0, hull1, answer);
  return true;
}

bool try_rounded_direction(const Scaled& p, const Vector3& d, double contact_distance,
                           Answer& answer) noexcept {
  double overlap = 0;
  return try_direction(p, d, contact_distance, reach_of(p) + contact_distance, overlap, answer);
}

// Whether nothing can be proved. The points with the vector e between them are so near each other, and e
// separates so much, that no other points and no other direction pass (rounded.md, section 4).
bool is_hopeless(const Scaled& p, const Vector3& e, double contact_distance) noexcept {
  const double reach = reach_of(p) + contact_distance,
               below = contact_distance - 4 * membership_error * reach;
  if (!(below > 0 && dot(e, e) <= square(contact_distance + 0.5 * separation_error * reach))) return false;
  return -support_gap(p, e) > below * length(e);
}

// The error of the points and ways in closed form, relative to the reach (rounded.md, section 4).
constexpr double closed_form_error = 2 * membership_error;

// Two segments. Their nearest points are known in closed form (rounded.md, section
// 3). They serve as certificate, or by the vector between them. If they do not, the answer is `otherwise`.
template <class Otherwise>
[[gnu::always_inline]] inline Answer prove_segments(const Scaled& p, double contact_distance,
                                                    Otherwise otherwise) noexcept {
  const NearestParameters nearest = nearest_of_segments(p);
  const double reach = p.h0 + p.h1 + length_bound(p.delta) + contact_distance,
               error = closed_form_error * reach + underflow_error, within = contact_distance - error;
  const Vector3 e = p.delta + (nearest.t * p.w1 - nearest.s * p.w0);
  const double least = dot(e, p.delta) - (p.h0 * std::fabs(dot(e, p.w0)) + p.h1 * std::fabs(dot(e, p.w1)));
  // Moved in from its end, and off its line, each is off by `error` at most; in a centre it is that.
  const Hull hull0 = hull_of(0, p.h0, reach), hull1 = hull_of(0, p.h1, reach);
  const double s = in_plane(hull0) ? 0 : clamped(nearest.s, p.h0 - error);
  const double t = in_plane(hull1) ? 0 : clamped(nearest.t, p.h1 - error);
  const Vector3 on0 = s * p.w0, on1 = t * p.w1, between = p.delta + (on1 - on0);
  const double square_of_way = dot(e, e), most = contact_distance + 3 * error;
  const bool near = dot(between, between) <= within * std::fabs(within), sure = nearest.reliable,
             apart = is_beyond(least, square_of_way, contact_distance + error);
  if (none_of(near, apart) || !sure)
    return (sure & (within > 0) & (square_of_way <= most * most)) ? Answer() : otherwise();
  Vector3 point0, point1;
  if (!brought_to_scene(on0, p.exponent, point0) || !brought_to_scene(on1, p.exponent, point1))
    return otherwise();
  return proof_of(!apart, Proof::points, without_unit(e, reach), point0, point1, hull0, hull1, false);
}

// Two balls. One comparison shows nothing only within rounding of touching, which is that of 6 operations.
[[gnu::always_inline]] inline Answer prove_balls(const Vector3& delta, double contact_distance) noexcept {
  const double square_of_way = dot(delta, delta), error = separation_error * contact_distance;
  // The square of a tiny clearance may vanish.
  const bool near = (square_of_way == 0) | (square_of_way < square(contact_distance - error));
  if (none_of(near, square_of_way > square(contact_distance + error))) return {};
  return proof_of(near, Proof::points, without_unit(delta, max_abs(delta)), {0, 0, 0}, {0, 0, 0},
                  Hull::center, Hull::center, false);
}

// A point and another core (rounded.md, section 2), `to` the point from its centre. If `swapped`, the point
// is the first solid.
template <class Otherwise>
[[gnu::always_inline]] inline Answer prove_ball(const Vector3& w, double r, double h, const Vector3& to,
                                                double contact_distance, bool swapped, int exponent,
                                                Otherwise otherwise) noexcept {
  const double reach = (r + h + contact_distance) + length_bound(to),
               error = closed_form_error * reach + underflow_error, within = contact_distance - error;
  const Hull hull = hull_of(r, h, reach);
  const double along = dot(to, w);
  Vector3 on = (in_plane(hull) ? 0 : clamped(along, h - error)) * w;
  if (!on_line(hull)) {
    const Vector3 across = to - along * w;
    const double most = r - error;
    on += most / larger(most, std::sqrt(dot(across, across))) * across;
  }
  // From the point just inside: nearest enough for the direction, too.
  const Vector3 e = to - on;
  const double square_of_way = dot(e, e);
  const bool near = square_of_way <= within * std::fabs(within);
  if (none_of(near, square_of_way > square(contact_distance + 8 * error) + 2 * error * reach)) {
    const double least = dot(e, to) - h * std::fabs(dot(e, w)) - r * length(e.cross(w)),
                 most = contact_distance + 3 * error;
    if (!is_beyond(least, square_of_way, contact_distance + error))
      // Too near to touching for a proof. Else rounding turned a short way, and another may serve.
      return ((within > 0) & (square_of_way <= most * most)) ? Answer() : otherwise();
  }
  Vector3 point;
  if (!brought_to_scene(on, exponent, point)) return otherwise();
  return proof_of(near, Proof::points, without_unit(e, reach, swapped), point, {0, 0, 0}, hull, Hull::center,
                  swapped);
}

// By the points and directions of alternate_projections(), most pairs.
bool prove_between(const Scaled& p, double contact_distance, Answer& answer) noexcept {
  constexpr int step_cap = first_steps + more_steps;
  Vector3 on0 = nearest(p.delta, p.w0, p.r0, p.h0);
  if (p.r0 + p.r1 == 0) {
    const NearestParameters nearest = nearest_of_segments(p);
    if (nearest.reliable) on0 = nearest.s * p.w0;
  }
  for (int i = 0; i < step_cap; ++i) {
    const Vector3 on1 = p.delta + nearest(on0 - p.delta, p.w1, p.r1, p.h1), e = on1 - on0;
    if (dot(e, e) <= square(contact_distance))
      return try_points(p, on0, on1, contact_distance, answer) || is_hopeless(p, e, contact_distance);
    if (try_rounded_direction(p, e, contact_distance, answer) || is_hopeless(p, e, contact_distance))
      return true;
    on0 = nearest(on1, p.w0, p.r0, p.h0);
  }
  return false;
}

// For solids in their order.
[[gnu::noinline]] Answer prove_in_full(const Prepared& a, const Prepared& b, double clearance) noexcept {
  Answer answer;
  const double contact_distance = contact_distance_of(a, b, clearance);
  if (contact_distance >= huge_distance) {
    answer = prove_in_full(shrunk(a), shrunk(b), huge_shrink * clearance);
    answer.point_head /= huge_shrink;
    answer.point_tail /= huge_shrink;
    return answer;
  }
  const Prepared first = core_of(a), second = core_of(b);
  const Scaled p = scale(first, second, contact_distance);
  const double scaled_contact = scaled_length(contact_distance, p.exponent);
  const auto in_general = [&] {
    if (prove_between(p, scaled_contact, answer)) return answer;
    const Answer of_cores = decide(first, second);
    if (of_cores.proof == Proof::point) return of_cores;
    const Distance d = distance_of_cores(first, second, false);
    const auto in_unit = [&](const Vector3& x) { return times_power(x, -p.exponent); };
    if (try_rounded_direction(p, d.direction, scaled_contact, answer)) return answer;
    try_points(p, in_unit(d.on_a), in_unit(d.on_b) + p.delta, scaled_contact, answer);
    return answer;
  };
  const bool ball0 = p.r0 + p.h0 == 0, ball1 = p.r1 + p.h1 == 0;
  if (ball0 & ball1) return prove_balls(p.delta, scaled_contact);
  if (ball0) return prove_ball(p.w1, p.r1, p.h1, -p.delta, scaled_contact, true, p.exponent, in_general);
  if (ball1) return prove_ball(p.w0, p.r0, p.h0, p.delta, scaled_contact, false, p.exponent, in_general);
  return p.r0 + p.r1 == 0 ? prove_segments(p, scaled_contact, in_general) : in_general();
}

// For what is not proved in closed form. An exchange of the solids changes no digit of that.
[[gnu::noinline]] Answer prove_otherwise(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const bool swapped = out_of_order(a, b);
  return in_order(swapped, swapped ? prove_in_full(b, a, clearance) : prove_in_full(a, b, clearance));
}

}  // namespace

Answer decide_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const auto otherwise = [&] { return prove_otherwise(a, b, clearance); };
  if (!(both_are(Prepared::moderate, a, b) & (clearance <= power_of_two(moderate_exponent))))
    return otherwise();
  const double contact_distance = contact_distance_of(a, b, clearance);
  if (both_are(Prepared::ball, a, b)) return prove_balls(b.center - a.center, contact_distance);
  if (one_is_ball(a, b)) {
    const bool swapped = (a.traits & Prepared::ball) != 0;
    const Prepared* const solids[] = {&a, &b};  // as in not_ball()
    const Prepared &core = *solids[swapped], &ball = *solids[!swapped];
    return prove_ball(core.unit_axis, core.radius, 0.5 * core.height, ball.center - core.center,
                      contact_distance, swapped, 0, otherwise);
  }
  return both_are(Prepared::thin, a, b) ? prove_segments(as_it_is(a, b), contact_distance, otherwise)
                                        : otherwise();
}

Answer decide_within(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const double contact_distance = contact_distance_of(a, b, clearance);
  if (!is_valid_question(a, b, clearance, contact_distance)) return Answer{.verdict = Verdict::invalid};
  if (has_other_shape(a, b)) return decide_shapes(a, b, clearance);
  return contact_distance > 0 ? decide_rounded(a, b, clearance) : decide(a, b);
}

}  // namespace cyl
