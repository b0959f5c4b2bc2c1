// SPDX-License-Identifier: MIT
// fork() on a machine that is short of processes for a moment.
#pragma once

#include <sys/types.h>

namespace cyl {

/// As fork(), but where the system says "try again" (EAGAIN) it does, for up to ten seconds. Negative, with
/// errno, where that did not help.
pid_t patient_fork() noexcept;

}  // namespace cyl
