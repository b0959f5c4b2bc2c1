// SPDX-License-Identifier: MIT
// Whether a cause is new, known, back or gone since earlier runs. Stated only if chance is an unlikely
// explanation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/enum_words.hpp"

namespace cyl {

enum class Recurrence : unsigned char {
  fresh,  ///< found here and in no earlier run; its word is "new"
  known,  ///< found here and before
  back,   ///< found here and before, and not in between
  gone,   ///< found before, and not here although this run looked for it
  rare    ///< found on so few pairs that its absence from other runs may be chance
};
constexpr auto words_of(Recurrence) noexcept { return std::array{"new", "known", "back", "gone", "rare"}; }

/// How many of a run's pairs showed a cause, and how many could have.
struct Observation {
  std::uint64_t count = 0, asked = 0;
};

struct RecurrenceOf {
  std::optional<Recurrence> status;  ///< none: found neither here nor in the last run, or not looked for here
  /// An upper bound of the probability that chance explains in which runs the cause was found, times the
  /// number of causes compared. None if the status does not rest on it.
  std::optional<double> chance;
};

/// A probability below this, corrected for the number of causes compared, is not taken for chance.
inline constexpr double chance_margin = 0.01;

/// Returns the status of one of `compared` causes. `earlier` holds the runs before, the earliest first; runs
/// that asked nothing are ignored. Assumes that the cause shows on each pair independently of the others.
RecurrenceOf recurrence_of(const Observation& here, std::span<const Observation> earlier,
                           std::size_t compared);

}  // namespace cyl
