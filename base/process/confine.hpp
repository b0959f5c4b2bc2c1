// SPDX-License-Identifier: MIT
// What code in a process of its own may ask of the system: threads and files, but no process and no signal to
// others.
#pragma once

#include <atomic>
#include <string>

namespace cyl {

/// The exit code of a process that asked for what it may not.
inline constexpr int denied_code = 97;

/// From here on this process starts no other, becomes no other program, and sends signals to itself alone.
/// Where it tries, the number of the call is left in `denied`, which lives as long as the process, and it
/// ends with denied_code. Returns false, and nothing is held back, where the kernel refuses the filter.
bool confine(std::atomic<int>& denied);

/// Whether this kernel lets processes be confined.
bool can_confine();

/// "kill", or the number where that has no name.
std::string system_call_name(int number);

}  // namespace cyl
