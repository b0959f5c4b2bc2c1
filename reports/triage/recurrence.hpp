// SPDX-License-Identifier: MIT
// What has become of something that runs find, since earlier runs: said only where it is unlikely to be
// chance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/enum_words.hpp"

namespace cyl {

enum class Recurrence : unsigned char {
  fresh,  ///< found here, in no earlier run; the word is "new"
  known,  ///< found here and before
  back,   ///< found here and before, and not in between
  gone,   ///< not found here though looked for, but before
  rare    ///< found in so few of the pairs that it may be chance which run met it
};
constexpr auto words_of(Recurrence) noexcept { return std::array{"new", "known", "back", "gone", "rare"}; }

/// How often a run met something, and how many pairs it looked at.
struct Sight {
  std::uint64_t count = 0, asked = 0;
};

struct Standing {
  std::optional<Recurrence> status;  ///< none: neither here nor in the last, or not looked for here
  /// The probability, at most, that it is chance where it was met and where not, times the number of things
  /// that are compared; none where nothing is said on the strength of it.
  std::optional<double> chance;
};

/// Chances below this, corrected for the number of things compared, are no chance.
inline constexpr double chance_margin = 0.01;

/// Says what has become of one of `compared` things. `earlier`: the runs before, the earliest first; those
/// that asked nothing say nothing. Takes each meeting as independent of the others.
Standing standing_of(const Sight& here, std::span<const Sight> earlier, std::size_t compared);

}  // namespace cyl
