// SPDX-License-Identifier: MIT
// The partition of all pairs: by what meets, by the angle of the axes and by the decade of the margin. Pairs
// of a given contact feature and decade are drawn by construction, with axes at any angle (strata.hpp). The
// stratum of a given pair is proved (oracles/trial/contact.hpp), or read off the solver's distance
// (fuzz/guided/counters.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

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
  containment  ///< one solid inside the other, with any nearest parts
};
constexpr auto words_of(ContactFeature) noexcept {
  return std::array{"side-side", "side-rim", "rim-rim", "cap-side", "cap-rim", "cap-cap", "containment"};
}
inline constexpr std::size_t contact_feature_count = enum_values<ContactFeature>.size();

/// How nearly the lines of the axes are parallel or perpendicular. In the order of the angle, which
/// flags_of() of cli/vectors.cpp compares.
enum class AngleClass : unsigned char {
  parallel,      ///< exactly
  within_1e_12,  ///< sine below 1e-12, not 0
  within_1e_7,   ///< below 1e-7
  within_1e_2,   ///< below 1e-2
  generic,
  near_right,  ///< cosine at most 1e-2, not 0
  right        ///< exactly perpendicular
};
constexpr auto words_of(AngleClass) noexcept {
  return std::array{"parallel", "<1e-12", "<1e-7", "<1e-2", "generic", "near-90", "90"};
}

/// tenths[d] is 10^-d.
inline constexpr std::array<double, 18> tenths{1,    1e-1,  1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,
                                               1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 1e-17};

/// Returns the margin of an index: 1e-1 to 1e-15 by turns, a gap at an even index, an overlap at an odd one.
constexpr double margin_at(std::uint64_t index) {
  const double margin = tenths[1 + index / 2 % 15];
  return index % 2 == 0 ? margin : -margin;
}

/// Returns d if 10^(-d-1) < margin <= 10^-d; from 0, for margins above 0.1, to 16, for all up to 1e-16.
inline constexpr int margin_decade_count = 17;
constexpr int margin_decade(double margin) noexcept {
  int decade = 0;
  while (decade + 1 < margin_decade_count && margin <= tenths[static_cast<std::size_t>(decade + 1)]) ++decade;
  return decade;
}

/// One cell of the partition.
struct Stratum {
  ContactFeature feature;
  int decade;                            ///< of the margin, as margin_decade() counts it
  std::optional<AngleClass> angle = {};  ///< nothing: axes at any angle
  bool operator==(const Stratum&) const = default;
};

}  // namespace cyl
