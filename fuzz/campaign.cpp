// SPDX-License-Identifier: MIT
#include "fuzz/campaign.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <csignal>
#include <ctime>
#include <deque>
#include <stdexcept>

#include "corpus/fnv.hpp"
#include "fuzz/flight.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::duration_cast;
using std::chrono::milliseconds;

/// How long to sleep where no batch has anything to say: progress stays lively, the processor free.
constexpr milliseconds poll_time{100};
/// Batches launched but not yet stored, per job: enough that one slow batch does not idle the rest.
constexpr std::size_t window_per_job = 8;

volatile std::sig_atomic_t stop_asked = 0;
void ask_stop(int) { stop_asked = 1; }

/// Turns SIGINT and SIGTERM into stop_asked while it lives.
class StopSignals {
 public:
  StopSignals() {
    stop_asked = 0;
    struct sigaction action {};
    action.sa_handler = ask_stop;
    sigaction(SIGINT, &action, &interrupt_before_);
    sigaction(SIGTERM, &action, &terminate_before_);
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals() {
    sigaction(SIGINT, &interrupt_before_, nullptr);
    sigaction(SIGTERM, &terminate_before_, nullptr);
  }

 private:
  struct sigaction interrupt_before_ {
  }, terminate_before_{};
};

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

/// With the methods, what the findings are a function of. Two sessions of one run agree in all of it.
Config identity(const CampaignOptions& options, const Subjects& subjects) {
  std::string families;
  for (const Family& family : subjects.families) families.append(family.name).append("\n");
  return {{"seed", std::to_string(options.seed)},
          {"families", families},
          {"case_count", std::to_string(subjects.cases.size())},
          {"case_fingerprint", fingerprint(subjects.cases)}};
}

void refuse(const CampaignOptions& options, const std::string& what) {
  throw std::runtime_error(fmt::format("{} cannot be resumed: {}", options.out, what));
}

RunStore open_run(const CampaignOptions& options, const Subjects& subjects) {
  Config config = identity(options, subjects);
  const std::vector<MethodRecord> methods = record_methods(subjects);
  if (!options.resume) {
    config["cases"] = options.cases;
    config["build"] = options.build;
    config["pairs"] = std::to_string(options.pairs);
    config["budget_milliseconds"] = std::to_string(options.budget.count());
    config["started"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    return RunStore::create(options.out, config, methods);
  }
  RunStore store = RunStore::open(options.out);
  const Config stored = store.config();
  for (const auto& [key, value] : config) {
    const auto found = stored.find(key);
    const std::string before = found == stored.end() ? "nothing" : found->second;
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
  return store;
}

void count(CampaignProgress& progress, const std::vector<TallyRecord>& tallies) {
  for (const auto& [method, family, counts] : tallies) {
    progress.contract += counts.contract;
    progress.resolution += counts.resolution;
    progress.failed += counts.failed;
    if (method == referee_row) progress.unresolved += counts.undecided;
  }
}

void wait_for_news(const std::deque<Flight>& flights) {
  std::vector<pollfd> descriptors;
  for (const Flight& flight : flights) {
    if (!flight.ended()) descriptors.push_back({flight.descriptor(), POLLIN, 0});
  }
  poll(descriptors.data(), descriptors.size(), static_cast<int>(poll_time.count()));
}

}  // namespace

CampaignSummary run_campaign(const CampaignOptions& options, const Subjects& subjects,
                             const std::function<void(const CampaignProgress&)>& on_progress) {
  if (options.pairs == 0 && options.budget.count() == 0) throw std::runtime_error("a campaign needs a limit");
  if (subjects.families.empty()) throw std::runtime_error("a campaign needs a family");
  RunStore store = open_run(options, subjects);
  const StopSignals signals;
  const auto start = Clock::now();
  auto last_commit = start;

  CampaignSummary summary;
  CampaignProgress& progress = summary.progress;
  progress.done = store.progress().next;
  count(progress, store.tallies());
  const auto report = [&] {
    progress.session_time = duration_cast<milliseconds>(Clock::now() - start);
    if (on_progress) on_progress(progress);
  };

  const std::uint64_t size = batch_size_for(subjects);
  std::deque<Flight> flights;  // in the order of their indices
  std::uint64_t next = progress.done;
  const auto may_launch = [&] {
    const auto running =
        std::count_if(flights.begin(), flights.end(), [](const Flight& f) { return !f.ended(); });
    return running < options.jobs && flights.size() < options.jobs * window_per_job && !stop_asked &&
           (options.pairs == 0 || next < options.pairs) &&
           (options.budget.count() == 0 || Clock::now() - start < options.budget);
  };

  while (true) {
    while (may_launch()) {
      const std::uint64_t first = next;
      next = first + size;
      if (options.pairs != 0) next = std::min(next, options.pairs);
      flights.emplace_back(first, next, [&] { return run_batch(subjects, options.seed, first, next); });
    }
    if (flights.empty()) break;
    wait_for_news(flights);
    for (Flight& flight : flights) flight.advance();
    while (!flights.empty() && flights.front().ended()) {
      BatchRecord batch;
      try {
        batch = flights.front().take();
      } catch (const std::exception& e) {
        summary.harness_failure = fmt::format(
            "the batch of indices {} to {} died: {}. What came before it is stored; "
            "`daylight campaign --resume {}` meets it again as its first batch",
            flights.front().first(), flights.front().next() - 1, e.what(), options.out);
        report();
        return summary;
      }
      const auto passed = duration_cast<milliseconds>(Clock::now() - last_commit);
      store.commit(batch, static_cast<std::uint64_t>(passed.count()));
      last_commit += passed;
      progress.done = batch.next;
      progress.session_done += batch.next - batch.first;
      count(progress, batch.tallies);
      flights.pop_front();
      report();
    }
    if (stop_asked) break;  // the batches still under way are lost; --resume does them again
    report();
  }
  const bool pairs_reached = options.pairs != 0 && progress.done >= options.pairs;
  const bool budget_reached = options.budget.count() != 0 && Clock::now() - start >= options.budget;
  summary.interrupted = stop_asked && !pairs_reached && !(budget_reached && flights.empty());
  report();
  return summary;
}

int exit_code(const CampaignSummary& summary) {
  if (!summary.harness_failure.empty()) return 1;
  if (summary.progress.contract + summary.progress.failed > 0) return 2;
  return summary.progress.unresolved > 0 || summary.interrupted ? 3 : 0;
}

}  // namespace cyl
