// SPDX-License-Identifier: MIT
// The referee for a bounded solid and a box. The search for nearest points offers a direction or points in
// double, which the filter checks. Exact arithmetic decides the rest.
#pragma once

#include <optional>

#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

/// The verdict, if doubles prove it. A certificate costs 20 us for flat solids that meet. It is left out
/// there unless `certified`. Other cost: 2 us.
std::optional<Truth> prove_box_in_double(const Pair& pair, const Filter& filter, bool certified);
/// The same in two doubles. Cost: 20 us.
std::optional<Verdict> box_verdict_in_twins(const Pair& pair, const TwinFilter& filter);

/// The verdict with its certificate, in rationals. Its kinds are those of other pairs. `undecided` only for a
/// box and a rounded cylinder, at the cap on bits.
Truth judge_box_exactly(const Pair& pair, int bits_cap);
/// Without a certificate.
Truth box_verdict_exactly(const Pair& pair);

/// The same for a box and a cylinder with a radius, one of them rounded. Their nearest points are searched
/// with more and more bits. Ties are proved by algebra, except for an edge and a rim that are nearest in a
/// direction that is not rational. Cost: 0.1 ms to some ms.
Truth judge_rounded_box(const Pair& pair, int bits_cap);

/// Solids that touch there or, if the points are rounded, within 2^-200 of the size in this direction.
Truth touching_at(const Pair& pair, const Rational3& on_a, const Rational3& on_b, const Rational3& direction);

/// The exact relation of a box and a bounded solid: whether they overlap, touch or are apart, with a witness.
/// It is always found, except for a box and a rounded cylinder (radius and one of the roundings > 0). Their
/// nearest points may need more than one root.
struct BoxRelation {
  int sign = 0;  ///< 1 overlapping, 0 touching, -1 disjoint
  /// Unless disjoint: in both cores, at most the contact distance apart. Overlapping polytopes without
  /// rounding leave them out.
  Rational3 on_a, on_b;
  Rational3 direction;  ///< unless overlapping: f is <= 0 there, and < 0 if they are disjoint
};

/// Returns whether box_relation() takes the pair.
bool has_box_relation(const Pair& pair);

/// The points and the direction are exact if they are rational. Else they are rounded, by at most 2^-bits of
/// the size and of the direction's length. Cost: 10 us to 2 ms.
BoxRelation box_relation(const Pair& pair, int bits);

/// Whether both cores are boxes, segments or points.
bool are_polytopes(const Pair& pair);

/// Polytopes without rounding that meet have this point in common, rounded in the same way.
Rational3 common_point_of_polytopes(const Pair& pair, int bits);

/// The sign alone.
int box_sign(const Pair& pair);

}  // namespace cyl
