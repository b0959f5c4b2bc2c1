// SPDX-License-Identifier: MIT
// Proofs about solids grown by balls. Such solids meet if the distance of their cores (the solids without
// rounding) is at most the contact distance, the sum of both roundings. So the nearest points of the cores
// decide, even if the cores meet.
#pragma once

#include <optional>

#include "corpus/pairs/method_answer.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/proofs.hpp"

namespace cyl {

/// Returns a proof if the offered points show that the solids overlap. The numbers must be finite.
std::optional<Truth> check_points_by_filter(const Filter& filter, const MethodAnswer& answer);
std::optional<Truth> check_points_exactly(const Pair& pair, const MethodAnswer& answer);
/// The same if they may only touch.
bool points_show_contact(const Pair& pair, const MethodAnswer& answer);

/// Proves that the solids overlap, by a point near each given one. They are relative to the centres of their
/// solids, in a unit of 2^exponent.
std::optional<Truth> meet_by_filter(const Pair& pair, const Filter& filter, const Vec3<double>& from_a,
                                    const Vec3<double>& from_b, int exponent);
/// The same with many bits, in the scene's frame.
std::optional<Truth> meet_at(const Pair& pair, const Rational3& on_a, const Rational3& on_b, int bits);

/// Leaves its result in `guess`.
std::optional<Truth> prove_rounded_in_double(const Pair& pair, const Filter& filter, Guess& guess);

/// Proves that they touch, by algebra near the nearest points that double finds. Cost: 0.1 ms.
std::optional<Truth> prove_rounded_at_once(const Pair& pair);

/// Proves that they overlap, by a point near the given one that lies in both cores. Or by a point in each
/// core, if their distance is below the contact distance.
std::optional<Truth> prove_cores_meet(const Pair& pair, const Rational3& point, int bits);

/// Proves that they are apart, overlap or touch, by the nearest points found with so many bits. If the cores
/// meet, it finds their common point only if both roundings are larger than the error of the search.
std::optional<Truth> prove_rounded(const Pair& pair, int bits);

}  // namespace cyl
