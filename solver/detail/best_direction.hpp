// SPDX-License-Identifier: MIT
// The best direction and the nearest points that the search of distance.cpp has seen, and the steps that
// improve them from any place. Only for that file. Symbols as in distance.md.
#pragma once

#include <cmath>
#include <limits>

#include "solver/detail/distance_frame.hpp"
#include "solver/distance.hpp"

namespace cyl {

// Two values of f within this times the reach may be the same: twice distance_error.
inline constexpr double tie_error = 2 * distance_error;

inline constexpr int projection_cap = 60;   // of the points, if no other step brought the bounds together
inline constexpr int touch_cap = 6;         // of them from each start, if the solids overlap
inline constexpr int shorter_step_cap = 6;  // how often a step of Newton's method is shortened

class BestDirection {
 protected:
  explicit BestDirection(const Scaled& p) noexcept
      : p_(p), reach_(p.r0 + p.h0 + p.r1 + p.h1 + length(p.delta)) {}

  // Takes points whose way from each other is along the direction within rounding, or along which f is as
  // low.
  bool belong_together(const Vector3& d, const Vector3& on0, const Vector3& on1) noexcept {
    const Vector3 way = on1 - on0;
    const double apart = length(way);
    if (!(apart <= tie_error * reach_ - low_)) return false;
    Vector3 along = d;
    if (length(way - dot(way, d) * d) > distance_error * reach_) {
      along = way / apart;
      if (!(support_gap(p_, along) <= low_ + 0.5 * distance_error * reach_)) return false;
    }
    high_ = apart;
    direction_ = along;
    on0_ = on0;
    on1_ = on1;
    return true;
  }

  // Takes a direction and a point of one of the solids that goes with it, relative to C0, if they are better.
  // Returns true if they prove the gap.
  bool consider(const Vector3& along, const Vector3& anchor, bool on_b) noexcept {
    const double size = length(along);
    if (!(size > 0)) return false;
    return consider_unit(along * ((dot(along, p_.delta) < 0 ? -1 : 1) / size), anchor, on_b);
  }

  // For a unit vector towards b.
  bool consider_unit(const Vector3& d, const Vector3& anchor, bool on_b) noexcept {
    const double f = support_gap(p_, d);
    if (f < low_) {
      low_ = f;
      direction_ = d;
      anchor_ = anchor;
      on_b_ = on_b;
    }
    if (settling_) [[unlikely]] {
      if (!(f <= low_ + 0.5 * distance_error * reach_)) return false;
      const Vector3 other = opposite(anchor, on_b);
      return on_b ? belong_together(d, other, anchor) : belong_together(d, anchor, other);
    }
    // As low within rounding: the direction is the same, its point may be the better one.
    return f < 0 && f <= low_ + tie_error * reach_ && meet(anchor, on_b);
  }

  // The point of the other solid that is nearest.
  Vector3 opposite(const Vector3& anchor, bool on_b) const noexcept {
    return on_b ? nearest(anchor, p_.w0, p_.r0, p_.h0)
                : Vector3(nearest(anchor - p_.delta, p_.w1, p_.r1, p_.h1) + p_.delta);
  }

  // Takes a point and its nearest one in the other solid, if they are nearer. Returns true if they prove the
  // gap.
  bool meet(const Vector3& anchor, bool on_b) noexcept {
    const Vector3 other = opposite(anchor, on_b);
    const double distance = length(other - anchor);
    if (distance < high_) {
      high_ = distance;
      on0_ = on_b ? other : anchor;
      on1_ = on_b ? anchor : other;
    }
    return high_ + low_ <= tie_error * reach_;
  }

