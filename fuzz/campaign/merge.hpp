// SPDX-License-Identifier: MIT
// Merges shards into one run. Findings, groups, counts and cells are those that one machine would have stored
// for the indices of the shards. Times are sums. The tally's rows have the order of the methods and families.
// The rows of a single run have the order of their first appearance.
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
  bool fuzz_failed = false;             ///< a shard found what its campaign cannot see
  bool harness_failed = false;          ///< in one of them
};

/// Writes the merged run of `runs` to `out`, atomically. It replaces an earlier merged run there. Throws
/// UsageError if shards do not belong together, one is given twice, or `out` has a run that was not
/// merged.
MergeSummary merge_runs(const std::vector<std::string>& runs, const std::string& out);

/// 1 the harness failed in a shard, 2 contract findings or failures, 3 none, but
/// undecided truth or incomplete shards, else 0.
int exit_code(const MergeSummary& summary);

}  // namespace cyl
