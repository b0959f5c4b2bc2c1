// SPDX-License-Identifier: MIT
// The words for what meets: what the strata are named by, what a search finds, what bucket keys say.
#pragma once

#include <array>
#include <cstddef>

#include "base/enum_words.hpp"

namespace cyl {

/// The parts of the two solids that face each other in the direction of their signed distance.
enum class ContactFeature : unsigned char {
  side_side,
  side_rim,
  rim_rim,
  cap_side,
  cap_rim,
  cap_cap,
  containment  ///< one solid wholly inside the other, whatever faces what
};
constexpr auto words_of(ContactFeature) noexcept {
  return std::array{"side-side", "side-rim", "rim-rim", "cap-side", "cap-rim", "cap-cap", "containment"};
}

inline constexpr std::size_t contact_feature_count = enum_values<ContactFeature>.size();

}  // namespace cyl
