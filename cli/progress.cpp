// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace cyl {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds line_interval{5000}, bar_interval{200};
constexpr int bar_width = 20;  // columns

double share_done(const CampaignOptions& options, const CampaignProgress& p) {
  double share = 0;
  if (options.pairs != 0) share = static_cast<double>(p.done) / static_cast<double>(options.pairs);
  if (options.budget.count() != 0) {
    share = std::max(
        share, static_cast<double>(p.session_time.count()) / static_cast<double>(options.budget.count()));
  }
  return std::clamp(share, 0.0, 1.0);
}

std::string numbers(const CampaignProgress& p) {
  const double seconds = std::max(1e-3, static_cast<double>(p.session_time.count()) / 1000);
  return fmt::format("{} pairs, {:.0f}/s; contract {}, failed {}, within claim {}", p.done,
                     static_cast<double>(p.session_done) / seconds, p.contract, p.failed, p.resolution);
}

}  // namespace

ProgressLine::ProgressLine(const CampaignOptions& options)
    : options_(options), terminal_(isatty(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::show(const CampaignProgress& progress) {
  if (progress.session_time - shown_at_ < (terminal_ ? bar_interval : line_interval)) return;
  shown_at_ = progress.session_time;
  const double share = share_done(options_, progress);
  if (!terminal_) {
    fmt::print(stderr, "{:3.0f} %  {}\n", 100 * share, numbers(progress));
    return;
  }
  const int filled = static_cast<int>(share * bar_width);
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {:3.0f} %  {}\033[K", "", filled, "", bar_width - filled,
             100 * share, numbers(progress));
  std::fflush(stderr);
}

}  // namespace cyl
