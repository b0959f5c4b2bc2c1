// SPDX-License-Identifier: MIT
// Holds a method's answer against the proved truth: what is wrong with it, if anything, and whether its own
// claim allows that. Only proofs refute: where the truth is undecided nothing is wrong.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/enum_words.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

struct Trial;

enum class FindingKind : unsigned char {
  wrong_disjoint,      ///< said disjoint of a pair with a common point
  wrong_intersecting,  ///< said intersecting or touching of a pair with daylight between
  wrong_touching,      ///< said touching of a pair whose distance is certainly not 0
  wrong_invalid,       ///< said invalid of a legal pair
  bad_witness,         ///< verdict and distance are right, the witness it offered does not prove the verdict
  distance_outside,    ///< its distance is outside the certified enclosure by more than its claim
  non_finite,          ///< an infinite or NaN distance or witness
  exception,
  crash,
  hang,
  malformed,       ///< no answer at all: a value that means nothing
  nondeterminism,  ///< two answers to one question
  undecided_truth  ///< nobody's fault: the referee could not prove a verdict
};
constexpr auto words_of(FindingKind) noexcept {
  return std::array{
      "wrong_disjoint",   "wrong_intersecting", "wrong_touching", "wrong_invalid", "bad_witness",
      "distance_outside", "non_finite",         "exception",      "crash",         "hang",
      "malformed",        "nondeterminism",     "undecided_truth"};
}

enum class Severity : unsigned char {
  contract,    ///< beyond what the method claims of itself; a failure always is
  resolution,  ///< within its own claim
  unresolved   ///< not known: the truth is undecided
};
constexpr auto words_of(Severity) noexcept { return std::array{"contract", "resolution", "unresolved"}; }

/// Whether the method broke: exception, crash, hang, non-finite number or malformed answer.
bool is_failure(FindingKind kind) noexcept;
/// Whether it said a verdict that the proved one refutes, which is all that a margin is sought of.
bool is_refuted_verdict(FindingKind kind) noexcept;
/// Whether its verdict is wrong in any way: refuted, or "invalid" of a legal pair.
bool is_wrong_verdict(FindingKind kind) noexcept;

/// What is wrong with an answer. The margin is how wrong, relative to size_of(pair): |distance| of the pair
/// for a verdict or a witness, |said - distance| for a distance; none where the truth is undecided.
struct Finding {
  FindingKind kind;
  Severity severity;
  std::optional<Enclosure> margin;
};

/// Returns what is wrong with `answer`, the worst first; nothing where it is right, declined or undecided, or
/// where nothing is proved. The distance is enclosed only where the finding's severity or an offered distance
/// depends on it, and is most of the cost. Throws nothing of its own.
std::optional<Finding> compare(Trial& trial, const Claim& claim, const MethodAnswer& answer);

/// Returns the length below which the claim promises nothing of a pair of this size, rounded up; exactly 0
/// for a claim of 0/0.
double reach(const Claim& claim, double size);

/// Returns |signed distance| of a pair whose verdict is proved, enclosed as narrowly as it takes to tell
/// whether it reaches `length` (or as narrowly as is ever asked).
Enclosure magnitude_against(double length, Trial& trial);

/// Returns whether two answers to one question say the same, bit for bit, reasons and kind `hang` excepted.
bool same_answer(const MethodAnswer& x, const MethodAnswer& y);

}  // namespace cyl
