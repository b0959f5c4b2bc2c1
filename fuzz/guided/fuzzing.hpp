// SPDX-License-Identifier: MIT
// Coverage-guided fuzzing: several libFuzzer processes of one target. Each has its own corpus and
// reads the finds of the others. The finds depend on timing, so the same seed does not give the same
// run.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace cyl {

struct FuzzOptions {
  std::string program;  ///< that libFuzzer drives, linked with the mutator and the counters
  std::string target;   ///< its name, the source of findings: "fuzz_core"
  /// The folder of the run. Its corpus/ is the start of the workers, if it exists. After the run it has the
  /// minimised union of all corpora. findings.jsonl has one line of a case file for each finding.
  std::string out;
  std::chrono::milliseconds budget{0};  ///< wall time, merging excluded
  unsigned jobs = 2;                    ///< workers
  std::uint64_t seed = 0;
  std::chrono::milliseconds exchange_interval{5000};  ///< between the workers' corpora
};

struct WorkerProgress {
  std::uint64_t executions = 0;
  double cpu_seconds = 0;
  std::size_t features = 0;        ///< distinguished by the engine: of coverage and of counters
  std::size_t first_features = 0;  ///< of them, those of the corpus it began with
  unsigned deaths = 0;             ///< each a finding, and a new process
};

struct FuzzProgress {
  std::chrono::milliseconds elapsed{0};
  std::vector<WorkerProgress> workers;
  std::size_t strata = 0;  ///< visited, among those that can occur
  std::size_t findings = 0;
};

struct FuzzSummary {
  FuzzProgress progress;
  std::vector<std::string> never_visited;   ///< strata that can occur
  std::size_t possible_strata = 0;          ///< that can occur
  std::vector<std::string> impossible;      ///< strata visited that cannot occur: counters.hpp is wrong
  std::size_t inputs = 0, kept_inputs = 0;  ///< of all corpora, distinct; after minimising
  std::size_t undecided = 0;                ///< strata with a pair that was undecided within a target's time
  std::vector<std::string> findings;        ///< of this run, a line of a case file each
  bool interrupted = false;                 ///< by SIGINT or SIGTERM before the budget was used up
  std::string harness_failure;              ///< empty, or why it could not go on
};

/// Fuzzes until the budget is used up or a signal asks to stop, and then merges. Calls `on_progress` about
/// once a second. Throws std::runtime_error if the folder cannot be used.
FuzzSummary run_fuzzing(const FuzzOptions& options,
                        const std::function<void(const FuzzProgress&)>& on_progress = {});

/// 1 the harness failed, 2 findings, else 0.
int exit_code(const FuzzSummary& summary);

/// Returns what a person wants to know of it, in lines.
std::string format_fuzzing(const FuzzSummary& summary);

}  // namespace cyl
