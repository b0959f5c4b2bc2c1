// SPDX-License-Identifier: MIT
// What stands in the stratum of a pair, proved: which features meet, and how nearly the axes are parallel or
// perpendicular.
#pragma once

#include <optional>

#include "corpus/pairs/stratum.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// Sine of the angle between a direction and an axis below which the direction is along it, and cosine below
/// which it is square to it.
inline constexpr double flat_tol = 1e-7;

/// Returns which features meet in a direction of any length from a to b, by the angles between it and the
/// axes: along the axis a cap, square to it a side, else a rim. A disk (height 0) has no side and a segment
/// (radius 0) no cap: there it is the rim. Never `containment`.
ContactFeature feature_along(const Pair& pair, const Vector3& direction);

/// Returns whether no point of `inner` is outside `outer`, but for rounding.
bool contains(const Cylinder& outer, const Cylinder& inner);

/// Returns which features meet in the direction of the signed distance, be it proved or the solver's:
/// `containment` if the solids overlap and one holds the other.
ContactFeature feature_at(const Pair& pair, bool overlap, const Vector3& direction);

/// Returns which features meet where the signed distance is attained, one of several where several do.
/// Nothing for a pair that is invalid or undecided. Cost: that of an enclosure of the distance.
std::optional<ContactFeature> contact_feature(const Pair& pair, const Truth& truth);
std::optional<ContactFeature> contact_feature(const Pair& pair);  ///< the truth is proved first

/// The angle between the lines of the axes.
struct AxesAngle {
  double sine = 0, cosine = 0;           ///< >= 0, within 1e-15
  bool parallel = false, right = false;  ///< exactly: decided in rational arithmetic
};
AxesAngle axes_angle(const Pair& pair);  ///< the pair is legal

/// Returns the class of a legal pair; what it says is exact is decided in rational arithmetic.
AngleClass angle_class(const Pair& pair);
AngleClass angle_class(const AxesAngle& angle);

}  // namespace cyl
