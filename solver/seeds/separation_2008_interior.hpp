// SPDX-License-Identifier: MIT
// Sections 9 to 13 of the text of 2008: the directions where all terms of f are smooth.
#pragma once

#include "solver/seeds/separation_2008.hpp"
#include "solver/seeds/separation_book.hpp"
#include "solver/seeds/solids.hpp"

namespace cyl::seeds {

/// g0(D) = r0 |P0 D| + r1 |P1 D| - D.phi, which is f(D) where sign0 D.W0, sign1 D.W1 and D.Delta >= 0. Of the
/// eight signs four have this form, the others are their companions: g1(D) = g0(-D).
struct SmoothGap {
  SmoothGap(const Solids& solids, double sign0, double sign1) noexcept;  ///< phi = 0 gives no_phi

  /// The pair (x, y) of D = x U + y V + W from etas (section 12), times a factor: W.D may be negative, and D
  /// is 0 where the text's C is not invertible.
  Vector3 direction(const Vector2& eta0, const Vector2& eta1) const noexcept;
  double value(const Vector3& d) const noexcept;
  /// The Newton step of g0 on the plane W.D = const, perpendicular to W.
  Vector3 newton_step(const Vector3& d) const noexcept;

  const Solids& solids;
  Vector3 phi;
  bool no_phi;
  Vector3 u, v, w;  ///< U, V, W = phi/|phi|
  CriticalSystem system;
};

/// Section 11, normalised: eta0 = -(r1/r0) B0^-1 B1 eta1. Needs r0 and both determinants not 0.
CriticalPairs solve_normalised(const CriticalSystem& system, Faults faults) noexcept;

/// Section 13: f0 |D0| + f1 |D1| < most from the squares, without a root.
bool below_by_squares(double r0_squared_length, double r1_squared_length, double phi_squared) noexcept;

/// Whether a direction with g0 < 0 of any signs separates.
bool separated_inside(const Solids& solids, CriticalWay way, const Options& options, Finder& finder) noexcept;

}  // namespace cyl::seeds
