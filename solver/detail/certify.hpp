// SPDX-License-Identifier: MIT
// Whether a direction or a point proves a verdict beyond rounding: derivation.md, section 8. For decide()
// alone.
#pragma once

#include <limits>

#include "solver/detail/both_solids.hpp"

namespace cyl {

// In a unit of 2^that or less the scene's own numbers may be subnormal: points lose bits when they go back
// into it.
inline constexpr int coarse_exponent = -900;

// The centre of the solid whose frame is used; answers are given from it.
struct Base {
  const Vector3& center;
  int exponent;  // of the frame's unit
};

inline Vector3 times_power(const Vector3& x, int exponent) noexcept {
  if (exponent == 0) return x;
  return {std::ldexp(x.x(), exponent), std::ldexp(x.y(), exponent), std::ldexp(x.z(), exponent)};
}

// x in the scene's unit. False if it loses bits there.
inline bool brought_to_scene(const Vector3& x, int exponent, Vector3& tail) noexcept {
  tail = times_power(x, exponent);
  return exponent == 0 || times_power(tail, -exponent) == x;
}

inline double reach_of(const Scaled& p) noexcept { return p.r0 + p.h0 + p.r1 + p.h1 + length(p.delta); }

// How much decide() grows and shrinks solids if rounding decides, relative to the reach. It is 64 units of
// rounding of separation_error. sqrt(8) of it, twice the size for the reach, is below 1e-13.
inline constexpr double proof_slack_tol = 0x1p-46;

// A solid no thicker than that is taken for flat: a common point in its plane or line needs no room across
// it.
inline Hull hull_of(double r, double h, double reach) noexcept {
  static_assert(static_cast<int>(Hull::plane) == 1 && static_cast<int>(Hull::line) == 2);
  const bool thin = r <= proof_slack_tol * reach, low = h <= proof_slack_tol * reach;
  return static_cast<Hull>(2 * static_cast<int>(thin) + static_cast<int>(low));
}
inline bool in_plane(Hull hull) noexcept { return (static_cast<int>(hull) & 1) != 0; }
inline bool on_line(Hull hull) noexcept { return (static_cast<int>(hull) & 2) != 0; }

// Writes a proof into the answer.
inline void hand_out(const Vector3& direction, Answer& answer) noexcept {
  answer.verdict = Verdict::disjoint;
  answer.proof = Proof::direction;
  answer.direction = direction;
}
inline void hand_out(Proof proof, const Vector3& head, const Vector3& tail, Hull hull0, Hull hull1,
                     Answer& answer) noexcept {
  answer.verdict = Verdict::intersecting;
  answer.proof = proof;
  answer.point_head = head;
  answer.point_tail = tail;
  answer.hull_a = hull0;
  answer.hull_b = hull1;
}

// As a sum, because compilers make two branches of a test of two bools.
inline bool none_of(bool x, bool y) noexcept { return static_cast<int>(x) + static_cast<int>(y) == 0; }

// Whether a way between the solids separates them by more than `beyond`: `least` is -f along it, times its
// length.
inline bool is_beyond(double least, double square_of_way, double beyond) noexcept {
  return least * std::fabs(least) > beyond * beyond * square_of_way;
}

// All bits, or none.
inline BothBits mask_of(bool yes) noexcept {
  const long long bits = -static_cast<long long>(yes);
  return BothBits{bits, bits};
}

// x, y or 0, without a branch. At most one of the masks has bits.
[[gnu::always_inline]] inline Vector3 either(BothBits of_x, const Vector3& x, BothBits of_y,
                                             const Vector3& y) noexcept {
  const Both first = Both((BothBits(Both{x[0], x[1]}) & of_x) | (BothBits(Both{y[0], y[1]}) & of_y)),
             last = Both((BothBits(Both{x[2], 0}) & of_x) | (BothBits(Both{y[2], 0}) & of_y));
  return {first[0], first[1], last[0]};
}

// One of two proofs: `kind`, of the points, or the direction. No branch can predict which of the two it
// is, or `swapped`, so there is none: point 0 of `points` and hull 0 are of the second solid.
[[gnu::always_inline]] inline Answer proof_of(bool meets, Proof kind, const Vector3& direction,
                                              const Vector3& point0, const Vector3& point1, Hull hull0,
                                              Hull hull1, bool swapped) noexcept {
  static_assert(static_cast<int>(Proof::direction) == 1);
  const bool turned = swapped & (kind == Proof::points);
  const BothBits apart = mask_of(!meets), same = mask_of(meets & !turned), other = mask_of(meets & turned);
  const int hulls[] = {meets * static_cast<int>(hull0), meets * static_cast<int>(hull1)};
  return {verdict_of(meets),
          static_cast<Proof>(1 + meets * (static_cast<int>(kind) - 1)),
          either(apart, direction, BothBits{}, direction),
          either(same, point0, other, point1),
          either(same, point1, other, point0),
          static_cast<Hull>(hulls[swapped]),
          static_cast<Hull>(hulls[!swapped])};
}

// The answer to the pair in the other order, if `swapped`. Tables, because branches would be unpredictable.
inline Answer in_order(bool swapped, const Answer& found) noexcept {
  Answer answer = found;
  constexpr double turns[] = {1, -1};
  const bool points = swapped & (found.proof == Proof::points);
  const Vector3* const ends[] = {&found.point_head, &found.point_tail};
  const Hull hulls[] = {found.hull_a, found.hull_b};
  // A direction that proves nothing stays +0.
  answer.direction = turns[swapped & (found.proof == Proof::direction)] * found.direction;
  answer.point_head = *ends[points];
  answer.point_tail = *ends[!points];
  answer.hull_a = hulls[swapped];
  answer.hull_b = hulls[!swapped];
  return answer;
}

// A direction has no unit. The way in one of about `size`, turned if `turns`.
inline Vector3 without_unit(const Vector3& way, double size, bool turns = false) noexcept {
  const double unit = power_of_two(-exponent_of(size));
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(unit) | static_cast<std::uint64_t>(turns) << 63) *
         way;
}

