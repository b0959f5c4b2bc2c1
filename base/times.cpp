// SPDX-License-Identifier: MIT
#include "base/times.hpp"

#include <fmt/chrono.h>
#include <time.h>

#include <charconv>
#include <ctime>
#include <system_error>

#include "base/usage_error.hpp"

namespace cyl {
namespace {

using std::chrono::system_clock;

[[noreturn]] void refuse(const std::string& text) {
  throw UsageError("'" + text + "' is not a time such as 06:30 or 2026-11-22T06:30");
}

// strptime accepts a 31st of February, and mktime moves it to March. So the result must equal the input.
system_clock::time_point time_point_of(std::tm written, bool utc, const std::string& text) {
  std::tm kept = written;
  kept.tm_isdst = -1;
  const std::time_t seconds = utc ? timegm(&kept) : std::mktime(&kept);
  if (seconds == -1 || kept.tm_mday != written.tm_mday || kept.tm_mon != written.tm_mon) refuse(text);
  return system_clock::from_time_t(seconds);
}

}  // namespace

system_clock::time_point parse_time_point(const std::string& text) {
  std::tm fields{};
  const auto reads_as = [&](const char* format) {
    fields = {};
    const char* end = strptime(text.c_str(), format, &fields);
    return end && *end == '\0';
  };
  if (reads_as("%Y-%m-%dT%H:%M") || reads_as("%Y-%m-%dT%H:%M:%S")) return time_point_of(fields, false, text);
  if (reads_as("%Y-%m-%dT%H:%MZ") || reads_as("%Y-%m-%dT%H:%M:%SZ")) return time_point_of(fields, true, text);
  if (!reads_as("%H:%M")) refuse(text);
  const system_clock::time_point now = system_clock::now();
  const std::time_t seconds = system_clock::to_time_t(now);
  std::tm day{};
  localtime_r(&seconds, &day);
  day.tm_hour = fields.tm_hour;
  day.tm_min = fields.tm_min;
  day.tm_sec = 0;
  for (int days = 0;; ++days) {  // today or tomorrow. A day of 23 hours may lack this time
    std::tm then = day;
    then.tm_mday += days;
    then.tm_isdst = -1;
    const system_clock::time_point next = system_clock::from_time_t(std::mktime(&then));
    if (next > now) return next;
  }
}

std::string format_time_point(system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(system_clock::to_time_t(time)));
}

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
