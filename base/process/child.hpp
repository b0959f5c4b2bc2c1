// SPDX-License-Identifier: MIT
// A program of somebody else's that answers lines on its standard input with lines on its standard output.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>

namespace cyl {

/// The most bytes of a line that are read; no answer needs so many.
inline constexpr std::size_t child_line_cap = std::size_t{1} << 16;

/// Runs `command` by /bin/sh in `folder`. It ends, with all that it started, with the Child and with this
/// process, however that ends. It does not hear the signals of a terminal, and where the machine runs out of
/// memory it is killed first. To a process forked from this one the Child is of no use.
class Child {
 public:
  /// Throws std::system_error where the system refuses a process, memory or a descriptor.
  Child(const std::string& command, const std::string& folder);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool ours() const;  ///< this process started it

  /// What a call may take: processor time of the program itself, and time in all.
  struct Cap {
    std::chrono::milliseconds cpu, wall;
  };
  enum class Read : unsigned char { line, ended, late, too_long };
  /// Sends `text` as it is and waits for a line, which is left in `line` without its newline.
  Read exchange(std::string_view text, std::string& line, const Cap& cap);
  /// Whether it has said more than was asked for.
  bool has_said_more();
  /// How it ended: "ended with status 1, after printing: ..." (on standard error). After Read::ended alone.
  std::string death();

 private:
  bool take_input();  ///< false at its end

  pid_t owner_;
  pid_t child_ = -1, keeper_ = -1;
  int to_ = -1, from_ = -1, life_ = -1, report_ = -1, said_ = -1;
  std::string buffer_;
};

}  // namespace cyl
