// SPDX-License-Identifier: MIT
#include "fuzz/campaign/self_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Faults that the kill matrix found only from this pair of a family on are not planted: by bad luck they
/// could take more than alarm_pairs_cap.
constexpr unsigned long long rare_from = 50;

/// Of what the kill matrix says of a finding, "method: kind on family 12; {pair}".
bool found_soon(const std::string& what) {
  unsigned long long index = 0;
  return std::sscanf(what.c_str(), "%*[^:]: %*s on %*s %llu;", &index) == 1 && index < rare_from;
}

/// Moments beyond it lie where no run comes.
constexpr unsigned moments_cap = 48;

bool asks_only(const KnownFault& fault, const std::vector<std::string>& all,
               const std::vector<std::string>& here) {
  const auto is_here = [&](std::size_t i) {
    return std::find(here.begin(), here.end(), all[i]) != here.end();
  };
  const std::vector<std::size_t> asked = select_names(all, fault.asks);
  return std::all_of(asked.begin(), asked.end(), is_here);
}

std::vector<std::string> names_of(std::span<const std::unique_ptr<Method>> methods) {
  std::vector<std::string> names;
  for (const auto& method : methods) names.emplace_back(method->name());
  return names;
}

/// A permutation that is a pure function of seed and faults.
std::vector<KnownFault> shuffled(std::vector<KnownFault> faults, std::uint64_t seed) {
  for (std::size_t i = 0; i < faults.size(); ++i)
    std::swap(faults[i], faults[i + RandomStream("alarm_fault", seed, i).below(faults.size() - i)]);
  return faults;
}

/// Of a fault, in the runs beside this one that drew from the same pairs.
PastAlarms past_of(const KnownFault& fault, const std::string& run_folder) {
  const fs::path run = fs::canonical(run_folder);
  const Config here = RunStore::open(run.string()).config();
  PastAlarms past;
  if (shard_of(here).count > 1) return past;  // beside it are the other shards
  for (const std::string& folder : runs_in(run.parent_path().string())) {
    if (folder == run.string()) continue;
    try {
      const RunStore store = RunStore::open(folder);
      const Config config = store.config();
      const auto same = [&](const char* key) { return value_of(config, key) == value_of(here, key); };
      if (!same("families") || !same("weights") || shard_of(config).count > 1) continue;
      if (value_of(config, "started") > value_of(here, "started")) continue;
      for (const AlarmRecord& alarm : store.alarms()) {
        if (alarm.mutant != fault.number || !alarm.found) continue;
        ++past.found;
        past.most = std::max(past.most, alarm.pairs);
      }
    } catch (const std::exception&) {  // what cannot be read is passed over, and told by the history
    }
  }
  return past;
}

std::uint64_t round_of(const Subjects& subjects) {
  std::uint64_t round = 0;
  for (const unsigned weight : subjects.weights) round += weight;
  return round == 0 ? subjects.families.size() : round;
}

}  // namespace

