// SPDX-License-Identifier: MIT
// How far long work is, on standard error: a bar on a terminal, a line each 5 s elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace cyl {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();  ///< takes the bar away
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  bool due() const;  ///< whether it is time to show something
  /// Shows the share of the work that is done, and its results so far.
  void show(double share, const std::string& numbers);

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  Clock::time_point shown_at_ = Clock::now();
};

}  // namespace cyl
