// SPDX-License-Identifier: MIT
// A rounded solid around points, the outer model of a mesh, and one in their hull, the inner model. A solid
// that is clear of the outer model is clear of the points. A solid that meets the inner model meets the hull.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "scenes/scene.hpp"

namespace cyl {

/// How much farther than computed a point may be from the axis or the middle of a bound, relative to all
/// lengths in the computation. It is 128 half units in the last place. Scaling, turning, moving and measuring
/// a point take fewer than 64.
inline constexpr double bound_error = 0x1p-46;
/// A length: what is lost of lengths whose squares underflow, below 2^-511.
inline constexpr double bound_underflow_error = 0x1p-500;

/// A bound of points before a pose moves them.
struct Bound {
  Solid solid;                    ///< around them, up to rounding errors
  double outside = 0, reach = 0;  ///< how far one lies outside of it, and from the origin, at most
  Vector3 low{0, 0, 0}, high{0, 0, 0};
  std::optional<Solid> inner = std::nullopt;  ///< in the shape
};
/// Finds the smallest in volume of a ball, a capsule and a cylinder around points. The search for axes begins
/// with the 13 of a cube, so it may miss a better one. Throws std::runtime_error if there are no points.
Bound bound_of(std::span<const Vector3> points);
/// Returns the solid moved by a pose, grown so that every moved point is in it. Throws std::runtime_error if
/// doubles cannot bound them.
Solid moved(const Bound& bound, const Pose& pose);

/// Returns the corners of a box around its origin.
std::array<Vector3, 8> corners_of(const Vector3& size);

/// Returns the volume of a ball, capsule or cylinder.
double volume_of(const Solid& solid) noexcept;

/// Returns a capsule or ball in the convex hull of points, along the axis of their bound; nothing if the
/// middle of the bound is not inside the hull.
std::optional<Solid> capsule_in_hull(std::span<const Vector3> points, const Bound& bound);
/// Bounds an ellipsoid with these half axes by a capsule, with a capsule in it.
void bound_ellipsoid(Body& body, const Vector3& half, const Pose& pose);

/// Returns a body that stands in for such points, with their box.
Body bounded_body(std::string name, std::size_t link, std::string shape, const Bound& bound,
                  const Pose& pose);

}  // namespace cyl
