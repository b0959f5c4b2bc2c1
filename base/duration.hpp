// SPDX-License-Identifier: MIT
// Durations as people write them: 90s, 1m, 8h.
#pragma once

#include <chrono>
#include <string_view>

namespace cyl {

/// "500ms", "90s", "1.5m", "8h", "2d". Throws UsageError on anything else, on 0 and on more than a
/// year.
std::chrono::milliseconds parse_duration(std::string_view text);

}  // namespace cyl
