// SPDX-License-Identifier: MIT
// A process that makes batches, one after the other, so that what it has started lives on: workers with
// libraries that are loaded, programs that answer.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "base/process/child.hpp"
#include "corpus/store/run_store.hpp"

namespace cyl {

/// CPU time that a process itself may take for a batch, ten minutes against the usual second: beyond it our
/// own code hangs.
inline constexpr std::chrono::seconds batch_cpu_cap{600};

class JobProcess {
 public:
  using MakeBatch = std::function<BatchRecord(std::uint64_t first, std::uint64_t next)>;
  /// Forks and calls `prepare` in the child. The process has its own process group, so a Ctrl-C for the
  /// parent does not reach it. It dies with the parent. Throws std::system_error if the system has no process
  /// or pipe left.
  explicit JobProcess(const std::function<MakeBatch()>& prepare,
                      std::chrono::seconds cpu_cap = batch_cpu_cap);
  /// If no batch is under way, lets the process end by itself, so that its time and that of its workers count
  /// as this process's; else kills it.
  ~JobProcess();

  /// Starts a batch. Call it only if none is running.
  void begin(std::uint64_t first, std::uint64_t next);
  bool busy() const { return busy_; }
  int descriptor() const { return child_.output(); }  ///< to poll for reading
  /// Takes in what has arrived, without waiting, and returns whether the batch under way is made or lost.
  bool advance();
  /// Returns the batch after advance() returned true. Throws std::runtime_error with the cause if the process
  /// died. Then it cannot be used again.
  BatchRecord take();

 private:
  struct Pipe {
    Pipe();
    ~Pipe();
    int ends[2];
  };

  Pipe ranges_;  ///< carries the ranges to make
  const std::chrono::seconds cpu_cap_;
  Child child_;
  bool busy_ = false, over_cap_ = false;
  std::uint64_t first_ = 0, next_ = 0;
  std::chrono::nanoseconds cpu_at_start_{0};
};

}  // namespace cyl
