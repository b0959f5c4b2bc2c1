// SPDX-License-Identifier: MIT
// What a fuzz target has seen in all its executions, for whoever drives it: the engine clears its counters
// before each of them, and a worker may be killed at any time. So it lies in a file that is mapped.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "corpus/pairs/stratum.hpp"

namespace cyl {

/// Visited are strata of every feature but containment, which no direction shows.
inline constexpr std::size_t visited_feature_count = contact_feature_count - 1,
                             visited_stratum_count =
                                 visited_feature_count * enum_values<AngleClass>.size() * margin_decade_count;

/// Two builds of one source agree about its layout, no others.
struct Visited {
  std::uint64_t executions = 0;
  /// Not 0: a moderate pair of that stratum was seen.
  std::array<std::uint8_t, visited_stratum_count> strata{};
};

/// Returns the place of a stratum in Visited::strata.
std::size_t index_of(const Stratum& s);
Stratum stratum_at(std::size_t index);

/// Returns the counts of this process.
Visited& visited();
/// Makes visited() from here on the content of that file, which is made where there is none; what is counted
/// goes on from what it holds. Throws std::system_error.
void keep_visited(const std::string& file);
/// Nothing seen where there is no such file.
Visited read_visited(const std::string& file);

}  // namespace cyl
