// SPDX-License-Identifier: MIT
// Functions that the moves of the shrinker share.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "corpus/pairs/pair_numbers.hpp"
#include "solver/solid.hpp"

namespace cyl::moves {

/// Returns the nearest double of units * 10^exponent, or 0 if that is out of range.
inline double decimal(long long units, int exponent) {
  const std::string text = std::to_string(units) + 'e' + std::to_string(exponent);
  double x = 0;
  return std::from_chars(text.data(), text.data() + text.size(), x).ec == std::errc() ? x : 0;
}

/// Returns the numbers of a, then those of b.
inline std::array<double*, 2 * solid_number_count> numbers(Pair& p) {
  std::array<double*, 2 * solid_number_count> all;
  std::ranges::copy(numbers_of(p.b), std::ranges::copy(numbers_of(p.a), all.begin()).out);
  return all;
}

/// Returns a changed copy.
template <class Change>
Pair with(Pair p, Change change) {
  change(p);
  return p;
}

}  // namespace cyl::moves
