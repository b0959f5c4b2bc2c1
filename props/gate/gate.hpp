// SPDX-License-Identifier: MIT
// The merge gate: may this method go in? Replays every known case, holds the method to every law, samples
// pairs from every stratum against the referee, and says how much that proves. Same seed and number of pairs,
// same failures in the same order, on any machine; hangs excepted. Where a cap on time cuts it, it says what
// was not asked.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/methods/method.hpp"
#include "props/laws/examine.hpp"
#include "props/laws/laws.hpp"

namespace cyl {

/// In the order they are run.
enum class GatePhase : unsigned char {
  corpus,       ///< every case, in full, by law 30 and on
  corpus_laws,  ///< all other laws on every case
  laws,         ///< all laws on generated pairs
  sample        ///< the differential sample: independent pairs of every stratum against the referee
};
constexpr auto words_of(GatePhase) noexcept {
  return std::array{"corpus", "laws on the corpus", "laws on drawn pairs", "sample of all strata"};
}

/// The number of pairs that a gate draws where nothing else is said: with them our own methods take about 40
/// s on two cores, as long as people wait for a merge, and each cell of the sample gets 2,300, which bounds
/// its error rate by 1.3e-3.
inline constexpr std::uint64_t gate_pairs = 250'000;

/// How much is drawn, in rounds: up to 64 pairs under all laws, or 4 pairs of each cell of the sample.
struct GateAmount {
  std::optional<std::uint64_t> cases_under_laws;  ///< all, where not given
  std::uint64_t law_rounds = 0, sample_rounds = 0;
};

/// Returns the amount of so many pairs in all, in whole rounds and at least one of each.
GateAmount amount_of(std::uint64_t pairs);

struct GateOptions {
  std::uint64_t seed = 1;
  std::uint64_t pairs = gate_pairs;  ///< to be drawn; the corpus is run in full beside them
  /// What an earlier gate drew, instead: so that both see the same pairs.
  std::optional<GateAmount> amount;
  std::optional<std::chrono::milliseconds> cap;  ///< wall time, after which nothing more is asked
  /// The caps on one call and on the hangs in one batch are shorter than a campaign's, for a gate is to end.
  Caps caps{
      .call_cpu = std::chrono::milliseconds(500), .call_wall = std::chrono::milliseconds(2000), .hangs = 4};
};

/// One way in which one method fails: all pairs of one bucket, that is of one method, kind of failure,
/// contact feature and extreme coordinate, and of one law; in the order found.
struct GateFailure {
  std::string method;
  const Law* law = nullptr;
  std::string kind;    ///< "wrong_disjoint" of a refuted verdict, "crash" of a failure, else the law's name
  std::string what;    ///< what broke, on the first pair
  std::string reason;  ///< of a failure: the method's own words, on the first pair
  Severity severity = Severity::contract;
  GatePhase phase = GatePhase::corpus;
  std::string origin;  ///< of the first pair: a case's "FILE:LINE id", or "side-rim 1e-09, seed 1, index 17"
  Pair found;          ///< the first pair
  Pair simplest;       ///< a simple one that breaks the same law in the same way
  std::string
      bucket;  ///< of the pairs as found, oracles/trial/bucket.hpp; that of the simplest may be another
  std::uint64_t count = 0;  ///< pairs seen to fail like this
  unsigned reruns = 0,
           failed_again = 0;  ///< of the first pair; fewer failures than reruns: it depends on luck
  std::string reproduce;      ///< RapidCheck's string, where it came from there; else empty
  std::string options;        ///< that bring the method where it is of no build; else empty
  bool known = false;         ///< excused: the base has it on as many pairs, or it is suppressed
  std::uint64_t in_base = 0;  ///< pairs of the base that failed like this
};

/// Independent random pairs of one contact feature and one decade of margin, and how many were wrong.
struct GateCell {
  std::string_view feature;
  int decade = 0;        ///< margins in (10^(-decade-1), 10^-decade]
  bool claimed = false;  ///< by the method, for every pair of the cell
  std::uint64_t pairs = 0, wrong = 0, undecided = 0;
};

/// What became of one method.
struct GateMethod {
  std::string name, version;
  Claim claim;
  AnswerCounts counts;
  std::vector<GateCell> cells;
  std::string remark;  ///< "abstains on every pair", "answers intersecting to every pair", ...; else empty
};

struct GatePhaseReport {
  GatePhase phase;
  std::uint64_t rounds = 0;  ///< of `laws` and `sample`
  std::uint64_t pairs = 0;
  std::chrono::milliseconds time{0};
  std::uint64_t digest = 0;  ///< of the pairs, in their order
};

struct GateReport {
  std::uint64_t seed = 0;
  std::uint64_t pairs = 0;  ///< that were to be drawn
  std::optional<std::chrono::milliseconds> cap;
  std::vector<std::string> not_asked;  ///< that should have been, a line each: empty if all was
  std::vector<std::uint64_t> cases;    ///< digests of the cases asked, in their order
  std::vector<GateMethod> methods;
  std::vector<GateFailure> failures;
  std::vector<GatePhaseReport> phases;
  std::uint64_t undecided_truths = 0;  ///< pairs of which nothing could be proved
  std::map<std::string, std::uint64_t>
      drawn;  ///< pairs that laws were tried on, by what they were drawn from
};

struct GateProgress {
  GatePhase phase;
  std::uint64_t pairs = 0;
  std::size_t failures = 0;  ///< beyond claims
  double share = 0;          ///< of the phase that is done
  std::chrono::milliseconds elapsed{0};
};

/// Runs the gate on methods. What is asked is decided by counts; only the cap, if any, by a clock. Throws
/// std::system_error only where the system refuses a process or memory.
GateReport run_gate(std::span<const std::unique_ptr<Method>> methods, std::span<const Case> cases,
                    const GateOptions& options,
                    const std::function<void(const GateProgress&)>& on_progress = {});

/// Returns whether a break shows in the answer to the pair itself, so that no law need be named to see it
/// again.
bool shows_in_answer(const Law& law);
/// Returns whether the method broke more than its own claim allows.
bool is_error(const GateFailure& failure);
/// Returns whether that is not excused either.
bool fails_gate(const GateFailure& failure);

/// Returns 2 where a failure fails the gate, reproducible or not; 3 where none does, but truth that nobody
/// could prove, a method that decided less than half of its pairs, or something that was not asked; else 0.
int exit_code(const GateReport& report);

}  // namespace cyl
