// SPDX-License-Identifier: MIT
// By how much a witness misses what it is to prove.
#pragma once

#include <optional>

#include "corpus/pairs/method_answer.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// Returns the miss of the witness of an answer, relative to the size: of a direction f of it at unit length,
/// which separates where it is negative; of a point how far beyond a cap or a wall it lies, negative within
/// both solids. In 512 bits, which no cancellation of doubles near 1 uses up; rounded. Nothing where there is
/// no witness, a point in hulls, a number that is not finite, or no size.
std::optional<double> witness_miss(const Pair& pair, const MethodAnswer& answer);

}  // namespace cyl
