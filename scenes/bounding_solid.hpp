// SPDX-License-Identifier: MIT
// A rounded solid around points: it stands in for a box or a mesh as an outer model. What it is clear of,
// they are clear of; of what is near it nothing is known.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "scenes/scene.hpp"

namespace cyl {

/// How much farther than computed a point may be from the axis or the middle of a bound, relative to all
/// lengths that go into it: 128 half units in the last place, where scaling, turning, moving and measuring a
/// point take fewer than 64.
inline constexpr double bound_error = 0x1p-46;
/// A length: what is lost of lengths whose squares underflow, below 2^-511.
inline constexpr double bound_underflow_error = 0x1p-500;

/// Returns the least in volume that is found of a ball, a capsule and a cylinder around points, moved by a
/// pose: every point, so moved, is in it. Axes are sought from the 13 of a cube on, so that a better one may
/// be missed. Throws std::runtime_error where there are no points, or none that doubles can bound.
Cylinder bounding_solid(std::span<const Vector3> points, const Pose& pose);

/// Returns the corners of a box around its origin.
std::array<Vector3, 8> corners_of(const Vector3& size);

/// Returns the volume of a ball, capsule or cylinder.
double volume_of(const Cylinder& solid) noexcept;

/// Returns a body that stands in for such points, with their box.
Body bounded_body(std::string name, std::size_t link, std::string shape, std::span<const Vector3> points,
                  const Pose& pose);

}  // namespace cyl
