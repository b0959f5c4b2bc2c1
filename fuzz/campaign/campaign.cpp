// SPDX-License-Identifier: MIT
#include "fuzz/campaign/campaign.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <deque>
#include <stdexcept>
#include <utility>

#include "base/fnv.hpp"
#include "base/process/stop_signals.hpp"
#include "fuzz/campaign/batch_process.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::duration_cast;
using std::chrono::milliseconds;

/// How long to sleep where no batch has anything to say: progress stays lively, the processor free.
constexpr milliseconds poll_time{100};
/// Batches launched but not yet stored, per job: enough that one slow batch does not idle the rest.
constexpr std::size_t window_per_job = 8;

/// A changed corpus is no attack.
std::string fingerprint(std::span<const Case> cases) {
  std::uint64_t hash = fnv1a({});
  for (const Case& c : cases) hash = fnv1a(format_case(c) + '\n', hash);
  return fmt::format("{:016x}", hash);
}

std::vector<MethodRecord> record_methods(const Subjects& subjects) {
  std::vector<MethodRecord> all;
  for (const auto& method : subjects.methods) {
    const Claim claim = method->claim();
    all.push_back({std::string(method->name()), std::string(method->version()), claim.relative,
                   claim.absolute, std::string(claim.source), method->share()});
  }
  return all;
}

std::string format_shard(const Shard& shard) {
  if (shard.count == 1) return "";
  return fmt::format("{}/{} of batches of {}", shard.index, shard.count, shard.batch);
}

/// With the methods, what the findings are a function of. Two sessions of one run agree in all of it.
Config identity(const CampaignOptions& options, const Subjects& subjects) {
  std::string families;
  for (const Family& family : subjects.families) families.append(family.name).append("\n");
  return {{"seed", std::to_string(options.seed)},
          {"families", families},
          {"case_count", std::to_string(subjects.cases.size())},
          {"case_fingerprint", fingerprint(subjects.cases)},
          {"weights", format_weights(subjects.weights)},
          {"shard", format_shard({options.shard, options.shards, batch_size_for(subjects)})}};
}

void refuse(const CampaignOptions& options, const std::string& what) {
  throw std::runtime_error(fmt::format("{} cannot be resumed: {}", options.out, what));
}

/// The budget is that of all sessions: what those before `spent`, and that of this one.
Config limits(const CampaignOptions& options, milliseconds spent) {
  // What a resumed run has left of its budget may be less than nothing, but it had one: at least 1 ms.
  const milliseconds all = std::max(spent + options.budget, milliseconds(1));
  const milliseconds budget = options.budget.count() == 0 ? options.budget : all;
  return {{"pairs", std::to_string(options.pairs)},
          {"budget_milliseconds", std::to_string(budget.count())},
          {"stop_at", options.stop_at}};
}

RunStore open_run(const CampaignOptions& options, const Subjects& subjects) {
  Config config = identity(options, subjects);
  const std::vector<MethodRecord> methods = record_methods(subjects);
  if (!options.resume) {
    config["cases"] = options.cases;
    config["build"] = options.build;
    config["guests"] = options.guests;
    config["alarm"] = options.alarm.program.empty() ? "" : "on";
    config["status"] = status_planned;
    config["started"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    config.merge(limits(options, {}));
    return RunStore::create(options.out, config, methods);
  }
  RunStore store = RunStore::open(options.out);
  const Config stored = store.config();
  if (stored.contains("shards")) refuse(options, "it was merged from shards; resume those, and merge again");
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
  const milliseconds spent(store.progress().milliseconds);
  for (const auto& [key, value] : limits(options, spent)) store.set(key, value);
  store.set("guests", options.guests);
  return store;
}

void wait_for_news(const std::deque<BatchProcess>& flights) {
  std::vector<pollfd> descriptors;
  for (const BatchProcess& flight : flights) {
    if (!flight.ended()) descriptors.push_back({flight.descriptor(), POLLIN, 0});
  }
  poll(descriptors.data(), descriptors.size(), static_cast<int>(poll_time.count()));
}

/// Finds the pair that broke a batch, by running halves of it again.
class Search {
 public:
  Search(const Subjects& subjects, std::uint64_t seed, std::function<void()> report)
      : subjects_(subjects), seed_(seed), report_(std::move(report)) {}

  /// Which index of [first, next) breaks the harness when it is alone, in words. A pair that does so only
  /// after others, or only sometimes, is not found.
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
    const Place place = place_of(subjects_, turns_of(subjects_), first);
    return fmt::format("its index {} alone dies ({}): pair {} of {}", first, how, place.index,
                       family_name(subjects_, place.family));
  }

 private:
  /// How [first, next) died, or nothing.
  std::string death(std::uint64_t first, std::uint64_t next) {
    std::deque<BatchProcess> flight;
    flight.emplace_back(
        first, next, [&] { return run_batch(subjects_, seed_, first, next); }, search_cpu_cap);
    while (!flight.front().advance()) {
      if (StopSignals::asked()) return {};
      wait_for_news(flight);
      report_();
    }
    try {
      flight.front().take();
      return {};
    } catch (const std::exception& e) {
      return e.what();
    }
  }

  const Subjects& subjects_;
  const std::uint64_t seed_;
  const std::function<void()> report_;
};

}  // namespace

std::string value_of(const Config& config, const std::string& key) {
  const auto found = config.find(key);
  return found == config.end() ? "" : found->second;
}