// The question, and the place of its certificate. Each is checked against these solids.
struct ProofTask {
  ProofTask(const Scaled& of, const Base& from, Answer& to) noexcept
      : solids(of), base(from), answer(to), reach(reach_of(of)) {}
  // True if an evaluation leaves no gap, or no ball in both, that a double shows. In the scene's unit, if
  // that is not so small that rounding is coarser there.
  bool no_gap() const noexcept {
    return base.exponent > coarse_exponent && outside <= separation_error * reach;
  }
  bool no_slack() const noexcept {
    return base.exponent > coarse_exponent && overlap <= separation_error * reach;
  }

  const Scaled& solids;
  const Base& base;
  Answer& answer;
  double reach;
  // The results of failed attempts: the least f(D)/|D| of a direction, and how far the best point is outside
  // the farther of the two solids.
  double overlap = std::numeric_limits<double>::infinity();
  double outside = std::numeric_limits<double>::infinity();
};

// A point looked at from one solid: how far along its axis and across it.
struct Place {
  Place(const Vector3& x, const Vector3& w) noexcept
      : along(std::fabs(dot(x, w))), across(length(x.cross(w))), away(length(x)) {}
  double off(Hull hull) const noexcept {
    return hull == Hull::space ? 0 : hull == Hull::plane ? along : hull == Hull::line ? across : away;
  }
  double outside(double r, double h) const noexcept { return larger(along - h, across - r); }
  // With so much room left; within its hull a solid needs none across it.
  bool inside(double r, double h, Hull hull, double slack) const noexcept {
    return (in_plane(hull) | (along + slack < h)) &
           (on_line(hull) | ((r - slack > 0) & (across < r - slack)));
  }
  double along, across, away;
};

// Whether the point of both hulls nearest to x, as seen from both solids, lies inside both solids beyond
// rounding. It is no farther from x than x is off the one hull. If planes cross, or a plane and a line, the
// bound is the distance of x from both, over the sine of their angle. It is twice that for the line, which x
// goes along.
inline bool in_both(const Scaled& p, const Place& at0, const Place& at1, Hull hull0, Hull hull1) noexcept {
  const double error = membership_error * (at0.away + length(p.delta)) + underflow_error;
  double move = 0;
  if ((hull0 != Hull::space) & (hull1 != Hull::space)) {
    if ((hull0 == Hull::center) | (hull1 == Hull::center) | ((hull0 == Hull::line) & (hull1 == Hull::line)))
      return false;  // no double can show that they cross
    const bool planes = hull0 == hull1;
    const double sine = (planes ? length(p.w0.cross(p.w1)) : std::fabs(dot(p.w0, p.w1))) - separation_error;
    if (!(sine > 0)) return false;
    move = (at0.off(hull0) + at1.off(hull1) + 2 * error) * ((planes ? 1 : 2) / sine);
  } else if ((hull0 != Hull::space) | (hull1 != Hull::space)) {
    move = at0.off(hull0) + at1.off(hull1) + error;
  }
  return at0.inside(p.r0, p.h0, hull0, error + move) && at1.inside(p.r1, p.h1, hull1, error + move);
}

// f(D) + R |D| < 0 beyond rounding. Otherwise `overlap` has that over |D|, if it is less.
inline bool try_direction(const Scaled& p, Vector3 d, double contact_distance, double reach, double& overlap,
                          Answer& answer) noexcept {
  // Weights are products of lengths, and a way between points has a unit. A direction has none.
  const double most = max_abs(d);
  if (!(most >= 0x1p-900)) return false;
  d *= power_of_two(-exponent_of(most));
  const double size = length(d), f = support_gap(p, d) + contact_distance * size;
  if (!(f < -separation_error * size * reach)) {
    overlap = smaller(overlap, f / size);
    return false;
  }
  hand_out(dot(d, p.delta) < 0 ? Vector3(-d) : d, answer);
  return true;
}
inline bool try_direction(ProofTask& q, const Vector3& d) noexcept {
  return try_direction(q.solids, d, 0, q.reach, q.overlap, q.answer);
}

inline bool try_point(ProofTask& q, const Vector3& x) noexcept {
  // The returned certificate is the one that is checked. In the scene's unit, a subnormal coordinate may have
  // lost bits.
  const Scaled& p = q.solids;
  const int exponent = q.base.exponent;
  const Vector3 tail = times_power(x, exponent), given = times_power(tail, -exponent);
  const Place at0(given, p.w0), at1(given - p.delta, p.w1);
  Hull hull0 = Hull::space, hull1 = Hull::space;
  if (!in_both(p, at0, at1, hull0, hull1)) {
    q.outside = smaller(q.outside, larger(at0.outside(p.r0, p.h0), at1.outside(p.r1, p.h1)));
    hull0 = hull_of(p.r0, p.h0, q.reach);
    hull1 = hull_of(p.r1, p.h1, q.reach);
    if (((hull0 == Hull::space) & (hull1 == Hull::space)) || !in_both(p, at0, at1, hull0, hull1))
      return false;
  }
  hand_out(Proof::point, q.base.center, tail, hull0, hull1, q.answer);
  return true;
}

}  // namespace cyl
