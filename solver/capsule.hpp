// SPDX-License-Identifier: MIT
// The capsule: all points within a radius of a segment. The text of 2017 recommends it in place of the
// cylinder. outer_proxy and inner_proxy bound the error of such a replacement.
#pragma once

#include "solver/decide.hpp"

namespace cyl {

struct Capsule {
  Vector3 from, to;   ///< the segment's ends; they may coincide
  double radius = 0;  ///< >= 0
};

/// By how much a proxy is too wide or too narrow, so that rounding does not undo the containment: a multiple
/// of |centre| + height + radius. The ends are off by 4 units of 2^-53 of the height (the unit axis), and by
/// two roundings of the sum.
inline constexpr double proxy_error = 0x1p-50;

/// The largest rounding error of segment_distance and capsule_distance, times the sum over both capsules of
/// |middle| + length + radius. capsule.cpp proves 75 units of 2^-53 for any angle. The rest is room for
/// additions to a distance by callers.
inline constexpr double proxy_distance_error = 0x1p-45;

/// The distance of two segments, within proxy_distance_error. A segment may be a point. Products of four
/// lengths must not overflow or underflow. Never below 0.
double segment_distance(const Vector3& p0, const Vector3& p1, const Vector3& q0, const Vector3& q1) noexcept;

/// If > 0, the distance of the solids. If negative, they overlap, by that depth if the segments do not cross.
/// Solids are closed, so 0 is touching.
double capsule_distance(const Capsule& a, const Capsule& b) noexcept;

/// A capsule that contains a valid cylinder: the same axis and radius, rounded ends in addition. So outer
/// proxies apart prove the cylinders disjoint.
Capsule outer_proxy(const Prepared& c) noexcept;
Capsule outer_proxy(const Cylinder& c) noexcept;

/// A capsule inside it, as wide or as high as the cylinder. So inner proxies that meet prove that the
/// cylinders intersect. If rounding leaves nothing (a segment, a disk, far from the origin), radius < 0:
/// there is none.
Capsule inner_proxy(const Prepared& c) noexcept;
Capsule inner_proxy(const Cylinder& c) noexcept;

}  // namespace cyl
