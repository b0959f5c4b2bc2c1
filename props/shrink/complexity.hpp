// SPDX-License-Identifier: MIT
// How simple a pair is to read.
#pragma once

#include <array>
#include <compare>

#include "corpus/pairs/pair_numbers.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Shortest round-trip decimals of a number: how many digits, their sum, and the exponent of the first.
struct Decimal {
  int digits = 0, exponent = 0, digit_sum = 0;
};
Decimal decimal_of(double x);

/// The simplicity of a pair, compared from the first member on; smaller is simpler. It is well-founded,
/// because there are finitely many doubles. Roundings and extremes come first, so that they stay only if they
/// matter. "Numbers" are those that the two shapes have, in their shortest round-trip decimals.
struct Complexity {
  int rounded;  ///< solids with a rounding
  /// Decades, summed, by which radii, heights, edges, roundings and the largest coordinate of each axis or
  /// quaternion are below 0.1 or not below 100.
  int extremes;
  int digits;      ///< significant decimal digits of all numbers together; 0 has none, 1e-9 has one
  int non_zero;    ///< numbers that are not 0
  int fractional;  ///< numbers that are not integers
  int exponents;   ///< absolute decimal exponents of all numbers, summed
  int bits;        ///< significant bits, summed
  int negative;    ///< numbers with a minus sign, -0 too
  int digit_sum;   ///< of the decimal digits
  int distinct;    ///< different absolute values, 0 aside
  /// Absolute values: quaternions, axes, radii, heights, edges, centres, roundings, those of a first, z last
  /// in each vector. 0 for what a shape does not have.
  std::array<double, 2 * solid_number_count> values;
  std::array<bool, 2 * solid_number_count> signs;  ///< which of them have a minus sign
  auto operator<=>(const Complexity&) const = default;
};

/// The pair is legal.
Complexity complexity(const Pair& pair);

}  // namespace cyl