  // Newton's method on f over unit directions, with a step shortened until f falls. g is the part of y
  // perpendicular to D. The second derivative is sum r/s t t^T - f. Here t is perpendicular to the axis and
  // to D, and s is the sine of their angle. b0 lies along the valley. A step along it ends at half of the way
  // to the pole.
  void descend(Vector3 d, int step_cap) noexcept {
    const Scaled& p = p_;
    double value = support_gap(p, d);
    for (int step = 0; step < step_cap; ++step) {
      ++steps_;
      const Vector3 radial0 = d - dot(d, p.w0) * p.w0, radial1 = d - dot(d, p.w1) * p.w1;
      const double s0 = length(radial0), s1 = length(radial1);
      if (!(s0 > 0) || !(s1 > 0) || dot(d, p.delta) < 0) return;
      const Vector3 n0 = radial0 / s0, n1 = radial1 / s1;
      const Vector3 on0 = std::copysign(p.h0, dot(d, p.w0)) * p.w0 + p.r0 * n0;
      const Vector3 y = on0 + std::copysign(p.h1, dot(d, p.w1)) * p.w1 + p.r1 * n1 - p.delta;
      consider_unit(d, on0, false);
      const Vector3 flat = p.w0 - dot(p.w0, d) * d, b0 = flat / length(flat), b1 = d.cross(b0);
      const Vector3 t0 = n0.cross(p.w0), t1 = n1.cross(p.w1);
      const double g0 = dot(y, b0), g1 = dot(y, b1), k0 = p.r0 / s0, k1 = p.r1 / s1;
      const double q00 = k0 * dot(t0, b0) * dot(t0, b0) + k1 * dot(t1, b0) * dot(t1, b0) - value,
                   q01 = k0 * dot(t0, b0) * dot(t0, b1) + k1 * dot(t1, b0) * dot(t1, b1),
                   q11 = k0 * dot(t0, b1) * dot(t0, b1) + k1 * dot(t1, b1) * dot(t1, b1) - value;
      if (!(q11 > 0)) return;
      const double slope = g0 - q01 * g1 / q11, bend = q00 - q01 * q01 / q11, most = s0 / 2;
      double x0 = bend > 0 ? -slope / bend : -std::copysign(most, slope);
      x0 = larger(-most, smaller(most, x0));
      const double x1 = -(g1 + q01 * x0) / q11;
      double part = 1;
      int tries = 0;
      for (;; part /= 4) {
        const Vector3 turned = d + part * x0 * b0 + part * x1 * b1, next = turned / length(turned);
        const double now = support_gap(p, next);
        if (now < value) {
          d = next;
          value = now;
          break;
        }
        if (++tries == shorter_step_cap) return;
      }
    }
  }

  // From each solid to the other and back.
  bool project() noexcept {
    for (int i = 0; i < projection_cap; ++i) {
      ++steps_;
      if (meet(on0_, false) || meet(on1_, true)) return true;
    }
    return false;
  }

  bool come_to_plane() noexcept {
    const Vector3 moved = p_.delta + low_ * direction_;
    const double error = tie_error * reach_;
    high_ = std::numeric_limits<double>::infinity();  // of two points, one in a and one in b moved
    return come_together(on_b_ ? Vector3(anchor_ + low_ * direction_) : anchor_, moved, error) ||
           come_together(farthest(direction_, p_.w0, p_.r0, p_.h0, error), moved, error) ||
           come_together(moved - farthest(direction_, p_.w1, p_.r1, p_.h1, error), moved, error);
  }

  // From a point to one solid and to the other and back, keeping what is nearest.
  bool come_together(Vector3 x, const Vector3& moved, double error) noexcept {
    for (int i = 0; i < touch_cap; ++i) {
      ++steps_;
      const Vector3 on0 = nearest(x, p_.w0, p_.r0, p_.h0);
      x = nearest(on0 - moved, p_.w1, p_.r1, p_.h1) + moved;
      const double off = length(on0 - x);
      if (off < high_) {
        high_ = off;
        on0_ = on0;
        on1_ = on0 - low_ * direction_;
      }
      if (high_ <= error) return true;
    }
    return false;
  }

  const Scaled& p_;
  double reach_;
  double low_ = std::numeric_limits<double>::infinity();   // least f seen
  double high_ = std::numeric_limits<double>::infinity();  // least distance of two points seen
  Vector3 direction_{0, 0, 0}, anchor_{0, 0, 0}, on0_{0, 0, 0}, on1_{0, 0, 0};
  bool on_b_ = false, settling_ = false;
  int steps_ = 0;
};

}  // namespace cyl
