// SPDX-License-Identifier: MIT
// Limits the system calls of code in a process of its own: threads and files are allowed, but not processes
// and signals to others.
#pragma once

#include <atomic>
#include <string>

namespace cyl {

/// The exit code of a process that asked for what it may not.
inline constexpr int denied_code = 97;

/// From here on this process cannot start or become another program, and can send signals to itself only. If
/// it tries, it ends with denied_code and the number of the call in `denied`, which lives as long as the
/// process. Returns false, and changes nothing, if the kernel rejects the filter.
bool confine(std::atomic<int>& denied);

/// Whether this kernel lets processes be confined.
bool can_confine();

/// Returns "kill", or the number if the call has no name.
std::string system_call_name(int number);

}  // namespace cyl
