// SPDX-License-Identifier: MIT
#include "solver/literature/real_roots.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace cyl::literature {

RealRoots real_roots(std::span<const double> c, double tolerance) noexcept {
  RealRoots roots;
  for (double coefficient : c)
    if (!(std::fabs(coefficient) <= std::numeric_limits<double>::max())) return roots;
  int low = 0, high = static_cast<int>(c.size()) - 1;
  while (low < high && c[static_cast<std::size_t>(low)] == 0) ++low;
  while (low < high && c[static_cast<std::size_t>(high)] == 0) --high;
  if (low > 0 && c[static_cast<std::size_t>(low)] != 0) roots.x[static_cast<std::size_t>(roots.count++)] = 0;
  const int n = high - low;
  if (n == 0) return roots;

  // x = 2^shift y makes the outer coefficients about equal, the roots' geometric mean about 1.
  const auto at = [&](int k) { return c[static_cast<std::size_t>(low + k)]; };
  const int shift = (std::ilogb(at(0)) - std::ilogb(at(n))) / n;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, degree_cap, degree_cap> companion(n, n);
  companion.setZero();
  companion.diagonal(-1).setOnes();
  for (int k = 0; k < n; ++k) companion(k, n - 1) = -std::scalbn(at(k) / at(n), (k - n) * shift);
  if (!companion.allFinite()) return roots;

  const Eigen::EigenSolver<decltype(companion)> solver(companion, false);
  if (solver.info() != Eigen::Success) return roots;
  for (int k = 0; k < n; ++k) {
    const auto root = solver.eigenvalues()[k];
    if (std::fabs(root.imag()) <= tolerance * std::abs(root))
      roots.x[static_cast<std::size_t>(roots.count++)] = std::scalbn(root.real(), shift);
  }
  return roots;
}

}  // namespace cyl::literature
