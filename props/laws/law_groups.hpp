// SPDX-License-Identifier: MIT
// The parts that all_laws() is put together from, a file a kind; and what they share. For the files of props/
// alone.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "props/laws/laws.hpp"

namespace cyl {

std::vector<Law> exact_laws();
std::vector<Law> one_sided_laws();
std::vector<Law> approximate_laws();
std::vector<Law> answer_laws();

/// Whether it answers yes or no. NaN, failures, `undecided` and `invalid` do not.
bool is_decided(const MethodAnswer& answer);
/// Whether a decided answer says that they meet: touching solids do.
bool says_meet(const MethodAnswer& answer);
/// Whether the verdict of an answer to `pair` is yes or no, and proved to be the other.
bool is_refuted(const LawCase& c, const Pair& pair, const MethodAnswer& answer);
/// The severity of what compares the verdicts on the pair and on asked[i]: contract where the method promises
/// both, or where one of them is refuted and it promises that one; else resolution. By proof.
Severity severity_of(const LawCase& c, std::size_t i);

/// What `violation_at(i)` finds of answers[i], the worst: one beyond the claim is not hidden by one within
/// it.
template <class ViolationAt>
std::optional<Violation> worst_of(const LawCase& c, ViolationAt violation_at) {
  std::optional<Violation> worst;
  for (std::size_t i = 0; i < c.answers.size(); ++i) {
    std::optional<Violation> violation = violation_at(i);
    if (!violation) continue;
    if (violation->severity == Severity::contract) return violation;
    if (!worst) worst = std::move(violation);
  }
  return worst;
}

/// How far a distance that was said of the pair may be off: the claim, its relative part of size and centres'
/// distance, or the rounding of the larger length.
double distance_allowance(const LawCase& c, const Pair& pair, double said);

/// The unit direction offered as witness, from a to b; not finite or 0 where none can be made of it.
Vector3 offered_direction(const Pair& pair, const MethodAnswer& answer);
/// -f(u), which no signed distance is below, whatever the unit vector u from a to b or back; rounded down.
/// The pair is in range.
double shown_by(const Pair& pair, const Vector3& u);

/// Whether the largest length of the pair, or of its coordinates, is one whose fourth power has all its
/// digits, so that the rounding bounds of the laws hold. Law 2 carries them to other scales.
bool is_in_range(const Pair& pair);

}  // namespace cyl
