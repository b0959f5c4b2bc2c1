// SPDX-License-Identifier: MIT
// Compares a method's answer with the proved truth: finds the fault of the answer, and whether the method's
// claim covers it. Only proofs refute. If the truth is undecided, no answer is wrong.
#pragma once

#include <optional>
#include <string>

#include "corpus/pairs/finding.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

struct Trial;

/// Returns the worst fault of `answer`.
/// 1. Returns nothing if the answer is right, declined or allowed to be undecided, or if no verdict is
///    proved.
/// 2. Encloses the distance only to grade a fault or to check a returned distance. Enclosing it is most of
///    the cost.
/// 3. Throws only what Trial throws.
std::optional<Finding> compare(Trial& trial, const Claim& claim, const MethodAnswer& answer);

/// Compares the verdict that a case states, as the answer of a method that claims to be always right.
std::optional<Finding> compare_statement(Trial& trial, Verdict stated);

/// Returns the kind of finding of a failure.
FindingKind finding_of(Failure failure);

/// The least relative part of a claim that has an absolute part. For huge solids, the rounding of coordinates
/// alone exceeds an absolute length. This is the claim of `intersect`.
inline constexpr double claim_floor = 1e-13;

/// Returns the length below which the claim promises nothing for a pair of this size, rounded up. It is
/// exactly 0 if the relative and the absolute claim are both 0.
double reach(const Claim& claim, double size);

/// Returns the distance error that a search or fuzz target allows, which is reach(claim, size + |Delta|).
/// Delta is the vector between the centres. If both parts of the claim are 0, returns size + |Delta|.
double allowed_error(const Claim& claim, const Pair& pair);

/// Returns |signed distance| of a pair whose verdict is proved. The enclosure narrows until it shows whether
/// the distance reaches `length`, or until the narrowest width is reached.
Enclosure magnitude_against(double length, Trial& trial);

/// Returns the error that the answer's `error_bound` bounds, if `real` encloses the true distance.
Enclosure error_bound_of(const Enclosure& real, const MethodAnswer& answer);

/// Returns whether two answers to one question are equal, bit for bit. Reasons are not compared, and every
/// answer equals a hang.
bool same_answer(const MethodAnswer& x, const MethodAnswer& y);

}  // namespace cyl
