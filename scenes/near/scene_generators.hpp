// SPDX-License-Identifier: MIT
// Scenes of any size, each a pure function of (kind, count, seed).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "solver/solid.hpp"

namespace cyl {

/// "rods": of height 1 and radius 0.05 at random in a cube, two to a unit of volume. "pipes": a rack of long
/// pipes on a grid that nearly touch their neighbours, layer across layer, with a flange on each. Throws
/// UsageError on another kind.
std::vector<Solid> generate_cylinders(std::string_view kind, std::size_t count, std::uint64_t seed);

}  // namespace cyl
