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
/// Returns whether a decided answer means that the solids meet. Touching solids meet.
bool says_meet(const MethodAnswer& answer);
/// Whether the verdict of an answer to `pair` is yes or no, and proved to be the other.
bool is_refuted(const LawCase& c, const Pair& pair, const MethodAnswer& answer);
/// The severity of a violation that compares the verdicts on the pair and on asked[i]. It is contract if the
/// method claims both, or claims a verdict that is refuted. Else it is resolution. Both are proved.
Severity severity_of(const LawCase& c, std::size_t i);

/// Returns the worst violation that `violation_at(i)` finds in answers[i]. A violation within the claim does
/// not hide one beyond it.
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

/// The allowed error of a returned distance of the pair: the claim, its relative part of size and centres'
/// distance, or the rounding error of the larger length.
double distance_allowance(const LawCase& c, const Pair& pair, double said);

/// The unit direction of the witness, from a to b. It is 0 or not finite if the witness has no direction.
Vector3 offered_direction(const Pair& pair, const MethodAnswer& answer);
/// Returns -f(u), rounded down. For any unit vector u from a to b or back, the signed distance is at least
/// this. The pair is in range. A half-space is asked at its normal instead of u.
double shown_by(const Pair& pair, const Vector3& u);

/// At least the support of the core in each unit direction, relative to its centre. It is 0 for a half-space.
double core_extent(const Solid& c);
/// The unit direction of the axis, of the outward normal, or of a box's longest edge.
Vector3 direction_of(const Solid& c);

/// The capsule around a valid solid: the same axis and radius, rounded ends in addition. So capsules apart
/// prove the solids disjoint. A box has a cylinder around it, along its longest edge, and one inside it,
/// which stand for it. A half-space stands for itself.
Solid capsule_around(const Solid& c);
/// A capsule inside it, as wide or as high as the solid. So capsules that meet prove that the solids
/// intersect. If rounding leaves nothing (a segment, a disk, far from the origin), its rounding is < 0: there
/// is none.
Solid capsule_inside(const Solid& c);

/// Whether the largest length of the pair, or of its coordinates, is one whose fourth power has all its
/// digits, so that the rounding bounds of the laws hold. Law 2 carries them to other scales.
bool is_in_range(const Pair& pair);

}  // namespace cyl
