// SPDX-License-Identifier: MIT
// Triage finds the causes of the findings of a run. It classifies each stored finding
// (oracles/trial/mechanism.hpp). While there is time, it simplifies findings, with the kind of failure, the
// contact feature and the cause unchanged. It stores every result in FOLDER/triage.sqlite at once. So a
// triage that is killed continues, and one that is run again simplifies more.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "oracles/methods/method.hpp"
#include "reports/triage/causes.hpp"

namespace cyl {

struct TriageOptions {
  std::string folder;  ///< of the run
  std::vector<std::string>
      against;  ///< triaged runs to compare with; if empty, the earlier runs in the same folder
  std::chrono::milliseconds budget{
      30'000};        ///< wall time, the page's included; overrun by a few questions a cause
  unsigned jobs = 2;  ///< processes; do not change the causes
  std::string build;  ///< what was found out by another build is found out again
};

/// Returns the source of stored results: the build and its methods, with their versions. Guests are not part
/// of it, because their findings are classified again if their own version changes.
std::string methods_line(const std::string& build, std::span<const std::unique_ptr<Method>> methods);

struct TriageProgress {
  std::size_t findings = 0, classified = 0;  ///< kept, and those whose cause is known
  std::size_t absent = 0;  ///< kept, of guests of the run that are not among the methods: not classified
  std::size_t simplified = 0;
  std::chrono::milliseconds elapsed{0};
};

struct Triage {
  std::vector<Cause> causes;  ///< new first, then beyond claims, of ordinary size, by count; gone last
  TriageProgress progress;    ///< at the end
  std::vector<FindingRecord> findings;  ///< of the run, by id
  std::vector<std::string> remarks;     ///< on earlier runs
};

/// Triages a run. `methods` are all of this build and the guests. Throws UsageError if there is no run, and
/// std::runtime_error if a store cannot be used or a process failed.
Triage run_triage(const TriageOptions& options, std::span<const std::unique_ptr<Method>> methods,
                  const std::function<void(const TriageProgress&)>& on_progress = {});

/// Returns the causes that the last triage of a run stored: an array of to_json(Cause). It is empty if the
/// run was never triaged.
nlohmann::json causes_json(const std::string& run_folder);

/// Returns 2 for a cause beyond a claim, 3 for none, but undecided truth or findings
/// that are not classified, else 0.
int exit_code(const Triage& triage);

}  // namespace cyl
