// SPDX-License-Identifier: MIT
// The shrinker: from a failing pair to the simplest one found that still fails the same way. It knows what
// pairs are made of (solids may be moved, turned, scaled, exchanged, kept at their distance while their shape
// changes) and nothing of why a pair fails: every pair it takes was asked about and failed. What "the same
// way" means is the caller's to say: a caller who wants the contact feature kept asks for it
// (oracles/trial/contact.hpp), or most pairs end as disks and points.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "solver/cylinder.hpp"

namespace cyl {

/// Which of these pairs still fail, one bool each; asked many at a time, because each call about foreign code
/// costs a fork. Must be a pure function of each pair. The pairs are legal.
using StillFails = std::function<std::vector<bool>(std::span<const Pair>)>;

/// How simple a pair is: compared from the first member on, smaller is simpler. Well-founded, since there
/// are finitely many doubles. Extremes come first, so that they stay only where they matter. "Numbers" are
/// the pair's 16, in their shortest round-trip decimals.
struct Complexity {
  /// Decades, summed, by which radii, heights and the largest coordinate of each axis are below 0.1 or not
  /// below 100.
  int extremes;
  int digits;      ///< significant decimal digits of all numbers together; 0 has none, 1e-9 has one
  int non_zero;    ///< numbers that are not 0
  int fractional;  ///< numbers that are not integers
  int exponents;   ///< absolute decimal exponents of all numbers, summed
  int bits;        ///< significant bits, summed
  int negative;    ///< numbers with a minus sign, -0 too
  int digit_sum;   ///< of the decimal digits
  int distinct;    ///< different absolute values, 0 aside
  /// Absolute values: a's axis, b's axis, radii, heights, a's centre, b's centre, z last in each vector.
  std::array<double, 16> values;
  std::array<bool, 16> signs;  ///< which of them have a minus sign
  auto operator<=>(const Complexity&) const = default;
};

/// Of a legal pair.
Complexity complexity(const Pair& pair);

struct Simplified {
  Pair pair;              ///< confirmed failing, or the pair given
  std::size_t questions;  ///< pairs asked about
  bool at_cap;            ///< ended by the cap: what more might have been found is not known
};

/// Pairs asked about before the simplest so far is returned. Near-touching pairs of every feature took 300,
/// at most 600, in 20 to 60 calls.
inline constexpr std::size_t question_cap_default = 4000;

/// The pair given is taken to fail and is not asked about; an illegal one comes back as it is. Deterministic;
/// never worse than what was given; where it did not end at the cap, simplifying again changes nothing.
Simplified simplify(const Pair& pair, const StillFails& still_fails,
                    std::size_t question_cap = question_cap_default);

}  // namespace cyl
