// SPDX-License-Identifier: MIT
// The findings of a run by their cause, and how many of all findings each cause stands for.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

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
  std::vector<CauseRecord> causes;    ///< by finding; findings without one are left out of the buckets
  std::vector<SimpleRecord> simples;  ///< by finding
  std::vector<WorstRecord> worsts;    ///< by bucket
};

/// Whether x is the worse of two findings: a refuted verdict before all else, then the larger proved margin.
bool is_worse(const FindingRecord& x, const FindingRecord& y);
/// The proved margin of a finding, or -1 if there is none.
double least_margin(const FindingRecord& finding);

/// A pair that may be shown as a bucket's simplest.
struct ShownCandidate {
  bool as_found;  ///< not simplified
  Complexity complexity;
  const FindingRecord* of;
  Pair pair;
};

/// The findings of one cause, and the pairs of it that may be shown.
struct CauseFindings {
  std::vector<const FindingRecord*> findings;  ///< by id
  std::set<Mechanism> mechanisms;
  std::map<std::string, std::size_t> labels;
  std::set<std::string> merged;
  std::vector<ShownCandidate> candidates;
  std::optional<ShownCandidate> simplest;
  bool seen_again = false;  ///< on the simplest
  const FindingRecord* worst = nullptr;
  const WorstRecord* found = nullptr;  ///< a pair that a search found, if it is worse

  /// The finding that stands for the others.
  const FindingRecord& first() const { return simplest ? *simplest->of : *worst; }
  Mechanism mechanism() const {
    return mechanisms.size() == 1 ? *mechanisms.begin() : Mechanism::unclassified;
  }
};

/// Groups the findings that have a cause. The candidates of each group are its simplified findings that are
/// legal, and its findings as they were found.
std::map<std::string, CauseFindings> group_by_cause(const TriageRecords& records);

/// Returns how many findings a bucket stands for. Findings that are not stored are only counted by group
/// (method, kind, severity, family). The buckets share the count of a group in proportion to its stored
/// findings. The remainder goes to the larger parts first.
struct BucketCount {
  std::uint64_t findings = 0;
  std::map<std::string, std::uint64_t> by_method;

  std::uint64_t most() const;  ///< of a method: pairs, since it has one finding a pair
};
std::map<std::string, BucketCount> count_by_bucket(const TriageRecords& records);

}  // namespace cyl
