// SPDX-License-Identifier: MIT
// Solids grown by balls: they meet where the solids without their rounding come within the sum of the
// roundings, the room. Derivation: rounded.md.
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

bool is_room(double x) noexcept { return x >= 0 && x <= std::numeric_limits<double>::max(); }

// What a quick look at a pair tells: 0 disjoint, 1 intersecting, as Verdict has them.
enum class Glance : unsigned char { disjoint, intersecting, neither };

double square(double x) noexcept { return x * x; }

Verdict verdict_of(bool met) noexcept { return met ? Verdict::intersecting : Verdict::disjoint; }

// A ball about the end of `to` from the middle of the core (rounded.md, section 2).
Verdict meets_point(const Prepared& core, const Vector3& to, double room) noexcept {
  const double along = dot(to, core.unit_axis);
  const Vector3 across = to - along * core.unit_axis;
  const double out = larger(0, std::fabs(along) - 0.5 * core.height);
  const double beside = larger(0, std::sqrt(dot(across, across)) - core.radius);
  return verdict_of(out * out + beside * beside <= room * room);
}

// Below that the sine's square says too little of two segments where they are nearest.
constexpr double level_square = 0x1p-10;

// Two segments whose nearest points are inside both, or on an end that lies towards the others' nearest
// point: both such ends are looked at, in terms that the roles of the solids do not change. No division
// (rounded.md, section 3).
[[gnu::always_inline]] inline bool segments_meet(const Vector3& delta, const Vector3& w0, const Vector3& w1,
                                                 double h0, double h1, double c, double room) noexcept {
  const double square = 1 - c * c, room2 = room * room;
  const double d0 = dot(delta, w0), d1 = dot(delta, w1);
  const double s_square = d0 - c * d1, t_square = c * d0 - d1;
  const bool inside = (std::fabs(s_square) <= h0 * square) & (std::fabs(t_square) <= h1 * square);
  const double across = dot(delta, w0.cross(w1));
  const bool inner = across * across <= room2 * square;
  const auto near = [&](double s, double t) {
    const Vector3 e = delta + (t * w1 - s * w0);
    return dot(e, e) <= room2;
  };
  const double end0 = std::copysign(h0, s_square), end1 = std::copysign(h1, t_square);
  const double beside0 = larger(-h1, smaller(h1, c * end0 - d1)),
               beside1 = larger(-h0, smaller(h0, c * end1 + d0));
  const bool outer = near(end0, beside0) | near(beside1, end1);
  return (inside & inner) | (!inside & outer);
}

// Two segments, either of which may be a point, in any position. Any two points of them show that they are no
// farther apart, and the direction between these how far they are apart at least.
Glance look_at_segments(const Scaled& p, double room) noexcept {
  const double c = dot(p.w0, p.w1), d0 = dot(p.delta, p.w0), d1 = dot(p.delta, p.w1);
  const double determinant = 1 - c * c;
  const double inner = p.h0 * p.h1 > 0 && determinant > 0 ? (d0 - c * d1) / determinant : d0;
  const double t = std::clamp(c * std::clamp(inner, -p.h0, p.h0) - d1, -p.h1, p.h1);
  const double s = std::clamp(d0 + c * t, -p.h0, p.h0);
  const Vector3 e = p.delta + t * p.w1 - s * p.w0;
  const double most2 = dot(e, e);
  if (most2 <= square(room)) return Glance::intersecting;
  const double least = dot(e, p.delta) - p.h0 * std::fabs(dot(e, p.w0)) - p.h1 * std::fabs(dot(e, p.w1));
  if (least > 0 && square(least) > square(room) * most2) return Glance::disjoint;
  return Glance::neither;
}

// By the five directions of the separating-axis filter, and by its first slice without any rounding.
Glance look_at_filter(const Scaled& p, double room) noexcept {
  const Couple<double> couple = p.couple();
  const Products<double> q = products(couple);
  if (!(magnitude(q.cosine) <= steep_cosine)) return Glance::neither;
  const Sections<double> f = sections(couple, q);
  const double room_s = f.s * room;
  const bool apart = (f.z_s - f.s * (f.r0 + f.r1) > room_s) | (f.k0 - f.s * f.r1 > room) |
                     (f.k1 - f.s * f.r0 > room) | (f.k2_s - f.s * (f.r0 + f.c * f.r1) > room_s) |
                     (f.k3_s - f.s * (f.c * f.r0 + f.r1) > room_s);
  if (apart) return Glance::disjoint;
  const auto filter = separating_axis_filter(f);
  return filter.met & !filter.apart ? Glance::intersecting : Glance::neither;
}

Prepared core_of(const Prepared& c) noexcept {
  Prepared core = c;
  core.rounding = 0;
  core.ordinary = c.moderate;
  return core;
}

// A point of a centred solid near x: without need of room in the hull where the solid is flat, and so far
// inside elsewhere that rounding does not carry it out.
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

