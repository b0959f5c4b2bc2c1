// SPDX-License-Identifier: MIT
#include "fuzz/campaign/campaign.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "base/exit_code.hpp"
#include "base/fnv.hpp"
#include "base/process/process.hpp"
#include "base/process/stop_signals.hpp"
#include "corpus/pairs/pair_digest.hpp"
#include "fuzz/campaign/job_process.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::duration_cast;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// Time to sleep if no batch reports anything. It is short for progress, and long enough to cost no CPU.
constexpr milliseconds poll_time{100};
/// Batches launched but not yet stored, per job: enough that one slow batch does not idle the rest.
constexpr std::size_t window_per_job = 8;

/// Detects a changed corpus. It need not withstand an attack.
std::string fingerprint(std::span<const Case> cases) {
  std::uint64_t hash = fnv1a({});
  for (const Case& c : cases) hash = fnv1a(format_case(c) + '\n', hash);
  return fmt::format("{:016x}", hash);
}

std::string fingerprint(std::span<const Pair> corpus) {
  std::uint64_t hash = fnv1a({});
  for (const Pair& pair : corpus) hash = digest_of(pair, hash);
  return fmt::format("{} {:016x}", corpus.size(), hash);
}

/// A fuzzer may still change the corpus of a run that has not asked anything. Each shard has its own.
constexpr const char* corpus_key = "corpus_fingerprint";

std::vector<MethodRecord> record_methods(const Workload& workload) {
  std::vector<MethodRecord> all;
  for (const auto& method : workload.methods) {
    const Claim claim = method->claim();
    all.push_back({std::string(method->name()), std::string(method->version()), claim.relative,
                   claim.absolute, std::string(claim.source), method->share(), std::string(method->library()),
                   claim.assumed});
  }
  return all;
}

/// Findings are a function of these values and the methods. The sessions of one run agree in them.
Config identity(const CampaignOptions& options, const Workload& workload) {
  std::string families;
  for (const Family& family : workload.families) families.append(family.name).append("\n");
  return {{"seed", std::to_string(options.seed)},
          {"families", families},
          {"case_count", std::to_string(workload.cases.size())},
          {"case_fingerprint", fingerprint(workload.cases)},
          {corpus_key, fingerprint(workload.corpus)},
          {"shard", format_shard({options.shard, options.shards, batch_size_for(workload)})}};
}

void refuse(const CampaignOptions& options, const std::string& what) {
  throw std::runtime_error(fmt::format("{} cannot be resumed: {}", options.out, what));
}

/// The budget is that of all sessions: what those before `spent`, and that of this one.
Config limits(const CampaignOptions& options, milliseconds spent) {
  // A resumed run may have less than nothing left, but it had a budget. So it gets at least 1 ms.
  const milliseconds all = std::max(spent + options.budget, milliseconds(1));
  const milliseconds budget = options.budget.count() == 0 ? options.budget : all;
  return {{"pairs", std::to_string(options.pairs)}, {"budget_milliseconds", std::to_string(budget.count())}};
}

RunStore open_run(const CampaignOptions& options, const Workload& workload) {
  Config config = identity(options, workload);
  const std::vector<MethodRecord> methods = record_methods(workload);
  if (!options.resume) {
    config["cases"] = options.cases;
    config["fuzz_milliseconds"] = std::to_string(options.fuzz.count());
    config["fuzz_targets"] = options.fuzz_targets;
    config["fuzzing"] = options.fuzzing;
    config["build"] = options.build;
    config["guests"] = options.guests;
    config["status"] = status_planned;
    config["started"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    config.merge(limits(options, {}));
    return RunStore::create(options.out, config, methods);
  }
  RunStore store = RunStore::open(options.out);
  if (store.progress().next == 0) store.set(corpus_key, config[corpus_key]);
  const Config stored = store.config();
  if (stored.contains("shards"))
    refuse(options, "it was merged from shards: resume the shards and merge them again");
  for (const auto& [key, value] : config) {
    const std::string before = value_of(stored, key);
    if (before != value) refuse(options, fmt::format("its {} was\n{}\nand is now\n{}", key, before, value));
  }
  const std::vector<MethodRecord> before = store.methods();
  if (before.size() != methods.size()) {
    refuse(options, fmt::format("it asked {} methods, now there are {}", before.size(), methods.size()));
  }
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (before[i] == methods[i]) continue;
    refuse(options, fmt::format("its method {} {} is now {} {}, or claims something else", before[i].name,
                                before[i].version, methods[i].name, methods[i].version));
  }
  check_progress(store);
  const milliseconds spent(store.progress().milliseconds);
  for (const auto& [key, value] : limits(options, spent)) store.set(key, value);
  store.set("guests", options.guests);
  return store;
}

/// CPU time of this process and of the children that have ended, with theirs.
nanoseconds cpu_time_so_far() {
  nanoseconds sum{0};
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    sum += cpu_time_of(used);
  }
  return sum;
}

