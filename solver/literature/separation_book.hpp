// SPDX-License-Identifier: MIT
// The page of the book (p. 656), which is also section 11 of the text of 2008: the critical points of g0 as
// pairs of planar vectors.
#pragma once

#include <Eigen/Core>

#include "solver/literature/document.hpp"

namespace cyl::literature {

using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;

/// r0 B0 eta0 + r1 B1 eta1 = 0 with |eta0| = |eta1| = 1, B_i = [U V]^T [U_i V_i].
struct CriticalSystem {
  Matrix2 b0, b1;
  double det0, det1;  ///< of b0 and b1
  double r0, r1;
};

/// Solutions, one of each pair (eta, -eta); of any length but 0.
struct CriticalPairs {
  Vector2 eta0[2], eta1[2];
  int count = 0;
  bool equal = false;  ///< e0 = e1: no isolated solution. g0 is least at W, or only at W0 and W1.

  void add(const Vector2& first, const Vector2& second) noexcept {
    eta0[count] = first;
    eta1[count++] = second;
  }
};

/// Eigenvalues nearer than this, relative to the larger, are equal: a^2 and b^2 are lost in rounding.
inline constexpr double equal_eigenvalues_tol = 0x1p-50;

/// (a, b)^perp = (b, -a).
inline Vector2 perpendicular(const Vector2& v) noexcept { return {v.y(), -v.x()}; }

/// det(B0) = 0 and det(B1) != 0 or the reverse (not both 0): P_i = |B0^T zeta| eta_i.
CriticalPairs solve_singular(const CriticalSystem& system) noexcept;
/// det(B0) and det(B1) not 0: P_0 = -C P_1 with C = Adj(B0) B1, |P_0| = r0 |det(B0)|, |P_1| = r1. If det(B0)
/// < 0, P_0 = r0 det(B0) eta_0 points against eta_0. Then it is reversed, except with the fault.
CriticalPairs solve_adjugate(const CriticalSystem& system, Faults faults) noexcept;

}  // namespace cyl::literature
