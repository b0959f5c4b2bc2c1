// SPDX-License-Identifier: MIT
#include "fuzz/guided/fuzzing.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include "base/files.hpp"
#include "base/process/child.hpp"
#include "base/process/process.hpp"
#include "base/process/stop_signals.hpp"
#include "fuzz/guided/record.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::duration_cast;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds poll_time{100};
constexpr seconds look_interval{1};
/// Time for one input, which takes about a millisecond.
constexpr seconds input_cap{25};
constexpr seconds merge_cap{600};
/// Deaths of jobs without an input that explains one, before the harness fails.
constexpr std::size_t unexplained_cap = 3;
/// Exit code of an engine that could not be run.
constexpr int cannot_run_code = 127;
/// Bytes at the end of a log that an error quotes.
constexpr std::size_t quoted_cap = 300;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Returns the number after the last `word`, or 0 if there is none.
std::size_t last_number(std::string_view text, std::string_view word) {
  const std::size_t at = text.rfind(word);
  std::size_t number = 0;
  if (at != text.npos) std::from_chars(text.data() + at + word.size(), text.data() + text.size(), number);
  return number;
}

/// Returns the line of a log with the cause of a process's death, as sanitizers and the engine write it.
std::string reason_in(const std::string& log) {
  for (const std::string_view word : {"SUMMARY: ", "ERROR: "}) {
    const std::size_t at = log.rfind(word);
    if (at != log.npos) return log.substr(at, log.find('\n', at) - at);
  }
  return "no reason given";
}

class Run {
 public:
  Run(const FuzzOptions& options, const std::function<void(const FuzzProgress&)>& on_progress)
      : options_(options),
        on_progress_(on_progress),
        unfinished_(fs::absolute(options.out) / "fuzz" / options.target),
        corpora_(fs::absolute(options.out) / "corpus"),
        corpus_(corpora_ / options.target) {
    summary_.target = options.target;
  }

  FuzzSummary run() {
    const StopSignals signals;
    try {
      if (fs::exists(unfinished_)) finish();
      fuzz();
      finish();
    } catch (const std::runtime_error& error) {
      summary_.harness_failure = error.what();
      look();
    }
    return std::move(summary_);
  }

 private:
  void fuzz() {
    for (const char* folder : {"died", "jobs"}) fs::create_directories(unfinished_ / folder);
    fs::create_directories(corpus_);
    // The engine ends if no input of its corpus runs any tested code. This one is not a legal pair.
    if (fs::is_empty(corpus_))
      std::ofstream(corpus_ / "zeros", std::ios::binary) << std::string(record_size, '\0');
    const std::uint64_t seed = 1 + options_.seed % 0x7fffffff;  // 0 asks for a random one
    const std::string log = unfinished_ / "log";
    std::vector<std::string> arguments{corpus_};
    for (const fs::path& other : files_in(corpora_))
      if (other != corpus_) arguments.push_back(other);
    for (const std::string& flag :
         {fmt::format("-fork={}", options_.jobs), fmt::format("-seed={}", seed),
          std::string("-ignore_crashes=1"), std::string("-ignore_timeouts=1"), std::string("-ignore_ooms=1"),
          std::string("-len_control=0"), std::string("-reduce_inputs=0"), std::string("-print_pcs=0"),
          // Tries the rare branches of a plug-in more often. Strata are to get equal shares.
          fmt::format("-entropic={}", options_.plugin.empty() ? 0 : 1)})
      arguments.push_back(flag);
    const auto engine = start(arguments, log);
    const auto begin = Clock::now();
    auto looked = begin;
    while (Clock::now() - begin < options_.budget && !summary_.interrupted) {
      std::this_thread::sleep_for(poll_time);
      summary_.interrupted = StopSignals::asked();
      const bool ended = engine->advance();
      if (!ended && Clock::now() - looked < look_interval) continue;
      looked = Clock::now();
      summary_.progress.elapsed = duration_cast<milliseconds>(looked - begin);
      look();
      if (ended || unexplained_deaths())
        throw std::runtime_error(fmt::format("the engine {}; {} has: {}",
                                             ended ? "ended with " + how_it_ended(engine->status())
                                                   : "loses its jobs without an input that explains it",
                                             log, end_of(log)));
      if (on_progress_) on_progress_(summary_.progress);
    }
    engine->kill_now();  // with its jobs, whose corpora remain
    engine->wait();
    summary_.progress.elapsed = duration_cast<milliseconds>(Clock::now() - begin);
  }

  /// Takes over all that is in unfinished/, and removes it.
  void finish() {
    look();
    keep_found();
    merge();
    fs::remove_all(unfinished_);
  }

  void look() {
    FuzzProgress& progress = summary_.progress;
    const std::string log = read_file(unfinished_ / "log");
    progress.executions = last_number(log, "#");
    progress.features = last_number(log, " ft: ");
    progress.found = files_in(unfinished_ / "findings").size();
    for (const fs::path& file : files_in(unfinished_ / "died"))
      if (known_deaths_.insert(file.filename()).second) add_death(file);
    progress.deaths = known_deaths_.size();
  }

  // The engine names a file by the kind of death: crash-, timeout-, oom-, leak-. A slow-unit- did not die.
  void add_death(const fs::path& file) {
    const std::string name = file.filename(), kind = name.substr(0, name.find('-'));
    if (kind == "slow" || fs::file_size(file) != record_size) return;
    const std::string what =
        fmt::format("the target {} died ({}): {}", options_.target, kind, reason_of_death(file, kind));
    if (known_reasons_.insert(what).second)
      summary_.failures.push_back(what + "; record " + name);
    else
      repeated_.insert(name);
  }

