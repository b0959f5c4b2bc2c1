// SPDX-License-Identifier: MIT
// Shared by the steps of a triage: the findings of the run, the methods, the store, the budget of time.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "corpus/store/run_store.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/trial/mechanism.hpp"
#include "reports/triage/triage.hpp"
#include "reports/triage/triage_store.hpp"

namespace cyl {

/// A finding with what is read of it once.
struct Subject {
  const FindingRecord* record;
  std::optional<std::size_t> method;
  bool absent = false;  ///< its method is a guest of the run that is not here
  Pair pair;

  /// Hangs and failures that are not deterministic reveal nothing on a second call. Findings within the claim
  /// have one cause.
  bool can_be_classified() const {
    return method && severity() == Severity::contract && kind() != FindingKind::hang && recurs();
  }
  bool can_be_simplified() const { return method && recurs(); }
  bool recurs() const {
    return kind() != FindingKind::nondeterminism && kind() != FindingKind::state_dependent;
  }
  FindingKind kind() const { return record->kind; }
  Severity severity() const { return record->severity; }
  Failing failing() const { return {*method, kind(), pair}; }
};

struct TriageContext {
  using Clock = std::chrono::steady_clock;

  const TriageOptions& options;
  const std::function<void(const TriageProgress&)>& on_progress;
  const std::span<const std::unique_ptr<Method>> methods;
  const std::string asked_by;                    ///< as askers() gives it
  Clock::time_point start = Clock::now();        ///< of the steps
  std::vector<std::size_t> groups;               ///< algorithm_groups(), of the libraries with findings
  std::string began;                             ///< the run
  std::vector<FindingRecord> findings;           ///< by id
  std::vector<GroupRecord> finding_groups;       ///< all findings, counted
  std::vector<std::string> asked;                ///< the run's methods that are here
  std::vector<Subject> subjects;                 ///< the findings
  std::map<std::int64_t, const Subject*> by_id;  ///< the subjects
  std::set<std::int64_t> absent;                 ///< findings of guests that are not here
  std::chrono::milliseconds budget;              ///< what the page will take is taken off

  /// Opens the run. Throws as run_triage() does.
  TriageContext(const TriageOptions& options, std::span<const std::unique_ptr<Method>> methods,
                const std::function<void(const TriageProgress&)>& on_progress);
  TriageContext(const TriageContext&) = delete;
  TriageContext& operator=(const TriageContext&) = delete;

  GroupedMethods grouped() const { return {methods, groups}; }
  /// Opens the triage's own store; each process its own.
  TriageStore store() const { return {options.folder, asked_by}; }
  // The stored causes, by finding, of findings whose guest is on this machine.
  std::vector<CauseRecord> causes() const { return here(store().causes()); }
  std::vector<SimpleRecord> simples() const { return here(store().simples()); }

  std::chrono::milliseconds elapsed() const;
  Clock::time_point end_of(double part) const {
    return start + std::chrono::duration_cast<Clock::duration>(part * budget);
  }
  bool out_of_time(double part = 1) const { return Clock::now() >= end_of(part); }
  /// Returns the limits of questions until that part of the budget is used up. A question after that is
  /// declined, so the asker drops its last result.
  Caps caps(double part, unsigned hangs = 4) const {
    Caps caps = attended_caps(hangs);
    caps.until = end_of(part);
    return caps;
  }
  TriageProgress progress() const;

  /// Calls `work(job)` in as many processes at once as there are jobs, and shows the progress. Throws
  /// std::runtime_error if one of them failed.
  void in_processes(const std::function<void(unsigned job)>& work) const;

 private:
  template <class Record>
  std::vector<Record> here(std::vector<Record> records) const {
    std::erase_if(records, [&](const Record& r) { return absent.contains(r.finding); });
    return records;
  }
};

// The steps. Each continues an earlier triage, and ends when the time does.

/// Finds the cause of each finding that does not have one, until that part of the budget is used up. Causes
/// from another version of a guest are found again.
void classify_findings(const TriageContext& context, double part);
/// Simplifies findings in the same way. A cut result is continued later. `known` are causes of earlier runs.
void simplify_findings(const TriageContext& context, const std::set<std::string>& known, double part);
/// Returns the findings to simplify: one of each cause after the other, new causes before known ones, then
/// those beyond a claim, then the largest.
std::vector<const Subject*> simplification_order(const TriageContext& context,
                                                 const std::set<std::string>& known);
}  // namespace cyl
