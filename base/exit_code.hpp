// SPDX-License-Identifier: MIT
// The exit codes of every command. docs/exit-codes.md has the meaning for each of them.
#pragma once

namespace cyl {

/// An int, so that a command returns it as it is.
enum ExitCode : int {
  exit_pass = 0,
  exit_harness_failed = 1,
  exit_findings = 2,
  exit_undecided = 3,
  exit_usage = 64,         // EX_USAGE of sysexits.h
  exit_invalid_input = 65  // EX_DATAERR of sysexits.h
};

}  // namespace cyl
