// SPDX-License-Identifier: MIT
// The families: generators of pairs, each named by the boundary it hugs. The only place that makes random
// numbers. Every pair is a pure function of (family, seed, index), the same on every machine: only + - x /
// sqrt.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "solver/solid.hpp"

namespace cyl {

struct Family {
  std::string_view name;     ///< e.g. "axes_nearly_parallel"
  std::string_view summary;  ///< one line for --help and the page
  /// Legal solids, in no unit of this world. Any seed and index will do. Throws nothing.
  Pair (*generate)(std::uint64_t seed, std::uint64_t index);
};

/// All families of cylinders without rounding, in a fixed order. The last of them are close_families().
std::span<const Family> families();
/// The families of close contacts, for which the gate has phases of its own.
std::span<const Family> close_families();
/// The combinations of a sphere, a capsule, a cylinder and a rounded cylinder, without two cylinders.
std::span<const Family> rounded_families();
/// A half-space with each of them, and at the ends of the range.
std::span<const Family> half_space_families();
/// A box with each of them, with a half-space and with a box, rounded too, and at the boundaries of boxes.
std::span<const Family> box_families();
/// The families of a campaign: families(), rounded_families(), half_space_families(), box_families().
std::span<const Family> campaign_families();
/// Families for timing, not for campaigns: "margin_1e-01" to "margin_1e-15". Pairs have that margin as a gap
/// (even index) or a penetration (odd index; at 1e-01 only gaps). They have the features of solids in general
/// position: side-side, side-rim, rim-rim, cap-rim.
std::span<const Family> margin_families();
/// The family of that name, of any kind, or nullptr.
const Family* find_family(std::string_view name);

}  // namespace cyl
