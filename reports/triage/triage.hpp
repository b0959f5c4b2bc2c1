// SPDX-License-Identifier: MIT
// Triage: from the findings of a run to their causes. Each finding that is kept is classified
// (oracles/trial/mechanism.hpp), and as many as the time allows are simplified with what fails, what meets
// and the cause kept. For each cause a worse pair is searched for (reports/triage/worst_pair.hpp). What is
// found out goes into FOLDER/triage.sqlite at once: a triage that is killed goes on where it was, and one
// that is run again simplifies more.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "corpus/store/case_files.hpp"
#include "corpus/store/suppressions.hpp"
#include "oracles/methods/method.hpp"
#include "reports/triage/buckets.hpp"

namespace cyl {

struct TriageOptions {
  std::string folder;  ///< of the run
  std::vector<std::string>
      against;  ///< triaged runs it is held against; none: those beside it that began before
  std::chrono::milliseconds budget{
      300'000};       ///< wall time, the page's included; overrun by a few questions a cause
  unsigned jobs = 2;  ///< processes; do not change the buckets
  std::vector<Suppression> suppressions;
  std::vector<Case> cases;  ///< of the case files: what a suppression must match
  std::string today;        ///< YYYY-MM-DD
  std::string build;        ///< what was found out by another build is found out again
};

/// Returns what found out whatever a triage keeps: the build and its methods, with their versions; guests
/// apart, whose findings are classified anew where their own version changed.
std::string methods_line(const std::string& build, std::span<const std::unique_ptr<Method>> methods);

struct TriageProgress {
  std::size_t findings = 0, classified = 0;  ///< kept, and those whose cause is known
  std::size_t absent = 0;  ///< kept, of guests of the run that are not among the methods: not classified
  std::size_t simplified = 0;
  std::size_t searched = 0;  ///< causes, for a worse pair
  std::chrono::milliseconds elapsed{0};
};

struct Triage {
  std::vector<Bucket> buckets;       ///< those beyond claims first, then by count; what is gone last
  TriageProgress progress;           ///< at the end
  std::vector<std::string> remarks;  ///< on earlier runs half looked at, and on suppressions
};

/// Triages a run. `methods`: all there are, and the guests. Throws UsageError where no run is there,
/// std::runtime_error where a store cannot be used or a process ended in a way it should not.
Triage run_triage(const TriageOptions& options, std::span<const std::unique_ptr<Method>> methods,
                  const std::function<void(const TriageProgress&)>& on_progress = {});

/// Returns the buckets that the last triage of a run left, as it stored them: an array of what to_json()
/// makes of a Bucket; empty where the run was never triaged.
nlohmann::json buckets_json(const std::string& run_folder);

/// Returns 2 for a cause beyond a claim that is not suppressed, 3 for none, but undecided truth or findings
/// that are not classified, else 0.
int exit_code(const Triage& triage);

}  // namespace cyl
