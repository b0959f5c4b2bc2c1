// SPDX-License-Identifier: MIT
// Coverage-guided fuzzing: one target in libFuzzer's fork mode, which runs jobs side by side and survives
// their deaths. It finds pairs, and a campaign judges them. Its finds depend on timing, so the same seed
// does not give the same corpus.
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
  std::string target;   ///< its name, "core"
  std::string plugin;   ///< path of the library that the target asks in place of its own methods, or empty
  /// The folder of the run. The search starts from all of its corpus/ and leaves the minimised corpus in
  /// corpus/TARGET. The pairs on which a method failed are in corpus/found. Until its end, a search keeps all
  /// it makes in fuzz/TARGET. If it is killed, the next one completes it first.
  std::string out;
  std::chrono::milliseconds budget{0};  ///< wall time, merging excluded
  unsigned jobs = 2;                    ///< side by side
  std::uint64_t seed = 0;
};

struct FuzzProgress {
  std::chrono::milliseconds elapsed{0};
  std::uint64_t executions = 0;  ///< of the jobs that have ended
  std::size_t features = 0;      ///< of coverage and of counters, of the same
  std::size_t deaths = 0;        ///< inputs that ended a process
  std::size_t found = 0;         ///< pairs on which a method failed beyond its claim, one a cause
};

struct FuzzSummary {
  std::string target;
  FuzzProgress progress;
  std::size_t inputs = 0, kept_inputs = 0;  ///< of all corpora, distinct; of corpus/TARGET after minimising
  /// Failures that a campaign does not see, a line each: broken laws, and inputs that ended a process.
  std::vector<std::string> failures;
  bool interrupted = false;     ///< by SIGINT or SIGTERM before the budget was used up
  std::string harness_failure;  ///< empty, or why it could not go on
};

/// Fuzzes until the budget is used up or a signal asks to stop, and then merges. Calls `on_progress` about
/// once a second. Throws std::runtime_error if the folder cannot be used.
FuzzSummary run_fuzzing(const FuzzOptions& options,
                        const std::function<void(const FuzzProgress&)>& on_progress = {});

/// "900000 executions, 30000 a second; 1500 features; ..".
std::string format_progress(const FuzzProgress& progress);
/// Returns what a person wants to know of it, in lines.
std::string format_fuzzing(const FuzzSummary& summary);

}  // namespace cyl
