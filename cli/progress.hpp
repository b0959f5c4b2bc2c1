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
  /// Returns whether it is time to show something; `elapsed` since the work began.
  bool due(std::chrono::milliseconds elapsed) const;
  /// Shows the share of the work that is done, and its results so far.
  void show(std::chrono::milliseconds elapsed, double share, const std::string& numbers);

 private:
  bool terminal_;
  std::chrono::milliseconds shown_at_{0};
};

}  // namespace cyl
