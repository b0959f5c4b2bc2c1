// SPDX-License-Identifier: MIT
// The words of the project: what a solid, a pair and a verdict are. No arithmetic lives here.
// (The namespace is cyl, not daylight: <time.h> declares a global variable `daylight`.)
#pragma once

#include <Eigen/Core>
#include <array>

namespace cyl {

using Vector3 = Eigen::Vector3d;

enum class Shape : unsigned char { cylinder, half_space, box };
/// The words used in files and on screens.
constexpr auto words_of(Shape) noexcept { return std::array{"cylinder", "half_space", "box"}; }

/// A closed solid. The direction of the axis is axis/|axis| taken exactly, so the axis may have any finite
/// non-zero length. A length that a shape does not have is 0.
/// 1. A finite cylinder, grown by a ball: all points within `rounding` of the cylinder. With radius 0 it is a
///    segment, with height 0 a disk, and with radius and height 0 a point. All are legal. With rounding a
///    segment is a capsule, a point a sphere.
/// 2. A half-space: all points x with axis.(x - center) <= 0. It has no lengths.
/// 3. A box, grown by a ball of radius `rounding`. Its edges have the directions to which the rotation of
///    quaternion/|quaternion| turns the coordinate vectors. The rotation is taken exactly, and it is
///    rational. Each edge may be 0.
struct Solid {
  Vector3 center{0, 0, 0};  ///< the middle of the axis segment, or a point of the plane, in the scene's unit
  Vector3 axis{0, 0, 1};  ///< any finite non-zero vector, the outward normal of a half-space; a box has none
  double radius = 0;      ///< >= 0, same unit
  double height = 0;      ///< full height, >= 0, same unit
  double rounding = 0;    ///< of all edges and faces, outward, >= 0, same unit
  Shape shape = Shape::cylinder;
  std::array<double, 3> edges{0, 0, 0};          ///< of a box: full lengths, >= 0, same unit
  std::array<double, 4> quaternion{1, 0, 0, 0};  ///< of a box: w x y z, any finite non-zero length
};

/// Two solids, at most one of them a half-space. Every direction in an answer about them points from a to b.
struct Pair {
  Solid a, b;
};

/// Solids are closed: touching solids do intersect.
enum class Verdict : unsigned char {
  disjoint,      ///< no common point
  intersecting,  ///< a common point; from a yes/no call this includes touching
  touching,      ///< a common point and signed distance exactly 0; only if proved
  undecided,     ///< not known: too close to touching for the arithmetic, or the work cap was reached
  invalid        ///< the input is not a pair of solids that the call takes
};
/// The words used in files and on screens.
constexpr auto words_of(Verdict) noexcept {
  return std::array{"disjoint", "intersecting", "touching", "undecided", "invalid"};
}

/// The smallest flat set that holds a flat solid, else the space. A common point of flat solids may have
/// coordinates that no double represents. An answer then gives a point in doubles, and the common point is
/// the point of the hull that is nearest to it. A solid no thicker than rounding errors counts as flat.
enum class Hull : unsigned char {
  space,
  plane,  ///< of a disk: through the centre, square to the axis
  line,   ///< of a segment: the axis
  center  ///< of a point: the point
};        // (a box with edges that are 0 has such a hull too, but no answer names it)
/// The words used in files and on screens.
constexpr auto words_of(Hull) noexcept { return std::array{"space", "plane", "line", "center"}; }

/// Why a Solid is invalid; the first reason in this order.
enum class Defect : unsigned char {
  none,
  center_not_finite,
  axis_not_finite,
  axis_zero,
  radius_not_finite,
  radius_negative,
  height_not_finite,
  height_negative,
  rounding_not_finite,
  rounding_negative,
  rounding_overflows,
  foreign_length,
  edge_not_finite,
  edge_negative,
  quaternion_not_finite,
  quaternion_zero
};
/// Phrases for people.
constexpr auto words_of(Defect) noexcept {
  return std::array{"nothing is wrong",
                    "center is not finite",
                    "axis is not finite",
                    "axis is zero",
                    "radius is not finite",
                    "radius is negative",
                    "height is not finite",
                    "height is negative",
                    "rounding is not finite",
                    "rounding is negative",
                    "rounding overflows with the other lengths",
                    "a length that the shape does not have is not 0",
                    "edges are not finite",
                    "edges are negative",
                    "quaternion is not finite",
                    "quaternion is zero"};
}

/// Cost: some twenty comparisons. Never throws.
Defect find_defect(const Solid& c) noexcept;

const char* to_string(Verdict v) noexcept;
const char* to_string(Defect d) noexcept;

}  // namespace cyl
