// SPDX-License-Identifier: MIT
// Times and durations as people write them: 06:30, 2026-11-22T06:30, 90s, 8h.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace cyl {

/// Reads "500ms", "90s", "1.5m", "8h", "2d". Throws UsageError on anything else, on 0 and on more than a
/// year.
std::chrono::milliseconds parse_duration(std::string_view text);

/// Reads "06:30", the next such local time, or "2026-11-22T06:30", with ":00" for seconds if wanted. A time
/// is local, or UTC if it ends in "Z". Throws UsageError on anything else.
std::chrono::system_clock::time_point parse_time_point(const std::string& text);
/// Returns the time in UTC, to the second, as parse_time_point() reads it.
std::string format_time_point(std::chrono::system_clock::time_point time);

/// Returns the local day as YYYY-MM-DD.
std::string today();

}  // namespace cyl
