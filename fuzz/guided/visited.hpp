// SPDX-License-Identifier: MIT
// The counts of a fuzz target over all its executions. The engine clears its own counters before each
// execution, and may kill a process at any time. So the counts are in a mapped file, which processes share.
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
void count_execution();
/// Makes the content of that file the value of visited(), and creates the file if necessary. Counting
/// continues from its content. Throws std::system_error.
void keep_visited(const std::string& file);
/// Empty if there is no such file.
Visited read_visited(const std::string& file);

}  // namespace cyl
