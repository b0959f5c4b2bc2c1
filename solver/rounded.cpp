// SPDX-License-Identifier: MIT
// Solids grown by balls. They meet if the distance of the solids without their rounding is at most the sum of
// the roundings, the contact distance. Derivation: rounded.md.
#include "solver/detail/rounded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/detail/certify.hpp"
#include "solver/detail/distance_frame.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

bool is_contact_distance(double x) noexcept { return x >= 0 && x <= std::numeric_limits<double>::max(); }

// The result of a quick test of a pair: 0 disjoint, 1 intersecting, as in Verdict.
enum class QuickVerdict : unsigned char { disjoint, intersecting, neither };

double square(double x) noexcept { return x * x; }

double scaled_length(double x, int exponent) noexcept { return std::ldexp(x, -exponent); }

// Without a branch: which of the two it is cannot be predicted.
Verdict verdict_of(bool overlaps) noexcept {
  static_assert(static_cast<int>(Verdict::disjoint) == 0 && static_cast<int>(Verdict::intersecting) == 1);
  return static_cast<Verdict>(overlaps);
}

double clamped(double x, double most) noexcept { return larger(-most, smaller(most, x)); }

// A ball about the end of `to` from the middle of the core (rounded.md, section 2).
Verdict meets_point(const Prepared& core, const Vector3& to, double contact_distance) noexcept {
  const double along = dot(to, core.unit_axis);
  const Vector3 across = to - along * core.unit_axis;
  const double out = positive(std::fabs(along) - 0.5 * core.height);
  const double beside = positive(std::sqrt(dot(across, across)) - core.radius);
  return verdict_of(out * out + beside * beside <= contact_distance * contact_distance);
}

// Below that, the square of the sine does not locate the nearest points of two segments well enough.
constexpr double level_square = 0x1p-10;

struct NearestParameters {
  double s, t;  // of the points c0 + s w0 and c1 + t w1
  bool reliable;
};

// The nearest points of two segments. A segment may be a point (rounded.md, section 3). The longer one leads.
// If both are equal, the one whose free optimum lies farther leads. If even that is equal, or the axes are
// too near to parallel, the result is not reliable. So the order of the solids has no effect.
[[gnu::always_inline]] inline NearestParameters nearest_of_segments(double h0, double h1, double u0,
                                                                    double u1, double c) noexcept {
  const double square = 1 - c * c;
  const bool first = (h0 > h1) | ((h0 == h1) & (u0 > u1));
  const double hp = larger(h0, h1), hq = smaller(h0, h1);
  const double up = pick(first, u0, u1), uq = pick(first, u1, u0);
  const double free = clamped((up + c * uq) / square, hp);
  const double q = clamped(uq + c * free, hq), p = clamped(up + c * q, hp);
  const bool even = (h0 == h1) & (u0 == u1);
  const bool reliable = (square >= level_square) | (hq == 0);
  return {pick(first, p, q), pick(first, q, p), reliable && !even};
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

Prepared core_of(const Prepared& c) noexcept {
  Prepared core = c;
  core.rounding = 0;
  core.ordinary = c.moderate;
  return core;
}

// A point of a centred solid near x. For a flat solid it lies in the hull and needs no margin. Else it lies
// so far inside that rounding does not carry it out.
Vector3 inner_point(const Vector3& x, const Vector3& w, double r, double h, Hull hull,
                    double error) noexcept {
  const double along = dot(x, w);
  const Vector3 across = x - along * w;
  const double beside = length(across), most = larger(0, r - 2 * error);
  const bool on_line = (hull == Hull::line) | (hull == Hull::center);
  const bool in_plane = (hull == Hull::plane) | (hull == Hull::center);
  const double kept_along = in_plane ? 0 : larger(2 * error - h, smaller(h - 2 * error, along));
  const double part = on_line ? 0 : beside > most ? most / beside : 1;
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
  answer.verdict = Verdict::intersecting;
  answer.proof = Proof::points;
  answer.point_head = point0;
  answer.point_tail = point1;
  answer.hull_a = hull0;
  answer.hull_b = hull1;
  return true;
}

// f(D) + R |D| < 0 beyond rounding.
bool try_rounded_direction(const Scaled& p, Vector3 d, double contact_distance, Answer& answer) noexcept {
  // A direction has no unit: a way between points has.
  const double most = max_abs(d);
  if (!(most >= 0x1p-900)) return false;
  d *= power_of_two(-exponent_of(most));
  const double f = p.r0 * length(d.cross(p.w0)) + p.h0 * std::fabs(dot(d, p.w0)) +
                   p.r1 * length(d.cross(p.w1)) + p.h1 * std::fabs(dot(d, p.w1)) - std::fabs(dot(d, p.delta));
  if (!(f + contact_distance * length(d) < -separation_error * length(d) * (reach_of(p) + contact_distance)))
    return false;
  answer.verdict = Verdict::disjoint;
  answer.proof = Proof::direction;
  answer.direction = dot(d, p.delta) < 0 ? Vector3(-d) : d;
  return true;
}

// From there on a contact distance or a gap may overflow, so the solids are first made smaller. Lengths that
// vanish beside the contact distance do not matter.
constexpr double huge_distance = 0x1p1000, huge_shrink = 0x1p-100;

Prepared shrunk(Prepared c) noexcept {
  c.center *= huge_shrink;
  c.radius *= huge_shrink;
  c.height *= huge_shrink;
  c.rounding *= huge_shrink;
  c.ordinary = c.moderate = c.thin = c.ball = false;
  return c;
}

}  // namespace

