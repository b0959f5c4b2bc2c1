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
/// 2. Encloses the distance only if the finding's severity or an offered distance depends on it. That is most
///    of the cost.
/// 3. Throws only what Trial throws.
std::optional<Finding> compare(Trial& trial, const Claim& claim, const MethodAnswer& answer);

/// Compares the verdict that a case states, as the answer of a method that claims to be always right.
std::optional<Finding> compare_statement(Trial& trial, Verdict stated);

/// Returns the kind of finding of a failure.
FindingKind finding_of(Failure failure);

/// Relative to the size. A claim with an absolute length is allowed at least this, because `intersect` claims
/// no less.
inline constexpr double claim_floor = 1e-13;

/// Returns the length below which the claim promises nothing for a pair of this size, rounded up. Exactly 0
/// for a claim of 0/0.
double reach(const Claim& claim, double size);

/// Returns the error of the distance that a claim allows in a search or a fuzz target: reach() of a length
/// that includes |Delta|, as in solver/distance.hpp. If nothing is claimed, this is the whole length.
double allowed_error(const Claim& claim, const Pair& pair);

/// Returns |signed distance| of a pair whose verdict is proved. The enclosure is narrow enough to decide
/// whether it reaches `length`, or as narrow as any that is computed.
Enclosure magnitude_against(double length, Trial& trial);

/// Returns the error that the answer's `error_bound` bounds, if `real` encloses the true distance.
Enclosure error_bound_of(const Enclosure& real, const MethodAnswer& answer);

/// Returns whether two answers to one question are equal, bit for bit. Reasons are not compared, and every
/// answer equals a hang.
bool same_answer(const MethodAnswer& x, const MethodAnswer& y);

}  // namespace cyl
