// SPDX-License-Identifier: MIT
// Draws the pairs on which a gate checks every law, round by round. They are pure functions of their
// arguments.
#pragma once

#include <cstdint>

#include "props/gate/sample.hpp"

namespace cyl {

/// The pairs of a round, at most: so many draws of so many pairs. The kind of each draw is random, and an
/// origin names it: "grid", "family random", "stratum side-rim 1e-09" or
/// "close near-parallel 1e-03..1e-08 1e-05".
inline constexpr std::uint64_t draws_per_round = 4, pairs_per_draw = 16;

/// The grid, the families before the close contacts, and the strata.
SampleRound draw_law_pairs(std::uint64_t seed, std::uint64_t round);
/// The cells of close contacts, and their families.
SampleRound draw_close_law_pairs(std::uint64_t seed, std::uint64_t round);
/// The families of other solids than cylinders.
SampleRound draw_rounded_law_pairs(std::uint64_t seed, std::uint64_t round);

}  // namespace cyl
