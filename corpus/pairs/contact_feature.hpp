// SPDX-License-Identifier: MIT
// The words for what meets: what the strata are named by, what a search finds, what bucket keys say.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

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

inline constexpr std::size_t contact_feature_count = 7;

/// "side-side", "side-rim", ...
constexpr std::string_view to_string(ContactFeature feature) noexcept {
  constexpr std::array<std::string_view, contact_feature_count> names{
      "side-side", "side-rim", "rim-rim", "cap-side", "cap-rim", "cap-cap", "containment"};
  return names[static_cast<std::size_t>(feature)];
}

}  // namespace cyl
