// SPDX-License-Identifier: MIT
// Rim on rim: a local minimum of the distance of a point on one from a point on the other. For distance.cpp
// alone. Symbols as in distance.md, section 3.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "solver/detail/distance_frame.hpp"

namespace cyl {

inline constexpr int rim_step_cap = 60;  // of one rim on another; 5 to 8 are usual

// A rim of each solid, and a point on each: (x, y) on (n, m0) and on (n, m1).
struct Rims {
  double side0, side1;  // which caps, along w0 and w1
  double x0, y0, x1, y1;
};

// The points on two rims, the vector y from the first to the second and the product of the tangents there.
class RimPoints {
 public:
  RimPoints(const Scaled& p, const TurnedFrame& f, const Rims& start) noexcept
      : k(start),
        p_(p),
        f_(f),
        e0_(f.e0 - start.side1 * p.h1 * f.s),
        e1_(f.e1 - start.side0 * p.h0 * f.s),
        l0_(f.d0 - start.side0 * p.h0 - start.side1 * p.h1 * f.c) {}

  // Newton on |y|^2 over the two angles, from the current ones, to a local minimum. False if that will be
  // more than `low`; then it stops early. Inlining gains 7 % of the time.
  [[gnu::always_inline]] bool come_near(int& steps, double low) noexcept {
    double last = std::numeric_limits<double>::infinity();
    Rims kept = k;
    Step step;
    bool fine = false, left = false;
    for (int i = 0;; ++i) {
      ++steps;
      look();
      if (fine || i == rim_step_cap) return true;
      const double now = square_of_y();
      if (now > last * (1 + 0x1p-40)) {
        step.turn0 /= 4;
        step.turn1 /= 4;
        fine = step.is_small();
      } else {
        last = now;
        kept = k;
        step = newton();
        fine = step.is_small();
        if (is_vain(step, now, low)) return false;
        // Stationary, but no minimum: once it is left along the direction in which |y| is bent down most.
        if (fine && !step.bowl && !left) {
          step = downwards();
          fine = false;
          left = true;
        }
      }
      turn(k.x0, k.y0, kept.x0, kept.y0, step.turn0);
      turn(k.x1, k.y1, kept.x1, kept.y1, step.turn1);
    }
  }

  const Rims& at() const noexcept { return k; }
  Vector3 on0() const noexcept { return k.side0 * p_.h0 * f_.w0 + p_.r0 * (k.x0 * f_.n + k.y0 * f_.m0); }
  Vector3 on1() const noexcept {
    return p_.delta - k.side1 * p_.h1 * f_.w1 - p_.r1 * (k.x1 * f_.n + k.y1 * f_.m1);
  }
  Vector3 tangent0() const noexcept { return k.x0 * f_.m0 - k.y0 * f_.n; }
  Vector3 tangent1() const noexcept { return k.x1 * f_.m1 - k.y1 * f_.n; }
  Vector3 y() const noexcept { return yn_ * f_.n + yw_ * f_.w0 + y0_ * f_.m0; }
  Vector3 product() const noexcept { return cn_ * f_.n + cw_ * f_.w0 + cm_ * f_.m0; }
  // Whether y is so short that the product of the tangents shows its direction better.
  bool near() const noexcept { return square_ * (p_.r0 + p_.r1) * (p_.r0 + p_.r1) > square_of_y(); }

 private:
  struct Step {
    double turn0 = 0, turn1 = 0;  // of the angles
    double det = 1, own = 1;      // of the equations: the determinant, and what it is without t0.t1
    bool bowl = true;             // whether |y|^2 is bent upwards in all directions
    // Small compared with the condition of the equations, or small anyway.
    bool is_small() const noexcept {
      const double most = larger(turn0 * turn0, turn1 * turn1);
      return most * own <= 0x1p-40 * det || most <= 0x1p-90;
    }
  };

  // Four times the promise of the model, at small steps, brings neither |y| down to `low` nor y to the inner
  // side of both rims, which would be a minimum of f.
  bool is_vain(const Step& step, double now, double low) const noexcept {
    constexpr double settled_turn = 0.125, most = std::numeric_limits<double>::infinity();
    const double turn0 = std::fabs(step.turn0), turn1 = std::fabs(step.turn1);
    if (!(low < most) || !step.bowl || larger(turn0, turn1) >= settled_turn) return false;
    const double fall = p_.r0 * slope0() * step.turn0 + p_.r1 * slope1() * step.turn1;
    if (now - 4 * fall > low * low) return true;
    const double move = p_.r0 * turn0 + p_.r1 * turn1, size = std::sqrt(now);
    return bend0() > 4 * (move + turn0 * size) || bend1() > 4 * (move + turn1 * size);
  }

