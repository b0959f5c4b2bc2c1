// SPDX-License-Identifier: MIT
// By how much a witness misses what it is to prove.
#pragma once

#include <optional>

#include "corpus/pairs/method_answer.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// Returns how far the witness of an answer is from a proof, relative to the size.
/// 1. For a direction: f of it at unit length. It separates if that is negative.
/// 2. For a point: how far it lies outside a cap or a wall, negative inside both solids.
/// 3. Returns nothing without a witness, for a point in hulls, for a number that is not finite, and for a
///    size of 0.
/// Computed in 512 bits, more than the cancellation of doubles near 1 can lose, then rounded.
std::optional<double> witness_miss(const Pair& pair, const MethodAnswer& answer);

}  // namespace cyl
