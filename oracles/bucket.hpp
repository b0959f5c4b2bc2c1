// SPDX-License-Identifier: MIT
// The bucket key: findings with one cause, as far as we can tell, have one key. It is taken from a simplified
// pair: what is still extreme there is what matters.
#pragma once

#include <string>
#include <string_view>

#include "oracles/contact.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// The one coordinate that still matters, the first that holds in this order: what moves or sizes the whole
/// scene before what tells the solids apart, and the margin last, because most findings are near touching.
enum class Coordinate : unsigned char {
  offset,  ///< a centre farther from the origin than offset_cap sizes
  scale,   ///< the size is below 1e-3 or above 1e3
  aspect,  ///< a solid's diameter and height, or the sizes of the two solids, more than 100 to 1
  angle,   ///< axes within 1e-2 of parallel or of perpendicular, but not exactly so
  margin,  ///< the margin is below 1e-3
  plain    ///< none of these
};

/// The words used in keys: "offset", "scale", ...
const char* to_string(Coordinate c) noexcept;

/// `margin`: |signed distance| / size, or an upper bound of it.
Coordinate coordinate_of(const Pair& simplified, double margin);

/// "fcl-libccd/wrong_disjoint/side-rim/angle". `failure`: a finding's kind or a law's name.
std::string bucket_key(std::string_view method, std::string_view failure, ContactFeature feature,
                       Coordinate coordinate);

/// Twelve letters a to p that stand for the key, for tools that mangle digits: its 48-bit hash, the highest
/// four bits first.
std::string letters_only(std::string_view key);

}  // namespace cyl
