// SPDX-License-Identifier: MIT
// A pair as the documents of 2008 write it, for the files of solver/literature/ alone.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "solver/detail/frame.hpp"

namespace cyl::literature {

/// W_i, r_i, *half* heights h_i, Delta, and the one frame for both solids: n is the axes' common unit normal,
/// and (n x W_i, n, W_i) is the (U_i, V_i, W_i) of solid i. The text leaves U_i and V_i open.
struct Solids {
  /// Axes not parallel.
  Solids(const Couple<double>& p, const Axes& axes) noexcept
      : w{{p.w0x, p.w0y, p.w0z}, {p.w1x, p.w1y, p.w1z}},
        r{p.r0, p.r1},
        h{p.h0, p.h1},
        delta(p.dx, p.dy, p.dz),
        cosine(axes.cosine),
        square(axes.square),
        sine(std::sqrt(axes.square)),
        cross(axes.cross),
        n(axes.cross / sine),
        u{n.cross(w[0]), n.cross(w[1])} {}

  /// f(D), Equation (6) of section 6. |P_i D| is taken as |D x W_i|: nothing cancels beside the axis.
  double gap(const Vector3& d) const noexcept {
    return r[0] * length(d.cross(w[0])) + r[1] * length(d.cross(w[1])) + h[0] * std::fabs(dot(d, w[0])) +
           h[1] * std::fabs(dot(d, w[1])) - std::fabs(dot(d, delta));
  }

  Vector3 w[2];
  double r[2], h[2];
  Vector3 delta;
  double cosine;  ///< W0.W1
  double square;  ///< |W0 x W1|^2
  double sine;
  Vector3 cross;  ///< W0 x W1 up to sign
  Vector3 n, u[2];
};

/// Looks for a direction of negative f and keeps the first.
class Finder {
 public:
  explicit Finder(const Solids& solids) noexcept : solids_(solids) {}
  /// Whether f(D) < 0, D of any length. False if it is not finite.
  bool separates(const Vector3& d) noexcept {
    if (!(solids_.gap(d) < 0)) return false;
    direction = dot(d, solids_.delta) < 0 ? Vector3(-d) : d;
    return true;
  }
  Vector3 direction{0, 0, 0};

 private:
  const Solids& solids_;
};

}  // namespace cyl::literature
