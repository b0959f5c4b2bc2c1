// SPDX-License-Identifier: MIT
#include "fuzz/campaign/self_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

#include "corpus/pairs/random_stream.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Those beyond it lie where no run comes.
constexpr unsigned starts_cap = 48;

/// A permutation that is a pure function of seed and faults.
std::vector<KnownFault> shuffled(std::vector<KnownFault> faults, std::uint64_t seed) {
  for (std::size_t i = 0; i < faults.size(); ++i)
    std::swap(faults[i], faults[i + RandomStream("alarm_fault", seed, i).below(faults.size() - i)]);
  return faults;
}

/// Returns what happened to a fault in the runs beside this one that drew from the same pairs.
PastSelfChecks past_of(const KnownFault& fault, const std::string& run_folder) {
  const fs::path run = fs::canonical(run_folder);
  const Config here = RunStore::open(run.string()).config();
  PastSelfChecks past;
  if (shard_of(here).count > 1) return past;  // beside it are the other shards
  for (const std::string& folder : runs_in(run.parent_path().string())) {
    if (folder == run.string()) continue;
    try {
      const RunStore store = RunStore::open(folder);
      const Config config = store.config();
      const auto same = [&](const char* key) { return value_of(config, key) == value_of(here, key); };
      if (!same("families") || !same("weights") || shard_of(config).count > 1) continue;
      if (value_of(config, "started") > value_of(here, "started")) continue;
      for (const SelfCheckRecord& check : store.self_checks()) {
        if (check.mutant != fault.number || !check.found) continue;
        ++past.found;
        past.most = std::max(past.most, check.pairs);
      }
    } catch (const std::exception&) {  // what cannot be read is passed over, and told by the history
    }
  }
  return past;
}

std::uint64_t round_of(const Workload& workload) {
  std::uint64_t round = 0;
  for (const unsigned weight : workload.weights) round += weight;
  return round == 0 ? workload.families.size() : round;
}

}  // namespace

std::uint64_t self_check_start(std::uint64_t seed, unsigned k) {
  const double octave = static_cast<double>(batch_size << k);
  return static_cast<std::uint64_t>(octave * (1 + RandomStream("alarm_moment", seed, k).unit()));
}

// Each pair is drawn anew, so the number of pairs until a fault is found is a waiting time without memory: it
// exceeds x with chance q^x. The greatest of n such, E, is exceeded f times over by the next with chance
// E(q^(f E)), which for exponential times is the product of i / (i + f) over i = 1 .. n, whatever q is;
// rounding times up to whole pairs makes it less.
std::uint64_t usual_pairs(const PastSelfChecks& past, std::uint64_t round) {
  if (past.found == 0) return self_check_pairs_cap;
  for (std::uint64_t factor = 1;; ++factor) {
    const std::uint64_t pairs = factor * std::max(past.most, round);
    if (pairs >= self_check_pairs_cap) return self_check_pairs_cap;
    double chance = 1;
    for (std::uint64_t i = 1; i <= past.found && chance > false_alarm_cap; ++i)
      chance *= static_cast<double>(i) / static_cast<double>(i + factor);
    if (chance <= false_alarm_cap) return pairs;
  }
}

BatchRecord run_until_found(const Workload& workload, std::uint64_t seed, std::uint64_t first,
                            std::uint64_t cap) {
  BatchRecord record;
  record.first = first;
  record.next = first + cap;
  for (std::uint64_t at = first; at < record.next; at += batch_size) {
    BatchRecord batch = run_batch(workload, seed, at, std::min(record.next, at + batch_size));
    for (FindingRecord& f : batch.findings) {
      if (f.severity != to_string(Severity::contract)) continue;
      record.findings.push_back(std::move(f));
      return record;
    }
  }
  return record;
}

