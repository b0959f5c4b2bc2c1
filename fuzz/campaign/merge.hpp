// SPDX-License-Identifier: MIT
// Shards into one run: findings, groups, counts and cells are those that one machine alone would have stored,
// had it done the indices that the shards did. Times are sums. The order of the tally's rows is that of the
// methods and families, where a run's own is that of first appearance.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign.hpp"

namespace cyl {

struct MergeSummary {
  CampaignProgress progress;            ///< of all shards together
  std::uint64_t whole_below = 0;        ///< every index below it was done
  std::vector<std::string> incomplete;  ///< shards that are missing or did not reach their limit, a line each
  bool harness_failed = false;          ///< in one of them
};

/// Writes the run of all `runs` together to `out`, at once: a run there that was merged before is replaced.
/// Throws UsageError where shards do not belong together, one comes twice, or `out` holds a run
/// that was not merged.
MergeSummary merge_runs(const std::vector<std::string>& runs, const std::string& out);

/// 1 the harness failed or a self-check failed in a shard, 2 contract findings or failures, 3 none, but
/// undecided truth or incomplete shards, else 0.
int exit_code(const MergeSummary& summary);

}  // namespace cyl
