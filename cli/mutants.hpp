// SPDX-License-Identifier: MIT
// The executable that holds the mutants, beside this one: never linked into it.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace cyl {

/// Its path; empty if it is not installed.
std::string mutants_executable();

/// Becomes `daylight-mutants` with these arguments. Throws std::runtime_error if it is not installed.
[[noreturn]] void become_mutants(const std::vector<std::string>& arguments);

struct SelfTest {
  bool ran = false;    ///< false: there is no such executable
  bool cut = false;    ///< the time was over before the last fault
  bool passed = true;  ///< every planted fault that was tried was detected
  std::string text;    ///< the result, such as "5 of 5 detected"
};
/// Plants this many faults, one after the other, and checks that laws, corpus and referee detect each. All
/// must end within `time`, if it is given.
SelfTest self_test(unsigned count, std::optional<std::chrono::milliseconds> time = {});

}  // namespace cyl