SelfChecks::SelfChecks(const SelfCheckOptions& options, const Workload& workload, std::uint64_t seed,
                       RunStore& store, const std::string& run_folder)
    : options_(options),
      workload_(workload),
      seed_(seed),
      store_(store),
      run_folder_(run_folder),
      order_(shuffled(options.faults, seed)),
      next_(static_cast<unsigned>(store.self_checks().size())) {}

bool SelfChecks::advance(std::uint64_t next) {
  if (options_.program.empty()) return true;
  if (process_ && !process_->advance()) return false;
  if (process_) store_what_ended();
  if (next_ >= std::min<std::size_t>(order_.size(), starts_cap)) return true;
  at_.start = workload_.cases.size() + self_check_start(seed_, next_);
  if (at_.start >= next) return true;
  launch();
  return false;
}

// A worker is told of drawn pairs alone: without the cases index i is what i + their number is with them.
void SelfChecks::launch() {
  const KnownFault& fault = order_[next_];
  const std::uint64_t start = at_.start;
  at_ = {};
  at_.start = start;
  at_.mutant = fault.number;
  at_.what = fault.what;
  at_.usual = usual_pairs(past_of(fault, run_folder_), round_of(workload_));
  std::string families;
  for (const Family& family : workload_.families)
    families.append(families.empty() ? "" : ",").append(family.name);
  const std::uint64_t first = at_.start - workload_.cases.size();
  process_.emplace(
      first, first + self_check_pairs_cap,
      std::vector<std::string>{options_.program, "alarm", "--mutant", std::to_string(fault.number), "--seed",
                               std::to_string(seed_), "--first", std::to_string(first), "--pairs",
                               std::to_string(self_check_pairs_cap), "--methods", fault.asks, "--families",
                               families, "--weights", format_weights(workload_.weights)},
      self_check_cpu_cap);
}

void SelfChecks::store_what_ended() {
  at_.milliseconds = static_cast<std::uint64_t>(process_->cpu_time().count());
  at_.pairs = self_check_pairs_cap;
  try {
    const BatchRecord batch = process_->take();
    at_.found = !batch.findings.empty();
    if (at_.found) {
      const FindingRecord& f = batch.findings.front();
      at_.pairs = f.index - batch.first + 1;
      at_.said = fmt::format("{}: {} on {} {}", f.method, f.kind, f.family, f.family_index);
    }
  } catch (const std::exception& error) {
    at_.pairs = 0;
    at_.said = error.what();
  }
  store_.add(at_);
  process_.reset();
  ++next_;
}

bool fails(const SelfCheckRecord& check) { return !check.found || check.pairs > check.usual; }

std::string describe_failed_checks(std::span<const SelfCheckRecord> checks) {
  std::string text;
  for (const SelfCheckRecord& a : checks) {
    if (!fails(a)) continue;
    if (!text.empty()) text += "; ";
    text += fmt::format("planted fault {} ({}), from index {} on, was ", a.mutant, a.what, a.start);
    if (a.found) {
      text += fmt::format("found after {} pairs only", a.pairs);
    } else {
      text += a.said.empty() ? fmt::format("not found in {} pairs", a.pairs)
                             : fmt::format("not found, its process ended: {}", a.said);
    }
    text += fmt::format("; usual are {} at most", a.usual);
  }
  return text;
}

std::string format_self_checks(std::span<const SelfCheckRecord> checks) {
  if (checks.empty()) return {};
  if (const std::string failed = describe_failed_checks(checks); !failed.empty()) return "ALARM: " + failed;
  std::uint64_t most = 0, milliseconds = 0;
  for (const SelfCheckRecord& a : checks) {
    most = std::max(most, a.pairs);
    milliseconds += a.milliseconds;
  }
  return fmt::format(
      "alarm: {} planted fault{} found, each within its usual time, after {} pairs at most; {:.1f} s",
      checks.size(), checks.size() == 1 ? "" : "s", most, static_cast<double>(milliseconds) / 1000);
}

}  // namespace cyl
