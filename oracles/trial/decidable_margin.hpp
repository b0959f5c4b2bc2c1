// SPDX-License-Identifier: MIT
// The margin from which a method that decides `above_1e13` must decide: the solids are apart by 1e-13 of the
// size, or have a ball of that radius in common. If a solid is flat, a disk or a segment of that radius takes
// the place of the ball.
#pragma once

#include <optional>

#include "oracles/trial/trial.hpp"

namespace cyl {

/// Relative to the size. solver/decide.hpp promises 1e-13. One hundredth more covers what core() and the
/// bound of the distance lose to rounding.
inline constexpr double resolved_margin = 1.01e-13;

/// Returns the points of the solid around which a ball of radius `least` fits. They are the solid, smaller by
/// `least` on all sides. If the solid is at most that thick, a disk or a segment takes the place of the ball.
/// Returns nothing for a solid between the two, and for a point.
std::optional<Solid> core(Solid c, double least);

/// Returns both cores. Returns nothing if nothing is promised: if both solids are flat, or the sum of the
/// lengths overflows, as an offset to a common point may.
std::optional<Pair> cores(const Pair& pair, double least);

/// Returns whether a method with this promise must decide the pair: more than its rounding is proved to lie
/// between the solids or to be common to them. The promise is not for boxes, nor for a half-space and a
/// rounded solid. Costs an enclosure, or a verdict on the cores.
bool must_decide(DecisionScope promised, Trial& proved);

/// Returns how far beyond rounding an undecided pair is, relative to its size, as computed by the solver: the
/// gap, or the radius of the largest common ball. Returns 0 if nothing is promised.
double estimated_margin(const Pair& pair);

}  // namespace cyl