/// Returns the time of the calls, which a store counts. The rest of a session's time is known only at its
/// end.
CampaignCost cost_of_calls(const std::vector<TallyRecord>& tallies) {
  CampaignCost cost;
  for (const TallyRecord& tally : tallies) {
    const nanoseconds time(tally.counts.nanoseconds);
    if (is_method_row(tally.method)) cost.asking += time;
    cost.hung += nanoseconds(tally.counts.hung_nanoseconds);
    if (tally.method == referee_row) cost.judging += time;
  }
  return cost;
}

void wait_for_news(std::span<const int> of) {
  std::vector<pollfd> descriptors;
  for (const int descriptor : of) descriptors.push_back({descriptor, POLLIN, 0});
  poll(descriptors.data(), descriptors.size(), static_cast<int>(poll_time.count()));
}

/// Finds the pair that broke a batch, by running halves of it again.
class Search {
 public:
  Search(const Workload& workload, std::uint64_t seed, std::function<void()> report)
      : workload_(workload), seed_(seed), report_(std::move(report)) {}

  /// Returns which index of [first, next) breaks the harness when it is alone, in words. A pair that does so
  /// only after others, or only sometimes, is not found.
  std::string blame(std::uint64_t first, std::uint64_t next) {
    while (next - first > 1) {
      const std::uint64_t middle = first + (next - first) / 2;
      const bool dies = !death(first, middle).empty();
      if (StopSignals::asked()) break;
      (dies ? next : first) = middle;
    }
    const std::string how = death(first, next);
    if (StopSignals::asked())
      return fmt::format("the search for the pair was stopped at {} to {}", first, next - 1);
    if (how.empty()) return "run again in parts it did not die, so no pair can be named";
    const FamilyIndex drawn = family_index_of(workload_, first);
    return fmt::format("its index {} alone dies ({}): pair {} of {}", first, how, drawn.index,
                       family_name(workload_, drawn.family));
  }

 private:
  /// Returns how [first, next) died, or nothing.
  std::string death(std::uint64_t first, std::uint64_t next) {
    JobProcess part([&] { return batch_maker(workload_, seed_); }, search_cpu_cap);
    part.begin(first, next);
    while (!part.advance()) {
      if (StopSignals::asked()) return {};
      const int descriptor = part.descriptor();
      wait_for_news({&descriptor, 1});
      report_();
    }
    try {
      part.take();
      return {};
    } catch (const std::exception& e) {
      return e.what();
    }
  }

  const Workload& workload_;
  const std::uint64_t seed_;
  const std::function<void()> report_;
};

/// The work on a run from the state of its store to a limit, a signal or a death.
class Session {
 public:
  Session(const CampaignOptions& options, const Workload& workload, RunStore& store,
          const std::function<void(const CampaignProgress&)>& on_progress)
      : options_(options),
        workload_(workload),
        store_(store),
        on_progress_(on_progress),
        shard_{options.shard, options.shards, batch_size_for(workload)},
        stored_to_(store.progress().next),
        next_(shard_.first_from(stored_to_)) {
    CampaignProgress& progress = summary_.progress;
    progress.done = shard_.below(stored_to_);
    progress.goal = shard_.below(options.pairs);
    count(progress, store.tallies());
  }

  CampaignSummary run() {
    store_.set("status", status_running);
    while (true) {
      while (may_launch()) launch();
      if (batches_.empty()) break;
      wait_for_jobs();
      while (!batches_.empty() && batches_.front().ended())
        if (!store_first()) return summary_;
      if (StopSignals::asked()) break;  // the batches still under way are lost; --resume does them again
      report();
    }
    settle();
    report();
    return summary_;
  }

 private:
  bool budget_is_spent() const {
    return options_.budget.count() != 0 && Clock::now() - start_ >= options_.budget;
  }

  /// A batch that was begun and is not stored yet.
  struct Batch {
    std::uint64_t first, next;
    JobProcess* job;  ///< while it is under way
    std::optional<BatchRecord> made = {};
    std::string death = {};  ///< how its process died
    bool ended() const { return !job; }
  };

  void wait_for_jobs() {
    std::vector<int> descriptors;
    for (const Batch& batch : batches_)
      if (batch.job) descriptors.push_back(batch.job->descriptor());
    wait_for_news(descriptors);
    for (Batch& batch : batches_) {
      if (!batch.job || !batch.job->advance()) continue;
      JobProcess* const job = std::exchange(batch.job, nullptr);
      try {
        batch.made = job->take();
      } catch (const std::exception& e) {
        batch.death = e.what();
        std::erase_if(jobs_, [&](const auto& each) { return each.get() == job; });
      }
    }
  }

  bool may_launch() const {
    const auto running =
        std::count_if(batches_.begin(), batches_.end(), [](const Batch& batch) { return !batch.ended(); });
    return running < options_.jobs && batches_.size() < options_.jobs * window_per_job &&
           !StopSignals::asked() && (options_.pairs == 0 || next_ < options_.pairs) && !budget_is_spent();
  }

