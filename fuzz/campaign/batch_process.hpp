// SPDX-License-Identifier: MIT
// A function or program that makes a batch in a process of its own. If it dies, the parent knows which batch
// it was.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/process/child.hpp"
#include "corpus/store/run_store.hpp"

namespace cyl {

/// CPU time a batch process itself may take, ten minutes against the usual second: beyond it our own code
/// hangs.
inline constexpr std::chrono::seconds batch_cpu_cap{600};

class BatchProcess {
 public:
  /// Forks. The process has its own process group, so a Ctrl-C for the parent does not reach it. It dies with
  /// the parent. Throws std::system_error if the system has no process or pipe left.
  BatchProcess(std::uint64_t first, std::uint64_t next, const std::function<BatchRecord()>& make,
               std::chrono::seconds cpu_cap = batch_cpu_cap);
  /// Runs a program with its arguments likewise, which prints the batch as format_batch() has it.
  BatchProcess(std::uint64_t first, std::uint64_t next, const std::vector<std::string>& command,
               std::chrono::seconds cpu_cap);

  std::uint64_t first() const { return first_; }
  std::uint64_t next() const { return next_; }
  int descriptor() const { return child_.output(); }  ///< to poll for reading
  /// Takes in what has arrived, without waiting, and returns whether the process has ended.
  bool advance();
  bool ended() const { return child_.ended(); }
  /// Returns the batch after the process has ended. Throws std::runtime_error with the cause of its
  /// death.
  BatchRecord take() const;
  /// Returns what the process took, once it has ended, with its workers.
  std::chrono::milliseconds cpu_time() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(child_.cpu_time());
  }

 private:
  const std::uint64_t first_, next_;
  const std::chrono::seconds cpu_cap_;
  bool over_cap_ = false;
  Child child_;
};

}  // namespace cyl
