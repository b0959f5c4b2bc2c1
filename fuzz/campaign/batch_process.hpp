// SPDX-License-Identifier: MIT
// A function or program that makes a batch, run in a process of its own: whatever happens to it, the parent
// learns which batch it was.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "corpus/store/run_store.hpp"

namespace cyl {

/// CPU time a batch process itself may take, ten minutes against the usual second: beyond it our own code
/// hangs.
inline constexpr std::chrono::seconds batch_cpu_cap{600};

class Flight {
 public:
  /// Forks. The process has a process group of its own, so a Ctrl-C meant for the parent does not reach it,
  /// and it dies with the parent. Throws std::system_error where the system has no process or pipe left.
  Flight(std::uint64_t first, std::uint64_t next, const std::function<BatchRecord()>& make,
         std::chrono::seconds cpu_cap = batch_cpu_cap);
  /// Likewise of a program, with its arguments, that prints the batch as format_batch() does.
  Flight(std::uint64_t first, std::uint64_t next, const std::vector<std::string>& command,
         std::chrono::seconds cpu_cap);
  Flight(Flight&& other) noexcept;
  Flight& operator=(Flight&&) = delete;
  ~Flight();  ///< kills what still runs

  std::uint64_t first() const { return first_; }
  std::uint64_t next() const { return next_; }
  int descriptor() const { return descriptor_; }  ///< to poll for reading
  /// Takes in what has arrived, without waiting. Whether the process has ended.
  bool advance();
  bool ended() const { return ended_; }
  /// What the batch gave, once it has ended. Throws std::runtime_error that says how it died.
  BatchRecord take() const;
  /// That the process took, once it has ended; its workers' included.
  std::chrono::milliseconds cpu_time() const { return cpu_time_; }

 private:
  void launch(const std::function<void(int descriptor)>& work);

  std::uint64_t first_, next_;
  std::chrono::seconds cpu_cap_;
  pid_t process_ = -1;
  int descriptor_ = -1;
  bool ended_ = false;
  bool over_cap_ = false;
  int status_ = 0;
  std::chrono::milliseconds cpu_time_{0};
  std::string received_;
};

}  // namespace cyl