Shard shard_of(const Config& config) {
  const std::string text = value_of(config, "shard");
  unsigned long long index = 0, count = 1, batch = 1;
  if (text.empty()) return {};
  if (std::sscanf(text.c_str(), "%llu/%llu of batches of %llu", &index, &count, &batch) != 3 ||
      index >= count || batch == 0) {
    throw std::runtime_error("'" + text + "' names no shard");
  }
  return {index, count, batch};
}

void count(CampaignProgress& progress, const std::vector<TallyRecord>& tallies) {
  for (const auto& [method, family, counts] : tallies) {
    progress.contract += counts.contract;
    progress.resolution += counts.resolution;
    progress.failed += counts.failed;
    if (method == referee_row) progress.unresolved += counts.undecided;
  }
}

CampaignSummary run_campaign(const CampaignOptions& options, const Subjects& subjects,
                             const std::function<void(const CampaignProgress&)>& on_progress) {
  if (options.pairs == 0 && options.budget.count() == 0) throw std::runtime_error("a campaign needs a limit");
  if (subjects.families.empty()) throw std::runtime_error("a campaign needs a family");
  if (options.shard >= options.shards) throw std::runtime_error("a campaign has no such shard");
  if (!subjects.weights.empty() && subjects.weights.size() != subjects.families.size())
    throw std::runtime_error("a campaign needs a weight for each family");
  RunStore store = open_run(options, subjects);
  if (options.create_only) return {};
  store.set("status", status_running);
  const StopSignals signals;
  const auto start = Clock::now();
  auto last_commit = start;

  CampaignSummary summary;
  CampaignProgress& progress = summary.progress;
  const Shard shard{options.shard, options.shards, batch_size_for(subjects)};
  std::uint64_t stored_to = store.progress().next;
  progress.done = shard.below(stored_to);
  progress.goal = shard.below(options.pairs);
  count(progress, store.tallies());
  const auto report = [&] {
    progress.session_time = duration_cast<milliseconds>(Clock::now() - start);
    if (on_progress) on_progress(progress);
  };

  Alarms alarms(options.alarm, subjects, options.seed, store, options.out);
  std::deque<BatchProcess> flights;  // in the order of their indices
  std::uint64_t next = shard.first_from(stored_to);
  const auto may_launch = [&] {
    const auto running =
        std::count_if(flights.begin(), flights.end(), [](const BatchProcess& f) { return !f.ended(); });
    return running < options.jobs && flights.size() < options.jobs * window_per_job &&
           !StopSignals::asked() && (options.pairs == 0 || next < options.pairs) &&
           (options.budget.count() == 0 || Clock::now() - start < options.budget);
  };

  while (true) {
    while (may_launch()) {
      const std::uint64_t first = next;
      std::uint64_t end = shard.batch_end(first);
      if (options.pairs != 0) end = std::min(end, options.pairs);
      flights.emplace_back(first, end, [&] { return run_batch(subjects, options.seed, first, end); });
      next = shard.first_from(end);
    }
    if (flights.empty()) break;
    wait_for_news(flights);
    for (BatchProcess& flight : flights) flight.advance();
    while (!flights.empty() && flights.front().ended()) {
      BatchRecord batch;
      try {
        batch = flights.front().take();
      } catch (const std::exception& e) {
        const std::uint64_t first = flights.front().first(), end = flights.front().next();
        flights.clear();
        const std::string blame = Search(subjects, options.seed, report).blame(first, end);
        summary.harness_failure = fmt::format(
            "the batch of indices {} to {} died: {}; {}. What came before it is stored; "
            "`daylight campaign --resume {}` meets it again as its first batch",
            first, end - 1, e.what(), blame, options.out);
        store.set("status", status_failed + summary.harness_failure);
        report();
        return summary;
      }
      const auto passed = duration_cast<milliseconds>(Clock::now() - last_commit);
      batch.first = stored_to;  // what lies between is other shards'
      store.commit(batch, static_cast<std::uint64_t>(passed.count()));
      last_commit += passed;
      stored_to = batch.next;
      const std::uint64_t done = shard.below(stored_to);
      progress.session_done += done - progress.done;
      progress.done = done;
      count(progress, batch.tallies);
      flights.pop_front();
      report();
    }
    if (StopSignals::asked()) break;  // the batches still under way are lost; --resume does them again
    alarms.advance(stored_to);
    report();
  }
  while (!StopSignals::asked() && !alarms.advance(stored_to)) {
    wait_for_news({});
    report();
  }
  const bool pairs_reached = options.pairs != 0 && next >= options.pairs && flights.empty();
  const bool budget_reached = options.budget.count() != 0 && Clock::now() - start >= options.budget;
  summary.interrupted = StopSignals::asked() && !pairs_reached && !(budget_reached && flights.empty());
  store.set("status", summary.interrupted ? status_stopped : status_complete);
  if (const std::string ringing = describe_rings(store.alarms()); !ringing.empty()) {
    summary.harness_failure = "the harness sleeps: " + ringing;
    store.set("status", status_failed + summary.harness_failure);
  }
  report();
  return summary;
}

int exit_code(const CampaignSummary& summary) {
  if (!summary.harness_failure.empty()) return 1;
  if (summary.progress.contract + summary.progress.failed > 0) return 2;
  return summary.progress.unresolved > 0 || summary.interrupted ? 3 : 0;
}

}  // namespace cyl
