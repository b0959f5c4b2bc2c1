// SPDX-License-Identifier: MIT
#include "fuzz/guided/fuzzing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/exit_code.hpp"
#include "base/process/process.hpp"
#include "base/process/stop_signals.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "fuzz/guided/fuzz_engine.hpp"
#include "fuzz/guided/record.hpp"
#include "fuzz/guided/visited.hpp"
#include "oracles/trial/bucket.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::duration_cast;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds poll_time{100};
constexpr seconds look_interval{1};
/// After being asked to end: an input takes a millisecond.
constexpr seconds end_cap{20};
constexpr seconds merge_cap{600};
/// Findings and strata that a report names.
constexpr std::size_t named_cap = 20;

/// Findings by their ids, those of earlier runs in the same folder aside.
class Findings {
 public:
  explicit Findings(const fs::path& out) : file_(out / "findings.jsonl") {
    std::ifstream in(file_);
    CaseReader reader(in);
    while (const auto line = reader.next())
      if (line->value) known_.insert(line->value->id);
  }
  void add(const Case& c) {
    if (!seen_.insert(c.id).second) return;
    lines_.push_back(format_case(c));
    if (known_.insert(c.id).second) std::ofstream(file_, std::ios::app) << lines_.back() << '\n';
  }
  /// Adds those that an engine has written in its folder.
  void add_all(const fs::path& folder) {
    std::ifstream in(folder / "findings.jsonl");
    CaseReader reader(in);
    while (const auto line = reader.next())
      if (line->value) add(*line->value);
  }
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  fs::path file_;
  std::set<std::string> known_, seen_;
  std::vector<std::string> lines_;
};

class Run {
 public:
  Run(const FuzzOptions& options, const std::function<void(const FuzzProgress&)>& on_progress)
      : options_(options), on_progress_(on_progress), out_(options.out), findings_(out_) {}

  FuzzSummary run() {
    const StopSignals signals;
    try {
      for (unsigned k = 1; k <= options_.jobs; ++k) engines_.push_back(std::make_unique<Engine>(options_, k));
      fuzz();
      end_all();
      merge();
    } catch (const std::runtime_error& error) {
      summary_.harness_failure = error.what();
    }
    look();
    summary_.interrupted = interrupted_;
    summary_.findings = findings_.lines();
    name_strata();
    std::set<std::string> undecided;
    for (const auto& engine : engines_)
      for (const fs::path& file : files_in(engine->findings() / "undecided"))
        undecided.insert(file.filename());
    summary_.undecided = undecided.size();
    return std::move(summary_);
  }

 private:
  void fuzz() {
    const auto start = Clock::now();
    auto looked = start, exchanged = start;
    while (Clock::now() - start < options_.budget) {
      if (StopSignals::asked()) {
        interrupted_ = true;
        break;
      }
      std::this_thread::sleep_for(poll_time);
      for (const auto& engine : engines_)
        if (const auto found = engine->replace_dead()) findings_.add(*found);
      if (Clock::now() - exchanged >= options_.exchange_interval) {
        exchanged = Clock::now();
        exchange();
      }
      if (Clock::now() - looked < look_interval) continue;
      looked = Clock::now();
      summary_.progress.elapsed = duration_cast<milliseconds>(looked - start);
      look();
      if (on_progress_) on_progress_(summary_.progress);
    }
    summary_.progress.elapsed = duration_cast<milliseconds>(Clock::now() - start);
  }

  // The engine takes in what is new in its folder. Files are named by their content.
  void exchange() {
    for (const auto& from : engines_)
      for (const fs::path& file : files_in(from->corpus())) {
        if (!exchanged_.insert(file.filename()).second) continue;
        for (const auto& to : engines_) {
          std::error_code taken;  // by a worker that found the same: as well
          if (to != from) fs::copy_file(file, to->corpus() / file.filename(), taken);
        }
      }
  }

  void look() {
    FuzzProgress& progress = summary_.progress;
    progress.workers.clear();
    strata_ = {};
    for (const auto& engine : engines_) {
      engine->look();
      progress.workers.push_back(engine->progress());
      findings_.add_all(engine->findings());
      const Visited seen = read_visited(engine->findings() / "visited");
      for (std::size_t i = 0; i < strata_.size(); ++i) strata_[i] |= seen.strata[i];
    }
    progress.strata = 0;
    for (std::size_t i = 0; i < strata_.size(); ++i)
      progress.strata += strata_[i] != 0 && can_occur(stratum_at(i));
    progress.findings = findings_.lines().size();
  }

  void end_all() {
    for (const auto& engine : engines_) engine->ask_to_end();
    const auto asked = Clock::now();
    const auto one_runs = [&] {
      return std::any_of(engines_.begin(), engines_.end(),
                         [](const auto& engine) { return !engine->ended(); });
    };
    while (one_runs() && Clock::now() - asked < end_cap) std::this_thread::sleep_for(poll_time);
    for (const auto& engine : engines_) engine->kill_now();
  }

