// SPDX-License-Identifier: MIT
// Section 7 of the text of 2017: G, which is f on the triangle that spans an octant of directions, and the
// convex cells of that triangle in which G is smooth.
#pragma once

#include "solver/literature/document.hpp"

namespace cyl::literature {

using Point = Eigen::Vector2d;  ///< (s, t)

/// Sign(L_0), Sign(L_1) in a cell; 0 is the sign at the point itself.
struct Signs {
  double l0 = 0, l1 = 0;
};

/// f on D(s, t) = s U + t V + (1-s-t) W, all coordinates with respect to (U, V, W), W along Delta. With the
/// signs of the octant in U and V.
struct Octant {
  Vector3 w0, w1;         ///< (a_i, b_i, c_i)
  double r0, h0, r1, h1;  ///< half heights
  double length;          ///< |Delta|
  bool printed_roots;     ///< Q_i = |D|^2 - L_i^2 as in the text
  bool printed_gradient;  ///< its 0/0 at an axis too

  static Vector3 at(const Point& x) noexcept { return {x.x(), x.y(), 1 - x.x() - x.y()}; }
  /// L_i, linear: D along axis i.
  double along(int i, const Point& x) const noexcept;
  /// G with the given signs of the L_i, or their own signs if those are 0.
  double value(const Point& x, Signs signs) const noexcept;
  /// A subgradient of value().
  Point gradient(const Point& x, Signs signs) const noexcept;
  /// |P_i D(x)|.
  double across(int i, const Point& x) const noexcept;
  /// The direction in which G falls most from the tip of the cone r_i |P_i D|, x = W_i or next to it.
  /// Without that term the gradient is g. 2 H is the second derivatives of Q_i. g.d/|P_i d| is least for H d
  /// = -g.
  Point off_axis(int i, const Point& x, Signs signs) const noexcept;
};

/// A convex polygon, anticlockwise: the triangle s, t >= 0, s + t <= 1, or the rest that lines cut off.
struct Cell {
  static constexpr int corner_cap = 5;  ///< a triangle and two cuts
  Point corners[corner_cap] = {{0, 0}, {1, 0}, {0, 1}};
  int count = 3;
  Signs signs;

  Point middle() const noexcept;
  /// The part with `sign` L_i >= 0; false if its interior is empty.
  bool keep(const Octant& octant, int i, double sign) noexcept;
  /// The r for which x + r d is in the cell, x being in it.
  struct Interval {
    double low, high;
  };
  Interval chord(const Point& x, const Point& d) const noexcept;
};

}  // namespace cyl::literature