  /// Copies what a campaign is to ask about into the corpus. A later run in this folder keeps it.
  void keep_found() {
    std::ifstream broken(unfinished_ / "broken");
    for (std::string line; std::getline(broken, line);) summary_.failures.push_back(line);
    const fs::path found = corpora_ / "found";
    fs::create_directories(found);
    for (const char* folder : {"findings", "undecided", "died"})
      for (const fs::path& file : files_in(unfinished_ / folder))
        if (!repeated_.contains(file.filename()) && fs::file_size(file) == record_size)
          fs::copy_file(file, found / file.filename(), fs::copy_options::overwrite_existing);
  }

  std::string reason_of_death(const fs::path& file, const std::string& kind) {
    if (kind == "timeout") return fmt::format("takes more than {} s", input_cap.count());
    if (kind == "oom") return "needs too much memory";
    const fs::path log = unfinished_ / "death.log";
    fs::remove(log);
    return start({file}, log)->wait() == 0 ? "not when run again" : reason_in(read_file(log));
  }

  bool unexplained_deaths() const {
    const std::string log = read_file(unfinished_ / "log");
    return known_deaths_.empty() && last_number(log, " oom/timeout/crash: 0/0/") >= unexplained_cap;
  }

  // Into a folder of its own, which takes the corpus's place at once.
  void merge() {
    const fs::path merged = unfinished_ / "corpus";
    fs::remove_all(merged);
    fs::create_directories(merged);
    std::vector<std::string> arguments{merged, "-merge=1"};
    for (const fs::path& folder : files_in(corpora_)) arguments.push_back(folder);
    // A job writes its corpus in a folder C1, C2, ..
    for (const fs::path& engine : files_in(unfinished_ / "jobs"))
      for (const fs::path& folder : files_in(engine))
        if (folder.filename().string().starts_with('C') && fs::is_directory(folder))
          arguments.push_back(folder);
    std::set<fs::path> inputs;
    for (const std::string& folder : arguments)
      for (const fs::path& file : files_in(folder)) inputs.insert(file.filename());
    const std::string log = unfinished_ / "merge.log";
    fs::remove(log);
    const auto merging = start(arguments, log);
    const auto begin = Clock::now();
    while (!merging->advance()) {
      if (Clock::now() - begin > merge_cap)
        throw std::runtime_error(fmt::format("merging took more than {} s. The inputs are in {} and {}",
                                             merge_cap.count(), corpus_.string(), unfinished_.string()));
      std::this_thread::sleep_for(poll_time);
    }
    if (merging->status() != 0)
      throw std::runtime_error(fmt::format("merging ended with {}: {}", how_it_ended(merging->status()),
                                           reason_in(read_file(log))));
    fs::remove_all(corpus_);
    fs::rename(merged, corpus_);
    summary_.inputs = inputs.size();
    summary_.kept_inputs = files_in(corpus_).size();
  }

  /// Starts the program, with its output at the end of `log`. The target keeps its findings in unfinished/.
  std::unique_ptr<Child> start(std::vector<std::string> arguments, const std::string& log) const {
    arguments.insert(arguments.begin(), options_.program);
    for (const std::string& flag :
         {fmt::format("-max_len={}", record_size), fmt::format("-timeout={}", input_cap.count()),
          fmt::format("-artifact_prefix={}/died/", unfinished_.string())})
      arguments.push_back(flag);
    return std::make_unique<Child>(
        [&]() -> std::string {
          try {
            redirect_streams("/dev/null", log);
            unsetenv("DAYLIGHT_FUZZ_ABORT");
            unsetenv("DAYLIGHT_FUZZ_PLUGIN");
            if (!options_.plugin.empty()) setenv("DAYLIGHT_FUZZ_PLUGIN", options_.plugin.c_str(), 1);
            setenv("DAYLIGHT_FUZZ_OUT", unfinished_.c_str(), 1);
            setenv("TMPDIR", (unfinished_ / "jobs").c_str(), 1);
            become_program(arguments);
          } catch (const std::exception& error) {
            fmt::print(stderr, "cannot run {}\n", error.what());
            _exit(cannot_run_code);
          }
        },
        ChildOptions{.own_group = true});
  }

  static std::string end_of(const std::string& log) {
    const std::string text = read_file(log);
    return text.substr(text.size() - std::min(text.size(), quoted_cap));
  }

  const FuzzOptions& options_;
  const std::function<void(const FuzzProgress&)>& on_progress_;
  const fs::path unfinished_, corpora_, corpus_;
  std::set<fs::path> known_deaths_, repeated_;  ///< by file; those whose reason another one has
  std::set<std::string> known_reasons_;
  FuzzSummary summary_;
};

}  // namespace

FuzzSummary run_fuzzing(const FuzzOptions& options,
                        const std::function<void(const FuzzProgress&)>& on_progress) {
  fs::create_directories(options.out);
  return Run(options, on_progress).run();
}

std::string format_progress(const FuzzProgress& p) {
  const double seconds = std::max(1e-3, static_cast<double>(p.elapsed.count()) / 1000);
  return fmt::format("{} executions, {:.0f} a second; {} features; failures in {} causes, deaths {}",
                     p.executions, static_cast<double>(p.executions) / seconds, p.features, p.found,
                     p.deaths);
}

std::string format_fuzzing(const FuzzSummary& summary) {
  const FuzzProgress& p = summary.progress;
  std::string text = fmt::format("fuzzed {}: {}; corpus {} inputs, of {}\n", summary.target,
                                 format_progress(p), summary.kept_inputs, summary.inputs);
  for (const std::string& line : summary.failures) text += "  " + line + '\n';
  return text;
}

}  // namespace cyl
