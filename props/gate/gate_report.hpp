// SPDX-License-Identifier: MIT
// The result of a merge gate. reports/gate/judged_gate.hpp adds what is already known.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/strata.hpp"
#include "props/laws/examine.hpp"
#include "props/laws/laws.hpp"

namespace cyl {

/// In the order they are run.
enum class GatePhase : unsigned char {
  corpus,          ///< every case, in full, by law 30 and on
  corpus_laws,     ///< all other laws on every case
  laws,            ///< all laws on generated pairs
  sample,          ///< the differential sample: independent pairs of every stratum against the referee
  close_laws,      ///< all laws on generated close contacts
  close_sample,    ///< independent close contacts of every cell against the referee
  rounded_laws,    ///< all laws on generated rounded solids
  rounded_sample,  ///< independent rounded solids against the referee
  simplify         ///< failures are run again and made simpler; its pairs are the failures'
};
constexpr auto words_of(GatePhase) noexcept {
  return std::array{"corpus",
                    "laws on the corpus",
                    "laws on drawn pairs",
                    "sample of all strata",
                    "laws on close contacts",
                    "sample of close contacts",
                    "laws on rounded solids",
                    "sample of rounded solids",
                    "simplification"};
}

/// One way in which one method fails: all pairs of one law and one cause (method, kind of failure, contact
/// feature and extreme coordinate), in the order found.
struct GateFailure {
  std::string method;
  const Law* law = nullptr;
  std::string kind;    ///< "wrong_disjoint" of a refuted verdict, "crash" of a failure, else the law's name
  std::string what;    ///< what broke, on the worst pair
  std::string reason;  ///< of a failure: the method's own words, on that pair
  /// How the method failed, on the pair itself or on a changed pair that the law asks about. Empty if it
  /// answered.
  std::optional<FindingKind> failed;
  Severity severity = Severity::contract;
  GatePhase phase = GatePhase::corpus;
  std::string origin;  ///< of the worst pair: a case's "FILE:LINE id", or "side-rim 1e-09, seed 1, index 17"
  Pair found;          ///< the first pair with the largest excess
  double excess = 0;   ///< of that pair, as in Violation
  /// Returns whether a kept case fails like this. Then the worst of the cases is shown.
  bool in_case() const { return phase == GatePhase::corpus || phase == GatePhase::corpus_laws; }
  Pair simplest;                 ///< a simple one that breaks the same law in the same way
  std::string what_of_simplest;  ///< the fault on that pair; if empty, the same as on the worst
  std::string
      cause;  ///< of the pairs as found, oracles/trial/failure_key.hpp; that of the simplest may be another
  std::uint64_t count = 0;  ///< pairs seen to fail like this
  unsigned reruns = 0,
           failed_again = 0;  ///< of the worst pair; if fewer than reruns, the failure is not
                              ///< deterministic
};

/// Independent random pairs of one stratum, and how many were wrong.
struct GateCell {
  Stratum stratum;
  bool claimed = false;  ///< by the method, for every drawn pair; false if no pair was drawn
  std::uint64_t pairs = 0, wrong = 0, undecided = 0;
  std::uint64_t drawn = 0;  ///< also pairs that the method declines
};

/// Independent random pairs of one cell of close contacts (corpus/pairs/close_contact.hpp).
struct CloseGateCell {
  CloseCell cell;
  bool claimed = false;  ///< by the method, for every drawn pair; false if no pair was drawn
  std::uint64_t gaps = 0, wrong_gaps = 0;
  /// Pairs that overlap by construction. The cell's margin is an upper bound of their depth. An answer is
  /// wrong if the proved margin is beyond the claim.
  std::uint64_t overlaps = 0, wrong_overlaps = 0;
  std::uint64_t undecided = 0;  ///< besides
  std::uint64_t drawn = 0;      ///< also pairs that the method declines
};

/// Verdicts on independent random pairs. Wrong: if the proved margin is beyond the claim.
struct VerdictCount {
  std::uint64_t pairs = 0, wrong = 0, undecided = 0;
};

/// The counts of one method.
struct GateMethod {
  std::string name, version;
  Claim claim;
  AnswerCounts counts = {};
  std::vector<GateCell> cells;
  std::vector<CloseGateCell> close_cells;  ///< in the order of their numbers
  VerdictCount rounded = {};               ///< of pairs with a solid other than a cylinder
  std::array<VerdictCount, drawn_kinds.size()> by_kinds = {};  ///< of these, without `undecided`
  std::string remark =
      {};  ///< "abstains on every pair", "answers intersecting to every pair", ...; else empty
};

/// Returns the counts of all cells of close contacts, claimed or not.
VerdictCount close_contacts_of(const GateMethod& method);

struct GatePhaseReport {
  GatePhase phase;
  std::uint64_t rounds = 0;  ///< of the phases that draw
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
  std::uint64_t undecided_truths = 0;  ///< pairs without a proved verdict
};

/// Returns whether a break shows in the answer to the pair itself, so that no law need be named to see it
/// again.
bool shows_in_answer(const Law& law);
/// Returns whether the method broke more than its own claim allows.
bool is_error(const GateFailure& failure);
/// Returns a line for truths that are not proved, for each sample without pairs, and for each method that
/// decided less than half of its pairs.
std::vector<std::string> doubts(const GateReport& report);
/// Returns 2 if there is an error, reproducible or not. Else returns 3 if there are doubts or something was
/// not asked, or 0.
int exit_code(const GateReport& report);

/// Returns whether a method gives no verdict on more than half of its pairs. Such a method does not pass the
/// gate.
bool abstains(const AnswerCounts& counts);
/// Returns what is remarkable in a method's answers, "abstains on every pair" or "answers disjoint to every
/// pair"; else nothing.
std::string remark_on(const AnswerCounts& counts);

}  // namespace cyl
