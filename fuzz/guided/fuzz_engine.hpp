// SPDX-License-Identifier: MIT
// Runs a fuzzing engine: a program linked with libFuzzer, in one process after the other, and the folder with
// its corpus, findings and log.
#pragma once

#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/process/child.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "fuzz/guided/fuzzing.hpp"

namespace cyl {

/// Returns the content of a file from a byte on, or nothing if it cannot be read.
std::string text_of(const std::filesystem::path& file, std::uintmax_t from = 0);

/// Returns the sorted paths of the entries of a folder. Empty if it is not a folder.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

/// Returns the line of a log with the cause of a process's death, as sanitizers and the engine write it.
std::string reason_in(const std::string& log);

/// Starts an engine with its output at the end of `log`, and with DAYLIGHT_FUZZ_OUT set to `findings` (unset
/// if empty).
std::unique_ptr<Child> run_engine(const std::vector<std::string>& command, const std::string& log,
                                  const std::string& findings);

class Engine {
 public:
  Engine(const FuzzOptions& options, unsigned number);

  std::filesystem::path corpus() const { return folder_ / "corpus"; }
  std::filesystem::path findings() const { return folder_; }
  std::string log() const { return folder_ / "log"; }
  const WorkerProgress& progress() const { return progress_; }
  bool ended() { return process_->advance(); }
  void ask_to_end() { process_->send(SIGUSR1); }
  void kill_now() { process_->kill_now(); }

  /// Brings progress() up to date.
  void look();
  /// Returns the input that killed a process, as a case, and starts a new process. Throws std::runtime_error
  /// if repeatedly no input explains the death.
  std::optional<Case> replace_dead();

 private:
  double cpu_seconds();
  void start();

  const FuzzOptions& options_;
  unsigned number_;
  std::filesystem::path folder_;
  std::unique_ptr<Child> process_;
  WorkerProgress progress_;
  std::uintmax_t log_read_ = 0;
  double earlier_cpu_seconds_ = 0;
  std::set<std::string> known_deaths_;
  unsigned unexplained_ = 0;
};

}  // namespace cyl
