// SPDX-License-Identifier: MIT
// Points in time as people write them: 06:30, 2026-11-22T06:30.
#pragma once

#include <chrono>
#include <string>

namespace cyl {

/// Reads "06:30", the next such local time, "2026-11-22T06:30" or with ":00" for seconds: local time; with
/// "Z" at its end UTC. Throws UsageError on anything else.
std::chrono::system_clock::time_point parse_time_point(const std::string& text);
/// Returns the time in UTC, to the second, as parse_time_point() reads it.
std::string format_time_point(std::chrono::system_clock::time_point time);

}  // namespace cyl
