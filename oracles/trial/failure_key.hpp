// SPDX-License-Identifier: MIT
// The cause of a failure of the gate or the fuzzer: method, kind, contact feature and the property of the
// pair that is extreme.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/enum_words.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// The one coordinate that still matters: the first that applies, in this order. Position and size of the
/// whole scene come before differences between the solids. The margin comes last, because most findings are
/// near touching.
enum class Coordinate : unsigned char {
  offset,  ///< both centres beyond offset_size_margin sizes from the origin, and nearer to each other than to
           ///< it
  scale,   ///< the size is below 1e-3 or above 1e3
  aspect,  ///< diameter to height of a solid, or the sizes of the two, beyond 100 to 1; 0 lengths aside
  angle,   ///< axes within 1e-2 of parallel or of perpendicular, but not exactly so
  margin,  ///< the margin is below 1e-3
  plain    ///< none of these
};
constexpr auto words_of(Coordinate) noexcept {
  return std::array{"offset", "scale", "aspect", "angle", "margin", "plain"};
}

/// Relative to the size.
inline constexpr double offset_size_margin = 100;

/// Returns the coordinate of a legal pair. `margin` is |signed distance| / size, or an upper bound.
Coordinate coordinate_of(const Pair& simplified, double margin);

/// Returns "fcl-libccd/wrong_disjoint/side-rim/angle". `failure` is a finding's kind or a law's name.
/// `feature` is in the words of contact_in_words().
std::string failure_key(std::string_view method, std::string_view failure, std::string_view feature,
                        Coordinate coordinate);

/// Returns the key of a pair. It finds the contact feature and the coordinate itself. Cost: that of an
/// enclosure of the distance.
std::string failure_key_of(std::string_view method, std::string_view failure, const Pair& pair);

/// Returns twelve letters a to p that stand for the key, for tools that mangle digits. They are the low 48
/// bits of its FNV-1a hash, four bits a letter, the highest first.
std::string letter_hash(std::string_view key);

}  // namespace cyl
