// SPDX-License-Identifier: MIT
// By how much a witness misses what it is to prove.
#pragma once

#include <optional>

#include "corpus/pairs/method_answer.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Returns the length by which the witness of an answer misses a proof.
/// 1. For a direction: f of it at unit length. It separates if that is negative.
/// 2. For a point: how far it lies outside a cap, a wall or a facet, negative inside both solids. For two
/// points: the
///    same for each and its solid, or how much farther apart they are than the roundings allow, if that is
///    more.
/// 3. Returns nothing without a witness, for a direction of length 0, for points in hulls, and for a number
///    that is not finite.
/// Computed in 512 bits, more than the cancellation of doubles near 1 can lose, then rounded.
std::optional<double> witness_miss(const Pair& pair, const MethodAnswer& answer);

}  // namespace cyl
