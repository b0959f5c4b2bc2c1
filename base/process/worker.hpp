// SPDX-License-Identifier: MIT
// A program run as a process of its own that writes to a file: a fuzzing engine at work.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace cyl {

/// Exit code of a process whose program could not be run.
inline constexpr int cannot_run_code = 127;

class Worker {
 public:
  /// Starts it, its output at the end of `log`, with DAYLIGHT_FUZZ_OUT set to `ledger` (none where empty).
  /// Its process group is its own, so a Ctrl-C does not reach it, and it dies with the parent. Throws
  /// std::system_error where the system has no process left.
  Worker(const std::vector<std::string>& command, const std::string& log, const std::string& ledger);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker();  ///< kills what still runs

  /// The status that waitpid gives, once it has ended. Does not wait.
  std::optional<int> ended();
  double cpu_seconds();
  /// Asks libFuzzer to end after the input at hand.
  void ask_to_end();
  void kill_now();

 private:
  pid_t process_;
  std::optional<int> status_;
  double cpu_seconds_ = 0;
};

/// "exit code 77", "killed by signal 9 (Killed)".
std::string how_it_ended(int status);

}  // namespace cyl
