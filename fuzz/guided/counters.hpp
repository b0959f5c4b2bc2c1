// SPDX-License-Identifier: MIT
// Reports the geometry that a fuzz target has seen to the engine. Engines do not trace comparisons of
// doubles. These counters are in the section that libFuzzer reads beside its own coverage. Without an engine
// they are written and not read.
#pragma once

#include <cstddef>
#include <string>

#include "corpus/pairs/stratum.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Returns the stratum by an approximate distance: a guide, no proof. Never of containment. The pair is
/// legal.
Stratum stratum_of(const Pair& pair, const MeasuredDistance& measured);

/// "cap-rim <1e-7 1e-12".
std::string to_string(const Stratum& s);

/// Lengths of a moderate pair are within this factor of 1 of the largest one, 0 aside.
inline constexpr double moderate_factor = 1e4;
/// Returns whether no length dwarfs another: a margin is small there because solids nearly touch, not because
/// one of them is huge.
bool is_moderate(const Pair& pair);

/// Counts the stratum of a moderate pair, and returns it. If `finely`, it also counts the features with the
/// signed binary exponent of the margin, and the decade of the axes' angle.
Stratum count_geometry(const Pair& pair, const MeasuredDistance& measured, bool finely);
/// How near an answer of our own calls comes to the ends of its promises.
enum class Badness : unsigned char {
  error,     ///< the error of the distance, divided by the bound that is returned with it
  bound,     ///< that bound, divided by the claim
  undecided  ///< the margin of an undecided pair
};
/// Counts the badness by halves.
void count_badness(Badness badness, double score);
/// Counts that the methods i < j, of at most 64, answer differently.
void count_difference(std::size_t i, std::size_t j);

}  // namespace cyl
