// SPDX-License-Identifier: MIT
// The pairs that the search for the worst pair goes through: its domain, the pairs of one shape, and the
// pairs near another.
#pragma once

#include <optional>

#include "corpus/pairs/random_stream.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Returns the pair scaled and moved into the domain of the search, with lengths enlarged that are less than
/// a millionth of the size. Bits change only if that is needed. Returns nothing for a pair that is not valid,
/// has only points or a half-space, or is too far out to be scaled. At sizes of 1e-300 or 1e150, or far from
/// the origin, every method is wrong by any margin. Without the domain a search would find only that.
std::optional<Pair> bring_into_domain(const Pair& pair);

/// Returns whether a pair is in the domain, rounding allowed for.
bool is_in_domain(const Pair& pair);

/// A shape: two solids that touch, and the direction in which b moves away from a. Apart, the margin along it
/// is the distance; into each other it is no less than the depth.
struct Ray {
  Pair touching;
  Vector3 direction;
  double size;

  Pair at(double margin) const {
    Pair p = touching;
    p.b.center += margin * size * direction;
    return p;
  }
};

/// Returns the shape of a pair. Nothing if the direction of its distance is not known.
std::optional<Ray> ray_of(const Pair& pair);

/// Returns a pair near this one. Some of its lengths, and the angle of the directions to parallel and to
/// perpendicular, change by decades or small parts of one. All turns a little, and b moves. Directions that
/// are exactly parallel or perpendicular stay so, up to rounding.
Pair nudged(const Pair& pair, RandomStream& stream);

}  // namespace cyl
