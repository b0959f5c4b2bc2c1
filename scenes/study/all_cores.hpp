// SPDX-License-Identifier: MIT
// Work in many parts on all cores, and the time that it may take.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace cyl {

/// Shows the share of the work that is done, and the results so far.
using ShowWork = std::function<void(double share, const std::string& results)>;

/// How a study may use the machine. Without a deadline, its results do not depend on it.
struct Workforce {
  unsigned threads = 0;  ///< 0: one for each core
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  ShowWork show;  ///< called by the thread that began the work, at once and then ten times a second
  bool out_of_time() const;
};

/// Calls `task` for each index below `count` on all cores, the lower indices first, and meanwhile `tick` on
/// this thread with the number of calls that are done. No task may throw.
void on_all_cores(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task,
                  const std::function<void(std::size_t)>& tick);

}  // namespace cyl
