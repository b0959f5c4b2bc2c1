// SPDX-License-Identifier: MIT
// Which indices of a run a shard does. Shards take turns by batches, so that all of them meet every family
// and shards of equal time stay about equally far.
#pragma once

#include <algorithm>
#include <cstdint>

namespace cyl {

/// Batch k of a run, the indices [k batch, (k + 1) batch), is done by the shard of index k mod count. The one
/// shard of 1 does the whole run.
struct Shard {
  std::uint64_t index = 0, count = 1;
  std::uint64_t batch = 1;  ///< indices

  /// Returns the least index of its own that is not below `at`.
  std::uint64_t first_from(std::uint64_t at) const {
    const std::uint64_t k = at / batch, wait = (index + count - k % count) % count;
    return wait == 0 ? at : (k + wait) * batch;
  }
  /// Returns the end of the batch that holds `at`.
  std::uint64_t batch_end(std::uint64_t at) const { return (at / batch + 1) * batch; }
  /// Returns how many indices of its own are below `at`.
  std::uint64_t below(std::uint64_t at) const {
    const std::uint64_t round = count * batch;
    const std::uint64_t rest = at % round, start = std::min(rest, index * batch);
    return at / round * batch + std::min(rest - start, batch);
  }
};

}  // namespace cyl
