// SPDX-License-Identifier: MIT
// The real roots of a polynomial as eigenvalues of its companion matrix, by Eigen. Nothing is allocated.
#pragma once

#include <array>
#include <span>

namespace cyl::literature {

inline constexpr int degree_cap = 8;  ///< of a polynomial whose roots are asked for

struct RealRoots {
  std::array<double, degree_cap> x;
  int count = 0;
};

/// Returns the real roots of c[0] + c[1] x + ... + c[n] x^n, n <= degree_cap. A root counts as real if its
/// imaginary part is at most `tolerance` times its size. Roots of multiplicity m come m times, but 0 once,
/// with an error of about 2^(-53/m). Returns none if a coefficient is not finite, or if all are 0.
RealRoots real_roots(std::span<const double> c, double tolerance) noexcept;

}  // namespace cyl::literature
