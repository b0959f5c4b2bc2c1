// SPDX-License-Identifier: MIT
// A rounded solid around points, the outer model of a box or a mesh. If a solid is clear of it, it is clear
// of them. If a solid is near it, nothing is known.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "scenes/scene.hpp"

namespace cyl {

/// How much farther than computed a point may be from the axis or the middle of a bound, relative to all
/// lengths in the computation. It is 128 half units in the last place. Scaling, turning, moving and measuring
/// a point take fewer than 64.
inline constexpr double bound_error = 0x1p-46;
/// A length: what is lost of lengths whose squares underflow, below 2^-511.
inline constexpr double bound_underflow_error = 0x1p-500;

/// Returns the smallest in volume of a ball, a capsule and a cylinder that it finds around points, moved by a
/// pose. Every moved point is in it. The search for axes begins with the 13 of a cube, so it may miss a
/// better one. Throws std::runtime_error if there are no points, or if doubles cannot bound them.
Cylinder bounding_solid(std::span<const Vector3> points, const Pose& pose);

/// Returns the corners of a box around its origin.
std::array<Vector3, 8> corners_of(const Vector3& size);

/// Returns the volume of a ball, capsule or cylinder.
double volume_of(const Cylinder& solid) noexcept;

/// Returns a body that stands in for such points, with their box.
Body bounded_body(std::string name, std::size_t link, std::string shape, std::span<const Vector3> points,
                  const Pose& pose);

}  // namespace cyl
