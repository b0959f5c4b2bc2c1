// SPDX-License-Identifier: MIT
// The faults of an answer, as plain data. compare() of oracles/trial finds those of one
// answer. The caller finds those that need several, such as nondeterminism.
#pragma once

#include <array>
#include <optional>

#include "base/enum_words.hpp"
#include "corpus/pairs/certificate.hpp"

namespace cyl {

enum class FindingKind : unsigned char {
  wrong_disjoint,      ///< the answer is disjoint, but the pair has a common point
  wrong_intersecting,  ///< the answer is intersecting or touching, but the pair is disjoint
  wrong_touching,      ///< the answer is touching, but the distance is certainly not 0
  wrong_invalid,       ///< the answer is invalid, but the pair is valid
  bad_witness,         ///< verdict and distance are right, the witness it offered does not prove the verdict
  distance_outside,    ///< its distance is outside the certified enclosure by more than its claim
  non_finite,          ///< an infinite or NaN distance or witness
  exception,
  crash,
  hang,
  malformed,        ///< no answer at all: a value that means nothing
  nondeterminism,   ///< two answers to one question
  undecided_truth,  ///< not a fault of a method: the referee could not prove a verdict
  left_undecided,   ///< undecided of a pair that it promises to decide
  side_effect,      ///< the answer is right, but the call did what it may not, or left something behind
  state_dependent,  ///< wrong after many pairs, but not in a new worker
  reported          ///< the method itself reports a failure
};
constexpr auto words_of(FindingKind) noexcept {
  return std::array{"wrong_disjoint",  "wrong_intersecting",
                    "wrong_touching",  "wrong_invalid",
                    "bad_witness",     "distance_outside",
                    "non_finite",      "exception",
                    "crash",           "hang",
                    "malformed",       "nondeterminism",
                    "undecided_truth", "left_undecided",
                    "side_effect",     "state_dependent",
                    "reported"};
}

enum class Severity : unsigned char {
  contract,    ///< beyond what the method claims of itself; a failure always is
  resolution,  ///< within its own claim
  unresolved   ///< not known: the truth is undecided
};
constexpr auto words_of(Severity) noexcept { return std::array{"contract", "resolution", "unresolved"}; }
/// Returns the words of texts for people; to_string() has those of JSON and SQL.
constexpr const char* in_words(Severity s) noexcept {
  return s == Severity::contract     ? "beyond its claim"
         : s == Severity::resolution ? "within its claim"
                                     : "truth undecided";
}

/// Returns whether the method failed: exception, crash, hang, non-finite number, malformed answer or its own
/// report.
constexpr bool is_failure(FindingKind kind) noexcept {
  return kind == FindingKind::exception || kind == FindingKind::crash || kind == FindingKind::hang ||
         kind == FindingKind::non_finite || kind == FindingKind::malformed || kind == FindingKind::reported;
}

/// Returns whether the proved verdict refutes the verdict of the answer. Only then is a margin searched for.
constexpr bool is_refuted_verdict(FindingKind kind) noexcept {
  return kind == FindingKind::wrong_disjoint || kind == FindingKind::wrong_intersecting ||
         kind == FindingKind::wrong_touching;
}

/// Whether its verdict is wrong in any way: refuted, or "invalid" of a legal pair.
constexpr bool is_wrong_verdict(FindingKind kind) noexcept {
  return is_refuted_verdict(kind) || kind == FindingKind::wrong_invalid;
}

/// A fault of an answer. The margin is its amount relative to size_of(pair): |distance| of the pair for a
/// verdict or witness, |returned - true distance| for a distance. It is empty if the truth is undecided.
struct Finding {
  FindingKind kind;
  Severity severity;
  std::optional<Enclosure> margin;
};

}  // namespace cyl
