// SPDX-License-Identifier: MIT
// Where a method that decides `beyond_rounding` promises not to be undecided: where the solids are apart by
// 1e-13 of the size, or hold a ball of that radius in common, or a disk or segment where one of them is flat.
#pragma once

#include <optional>

#include "oracles/trial/trial.hpp"

namespace cyl {

/// Relative to the size: solver/decide.hpp promises 1e-13, and a hundredth more is far beyond what core() and
/// the bound of the distance lose.
inline constexpr double resolved_margin = 1.01e-13;

/// Returns the points around which a ball of radius `least` lies in the solid: a cylinder, smaller by that
/// all around; of one no thicker than that, those around which a disk or a segment does. Nothing of a solid
/// between, which no ball fits into, and of a point.
std::optional<Cylinder> core(Cylinder c, double least);

/// Returns the two cores where something is promised of them: not of two flat solids, nor of lengths whose
/// sum overflows, as an offset to a common point may.
std::optional<Pair> cores(const Pair& pair, double least);

/// Returns whether a method that promises this owes a verdict of the pair: where more than its rounding is
/// proved to be in between or in common. Costs an enclosure, or a verdict on the cores.
bool owes_verdict(Decides promised, Trial& proved);

/// Returns how far beyond rounding an undecided pair is, relative to its size: apart the distance, else the
/// radius of the largest ball in common, as the solver has it. 0 where nothing is promised.
double likely_room(const Pair& pair);

/// Returns no less, by one call of the solver: no ball in common is larger than the depth or than a solid.
double most_room(const Pair& pair);

/// The same for certain, at least.
double proved_room(Trial& proved);

}  // namespace cyl
