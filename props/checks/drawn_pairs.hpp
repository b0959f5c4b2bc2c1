// SPDX-License-Identifier: MIT
// The pairs that the checks of a gate ask about.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "solver/cylinder.hpp"

namespace cyl {

/// Steps are counted over pairs that are always the same: from seed to seed their mean changes by some
/// hundredths, which would hide what costs less than that. The counts are whole numbers and the same on every
/// machine; the room is for the logarithms in their means.
inline constexpr std::uint64_t counting_seed = 1;
inline constexpr double count_room = 1.00005;

struct PairsOfKind {
  std::string_view name;
  std::vector<Pair> pairs;
};

/// Returns pairs of every family, of every stratum, and close contacts of every cell. A pure function of the
/// seed.
std::vector<PairsOfKind> draw_pairs(std::uint64_t seed);

}  // namespace cyl
