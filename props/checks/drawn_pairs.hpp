// SPDX-License-Identifier: MIT
// The pairs that the checks of a gate ask about.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "solver/cylinder.hpp"

namespace cyl {

struct PairsOfKind {
  std::string_view name;
  std::vector<Pair> pairs;
};

/// Returns pairs of every family, of every stratum, and close contacts of every cell. A pure function of the
/// seed.
std::vector<PairsOfKind> draw_pairs(std::uint64_t seed);

}  // namespace cyl
