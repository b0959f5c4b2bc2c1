// SPDX-License-Identifier: MIT
#include "solver/literature/separation_book.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <utility>

namespace cyl::literature {

CriticalPairs solve_singular(const CriticalSystem& system) noexcept {
  CriticalPairs pairs;
  CriticalSystem s = system;
  const bool swapped = s.det1 != 0;
  if (swapped) {
    std::swap(s.b0, s.b1);
    std::swap(s.r0, s.r1);
  }
  // Now det(B1) = 0: psi spans its columns, zeta^T B1 = 0.
  const Vector2 psi = s.b1.col(s.b1.col(0).squaredNorm() < s.b1.col(1).squaredNorm() ? 1 : 0);
  const Vector2 zeta = perpendicular(psi);
  const Vector2 eta0 = perpendicular(s.b0.transpose() * zeta);
  // A line and a circle: normal . eta1 = offset, |eta1| = |eta0|.
  const Vector2 normal = s.r1 * (s.b1.transpose() * psi);
  const double offset = -s.r0 * (s.b0.transpose() * psi).dot(eta0), square = normal.squaredNorm();
  const double rest = square * eta0.squaredNorm() - offset * offset;
  if (!(square > 0) || !(rest >= 0)) return pairs;
  for (const double sign : {1.0, -1.0}) {
    const Vector2 eta1 = (offset * normal + sign * std::sqrt(rest) * perpendicular(normal)) / square;
    if (swapped)
      pairs.add(eta1, eta0);
    else
      pairs.add(eta0, eta1);
  }
  return pairs;
}

CriticalPairs solve_adjugate(const CriticalSystem& s, Faults faults) noexcept {
  CriticalPairs pairs;
  Matrix2 adjugate;
  adjugate << s.b0(1, 1), -s.b0(0, 1), -s.b0(1, 0), s.b0(0, 0);
  const Matrix2 c = adjugate * s.b1;
  const Eigen::SelfAdjointEigenSolver<Matrix2> eigen(c.transpose() * c);
  const double e1 = eigen.eigenvalues()[1];
  // e0 e1 = det(C)^2, and e0 may be small beside e1.
  const double e0 = s.det0 * s.det0 * s.det1 * s.det1 / e1;
  if (!faults.has(Fault::equal_eigenvalues) && !(e1 - e0 > equal_eigenvalues_tol * e1)) {
    pairs.equal = true;
    return pairs;
  }
  const double p0 = s.r0 * s.r0 * s.det0 * s.det0, p1 = s.r1 * s.r1;
  const double a2 = (e1 * p1 - p0) / (e1 - e0);
  const double b2 = (faults.has(Fault::wrong_b_squared) ? p1 - e0 * p0 : p0 - e0 * p1) / (e1 - e0);
  if (!(a2 >= 0) || !(b2 >= 0)) return pairs;
  for (const double sign : {1.0, -1.0}) {
    const Vector2 eta1 = eigen.eigenvectors() * Vector2(sign * std::sqrt(a2), std::sqrt(b2));
    const double turned = faults.has(Fault::sign_of_p0) ? 1 : std::copysign(1.0, s.det0);
    pairs.add(-c * eta1 * turned, eta1);
  }
  return pairs;
}

}  // namespace cyl::literature
