// SPDX-License-Identifier: MIT
// A fuzzing engine at work: a program linked with libFuzzer in processes of its own, one after the other, and
// the folder where it keeps its corpus, its findings and its log.
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

/// Returns what a file holds from a byte on; nothing where it cannot be read.
std::string text_of(const std::filesystem::path& file, std::uintmax_t from = 0);

/// Returns the paths of what a folder holds, sorted; none where it is no folder.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

/// Returns the line of a log that says why a process died, as sanitizers and the engine write it.
std::string reason_in(const std::string& log);

/// Starts an engine, its output at the end of `log`, with DAYLIGHT_FUZZ_OUT set to `findings` (none where
/// empty).
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
  /// Returns what a process that has died says of the input it died of, as a case, and starts a new one.
  /// Throws std::runtime_error where no input explains it, time and again.
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
