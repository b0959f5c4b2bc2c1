// SPDX-License-Identifier: MIT
#include "props/mutants/kill_matrix.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <exception>
#include <memory>

#include "base/json.hpp"
#include "base/process/child.hpp"
#include "base/process/process.hpp"
#include "corpus/pairs/families.hpp"
#include "oracles/trial/trial.hpp"
#include "props/laws/examine.hpp"

namespace cyl {
namespace {

/// Bytes of a message that are kept.
constexpr std::size_t message_cap = 4096;

/// Pairs of each family for the laws, and for the differential detector. They are so many that luck plays no
/// part with faults that are seen at all.
constexpr std::uint64_t law_pairs = 100, differential_pairs = 400;
constexpr std::uint64_t detector_seed = 20261121;

/// Pairs examined at once. They are few, so that a kill ends the work early, and many, so that forks cost
/// little.
constexpr std::size_t chunk_size = 256;

constexpr int first_law_of_truth = 30;
bool any(std::size_t, const Law&) { return true; }
bool of_truth(std::size_t, const Law& law) { return law.number >= first_law_of_truth; }

std::string violation_on(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                         const LawFilter& wanted) {
  for (std::size_t at = 0; at < pairs.size(); at += chunk_size) {
    const auto chunk = pairs.subspan(at, std::min(chunk_size, pairs.size() - at));
    for (const LawViolation& b : examine(methods, chunk, wanted).violations)
      if (b.violation.severity == Severity::contract)
        return fmt::format("{} breaks law {}, {}: {}; {}", methods[b.method]->name(), b.law->number,
                           b.law->name, b.violation.what, format_pair(chunk[b.pair]));
  }
  return {};
}

void draw(std::vector<Pair>& pairs, std::span<const Family> from, std::uint64_t count, std::uint64_t seed) {
  for (std::uint64_t i = 0; i < count; ++i)
    for (const Family& family : from) pairs.push_back(family.generate(seed, i));
}

std::vector<Pair> pairs_of(std::span<const Case> cases) {
  std::vector<Pair> pairs;
  for (const Case& c : cases) pairs.push_back(c.pair);
  return pairs;
}

auto methods_of(const Mutant& mutant) { return select_methods(all_methods(), mutant.asks); }

// Compares the statement of a case with the proof, as an answer of a method that is always right. If the
// case states a verdict, the verdict has been proved once.
std::string contradiction(std::span<const Case> cases) {
  for (const Case& c : cases) {
    if (!c.truth) continue;
    Trial trial(c.pair);
    const Verdict truth = trial.truth.verdict;
    MethodAnswer stated;
    stated.status = Status::answered;
    stated.verdict = *c.truth;
    if (truth == Verdict::undecided ? *c.truth != Verdict::undecided
                                    : compare(trial, Claim{}, stated).has_value())
      return fmt::format("{} is stated to be {}, judged {}", c.id, to_string(*c.truth), to_string(truth));
  }
  return {};
}

/// Returns the evidence as CBOR, or no bytes if there is none.
std::string run_detector(const Mutant& mutant, const Detector& detector, void (*select)(int) noexcept) {
  limit(RLIMIT_CORE, 0);
  const rlimit cpu{detector_cpu_cap, detector_cpu_cap + 1};
  setrlimit(RLIMIT_CPU, &cpu);
  alarm(detector_wall_cap);
  redirect_streams("/dev/null", "/dev/null");
  select(mutant.number);
  Evidence evidence;
  try {
    evidence = detector.detect(mutant);
  } catch (const std::exception& error) {
    evidence.failure_message = fmt::format("the harness fails: {}", error.what());
  }
  if (evidence.failure_message.empty()) return {};
  nlohmann::json bytes = nlohmann::json::array({evidence.failure_message.substr(0, message_cap)});
  if (evidence.family_index) bytes.push_back(*evidence.family_index);
  return format_cbor(bytes);
}

Detection::Outcome outcome_of(const Child& child) {
  using enum Detection::Outcome;
  if (!WIFSIGNALED(child.status())) return child.status() == 0 && child.bytes().empty() ? survived : killed;
  const int signal = WTERMSIG(child.status());
  return signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL ? hung : crashed;
}

}  // namespace

bool KillRow::killed() const {
  return std::any_of(detections.begin(), detections.end(),
                     [](const Detection& d) { return d.outcome > Detection::Outcome::survived; });
}

KillRow run_detectors(const Mutant& mutant, std::span<const Detector> detectors,
                      void (*select)(int) noexcept) {
  KillRow row{mutant, {}};
  for (const Detector& detector : detectors) {
    const auto start = std::chrono::steady_clock::now();
    Child child([&] { return run_detector(mutant, detector, select); });
    child.wait();
    Detection d;
    d.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    d.outcome = outcome_of(child);
    if (!child.bytes().empty()) {
      const nlohmann::json evidence = parse_cbor(child.bytes());
      d.evidence.failure_message = evidence.at(0);
      if (evidence.size() > 1) d.evidence.family_index = evidence.at(1);
    }
    row.detections.push_back(d);
  }
  return row;
}

std::vector<Detector> law_detectors(std::span<const Case> cases) {
  return {
      {"laws",
       [cases](const Mutant& mutant) {
         std::vector<Pair> pairs = pairs_of(cases);
         draw(pairs, families(), law_pairs, detector_seed);
         return violation_on(methods_of(mutant), pairs, any);
       }},
      {"corpus",
       [cases](const Mutant& mutant) {
         const std::string violation = violation_on(methods_of(mutant), pairs_of(cases), of_truth);
         return violation.empty() ? contradiction(cases) : violation;
       }},
      {"differential",
       [](const Mutant& mutant) {
         std::vector<Pair> pairs;
         draw(pairs, families(), differential_pairs, detector_seed + 1);
         draw(pairs, margin_families(), differential_pairs, detector_seed + 1);
         return violation_on(methods_of(mutant), pairs, of_truth);
       }},
  };
}

}  // namespace cyl