  // Into a folder of its own, which takes the corpus's place at once.
  void merge() {
    const fs::path kept = out_ / "corpus", unfinished = out_ / "corpus.unfinished";
    fs::remove_all(unfinished);
    fs::create_directories(unfinished);
    std::set<fs::path> inputs;
    std::vector<std::string> command{options_.program,
                                     "-merge=1",
                                     fmt::format("-max_len={}", record_size),
                                     "-timeout=25",
                                     fmt::format("-artifact_prefix={}/", out_.string()),
                                     unfinished};
    if (fs::exists(kept)) command.push_back(kept);
    for (const auto& engine : engines_) command.push_back(engine->corpus());
    for (auto folder = command.begin() + 6; folder != command.end(); ++folder)
      for (const fs::path& file : files_in(*folder)) inputs.insert(file.filename());
    const std::string log = out_ / "merge.log";
    fs::remove(log);
    const auto merging = run_engine(command, log, {});
    const auto start = Clock::now();
    while (!merging->advance()) {
      if (Clock::now() - start > merge_cap)
        throw std::runtime_error(
            fmt::format("merging took more than {} s. The corpora of the workers are in {}",
                        merge_cap.count(), out_.string()));
      std::this_thread::sleep_for(poll_time);
    }
    if (merging->status() != 0)
      throw std::runtime_error(
          fmt::format("merging ended with {}: {}", how_it_ended(merging->status()), reason_in(text_of(log))));
    fs::remove_all(kept);
    fs::rename(unfinished, kept);
    summary_.inputs = inputs.size();
    summary_.kept_inputs = files_in(kept).size();
  }

  void name_strata() {
    for (std::size_t i = 0; i < strata_.size(); ++i) {
      const Stratum s = stratum_at(i);
      summary_.possible_strata += can_occur(s);
      if (can_occur(s) && !strata_[i]) summary_.never_visited.push_back(to_string(s));
      if (!can_occur(s) && strata_[i]) summary_.impossible.push_back(to_string(s));
    }
  }

  const FuzzOptions& options_;
  const std::function<void(const FuzzProgress&)>& on_progress_;
  fs::path out_;
  Findings findings_;
  std::vector<std::unique_ptr<Engine>> engines_;
  std::set<fs::path> exchanged_;
  decltype(Visited::strata) strata_{};
  FuzzSummary summary_;
  bool interrupted_ = false;
};

/// "a, b and 3 more".
std::string first_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), named_cap); ++i) text += (i ? ", " : "") + names[i];
  if (names.size() > named_cap) text += fmt::format(" and {} more", names.size() - named_cap);
  return text;
}

}  // namespace

FuzzSummary run_fuzzing(const FuzzOptions& options,
                        const std::function<void(const FuzzProgress&)>& on_progress) {
  fs::create_directories(options.out);
  return Run(options, on_progress).run();
}

int exit_code(const FuzzSummary& summary) {
  if (!summary.harness_failure.empty()) return exit_harness_failed;
  return summary.findings.empty() ? exit_pass : exit_findings;
}

std::string format_fuzzing(const FuzzSummary& summary) {
  std::string text;
  const double wall = std::max(1e-3, static_cast<double>(summary.progress.elapsed.count()) / 1000);
  unsigned number = 0;
  for (const WorkerProgress& w : summary.progress.workers)
    text += fmt::format(
        "worker {}: {} executions, {:.0f}/s, {:.0f} a second of its CPU time; {} features, {} of them new; "
        "{} "
        "deaths\n",
        ++number, w.executions, static_cast<double>(w.executions) / wall,
        static_cast<double>(w.executions) / std::max(1e-3, w.cpu_seconds), w.features,
        w.features - w.first_features, w.deaths);
  text += fmt::format("strata: {} of {} that can occur ({:.1f} %)\n", summary.progress.strata,
                      summary.possible_strata,
                      100 * static_cast<double>(summary.progress.strata) /
                          std::max(1.0, static_cast<double>(summary.possible_strata)));
  if (!summary.never_visited.empty())
    text += fmt::format("never visited: {}\n", first_of(summary.never_visited));
  if (!summary.impossible.empty())
    text += fmt::format("visited, though they cannot occur: {}\n", first_of(summary.impossible));
  text += fmt::format("undecided: pairs of {} strata\n", summary.undecided);
  text += fmt::format("corpus: {} inputs, of {}\n", summary.kept_inputs, summary.inputs);
  text += fmt::format("findings: {} buckets\n", summary.findings.size());
  for (const std::string& line : summary.findings) text += line + '\n';
  return text;
}

}  // namespace cyl
