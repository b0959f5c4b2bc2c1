// SPDX-License-Identifier: MIT
// Moments as people write them: 06:30, 2026-11-22T06:30.
#pragma once

#include <chrono>
#include <string>

namespace cyl {

/// "06:30": the next such local time. "2026-11-22T06:30" or with ":00" for seconds: local time; with "Z" at
/// its end UTC. Throws UsageError on anything else.
std::chrono::system_clock::time_point parse_moment(const std::string& text);
/// In UTC, to the second; parse_moment reads it.
std::string format_moment(std::chrono::system_clock::time_point moment);

}  // namespace cyl
