// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace cyl {
namespace {

constexpr std::chrono::milliseconds line_interval{5000}, bar_interval{200};
constexpr int bar_width = 20;  // columns

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

bool ProgressLine::due() const {
  return Clock::now() - shown_at_ >= (terminal_ ? bar_interval : line_interval);
}

void ProgressLine::show(double share, const std::string& numbers) {
  shown_at_ = Clock::now();
  share = std::clamp(share, 0.0, 1.0);
  if (!terminal_) {
    fmt::print(stderr, "{:3.0f} %  {}\n", 100 * share, numbers);
    return;
  }
  const int filled = static_cast<int>(share * bar_width);
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {:3.0f} %  {}\033[K", "", filled, "", bar_width - filled,
             100 * share, numbers);
  std::fflush(stderr);
}

}  // namespace cyl
