// SPDX-License-Identifier: MIT
// Solids grown by balls: they meet where the solids without their rounding come within the sum of the roundings,
// the room. Derivation: rounded.md.
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/detail/certify.hpp"
#include "solver/detail/distance_frame.hpp"
#include "solver/detail/rounded.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

bool is_clearance(double x) noexcept { return x >= 0 && x <= std::numeric_limits<double>::max(); }

// What a quick look at a pair tells: 0 disjoint, 1 intersecting, as Verdict has them.
enum class Glance : unsigned char { disjoint, intersecting, neither };

double square(double x) noexcept { return x * x; }

// Two segments, either of which may be a point. Any two points of them show that they are no farther apart, and the
// direction between these how far they are apart at least (rounded.md, section 2).
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

// A point of a centred solid near x: without need of room in the hull where the solid is flat, and so far inside
// elsewhere that rounding does not carry it out.
struct Inner {
  Vector3 at;
  Hull hull;
  double off;  // of the hull, at most
  bool inside;
};

Inner inner_point(const Vector3& x, const Vector3& w, double r, double h, double reach) noexcept {
  // Twice what in_both allows for, of a point no farther than `reach` from either centre.
  const double error = 4 * membership_error * reach + underflow_error;
  const Hull hull = hull_of(r, h, reach);
  const double along = dot(x, w);
  const Vector3 across = x - along * w;
  const double beside = length(across), most = larger(0, r - 2 * error);
  const bool on_line = (hull == Hull::line) | (hull == Hull::center);
  const bool in_plane = (hull == Hull::plane) | (hull == Hull::center);
  const double kept_along = in_plane ? 0 : std::clamp(along, 2 * error - h, h - 2 * error);
  const double part = on_line ? 0 : beside > most ? most / beside : 1;
  const Vector3 at = kept_along * w + part * across;
  const Place place(at, w);
  return {at, hull, place.off(hull) + error, place.inside(r, h, hull, error)};
}

// Two points, one of each solid, no farther apart than the room beyond rounding. `on0`, `on1` from the first centre.
bool try_points(const Scaled& p, Vector3 on0, Vector3 on1, double room, Answer& answer) noexcept {
  const double reach = reach_of(p) + room;
  // Where the solids themselves meet the two may be far apart: what is nearest to the one serves.
  const Vector3 nearer = nearest(on0 - p.delta, p.w1, p.r1, p.h1) + p.delta;
  if (length(nearer - on0) < length(on1 - on0)) on1 = nearer;
  const Inner in0 = inner_point(on0, p.w0, p.r0, p.h0, reach);
  const Inner in1 = inner_point(on1 - p.delta, p.w1, p.r1, p.h1, reach);
  const double apart = length(p.delta + in1.at - in0.at) + in0.off + in1.off;
  if (!in0.inside || !in1.inside || !(apart + separation_error * reach <= room)) return false;
  const Vector3 tail0 = times_power(in0.at, p.exponent), tail1 = times_power(in1.at, p.exponent);
  if (p.exponent < -900 || !tail0.allFinite() || !tail1.allFinite()) return false;  // bits may be lost on the way
  answer.verdict = Verdict::intersecting;
  answer.proof = Proof::points;
  answer.point_tail = tail0;
  answer.other_tail = tail1;
  answer.hull_a = in0.hull;
  answer.hull_b = in1.hull;
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
    const Scaled p{a.unit_axis,    b.unit_axis, b.center - a.center, a.radius,
                   a.height * 0.5, b.radius,    b.height * 0.5,      0};
    const Glance seen = a.radius + b.radius == 0 ? look_at_segments(p, room) : look_at_filter(p, room);
    if (seen != Glance::neither) return seen == Glance::disjoint ? Verdict::disjoint : Verdict::intersecting;
  }
  const double gap = distance_of_cores(core_of(a), core_of(b)).value;
  constexpr double most = std::numeric_limits<double>::max();
  if (gap == most && room >= most) return Verdict::undecided;  // neither is known
  return gap > room ? Verdict::disjoint : Verdict::intersecting;
}

Answer decide_rounded(const Prepared& a, const Prepared& b, double room) noexcept {
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
  if ((a.defect != Defect::none) | (b.defect != Defect::none) | !is_clearance(clearance)) return Verdict::invalid;
  const double room = room_of(a, b, clearance);
  return room > 0 ? intersect_rounded(a, b, room) : intersect(a, b);
}

Answer decide_within(const Prepared& a, const Prepared& b, double clearance) noexcept {
  if ((a.defect == Defect::none) & (b.defect == Defect::none) & is_clearance(clearance)) {
    const double room = room_of(a, b, clearance);
    return room > 0 ? decide_rounded(a, b, room) : decide(a, b);
  }
  Answer answer;
  answer.verdict = Verdict::invalid;
  return answer;
}

}  // namespace cyl
