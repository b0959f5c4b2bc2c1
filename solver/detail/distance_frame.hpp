// SPDX-License-Identifier: MIT
// The working frame of distance.cpp: f, the frame with all signs turned, the lowest point of a circle. Only
// for files of solver/. Symbols as in distance.md.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "solver/detail/frame.hpp"
#include "solver/distance.hpp"

namespace cyl {

// The point of a centred solid nearest to x.
inline Vector3 nearest(const Vector3& x, const Vector3& w, double r, double h) noexcept {
  const double along = dot(x, w);
  const Vector3 radial = x - along * w;
  const double square = dot(radial, radial);
  const double shrink = square > r * r ? r / std::sqrt(square) : 1;
  return larger(-h, smaller(h, along)) * w + shrink * radial;
}

// The point of a centred solid farthest along the unit vector d. If that is a face or a line within `error`,
// its middle.
inline Vector3 farthest(const Vector3& d, const Vector3& w, double r, double h, double error) noexcept {
  const double along = dot(d, w);
  const Vector3 radial = d - along * w;
  const double across = length(radial);
  return (std::fabs(along) * h > error ? std::copysign(h, along) : 0) * w +
         (across * r > error ? r / across : 0) * radial;
}

// Axes that are not parallel. Both are turned, and m0, m1 chosen perpendicular to them in their plane, so
// that
//   w0.w1 = c,  m0.w1 = m1.w0 = s,  m0.m1 = -c,  z = Delta.n >= 0,  e0 = Delta.m0 >= 0,  e1 = Delta.m1 >= 0.
struct TurnedFrame {
  TurnedFrame(const Scaled& p, const Axes& axes) noexcept {
    const double beside = dot(p.delta, axes.cross);
    s = std::sqrt(axes.square);
    n = axes.cross * std::copysign(1 / s, beside);
    z = std::fabs(beside) / s;
    m0 = p.w0.cross(n);
    m1 = p.w1.cross(n);
    const double turn0 = std::copysign(1.0, dot(p.delta, m0)), turn1 = std::copysign(1.0, dot(p.delta, m1));
    m0 *= turn0;
    m1 *= turn1;
    const double sign0 = std::copysign(1.0, dot(m1, p.w0)), sign1 = std::copysign(1.0, dot(m0, p.w1));
    w0 = p.w0 * sign0;
    w1 = p.w1 * sign1;
    const auto [along0, along1] = axes.along(p.delta);
    d0 = along0 * sign0;
    d1 = along1 * sign1;
    e0 = dot(p.delta, m0);
    e1 = dot(p.delta, m1);
    // At right angles within rounding: an angle of 2^-60 instead moves nothing, and no quotient below is 0/0.
    c = std::copysign(larger(std::fabs(axes.cosine), 0x1p-60), dot(w0, w1));
  }
  Vector3 n, w0, w1, m0, m1;
  double z, s, c, d0, d1, e0, e1;
};

inline constexpr int circle_step_cap = 60;  // 3 or 4 are usual

struct Turn {
  double x, y;
};

// Section 2. On the circle perpendicular to one axis: D = x n + y m, x and y >= 0. Beyond x = 1 the varying
// part of f, r sqrt(x^2 + c^2 y^2) - z x - e y, has at most one minimum inside the quarter. E(t) = its
// derivative over x, t = y/x, is convex, and the minimum is at the larger root. {1, 0} if there is none.
inline Turn lowest_on_circle(double z, double e, double r, double s, double c, int& steps) noexcept {
  const double bend = r * s * s, cc = c * c;
  if (!(e > 0) && z >= bend) return {1, 0};  // E >= 0 everywhere
  const double q1 = 1 / std::sqrt(1 + cc), g1 = z - e - bend * q1, slope1 = z - bend * (q1 * q1 * q1);
  if (g1 >= 0 && slope1 > 0) {
    double t = e > 0 ? e / (e + g1) : 1;
    for (int i = 0; i < circle_step_cap; ++i) {
      ++steps;
      const double q = 1 / std::sqrt(1 + cc * t * t);
      const double slope = z - bend * (q * q * q);
      if (!(slope > 0)) {
        if (i > 0) return {1, 0};
        t = 1;
        continue;
      }
      const double step = (z * t - e - bend * t * q) / slope;
      t -= step;
      if (!(t > 0)) return {1, 0};
      if (std::fabs(step) <= 0x1p-27 * t || t <= 0x1p-60) break;  // below that, D is n
    }
    const double x = 1 / std::sqrt(1 + t * t);
    return {x, t * x};
  }
  double t = e > 0 && z > bend ? (z - bend) / e : 0;  // x/y here
  // not covered: Newton on a convex function ends before the cap
  for (int i = 0; i < circle_step_cap; ++i) {
    ++steps;
    const double q = 1 / std::sqrt(t * t + cc);
    const double slope = e + bend * cc * (q * q * q);
    if (!(slope > 0)) return {1, 0};
    const double step = (z - e * t - bend * t * q) / slope;
    if (!(step > 0)) break;  // rounding
    t += step;
    if (step <= 0x1p-27 * t) break;
  }
  const double y = 1 / std::sqrt(1 + t * t);
  return {t * y, y};
}

// Whether f >= `low` on the circle perpendicular to an axis of radius `own`. z and e are as above, both >= 0
// except for e. Note that sqrt(x^2 + c^2 y^2) is at least x, and at least 1 - (1 - c) y.
inline bool circle_is_above(double z, double e, double own, double other, double c, double low) noexcept {
  const double room = own - low, from_z = larger(0, z - other), from_e = larger(0, e);
  const double both = room + other, from_chord = larger(0, e + other * (1 - c));
  return (room >= 0 && from_z * from_z + from_e * from_e <= room * room) ||
         (both >= 0 && z * z + from_chord * from_chord <= both * both);
}

// Cut off at the largest double.
inline double in_range(double x) noexcept {
  constexpr double most = std::numeric_limits<double>::max();
  return larger(-most, smaller(most, x));
}

// Parallel axes: apart along w, across it, or both.
inline void measure_parallel(const Scaled& p, const Vector3& axis_sum, Distance& out) noexcept {
  const Vector3 w = axis_sum / length(axis_sum);
  const double along = dot(p.delta, w);
  // It is perpendicular to w even if nearly all of Delta is along w. If all is along it but for rounding,
  // `off` need not be perpendicular to w. Then Delta counts as along it.
  constexpr double coaxial_error = 8 * unit_roundoff_error;
  const Vector3 rest = p.delta - along * w, off = rest - dot(rest, w) * w;
  const double across = length(off) > coaxial_error * std::fabs(along) ? length(off) : 0;
  // Any direction perpendicular to w if there is none.
  Vector3 u;
  if (across > 0) {
    u = off * power_of_two(-exponent_of(max_abs(off)));  // its square may have no digits left
    u /= length(u);
  } else {
    int least = 0;
    for (int i = 1; i < 3; ++i)
      if (std::fabs(w[i]) < std::fabs(w[least])) least = i;
    const Vector3 unit(least == 0 ? 1 : 0, least == 1 ? 1 : 0, least == 2 ? 1 : 0);
    u = w.cross(unit);
    u /= length(u);
  }
  if (dot(u, p.delta) < 0) u = -u;
  const double beyond = std::fabs(along) - p.h0 - p.h1, beside = across - p.r0 - p.r1;
  const double sign = std::copysign(1.0, along);
  const bool by_caps = beyond > 0 || (beside <= 0 && beyond >= beside), by_sides = beside > 0 || !by_caps;
  const double along0 = by_caps ? sign * p.h0 : middle_of_both(p.h0, along, p.h1);
  const double along1 = by_caps ? -sign * p.h1 : along0 - along;
  const double across0 = by_sides ? p.r0 : middle_of_both(p.r0, across, p.r1);
  const double across1 = by_sides ? -p.r1 : across0 - across;
  out.on_a = along0 * w + across0 * u;
  out.on_b = along1 * w + across1 * u;
  if (by_caps && by_sides) {
    const double most = larger(beyond, beside), x = beyond / most, y = beside / most;
    const double root = std::sqrt(x * x + y * y);
    out.value = most * root;
    out.direction = (x / root * sign) * w + (y / root) * u;
  } else {
    out.value = by_caps ? beyond : beside;
    out.direction = by_caps ? Vector3(sign * w) : u;
  }
  out.error = distance_error * (p.r0 + p.h0 + p.r1 + p.h1 + length(p.delta));
  out.least = !(out.value > 0);
}

}  // namespace cyl
