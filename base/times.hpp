// SPDX-License-Identifier: MIT
// Durations as people write them, and the day.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace cyl {

/// Reads "500ms", "90s", "1.5m", "8h", "2d". Throws UsageError on anything else, on 0 and on more than a
/// year.
std::chrono::milliseconds parse_duration(std::string_view text);

/// Returns the local day as YYYY-MM-DD.
std::string today();

}  // namespace cyl
