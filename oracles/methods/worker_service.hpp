// SPDX-License-Identifier: MIT
// The inside of a worker: what it does from its start to its end.
#pragma once

#include <sys/types.h>

#include <memory>
#include <span>

#include "oracles/methods/worker_block.hpp"

namespace cyl {

/// Bytes that a worker may print, kept in memory; what comes after is lost.
inline constexpr off_t output_cap = off_t{16} << 20;

/// Exit code of a worker in which a method called exit().
inline constexpr int exit_called_code = 98;

/// Answers the blocks that `asked` holds, one whenever `go` (an eventfd) says so, and says on `done` that one
/// is answered. Returns where the guest closed the descriptors, which is no fault. `confined` as of Worker.
void answer_blocks(std::span<const std::unique_ptr<Method>> methods, bool confined, const RequestBlock& asked,
                   ResponseBlock& said, int go, int done);

}  // namespace cyl
