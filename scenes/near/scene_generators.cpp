// SPDX-License-Identifier: MIT
#include "scenes/near/scene_generators.hpp"

#include <cmath>
#include <string>

#include "base/usage_error.hpp"
#include "corpus/pairs/random_stream.hpp"

namespace cyl {
namespace {

constexpr double rods_per_volume = 2;

std::vector<Solid> rods(std::size_t count, std::uint64_t seed) {
  // The side of the cube grows in fixed steps, because cbrt differs between C libraries.
  double side = 1;
  while (side * side * side * rods_per_volume < static_cast<double>(count)) side += 0.125;
  std::vector<Solid> cylinders;
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream stream("scene rods", seed, i);
    Vector3 center;
    for (int k = 0; k < 3; ++k) center[k] = stream.between(0, side);
    cylinders.push_back({center, stream.unit_vector(), 0.05, 1});
  }
  return cylinders;
}

/// Makes pipes of radius 0.1 and height 6, in layers of 16 at a pitch of 0.25, each across the layer below.
/// Every second solid is a flange on a pipe, near the flange of its neighbour. Racks stand side by side.
std::vector<Solid> pipes(std::size_t count, std::uint64_t seed) {
  constexpr std::size_t row = 16, layers = 20;
  constexpr double pitch = 0.25, layer_pitch = 0.2501, rack_pitch = 8;
  std::vector<Solid> cylinders;
  for (std::size_t i = 0; cylinders.size() < count; ++i) {
    RandomStream stream("scene pipes", seed, i);
    const std::size_t column = i % row, layer = i / row % layers, rack = i / (row * layers);
    const bool across = layer % 2 != 0;
    const double place = (static_cast<double>(column) - 7.5) * pitch;
    Vector3 center(0, 0, static_cast<double>(layer) * layer_pitch);
    center[across ? 0 : 1] = place;
    Vector3 axis(0, 0, 0);
    axis[across ? 1 : 0] = 1;
    const Vector3 corner(static_cast<double>(rack % row) * rack_pitch,
                         static_cast<double>(rack / row) * rack_pitch, 0);
    cylinders.push_back({corner + center, axis, 0.1, 6});
    if (cylinders.size() < count)
      cylinders.push_back({corner + center + stream.between(2.2, 2.8) * axis, axis, 0.124, 0.02});
  }
  return cylinders;
}

}  // namespace

std::vector<Solid> generate_cylinders(std::string_view kind, std::size_t count, std::uint64_t seed) {
  if (kind == "rods") return rods(count, seed);
  if (kind == "pipes") return pipes(count, seed);
  throw UsageError("'" + std::string(kind) + "' is none of rods, pipes");
}

}  // namespace cyl
