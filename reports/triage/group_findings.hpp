// SPDX-License-Identifier: MIT
// Groups the findings of a run by cause, and estimates how many of all findings each cause has.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/trial/mechanism.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/triage/triage_store.hpp"

namespace cyl {

/// All that is known of a run's findings.
struct TriageRecords {
  std::string folder;                   ///< of the run
  std::vector<FindingRecord> findings;  ///< by id
  std::vector<GroupRecord> groups;
  std::vector<CauseRecord> causes;    ///< by finding; findings without one are left out
  std::vector<SimpleRecord> simples;  ///< by finding
};

/// Returns whether x is worse than y. A refuted verdict is worse than any other finding. Else the larger
/// proved margin is worse.
bool is_worse(const FindingRecord& x, const FindingRecord& y);
/// The proved margin of a finding, or -1 if there is none.
double least_margin(const FindingRecord& finding);

/// Pairs with the least rank are shown and simplified first: programs for maintainers have no roundings, and
/// readers compare with the sizes of scenes.
inline std::pair<bool, bool> shown_rank(const Pair& pair) { return {is_rounded(pair), !is_ordinary(pair)}; }

/// A pair that may be shown as a cause's simplest.
struct ShownCandidate {
  bool as_found;  ///< not simplified
  bool finished;  ///< simplified to the end
  Complexity complexity;
  const FindingRecord* of;
  Pair pair;
};

/// The findings of one cause, and the pairs of it that may be shown.
struct CauseFindings {
  std::vector<const FindingRecord*> findings;  ///< by id
  std::set<Mechanism> mechanisms;
  std::map<std::string, std::size_t> labels;  ///< further labels, with the number of their findings
  std::vector<ShownCandidate> candidates;
  std::optional<ShownCandidate> simplest;
  bool seen_again = false;  ///< a rerun of the simplest pair fails again
  const FindingRecord* worst = nullptr;

  /// The finding that stands for the others.
  const FindingRecord& first() const { return simplest ? *simplest->of : *worst; }
  Mechanism mechanism() const {
    return mechanisms.size() == 1 ? *mechanisms.begin() : Mechanism::unclassified;
  }
};

/// Groups the findings that have a cause. The candidates of each cause are its simplified pairs that are
/// legal (is_legal()), and its pairs as they were found.
std::map<std::string, CauseFindings> group_by_cause(const TriageRecords& records);

/// Returns the count of each cause. The store counts findings that it did not keep by FindingGroup, and the
/// causes share that count in proportion.
std::map<std::string, std::uint64_t> count_by_cause(const std::vector<GroupRecord>& groups,
                                                    const std::vector<FindingRecord>& findings,
                                                    const std::vector<CauseRecord>& causes);

}  // namespace cyl
