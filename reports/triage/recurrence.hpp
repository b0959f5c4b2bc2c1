// SPDX-License-Identifier: MIT
// What has become of something that runs find, since earlier runs.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/enum_words.hpp"

namespace cyl {

enum class Recurrence : unsigned char {
  fresh,  ///< found here, in no earlier run; the word is "new"
  known,  ///< found here and in the last
  back,   ///< found here and in an earlier run, not in the last
  gone    ///< not found here though looked for, but in the last
};
constexpr auto words_of(Recurrence) noexcept { return std::array{"new", "known", "back", "gone"}; }

/// `earlier`: of the runs that looked for it, the earliest first, whether each found it. Returns nothing
/// where it is neither here nor was in the last of them.
inline std::optional<Recurrence> recurrence(bool found_here, bool looked_for_here,
                                            const std::vector<bool>& earlier) {
  const bool last = !earlier.empty() && earlier.back();
  if (!found_here) return last && looked_for_here ? std::optional(Recurrence::gone) : std::nullopt;
  if (last) return Recurrence::known;
  return std::find(earlier.begin(), earlier.end(), true) == earlier.end() ? Recurrence::fresh
                                                                          : Recurrence::back;
}

}  // namespace cyl
