// SPDX-License-Identifier: MIT
// The code that runs inside a worker, from its start to its end.
#pragma once

#include <sys/types.h>

#include <memory>
#include <span>

#include "oracles/methods/worker_block.hpp"

namespace cyl {

/// Bytes of output of a worker that are kept, in memory. The rest is lost.
inline constexpr off_t output_cap = off_t{16} << 20;

/// Exit code of a worker in which a method called exit().
inline constexpr int exit_called_code = 98;

/// Answers the blocks in `asked`, one for each signal on `go` (an eventfd), and signals each completed block
/// on `done`. Returns if the guest has closed the descriptors, which is not a fault. `confined` as in Worker.
void answer_blocks(std::span<const std::unique_ptr<Method>> methods, bool confined, const RequestBlock& asked,
                   ResponseBlock& said, int go, int done);

}  // namespace cyl
