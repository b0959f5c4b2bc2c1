// SPDX-License-Identifier: MIT
// The cores of rounded solids, which are the solids without their rounding. They meet the question if their
// distance is at most the contact distance. Only for files of solver/. Derivation: rounded.md.
#pragma once

#include <cmath>

#include "solver/detail/distance_frame.hpp"
#include "solver/detail/rounded.hpp"

namespace cyl {

inline double square(double x) noexcept { return x * x; }

inline double clamped(double x, double most) noexcept { return larger(-most, smaller(most, x)); }

inline Prepared core_of(const Prepared& c) noexcept {
  Prepared core = c;
  core.rounding = 0;
  if (c.shape == Shape::cylinder && (c.traits & Prepared::moderate) != 0) core.traits |= Prepared::ordinary;
  return core;
}

// Below that, the square of the sine does not locate the nearest points of two segments well enough.
inline constexpr double level_square = 0x1p-10;

inline bool one_is_ball(const Prepared& a, const Prepared& b) noexcept {
  return ((a.traits | b.traits) & Prepared::ball) != 0;
}
// The other solid than the ball. A table, because a branch would be unpredictable.
inline const Prepared& not_ball(const Prepared& a, const Prepared& b) noexcept {
  const Prepared* const solids[] = {&a, &b};
  return *solids[a.traits / Prepared::ball];
}

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

inline NearestParameters nearest_of_segments(const Scaled& p) noexcept {
  return nearest_of_segments(p.h0, p.h1, dot(p.delta, p.w0), -dot(p.delta, p.w1), dot(p.w0, p.w1));
}

// Two moderate solids whose cores are segments or points. Returns false if their nearest points are not
// reliable.
[[gnu::always_inline]] inline bool intersect_thin(const Prepared& a, const Prepared& b,
                                                  double contact_distance, Verdict& verdict) noexcept {
  const Vector3 delta = b.center - a.center;
  Vector3 e = delta;
  bool reliable = true;
  if (!both_are(Prepared::ball, a, b)) {
    if (one_is_ball(a, b)) {
      const Prepared& segment = not_ball(a, b);
      e -= clamped(dot(delta, segment.unit_axis), 0.5 * segment.height) * segment.unit_axis;
    } else {
      const NearestParameters nearest =
          nearest_of_segments(0.5 * a.height, 0.5 * b.height, dot(delta, a.unit_axis),
                              -dot(delta, b.unit_axis), dot(a.unit_axis, b.unit_axis));
      e += nearest.t * b.unit_axis - nearest.s * a.unit_axis;
      reliable = nearest.reliable;
    }
  }
  verdict = verdict_of(dot(e, e) <= contact_distance * contact_distance);
  return reliable;
}

// From there on a contact distance or a gap may overflow, so the solids are first made smaller. Lengths that
// vanish beside the contact distance do not matter.
inline constexpr double huge_distance = 0x1p1000, huge_shrink = 0x1p-100;

inline Prepared shrunk(Prepared c) noexcept {
  c.center *= huge_shrink;
  c.radius *= huge_shrink;
  c.height *= huge_shrink;
  c.rounding *= huge_shrink;
  c.traits = 0;
  return c;
}

// Steps of alternate projections between the cores. With a great contact distance the first ones mostly
// decide. More of them cost more than distance_of_cores() does.
inline constexpr int first_steps = 2, more_steps = 6;

}  // namespace cyl