  void look() noexcept {
    yn_ = f_.z - p_.r0 * k.x0 - p_.r1 * k.x1;
    y0_ = e0_ - p_.r0 * k.y0 + p_.r1 * f_.c * k.y1;
    y1_ = e1_ + p_.r0 * f_.c * k.y0 - p_.r1 * k.y1;
    yw_ = l0_ - p_.r1 * f_.s * k.y1;
    cn_ = f_.s * k.x0 * k.x1;
    cm_ = f_.s * k.x1 * k.y0;
    cw_ = k.x0 * k.y1 + f_.c * k.x1 * k.y0;
    square_ = cn_ * cn_ + cm_ * cm_ + cw_ * cw_;
  }
  double square_of_y() const noexcept { return yn_ * yn_ + y0_ * y0_ + yw_ * yw_; }
  double slope0() const noexcept { return k.x0 * y0_ - k.y0 * yn_; }  // y.t0
  double slope1() const noexcept { return k.x1 * y1_ - k.y1 * yn_; }
  double bend0() const noexcept { return k.x0 * yn_ + k.y0 * y0_; }  // y.u0
  double bend1() const noexcept { return k.x1 * yn_ + k.y1 * y1_; }
  double tangents() const noexcept { return k.y0 * k.y1 - f_.c * k.x0 * k.x1; }  // t0.t1

  // The equations of section 3, with the second one replaced by its difference from the first. If they are
  // not positive definite, it uses -y.u_i/4 for a negative y.u_i, which goes downwards in any case. A step
  // above 1/2 is shortened in both angles alike, or it might not go downwards.
  [[gnu::always_inline]] Step newton() const noexcept {
    Step step;
    const double b = tangents(), sign = std::copysign(1.0, b), across = p_.r0 * p_.r1 * square_;
    double u0 = bend0(), u1 = bend1(), det = across + p_.r0 * u1 + p_.r1 * u0 + u0 * u1;
    step.bowl = p_.r0 + u0 > 0 && det > 0;
    if (!step.bowl) {
      u0 = larger(u0, -u0 / 4);
      u1 = larger(u1, -u1 / 4);
      det = across + p_.r0 * u1 + p_.r1 * u0 + u0 * u1;
    }
    const double q = square_ / (1 + std::fabs(b));  // 1 - |b|
    const double g = slope0();
    const double apart =
        (k.x0 + sign * f_.c * k.x1) * y0_ - sign * f_.s * k.x1 * yw_ - (k.y0 - sign * k.y1) * yn_;
    const double of0 = (u1 + p_.r1 * q) * g + p_.r1 * std::fabs(b) * apart;
    const double of1 = sign * ((u0 + p_.r0 * q) * g - (p_.r0 + u0) * apart);
    const double most = larger(larger(det, 0x1p-1000), 2 * larger(std::fabs(of0), std::fabs(of1)));
    const double inverse = 1 / most;
    step.turn0 = of0 * inverse;
    step.turn1 = of1 * inverse;
    step.det = det;
    step.own = (p_.r0 + u0) * (p_.r1 + u1);
    return step;
  }

  // Along the eigenvector of the lowest eigenvalue of the same equations.
  Step downwards() const noexcept {
    constexpr double first_turn = 0.25;
    const double own0 = p_.r0 + bend0(), own1 = p_.r1 + bend1(), b = tangents();
    const double half = (own0 - own1) / 2, root = std::sqrt(half * half + p_.r0 * p_.r1 * b * b);
    Step step;
    step.turn0 = half > 0 ? -p_.r1 * b : root - half;
    step.turn1 = half > 0 ? root + half : -p_.r0 * b;
    const double slope = step.turn0 * p_.r0 * slope0() + step.turn1 * p_.r1 * slope1();
    const double most = larger(larger(std::fabs(step.turn0), std::fabs(step.turn1)), 0x1p-1000);
    const double unit = std::copysign(first_turn / most, slope);
    step.turn0 *= unit;
    step.turn1 *= unit;
    return step;
  }

  // (x, y) turned by about `angle` (its third order is off), still of unit length.
  static void turn(double& x, double& y, double x_old, double y_old, double angle) noexcept {
    const double q = angle / 2, i = 1 / (1 + q * q);
    x = ((1 - q * q) * x_old - 2 * q * y_old) * i;
    y = ((1 - q * q) * y_old + 2 * q * x_old) * i;
  }

  Rims k;
  const Scaled& p_;
  const TurnedFrame& f_;
  double e0_, e1_, l0_;           // between the centres of the caps, along m0, m1, w0
  double yn_, y0_, y1_, yw_;      // y along n, m0, m1, w0
  double cn_, cm_, cw_, square_;  // the product of the tangents along n, m0, w0, and its square
};

}  // namespace cyl