std::vector<KnownFault> known_faults(const std::string& kill_matrix,
                                     std::span<const std::unique_ptr<Method>> methods) {
  const std::vector<std::string> all = names_of(all_methods()), here = names_of(methods);
  std::vector<KnownFault> faults;
  std::ifstream in(kill_matrix);
  std::string line;
  try {
    while (std::getline(in, line)) {
      const nlohmann::json row = parse_json(line);
      if (!row.contains("fuzz") || !row.contains("asks")) continue;
      const nlohmann::json& fuzz = row.at("fuzz");
      // One that crashes or hangs says no number of pairs; an undecided truth is no method's fault.
      const std::string what = fuzz.at("what");
      if (fuzz.at("fate") != "killed" || what.starts_with(referee_row) || !found_soon(what)) continue;
      KnownFault fault{row.at("mutant"), row.at("what"), row.at("asks")};
      if (asks_only(fault, all, here)) faults.push_back(std::move(fault));
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(kill_matrix + " is no kill matrix: " + error.what());
  }
  if (!in.eof()) throw std::runtime_error(kill_matrix + " cannot be read");
  return faults;
}

std::uint64_t alarm_moment(std::uint64_t seed, unsigned k) {
  const double octave = static_cast<double>(batch_size << k);
  return static_cast<std::uint64_t>(octave * (1 + RandomStream("alarm_moment", seed, k).unit()));
}

// Each pair is drawn anew, so the number of pairs until a fault is found is a waiting time without memory: it
// exceeds x with chance q^x. The greatest of n such, E, is exceeded f times over by the next with chance
// E(q^(f E)), which for exponential times is the product of i / (i + f) over i = 1 .. n, whatever q is;
// rounding times up to whole pairs makes it less.
std::uint64_t usual_pairs(const PastAlarms& past, std::uint64_t round) {
  if (past.found == 0) return alarm_pairs_cap;
  for (std::uint64_t factor = 1;; ++factor) {
    const std::uint64_t pairs = factor * std::max(past.most, round);
    if (pairs >= alarm_pairs_cap) return alarm_pairs_cap;
    double chance = 1;
    for (std::uint64_t i = 1; i <= past.found && chance > false_alarm_cap; ++i)
      chance *= static_cast<double>(i) / static_cast<double>(i + factor);
    if (chance <= false_alarm_cap) return pairs;
  }
}

BatchRecord run_until_found(const Subjects& subjects, std::uint64_t seed, std::uint64_t first,
                            std::uint64_t cap) {
  BatchRecord record;
  record.first = first;
  record.next = first + cap;
  for (std::uint64_t at = first; at < record.next; at += batch_size) {
    BatchRecord batch = run_batch(subjects, seed, at, std::min(record.next, at + batch_size));
    for (FindingRecord& f : batch.findings) {
      if (f.severity != to_string(Severity::contract)) continue;
      record.findings.push_back(std::move(f));
      return record;
    }
  }
  return record;
}

Alarms::Alarms(const AlarmOptions& options, const Subjects& subjects, std::uint64_t seed, RunStore& store,
               const std::string& run_folder)
    : options_(options),
      subjects_(subjects),
      seed_(seed),
      store_(store),
      run_folder_(run_folder),
      order_(shuffled(options.faults, seed)),
      next_(static_cast<unsigned>(store.alarms().size())) {}

bool Alarms::advance(std::uint64_t next) {
  if (options_.program.empty()) return true;
  if (flight_ && !flight_->advance()) return false;
  if (flight_) store_what_ended();
  if (next_ >= std::min<std::size_t>(order_.size(), moments_cap)) return true;
  at_.start = subjects_.cases.size() + alarm_moment(seed_, next_);
  if (at_.start >= next) return true;
  launch();
  return false;
}

// A worker is told of drawn pairs alone: without the cases index i is what i + their number is with them.
void Alarms::launch() {
  const KnownFault& fault = order_[next_];
  const std::uint64_t start = at_.start;
  at_ = {};
  at_.start = start;
  at_.mutant = fault.number;
  at_.what = fault.what;
  at_.usual = usual_pairs(past_of(fault, run_folder_), round_of(subjects_));
  std::string families;
  for (const Family& family : subjects_.families)
    families.append(families.empty() ? "" : ",").append(family.name);
  const std::uint64_t first = at_.start - subjects_.cases.size();
  flight_.emplace(
      first, first + alarm_pairs_cap,
      std::vector<std::string>{options_.program, "alarm", "--mutant", std::to_string(fault.number), "--seed",
                               std::to_string(seed_), "--first", std::to_string(first), "--pairs",
                               std::to_string(alarm_pairs_cap), "--methods", fault.asks, "--families",
                               families, "--weights", format_weights(subjects_.weights)},
      alarm_cpu_cap);
}

void Alarms::store_what_ended() {
  at_.milliseconds = static_cast<std::uint64_t>(flight_->cpu_time().count());
  at_.pairs = alarm_pairs_cap;
  try {
    const BatchRecord batch = flight_->take();
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
  flight_.reset();
  ++next_;
}

bool rings(const AlarmRecord& alarm) { return !alarm.found || alarm.pairs > alarm.usual; }

std::string describe_rings(std::span<const AlarmRecord> alarms) {
  std::string text;
  for (const AlarmRecord& a : alarms) {
    if (!rings(a)) continue;
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

std::string format_alarms(std::span<const AlarmRecord> alarms) {
  if (alarms.empty()) return {};
  if (const std::string ringing = describe_rings(alarms); !ringing.empty()) return "ALARM: " + ringing;
  std::uint64_t most = 0, milliseconds = 0;
  for (const AlarmRecord& a : alarms) {
    most = std::max(most, a.pairs);
    milliseconds += a.milliseconds;
  }
  return fmt::format(
      "alarm: {} planted fault{} found, each within its usual time, after {} pairs at most; {:.1f} s",
      alarms.size(), alarms.size() == 1 ? "" : "s", most, static_cast<double>(milliseconds) / 1000);
}

}  // namespace cyl
