// SPDX-License-Identifier: MIT
#include "base/times.hpp"

#include <fmt/chrono.h>

#include <charconv>
#include <ctime>
#include <system_error>

#include "base/usage_error.hpp"

namespace cyl {
std::chrono::milliseconds parse_duration(std::string_view text) {
  constexpr double year = 365.0 * 24 * 3600 * 1000;  // ms
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  double scale = 0;
  if (unit == "ms") scale = 1;
  if (unit == "s") scale = 1000;
  if (unit == "m") scale = 60 * 1000;
  if (unit == "h") scale = 3600 * 1000;
  if (unit == "d") scale = 24 * 3600 * 1000;
  if (error != std::errc() || !(value * scale >= 1 && value * scale <= year)) {
    throw UsageError("'" + std::string(text) + "' is not a duration such as 90s, 1m or 8h");
  }
  return std::chrono::milliseconds(static_cast<std::int64_t>(value * scale));
}

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr))); }

}  // namespace cyl
