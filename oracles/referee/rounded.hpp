// SPDX-License-Identifier: MIT
// Proofs about solids grown by balls. They meet where their cores, the solids without their rounding, come as
// near as both roundings together: the room. So the nearest points of the cores decide, and so do they where
// the cores meet.
#pragma once

#include <optional>

#include "corpus/pairs/method_answer.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/proofs.hpp"

namespace cyl {

/// Whether the points offered show that the solids meet, and more than touch. The numbers are finite.
std::optional<Truth> check_points_by_filter(const Filter& filter, const MethodAnswer& answer);
std::optional<Truth> check_points_exactly(const Pair& pair, const MethodAnswer& answer);
/// The same where they may only touch.
bool points_show_contact(const Pair& pair, const MethodAnswer& answer);

/// What was found is left in `guess`.
std::optional<Truth> prove_rounded_in_double(const Pair& pair, const Filter& filter, Guess& guess);

/// Touching, by algebra near the nearest points that double finds. Cost: 0.1 ms.
std::optional<Truth> prove_rounded_at_once(const Pair& pair);

/// Overlapping, by a point near the one given that lies in both cores, or by one in each, nearer than the
/// room.
std::optional<Truth> prove_cores_meet(const Pair& pair, const Rational3& point, int bits);

/// Apart, overlapping or touching, by the nearest points found with so many bits. Of cores that meet it finds
/// their common point only where both roundings make up for what the search lacks.
std::optional<Truth> prove_rounded(const Pair& pair, int bits);

}  // namespace cyl