// Two points, one of each solid, no farther apart than the room beyond rounding. `on0`, `on1` from the first
// centre.
bool try_points(const Scaled& p, Vector3 on0, Vector3 on1, double room, Answer& answer) noexcept {
  const double reach = reach_of(p) + room;
  // Twice what in_both allows for, of a point no farther than `reach` from either centre.
  const double error = 4 * membership_error * reach + underflow_error;
  // Where the solids themselves meet the two may be far apart: what is nearest to the one serves.
  const Vector3 nearer = nearest(on0 - p.delta, p.w1, p.r1, p.h1) + p.delta;
  if (length(nearer - on0) < length(on1 - on0)) on1 = nearer;
  const Hull hull0 = hull_of(p.r0, p.h0, reach), hull1 = hull_of(p.r1, p.h1, reach);
  // The certificate is what is handed out, so that is what gets checked: in the scene's unit, where a
  // subnormal coordinate may have lost bits.
  const Vector3 tail0 = times_power(inner_point(on0, p.w0, p.r0, p.h0, hull0, error), p.exponent);
  const Vector3 tail1 = times_power(inner_point(on1 - p.delta, p.w1, p.r1, p.h1, hull1, error), p.exponent);
  const Vector3 at0 = times_power(tail0, -p.exponent), at1 = times_power(tail1, -p.exponent);
  const Place place0(at0, p.w0), place1(at1, p.w1);
  const double apart = length(p.delta + at1 - at0) + place0.off(hull0) + place1.off(hull1) + 2 * error;
  if (!(place0.inside(p.r0, p.h0, hull0, error) & place1.inside(p.r1, p.h1, hull1, error)) ||
      !(apart + separation_error * reach <= room))
    return false;
  answer.verdict = Verdict::intersecting;
  answer.proof = Proof::points;
  answer.point_tail = tail0;
  answer.other_tail = tail1;
  answer.hull_a = hull0;
  answer.hull_b = hull1;
  return true;
}

// f(D) + room |D| < 0 beyond rounding.
bool try_rounded_direction(const Scaled& p, const Vector3& d, double room, Answer& answer) noexcept {
  const double f = p.r0 * length(d.cross(p.w0)) + p.h0 * std::fabs(dot(d, p.w0)) +
                   p.r1 * length(d.cross(p.w1)) + p.h1 * std::fabs(dot(d, p.w1)) - std::fabs(dot(d, p.delta));
  if (!(f + room * length(d) < -separation_error * length(d) * (reach_of(p) + room))) return false;
  answer.verdict = Verdict::disjoint;
  answer.proof = Proof::direction;
  answer.direction = dot(d, p.delta) < 0 ? Vector3(-d) : d;
  return true;
}

double scaled_length(double x, int exponent) noexcept { return std::ldexp(x, -exponent); }

}  // namespace

double room_of(const Prepared& a, const Prepared& b, double clearance) noexcept {
  return (a.rounding + b.rounding) + clearance;
}

Verdict intersect_rounded(const Prepared& a, const Prepared& b, double room) noexcept {
  if (a.moderate & b.moderate & (room <= 0x1p202)) {
    const Vector3 delta = b.center - a.center;
    const bool point_a = a.radius + a.height == 0, point_b = b.radius + b.height == 0;
    if (point_a & point_b) return verdict_of(dot(delta, delta) <= room * room);
    if (point_a) return meets_point(b, delta, room);
    if (point_b) return meets_point(a, delta, room);
    const bool segments = a.radius + b.radius == 0;
    if (segments) {
      const double c = dot(a.unit_axis, b.unit_axis);
      if (1 - c * c >= level_square)
        return verdict_of(
            segments_meet(delta, a.unit_axis, b.unit_axis, 0.5 * a.height, 0.5 * b.height, c, room));
    }
    const bool swapped = out_of_order(a, b);
    const Scaled p = swapped ? as_it_is(b, a) : as_it_is(a, b);
    const Glance seen = segments ? look_at_segments(p, room) : look_at_filter(p, room);
    if (seen != Glance::neither) return verdict_of(seen == Glance::intersecting);
  }
  const double gap = distance_of_cores(core_of(a), core_of(b)).value;
  constexpr double most = std::numeric_limits<double>::max();
  if (gap == most && room >= most) return Verdict::undecided;  // neither is known
  return gap > room ? Verdict::disjoint : Verdict::intersecting;
}

// The answer of two solids in one order, told in the other.
Answer turned(Answer answer) noexcept {
  if (answer.proof == Proof::direction) answer.direction = -answer.direction;
  if (answer.proof == Proof::points) std::swap(answer.point_tail, answer.other_tail);
  std::swap(answer.hull_a, answer.hull_b);
  return answer;
}

Answer decide_rounded(const Prepared& a, const Prepared& b, double room) noexcept {
  if (out_of_order(a, b)) return turned(decide_rounded(b, a, room));
  const Prepared first = core_of(a), second = core_of(b);
  Answer answer = decide(first, second);
  if (answer.proof == Proof::point) return answer;
  answer = Answer{};
  const Scaled p = scale(first, second);
  const double scaled_room = scaled_length(room, p.exponent);
  if (!std::isfinite(scaled_room)) return answer;
  const Distance d = distance_of_cores(first, second);
  const auto in_unit = [&](const Vector3& x) { return times_power(x, -p.exponent); };
  if (try_rounded_direction(p, d.direction, scaled_room, answer)) return answer;
  try_points(p, in_unit(d.on_a), in_unit(d.on_b) + p.delta, scaled_room, answer);
  return answer;
}

Verdict within(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const double room = room_of(a, b, clearance);
  if ((a.defect != Defect::none) | (b.defect != Defect::none) | !(clearance >= 0) | !is_room(room))
    return Verdict::invalid;
  return room > 0 ? intersect_rounded(a, b, room) : intersect(a, b);
}

Answer decide_within(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const double room = room_of(a, b, clearance);
  if ((a.defect == Defect::none) & (b.defect == Defect::none) & (clearance >= 0) & is_room(room)) {
    return room > 0 ? decide_rounded(a, b, room) : decide(a, b);
  }
  Answer answer;
  answer.verdict = Verdict::invalid;
  return answer;
}

}  // namespace cyl
