// SPDX-License-Identifier: MIT
#include "fuzz/campaign/self_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "base/process/process.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/store/batch_bytes.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

/// No run reaches starts beyond this number.
constexpr unsigned starts_cap = 48;

/// A permutation that is a pure function of seed and faults.
std::vector<KnownFault> shuffled(std::vector<KnownFault> faults, std::uint64_t seed) {
  for (std::size_t i = 0; i < faults.size(); ++i)
    std::swap(faults[i], faults[i + RandomStream("alarm_fault", seed, i).below(faults.size() - i)]);
  return faults;
}

}  // namespace

std::uint64_t self_check_start(std::uint64_t seed, unsigned k) {
  const double octave = static_cast<double>(self_check_octave << k);
  return static_cast<std::uint64_t>(octave * (1 + RandomStream("alarm_moment", seed, k).unit()));
}

BatchRecord run_until_found(const Workload& workload, std::uint64_t seed, std::uint64_t first,
                            std::uint64_t cap) {
  BatchRecord record;
  record.first = first;
  record.next = first + cap;
  for (std::uint64_t at = first; at < record.next; at += self_check_octave) {
    BatchRecord batch = run_batch(workload, seed, at, std::min(record.next, at + self_check_octave));
    for (FindingRecord& f : batch.findings) {
      if (f.severity != Severity::contract) continue;
      record.findings.push_back(std::move(f));
      return record;
    }
  }
  return record;
}

SelfChecks::SelfChecks(const SelfCheckOptions& options, const Workload& workload, std::uint64_t seed,
                       RunStore& store)
    : options_(options),
      workload_(workload),
      seed_(seed),
      store_(store),
      order_(shuffled(options.faults, seed)),
      next_(static_cast<unsigned>(store.self_checks().size())) {}

bool SelfChecks::advance(std::uint64_t next) {
  if (options_.program.empty()) return true;
  if (process_ && !process_->advance()) {
    over_cap_ = process_->cpu_time() > self_check_cpu_cap;
    if (over_cap_) process_->kill_now();
    return false;
  }
  if (process_) store_what_ended();
  if (next_ >= std::min<std::size_t>(order_.size(), starts_cap)) return true;
  at_.start = workload_.cases.size() + self_check_start(seed_, next_);
  if (at_.start >= next) return true;
  launch();
  return false;
}

// A worker has drawn pairs alone. Its index i is i + the number of cases in a run with cases.
void SelfChecks::launch() {
  const KnownFault& fault = order_[next_];
  const std::uint64_t start = at_.start;
  at_ = {};
  at_.start = start;
  at_.mutant = fault.number;
  at_.what = fault.what;
  std::string families;
  for (const Family& family : workload_.families)
    families.append(families.empty() ? "" : ",").append(family.name);
  const std::uint64_t first = at_.start - workload_.cases.size();
  over_cap_ = false;
  process_.emplace(
      std::vector<std::string>{options_.program, "self-check", "--mutant", std::to_string(fault.number),
                               "--seed", std::to_string(seed_), "--first", std::to_string(first), "--pairs",
                               std::to_string(self_check_pairs_cap), "--methods", fault.asks, "--families",
                               families, "--weights", format_weights(workload_.weights)},
      ChildOptions{.failure = "a self-check failed", .own_group = true});
}

BatchRecord SelfChecks::take() const {
  if (over_cap_)
    throw std::runtime_error(fmt::format("no end after {} s of CPU time", self_check_cpu_cap.count()));
  if (process_->status() != 0) throw std::runtime_error(how_it_ended(process_->status()));
  return parse_batch(process_->bytes());
}

void SelfChecks::store_what_ended() {
  at_.milliseconds = static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(process_->cpu_time()).count());
  at_.pairs = self_check_pairs_cap;
  try {
    const BatchRecord batch = take();
    at_.found = !batch.findings.empty();
    if (at_.found) {
      const FindingRecord& f = batch.findings.front();
      at_.pairs = f.index - (at_.start - workload_.cases.size()) + 1;
      at_.said = fmt::format("{}: {} on {} {}", f.method, to_string(f.kind), f.family, f.family_index);
    }
  } catch (const std::exception& error) {
    at_.pairs = 0;
    at_.said = error.what();
  }
  store_.add(at_);
  process_.reset();
  ++next_;
}

}  // namespace cyl