double contact_distance_of(const Prepared& a, const Prepared& b, double clearance) noexcept {
  return (a.rounding + b.rounding) + clearance;
}

namespace {

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

constexpr int first_steps = 2;  // with a great contact distance they mostly do
constexpr int more_steps = 6;   // more of them cost more than distance_of_cores() does

// For solids in their order (frame.hpp).
QuickVerdict classify_by_projection(const Prepared& a, const Prepared& b, double contact_distance) noexcept {
  const Scaled p = as_it_is(a, b);
  if (a.thin & b.thin) return classify_segments(p, contact_distance);
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
  mark_moderate(c);
  c.moderate &= ((c.center.array() == 0) == (before.center.array() == 0)).all() &
                ((c.radius == 0) == (before.radius == 0)) & ((c.height == 0) == (before.height == 0)) &
                ((c.rounding == 0) == (before.rounding == 0));
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
  if (!(first.moderate & second.moderate) || std::ldexp(moved, -exponent) != clearance) return false;
  verdict = within(first, second, moved);
  return true;
}

Verdict intersect_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const double contact_distance = contact_distance_of(a, b, clearance);
  if (a.moderate & b.moderate & (clearance <= moderate_length)) {
    const Vector3 delta = b.center - a.center;
    if (a.ball & b.ball) return verdict_of(dot(delta, delta) <= contact_distance * contact_distance);
    if (a.thin & b.thin) {
      const double c = dot(a.unit_axis, b.unit_axis);
      const NearestParameters nearest = nearest_of_segments(
          0.5 * a.height, 0.5 * b.height, dot(delta, a.unit_axis), -dot(delta, b.unit_axis), c);
      const Vector3 e = delta + (nearest.t * b.unit_axis - nearest.s * a.unit_axis);
      if (nearest.reliable) return verdict_of(dot(e, e) <= contact_distance * contact_distance);
    } else if (a.ball | b.ball) {
      const Prepared* const solids[] = {&a, &b};
      return meets_point(*solids[a.ball], delta, contact_distance);
    }
    QuickVerdict seen =
        (a.thin & b.thin) ? QuickVerdict::neither : classify_by_filter(as_it_is(a, b), contact_distance);
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

namespace {

// Returns the answer of two solids in one order as an answer in the other.
Answer turned(Answer answer) noexcept {
  if (answer.proof == Proof::direction) answer.direction = -answer.direction;
  if (answer.proof == Proof::points) std::swap(answer.point_head, answer.point_tail);
  std::swap(answer.hull_a, answer.hull_b);
  return answer;
}

void hand_out_direction(const Vector3& d, Answer& answer) noexcept {
  answer.verdict = Verdict::disjoint;
  answer.proof = Proof::direction;
  answer.direction = power_of_two(-exponent_of(max_abs(d))) * d;
}

void hand_out_points(const Scaled& p, const Vector3& on0, const Vector3& on1, Hull hull0, Hull hull1,
                     Answer& answer) noexcept {
  answer.verdict = Verdict::intersecting;
  answer.proof = Proof::points;
  answer.point_head = times_power(on0, p.exponent);
  answer.point_tail = times_power(on1, p.exponent);
  answer.hull_a = hull0;
  answer.hull_b = hull1;
}

// Whether a way between the cores separates them by more than the contact distance: `least` is -f along it,
// times its length.
bool is_beyond(double least, double square_of_way, double contact_distance, double reach) noexcept {
  const double beyond = contact_distance + 2 * separation_error * reach;
  return (least > 0) & (least * least > beyond * beyond * square_of_way);
}

// Two cores, each a segment or a point. Their nearest points are known in closed form (rounded.md, section
// 3). They serve as certificate, or by the vector between them.
bool prove_segments(const Scaled& p, double contact_distance, Answer& answer) noexcept {
  const NearestParameters nearest =
      nearest_of_segments(p.h0, p.h1, dot(p.delta, p.w0), -dot(p.delta, p.w1), dot(p.w0, p.w1));
  if (!nearest.reliable) return false;
  const double reach = reach_of(p) + contact_distance, error = 4 * membership_error * reach + underflow_error;
  const Vector3 e = p.delta + (nearest.t * p.w1 - nearest.s * p.w0);
  const double least = dot(e, p.delta) - p.h0 * std::fabs(dot(e, p.w0)) - p.h1 * std::fabs(dot(e, p.w1));
  if (is_beyond(least, dot(e, e), contact_distance, reach)) {
    hand_out_direction(e, answer);
    return true;
  }
  // Moved in from its end, and off its line, each is off by `error` at most; in a centre it is that.
  const Hull hull0 = hull_of(0, p.h0, reach), hull1 = hull_of(0, p.h1, reach);
  const double s = hull0 == Hull::center ? 0 : clamped(nearest.s, p.h0 - 2 * error);
  const double t = hull1 == Hull::center ? 0 : clamped(nearest.t, p.h1 - 2 * error);
  const Vector3 on0 = s * p.w0, on1 = t * p.w1, between = p.delta + (on1 - on0);
  const double within = contact_distance - 5 * error;
  if (!((within > 0) & (dot(between, between) <= within * within))) return false;
  hand_out_points(p, on0, on1, hull0, hull1, answer);
  return true;
}

// Does the same for a point, and a core that is neither flat nor thin (rounded.md, section 2).
bool prove_ball(const Scaled& p, double contact_distance, Answer& answer) noexcept {
  const bool second = p.r1 + p.h1 == 0;  // the ball
  const Vector3 &w = second ? p.w0 : p.w1, to = second ? p.delta : Vector3(-p.delta);
  const double r = second ? p.r0 : p.r1, h = second ? p.h0 : p.h1,
               reach = r + h + length(to) + contact_distance;
  if (hull_of(r, h, reach) != Hull::space) return false;
  const double error = 4 * membership_error * reach + underflow_error;
  const double along = dot(to, w), kept = clamped(along, h - 2 * error), most = r - 2 * error;
  const Vector3 across = to - along * w;
  const double square_across = dot(across, across);
  const double part = square_across > most * most ? most / std::sqrt(square_across) : 1;
  // From the point just inside: nearest enough for the direction, too.
  const Vector3 on = kept * w + part * across, e = to - on;
  const double square_of_way = dot(e, e), within = contact_distance - 5 * error;
  if ((within > 0) & (square_of_way <= within * within)) {
    const Vector3 center(0, 0, 0);
    if (second)
      hand_out_points(p, on, center, Hull::space, Hull::center, answer);
    else
      hand_out_points(p, center, on, Hull::center, Hull::space, answer);
    return true;
  }
  const double least = dot(e, to) - h * std::fabs(dot(e, w)) - r * length(e.cross(w));
  if (!is_beyond(least, square_of_way, contact_distance, reach)) return false;
  hand_out_direction(second ? e : Vector3(-e), answer);
  return true;
}

bool prove_in_closed_form(const Scaled& p, double contact_distance, Answer& answer) noexcept {
  if (p.exponent <= coarse_exponent) return false;  // points may lose bits on their way back
  if (p.r0 + p.r1 == 0) return prove_segments(p, contact_distance, answer);
  return (p.r0 + p.h0 == 0 || p.r1 + p.h1 == 0) && prove_ball(p, contact_distance, answer);
}

// By the points and directions of alternate_projections(), most pairs.
bool prove_between(const Scaled& p, double contact_distance, Answer& answer) noexcept {
  constexpr int step_cap = first_steps + more_steps;
  Vector3 on0 = nearest(p.delta, p.w0, p.r0, p.h0);
  if (p.r0 + p.r1 == 0) {
    const double c = dot(p.w0, p.w1);
    const NearestParameters nearest =
        nearest_of_segments(p.h0, p.h1, dot(p.delta, p.w0), -dot(p.delta, p.w1), c);
    if (nearest.reliable) on0 = nearest.s * p.w0;
  }
  for (int i = 0; i < step_cap; ++i) {
    const Vector3 on1 = p.delta + nearest(on0 - p.delta, p.w1, p.r1, p.h1), e = on1 - on0;
    if (dot(e, e) <= square(contact_distance)) return try_points(p, on0, on1, contact_distance, answer);
    if (try_rounded_direction(p, e, contact_distance, answer)) return true;
    on0 = nearest(on1, p.w0, p.r0, p.h0);
  }
  return false;
}

}  // namespace

Answer decide_rounded(const Prepared& a, const Prepared& b, double clearance) noexcept {
  if (out_of_order(a, b)) return turned(decide_rounded(b, a, clearance));
  Answer answer;
  const double contact_distance = contact_distance_of(a, b, clearance);
  if (contact_distance >= huge_distance) {
    answer = decide_rounded(shrunk(a), shrunk(b), huge_shrink * clearance);
    answer.point_head /= huge_shrink;
    answer.point_tail /= huge_shrink;
    return answer;
  }
  const Prepared first = core_of(a), second = core_of(b);
  const Scaled p = scale(first, second, contact_distance);
  const double scaled_contact = scaled_length(contact_distance, p.exponent);
  if (prove_in_closed_form(p, scaled_contact, answer) || prove_between(p, scaled_contact, answer))
    return answer;
  const Answer of_cores = decide(first, second);
  if (of_cores.proof == Proof::point) return of_cores;
  const Distance d = distance_of_cores(first, second, false);
  const auto in_unit = [&](const Vector3& x) { return times_power(x, -p.exponent); };
  if (try_rounded_direction(p, d.direction, scaled_contact, answer)) return answer;
  try_points(p, in_unit(d.on_a), in_unit(d.on_b) + p.delta, scaled_contact, answer);
  return answer;
}

Verdict within(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const double contact_distance = contact_distance_of(a, b, clearance);
  if ((a.defect != Defect::none) | (b.defect != Defect::none) | !(clearance >= 0) |
      !is_contact_distance(contact_distance))
    return Verdict::invalid;
  return contact_distance > 0 ? intersect_rounded(a, b, clearance) : intersect(a, b);
}

Answer decide_within(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const double contact_distance = contact_distance_of(a, b, clearance);
  if ((a.defect == Defect::none) & (b.defect == Defect::none) & (clearance >= 0) &
      is_contact_distance(contact_distance)) {
    return contact_distance > 0 ? decide_rounded(a, b, clearance) : decide(a, b);
  }
  Answer answer;
  answer.verdict = Verdict::invalid;
  return answer;
}

}  // namespace cyl
