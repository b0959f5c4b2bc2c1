// SPDX-License-Identifier: MIT
// The stratum of a pair: which features meet, how nearly the axes are parallel or perpendicular, and the
// decade of the margin.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "base/enum_words.hpp"
#include "corpus/pairs/contact_feature.hpp"
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

/// Returns which features meet where the signed distance is attained, one of several where several do:
/// `containment` where the solids overlap and one holds the other. Nothing for a pair that is invalid or
/// undecided. Cost: that of an enclosure of the distance.
std::optional<ContactFeature> contact_feature(const Pair& pair, const Truth& truth);

/// The angle between the lines of the axes.
struct AxesAngle {
  double sine = 0, cosine = 0;           ///< >= 0, within 1e-15
  bool parallel = false, right = false;  ///< exactly: decided in rational arithmetic
};
AxesAngle axes_angle(const Pair& pair);  ///< the pair is legal

/// How nearly the lines of the axes are parallel or perpendicular.
enum class AngleClass : unsigned char {
  parallel,      ///< exactly
  within_1e_12,  ///< sine below 1e-12, not 0
  within_1e_7,   ///< below 1e-7
  within_1e_2,   ///< below 1e-2
  generic,
  near_right,  ///< cosine at most 1e-2, not 0
  right        ///< exactly perpendicular
};
constexpr auto words_of(AngleClass) noexcept {
  return std::array{"parallel", "<1e-12", "<1e-7", "<1e-2", "generic", "near-90", "90"};
}
inline constexpr std::size_t angle_class_count = 7;

/// Returns the class of a legal pair; what it says is exact is decided in rational arithmetic.
AngleClass angle_class(const Pair& pair);

/// Returns d where 10^(-d-1) < margin <= 10^-d; from 0, for margins above 0.1, to 16, for all up to 1e-16.
int margin_decade(double margin);

}  // namespace cyl
