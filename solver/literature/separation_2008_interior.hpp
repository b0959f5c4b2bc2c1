// SPDX-License-Identifier: MIT
// Sections 9 to 13 of the text of 2008: the directions at which all terms of f are smooth.
#pragma once

#include "solver/literature/separation_2008.hpp"
#include "solver/literature/separation_book.hpp"
#include "solver/literature/solids.hpp"

namespace cyl::literature {

/// g0(D) = r0 |P0 D| + r1 |P1 D| - D.phi, which is f(D) if sign0 D.W0, sign1 D.W1 and D.Delta >= 0. Four of
/// the eight sign patterns have this form. The others are their companions: g1(D) = g0(-D).
struct SmoothGap {
  SmoothGap(const Solids& solids, double sign0, double sign1) noexcept;  ///< phi = 0 gives no_phi

  /// Section 12: D = x U + y V + W times det(C), and (x, y) are the etas'. 0 if C is not invertible.
  Vector3 direction(const Vector2& eta0, const Vector2& eta1) const noexcept;
  /// The same by the text's own two equations in x and y, with C, d and the dot products G_i = R^T R_i; D.W
  /// = 1.
  Vector3 direction_by_equations(const Vector2& eta0, const Vector2& eta1) const noexcept;
  double value(const Vector3& d) const noexcept;
  /// The Newton step of g0 on the plane W.D = const, perpendicular to W.
  Vector3 newton_step(const Vector3& d) const noexcept;

  const Solids& solids;
  double sign0, sign1;
  Vector3 phi;
  bool no_phi;
  Vector3 u, v, w;  ///< U, V, W = phi/|phi|
  CriticalSystem system;
};

/// Whether a direction in the inside of one of the eight sign cases separates. Critical points outside the
/// case's own signs need not be rejected, as f itself is asked there; literally they are.
bool separated_inside(const Solids& solids, const Options& options, Finder& finder) noexcept;

}  // namespace cyl::literature
