// SPDX-License-Identifier: MIT
// Compares the findings of a run with earlier runs: those in the same folder that began before it. Shards are
// skipped and do not have a history; the merged run has one.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "corpus/store/run_store.hpp"
#include "reports/triage/recurrence.hpp"

namespace cyl {

struct RunData;

/// A run counts for a group only if it asked the group's method about its family.
struct History {
  std::size_t runs = 0;        ///< earlier ones
  std::size_t unreadable = 0;  ///< stores that cannot be read, and are passed over
  std::vector<std::pair<FindingGroup, Recurrence>> groups;

  std::size_t count(Recurrence status) const;
};

/// Compares the groups of a run with those of earlier runs.
History compare_with_earlier(const RunData& run);

/// "against 5 earlier runs: 2 new, 31 known, 1 gone, 0 back"
std::string format_history(const History& history);

}  // namespace cyl
