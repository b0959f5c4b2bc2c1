// SPDX-License-Identifier: MIT
// The moves of the shrinker: from a legal pair each makes pairs that might be simpler. Not all are legal.
// simplify.cpp lists the moves that are tried.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "solver/solid.hpp"

namespace cyl::moves {

using Pairs = std::vector<Pair>;

/// Relative to the size: a pair nearer to touching is also tried with its distance kept.
inline constexpr double near_margin = 1e-2;

/// Brings a or b to the origin, or to a place of few digits, and moves the other along; what rounding left of
/// their difference is rounded away.
Pairs translations(const Pair& p);
/// Turns the scene so that a's axis, b's, an edge or the direction of the distance is the z axis.
Pairs frames(const Pair& p);
/// Permutes and mirrors coordinates; reverses axes and quaternions, exchanges the solids or their centres.
/// (Solids are their own mirror images in their centres, so the last is a mirror image of the scene.)
Pairs symmetries(const Pair& p);
/// Divides all lengths by one of them, by powers of ten and of two.
Pairs scales(const Pair& p);
/// Gives both solids, or one, lengths 0, 1, 2, also as cubes; brings all lengths to powers of two.
Pairs shapes(const Pair& p);
/// Tries other axes and quaternions: of small integers, of other lengths, equal, nearly parallel. Tries boxes
/// with their edges in another order.
Pairs axes(const Pair& p);
/// Drops some coordinates of b's centre, or puts it as far away along one of them.
Pairs centres(const Pair& p);
/// Rounds some numbers together to integers and to few digits.
Pairs roundings(const Pair& p);
/// Makes one of the numbers simpler.
Pairs one_number(const Pair& p, std::size_t which);
/// Makes one radius, height or edge equal to another, or all of them.
Pairs equalities(const Pair& p);

/// Adds the pair with one number of it solved for the distance `kept`: that coordinate of b's centre, and
/// that length, which moves the distance most.
void add_at_distance(const Pair& p, double kept, Pairs& out);

// Functions that the moves share.

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
