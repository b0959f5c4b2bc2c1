// SPDX-License-Identifier: MIT
// The signed distance of two cylinders with the points and the direction that show it. Nothing here prints,
// throws, allocates, aborts or keeps state. The mathematics, in the symbols of the code: distance.md.
#pragma once

#include "solver/decide.hpp"

namespace cyl {

/// Steps that one answer may spend in all its searches together: two on circles and four of rims, 60 each
/// but for the last step that looks at the result.
inline constexpr int distance_step_cap = 360;

/// Bound of rounding in `value` and `error`, times r0 + h0/2 + r1 + h1/2 + |Delta|; derived in distance.md.
inline constexpr double distance_error = 32 * unit_roundoff_error;

struct Distance {
  Verdict verdict = Verdict::undecided;  ///< by the sign of `value` (0: intersecting), or `invalid`
  /// > 0: the gap. <= 0: minus the penetration depth. It is -f(direction), rounded.
  double value = 0;
  /// Apart: |value - exact| <= error, always. Overlapping: the exact depth is at most -value + error, always;
  /// that no direction is shallower is not proved.
  double error = 0;
  /// Of unit length, from a to b: moving b by any length above -value along it leaves no common point.
  Vector3 direction{0, 0, 0};
  /// Offsets from a.center and from b.center. Apart: the nearest points. Overlapping: the point of a deepest
  /// in b and the reverse, value * direction apart.
  Vector3 on_a{0, 0, 0};
  Vector3 on_b{0, 0, 0};
  int iterations = 0;  ///< steps of all searches, at most distance_step_cap
};

Distance distance(const Prepared& a, const Prepared& b) noexcept;
Distance distance(const Cylinder& a, const Cylinder& b) noexcept;

}  // namespace cyl
