// SPDX-License-Identifier: MIT
// Holds a method's answer against the proved truth: what is wrong with it, if anything, and whether its own
// claim allows that. Only proofs refute: where the truth is undecided nothing is wrong.
#pragma once

#include <optional>
#include <string>

#include "corpus/pairs/finding.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

struct Trial;

/// Returns what is wrong with `answer`, the worst first; nothing where it is right, declined or may be
/// undecided, or where nothing is proved. The distance is enclosed only where the finding's severity or an
/// offered distance depends on it, and is most of the cost. Throws nothing of its own.
std::optional<Finding> compare(Trial& trial, const Claim& claim, const MethodAnswer& answer);

/// Returns the finding that a failure is.
FindingKind finding_of(Failure failure);

/// Relative to the size: what a claim with an absolute length is allowed at least, since `intersect` claims
/// no less of itself.
inline constexpr double claim_floor = 1e-13;

/// Returns the length below which the claim promises nothing of a pair of this size, rounded up; exactly 0
/// for a claim of 0/0.
double reach(const Claim& claim, double size);

/// Returns |signed distance| of a pair whose verdict is proved, enclosed as narrowly as it takes to tell
/// whether it reaches `length` (or as narrowly as is ever asked).
Enclosure magnitude_against(double length, Trial& trial);

/// Returns the error of the distance said that the answer's `error_bound` bounds; `real` holds the distance.
Enclosure error_bound_of(const Enclosure& real, const MethodAnswer& answer);

/// Returns whether two answers to one question say the same, bit for bit, reasons and kind `hang` excepted.
bool same_answer(const MethodAnswer& x, const MethodAnswer& y);

}  // namespace cyl
