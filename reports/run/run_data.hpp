// SPDX-License-Identifier: MIT
// All that a run's page, charts and table show of it, read once: the run's store and RUN/charts.json.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/run_facts.hpp"

namespace cyl {

/// The pair of a finding, as far as its record can be read.
struct FoundPair {
  std::optional<Case> line;
  std::optional<Verdict> truth;  ///< if it is proved: disjoint, intersecting or touching
};

struct RunData {
  std::string folder;  ///< as it was named
  Config config;
  Progress progress;
  std::vector<MethodRecord> methods;
  std::vector<TallyRecord> tallies;
  std::vector<GroupRecord> groups;
  std::vector<FindingRecord> findings;
  std::vector<FoundPair> pairs;  ///< of `findings`, one each
  std::vector<CellRecord> cells;
  nlohmann::json charts;  ///< what RUN/charts.json holds, which may be the work of earlier commands; or {}
};

/// Reads the run in a folder. Throws UsageError if there is none, and std::runtime_error that names a file
/// that cannot be read. `findings`: those of the run, if they were read before.
RunData read_run(const std::string& folder, std::vector<FindingRecord> findings = {});

}  // namespace cyl
