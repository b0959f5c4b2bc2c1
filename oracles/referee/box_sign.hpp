// SPDX-License-Identifier: MIT
// The exact relation of a box and a bounded solid: whether they overlap, touch or are apart, with a witness.
// It is always found, except for a box and a rounded cylinder (radius and one of the roundings > 0). Their
// nearest points may need more than one root.
#pragma once

#include <optional>

#include "oracles/referee/certificate_check.hpp"

namespace cyl {

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