  void launch() {
    const std::uint64_t first = next_;
    std::uint64_t end = shard_.batch_end(first);
    if (options_.pairs != 0) end = std::min(end, options_.pairs);
    auto job = std::find_if(jobs_.begin(), jobs_.end(), [](const auto& each) { return !each->busy(); });
    if (job == jobs_.end()) {
      jobs_.push_back(std::make_unique<JobProcess>([&] { return batch_maker(workload_, options_.seed); }));
      job = jobs_.end() - 1;
    }
    (*job)->begin(first, end);
    batches_.push_back({first, end, job->get()});
    next_ = shard_.first_from(end);
  }

  /// Stores what the first of the batches gave, and returns whether it lived to give it.
  bool store_first() {
    if (!batches_.front().made) {
      name_death(batches_.front().death);
      return false;
    }
    BatchRecord batch = std::move(*batches_.front().made);
    batches_.pop_front();
    const auto passed = duration_cast<milliseconds>(Clock::now() - last_commit_);
    batch.first = stored_to_;  // what lies between is other shards'
    store_.commit(batch, static_cast<std::uint64_t>(passed.count()));
    last_commit_ += passed;
    stored_to_ = batch.next;
    CampaignProgress& progress = summary_.progress;
    const std::uint64_t done = shard_.below(stored_to_);
    progress.session_done += done - progress.done;
    progress.done = done;
    count(progress, batch.tallies);
    report();
    return true;
  }

  void name_death(const std::string& how) {
    const std::uint64_t first = batches_.front().first, end = batches_.front().next;
    batches_.clear();
    jobs_.clear();
    const std::string blame = Search(workload_, options_.seed, [this] { report(); }).blame(first, end);
    fail(
        fmt::format("the batch of indices {} to {} died: {}; {}. Earlier batches are stored; "
                    "`daylight campaign --resume {}` meets it again as its first batch",
                    first, end - 1, how, blame, options_.out));
    report();
  }

  void settle() {
    const bool pairs_reached = options_.pairs != 0 && next_ >= options_.pairs && batches_.empty();
    summary_.interrupted = StopSignals::asked() && !pairs_reached && !(budget_is_spent() && batches_.empty());
    store_.set("status", summary_.interrupted ? status_stopped : status_complete);
  }

  void fail(const std::string& how) {
    summary_.harness_failure = how;
    store_.set("status", status_failed + how);
  }

  void report() {
    summary_.progress.session_time = duration_cast<milliseconds>(Clock::now() - start_);
    if (on_progress_) on_progress_(summary_.progress);
  }

  const StopSignals signals_;
  const CampaignOptions& options_;
  const Workload& workload_;
  RunStore& store_;
  const std::function<void(const CampaignProgress&)>& on_progress_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point last_commit_ = start_;
  const Shard shard_;
  CampaignSummary summary_;
  std::uint64_t stored_to_, next_;  ///< all below is stored; the next index to launch
  std::vector<std::unique_ptr<JobProcess>> jobs_;
  std::deque<Batch> batches_;  ///< in the order of their indices
};

}  // namespace

void count(CampaignProgress& progress, const std::vector<TallyRecord>& tallies) {
  for (const auto& [method, family, counts] : tallies) {
    progress.contract += counts.contract;
    progress.resolution += counts.resolution;
    progress.failed += counts.failed;
    if (method == referee_row) progress.unresolved += counts.undecided;
  }
}

CampaignSummary run_campaign(const CampaignOptions& options, const Workload& workload,
                             const std::function<void(const CampaignProgress&)>& on_progress) {
  const bool idle = options.create_only;  // what it lacks may come before it asks anything
  if (!idle && options.pairs == 0 && options.budget.count() == 0)
    throw std::runtime_error("a campaign needs a limit");
  if (!idle && workload.families.empty() && workload.corpus.empty())
    throw std::runtime_error("a campaign needs a family");
  if (options.shard >= options.shards) throw std::runtime_error("a campaign has no such shard");
  RunStore store = open_run(options, workload);
  if (options.create_only) return {};
  const nanoseconds start = cpu_time_so_far();
  const CampaignCost before = cost_of_calls(store.tallies());
  CampaignSummary summary = Session(options, workload, store, on_progress).run();
  summary.fuzz_failed = store.config().contains(fuzz_failed_key);
  const CampaignCost after = cost_of_calls(store.tallies());
  summary.cost = {cpu_time_so_far() - start, after.asking - before.asking, after.judging - before.judging,
                  after.hung - before.hung};
  return summary;
}

int exit_code(const CampaignSummary& summary) {
  if (!summary.harness_failure.empty()) return exit_harness_failed;
  if (summary.progress.contract + summary.progress.failed > 0 || summary.fuzz_failed) return exit_findings;
  return summary.progress.unresolved > 0 || summary.interrupted ? exit_undecided : exit_pass;
}

}  // namespace cyl
