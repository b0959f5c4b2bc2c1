// SPDX-License-Identifier: MIT
// The signed distance of two solids with the points and the direction that show it. Nothing here prints,
// throws, allocates, aborts or keeps state. The mathematics, in the symbols of the code: distance.md.
#pragma once

#include "solver/decide.hpp"

namespace cyl {

/// A bound on the steps for one answer. Solids apart need four searches of 60 steps on circles, 14 of 61 with
/// rims, and 72 projections. An overlap needs at most as many, and 160 steps along valleys of f
/// (distance.md).
inline constexpr int distance_step_cap = 1326;

/// A bound on the rounding error of f(direction) and of the distance between the points. The unit is
/// r0 + h0/2 + r1 + h1/2 + |Delta|, with Delta = b.center - a.center. It is derived in distance.md,
/// section 5.
inline constexpr double distance_error = 32 * unit_roundoff_error;

/// Lengths in the unit, vectors in the frame of the cylinders. If the verdict is `invalid`, all else is 0.
struct Distance {
  /// By the sign of `value` (0: intersecting), or `invalid`. `disjoint` is proved if value > error.
  /// `intersecting` is not proved:
  /// there may be a gap, but only one so small that decide() leaves it undecided.
  Verdict verdict = Verdict::undecided;
  /// The gap if > 0, else minus the penetration depth. It is -f(direction), rounded, and limited to the
  /// largest double.
  double value = 0;
  /// A bound of the error of `value`. Always finite. The size is r0 + h0 + r1 + h1 plus the radii of
  /// the rounded edges.
  /// * Apart: |value - exact| <= error, always. It is the distance of the two points minus the gap
  ///   that `direction` proves, plus rounding. On all pairs tried it is at most 1e-13 * (size + |Delta|), or
  ///   2^-1071 if that is subnormal (distance.md, section 4). If it is more, pass it on to your user.
  ///   With a box, 1 in 240 gaps reports more, up to 4e-10 times the size, because the points are not the
  ///   nearest. But `value` is off by at most 2e-14 times the size, on the 110,000 gaps tried.
  /// * Overlapping: the exact depth is at most -value + error, always. See `least`.
  double error = 0;
  /// A unit vector that points from a to b (up to rounding). If b moves along it by error - value or more,
  /// the solids share no inner point.
  Vector3 direction{0, 0, 0};
  /// Offsets from a.center and from b.center.
  /// * Apart: points of a and of b, |distance - value| <= error.
  /// * Overlapping: the point of a that is deepest in b, and the point of b that is deepest in a. They differ
  ///   by value * direction. One lies in its solid within rounding. Bounds of the other, on the pairs tried:
  ///   * 1e-12 * (size + |Delta|), except for one pair in 100,000;
  ///   * 1e-9, unless two caps lie on each other at an angle of 1e-11 to 1e-13;
  ///   * 2.6e-9 then. 1 in 3,200 of these is farther out than 1e-9.
  ///   With a box, 3 in 100 overlaps have points that differ otherwise by more than 1e-12.
  Vector3 on_a{0, 0, 0};
  Vector3 on_b{0, 0, 0};
  /// True if no direction has a depth that is smaller by more than 4 * error.
  /// * Overlapping: true is proved (distance.md, section 6). If false, such a direction may exist.
  ///   distance.md, section 4, has the rates by family.
  /// * A box that overlaps a cylinder with a radius: false. The least of 4 circles of directions is taken, by
  ///   samples (boxes.md, section 7). So the depth is not promised. It was off by at most 1e-13 times the
  ///   size on the 35,000 overlaps tried. Any other pair with a box or a half-space: true.
  /// * Apart: false, because `error` is the bound.
  bool least = false;
  int iterations = 0;  ///< at most distance_step_cap
};

/// 1. Symmetric in its arguments: an exchange keeps the value bit for bit, reverses the direction, and
///    exchanges the points. Two equal solids may get any direction.
/// 2. Exact under scaling by powers of two.
/// Cost: 13 times intersect() if apart. 50 times if overlapping, with decide() in it.
Distance distance(const Prepared& a, const Prepared& b) noexcept;
Distance distance(const Solid& a, const Solid& b) noexcept;

}  // namespace cyl
