// SPDX-License-Identifier: MIT
// A foreign program that answers lines on its standard input with lines on its standard output.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "base/process/process.hpp"
#include "base/process/supervised_process.hpp"

namespace cyl {

/// The most bytes of a line that are read; no answer needs so many.
inline constexpr std::size_t program_line_cap = std::size_t{1} << 16;

/// Runs `command` by /bin/sh in `folder`. It ends, with all its descendants, when the LineProgram or this
/// process ends. Signals of a terminal do not reach it, and if memory runs out it is killed first. A process
/// forked from this one cannot use the LineProgram.
class LineProgram {
 public:
  /// Throws std::system_error if the system refuses a process, memory or a descriptor.
  LineProgram(const std::string& command, const std::string& folder);
  ~LineProgram();
  LineProgram(const LineProgram&) = delete;
  LineProgram& operator=(const LineProgram&) = delete;

  bool ours() const { return process_->ours(); }  ///< this process started it
  /// The time of the program and of its descendants that still run.
  std::chrono::nanoseconds cpu_time() const { return cpu_time_of_tree(process_->id()); }

  /// Limits of the wait for a line: processor time, and time in all.
  struct Cap {
    std::chrono::milliseconds cpu, wall;
  };
  enum class Read : unsigned char { line, ended, over_cpu_cap, over_wall_cap, too_long };
  /// Queues `text`, which is sent unchanged while lines are awaited.
  void send(std::string_view text);
  /// Waits for a line, which is left in `line` without its newline.
  Read receive(std::string& line, const Cap& cap);
  /// Returns whether it has answered more than was received.
  bool has_answered_more();
  /// Returns how it ended: "ended with status 1, after printing: ValueError: no such shape" (the last line of
  /// standard error, without a stack). Only after Read::ended.
  std::string death();

 private:
  bool take_input();  ///< false at its end

  std::unique_ptr<SupervisedProcess> process_;
  int to_ = -1, from_ = -1;
  int printed_ = -1;  ///< what the program printed on standard error
  std::string incoming_, outgoing_;
  std::size_t taken_ = 0;  ///< bytes of `incoming_` that were received
};

}  // namespace cyl
