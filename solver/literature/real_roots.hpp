// SPDX-License-Identifier: MIT
// The real roots of a polynomial as eigenvalues of its companion matrix, by Eigen. Nothing is allocated.
#pragma once

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <limits>

namespace cyl::seeds {

template <int degree>
struct RealRoots {
  std::array<double, degree> x;
  int count = 0;
};

/// Of c[0] + c[1] x + ... + c[degree] x^degree, but for a root x = 0. A root counts as real where its
/// imaginary part is at most `tolerance` times its size. Multiple roots of multiplicity m come with an error
/// of about 2^(-53/m). None where a coefficient is not finite.
template <int degree>
RealRoots<degree> real_roots(const std::array<double, degree + 1>& c, double tolerance) noexcept {
  RealRoots<degree> roots;
  for (double coefficient : c)
    if (!(std::fabs(coefficient) <= std::numeric_limits<double>::max())) return roots;
  int low = 0, high = degree;
  while (low < high && c[static_cast<std::size_t>(low)] == 0) ++low;
  while (low < high && c[static_cast<std::size_t>(high)] == 0) --high;
  const int n = high - low;
  if (n == 0) return roots;

  // x = 2^shift y makes the outer coefficients about equal, the roots' geometric mean about 1.
  const auto at = [&](int k) { return c[static_cast<std::size_t>(low + k)]; };
  const int shift = (std::ilogb(at(0)) - std::ilogb(at(n))) / n;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, degree, degree> companion(n, n);
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

}  // namespace cyl::seeds
