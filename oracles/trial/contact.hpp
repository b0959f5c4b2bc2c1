// SPDX-License-Identifier: MIT
// Proves the stratum of a pair: the features that meet, and how nearly the axes are parallel or
// perpendicular.
#pragma once

#include <optional>
#include <string>

#include "corpus/pairs/stratum.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// A direction is along an axis if the sine of their angle is below this, and perpendicular to it if the
/// cosine is.
inline constexpr double flat_tol = 1e-7;

/// Returns the features that meet in a direction from a to b, which may have any length. Along the axis it is
/// a cap, perpendicular to the axis a side, else a rim. A disk (height 0) has no side and a segment (radius
/// 0) no cap: the rim takes their place. A facet of a box counts as a cap, an edge as a side and a vertex as
/// a rim. Never returns `containment`.
ContactFeature feature_along(const Pair& pair, const Vector3& direction);

/// Returns whether no point of `inner` is outside `outer`, up to rounding.
bool contains(const Solid& outer, const Solid& inner);

/// Returns the features that meet in the direction of the signed distance, proved or from the solver.
/// `containment` if the solids overlap and one holds the other.
ContactFeature feature_at(const Pair& pair, bool overlap, const Vector3& direction);

/// Returns the features that meet in the direction in which the signed distance is attained. If there are
/// several such directions, it takes one. Returns nothing for an invalid or undecided pair. Cost: that of an
/// enclosure of the distance.
std::optional<ContactFeature> contact_feature(const Pair& pair, const Truth& truth);
std::optional<ContactFeature> contact_feature(const Pair& pair);  ///< proves the truth first
/// Returns the feature in words, "unknown" if there is none. Pairs with a box have words of their own, such
/// as "facet-rim" and "edge-vertex".
std::string contact_in_words(const Pair& pair, const Truth& truth);

/// The angle between the lines of the axes. The edges of a box are three lines: of all angles, the smallest.
struct AxesAngle {
  double sine = 0, cosine = 0;           ///< >= 0, right within 1e-15
  bool parallel = false, right = false;  ///< exactly, decided in rational arithmetic
};
AxesAngle axes_angle(const Pair& pair);  ///< for a legal pair

/// Returns the class of a legal pair. Exactly parallel and exactly perpendicular are decided in rational
/// arithmetic.
AngleClass angle_class(const Pair& pair);
AngleClass angle_class(const AxesAngle& angle);

}  // namespace cyl
