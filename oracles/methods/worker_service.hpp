// SPDX-License-Identifier: MIT
// The code that runs inside a worker, from its start to its end.
#pragma once

#include <sys/types.h>

#include <memory>
#include <span>
#include <string>

#include "oracles/methods/worker_block.hpp"

namespace cyl {

/// Bytes of output of a worker that are kept, in memory. The rest is lost.
inline constexpr off_t output_cap = off_t{16} << 20;

/// Failed assertions from which one worker recovers: a new worker costs 10 to 25 ms, a return from an
/// assertion nothing. Each one leaks the memory that the call had allocated.
inline constexpr int recovery_cap = 64;

/// Exit code of a worker in which a method called exit().
inline constexpr int exit_called_code = 98;

/// Answers the blocks in `asked`, one for each signal on `go` (an eventfd), and signals each completed block
/// on `done`. Returns if the guest has closed the descriptors, which is not a fault. `confined` as in Worker.
void answer_blocks(std::span<const std::unique_ptr<Method>> methods, bool confined, const RequestBlock& asked,
                   ResponseBlock& said, int go, int done);

/// Returns "SIGABRT, after printing: ...": `how`, and the last words in the file, cut to the length of a
/// reason.
std::string with_last_words(const std::string& how, int output);

}  // namespace cyl
