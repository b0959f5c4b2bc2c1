// SPDX-License-Identifier: MIT
// Turns solids of any kind so that a plane touches them in a chosen part: the start of a pair that is built
// from the contact outwards.
#pragma once

#include <array>
#include <cstddef>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/stratum.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// The part of the core in which a plane touches it, by its dimension.
enum class TouchPart : unsigned char {
  point,  ///< a vertex, a rim, the end of a segment
  line,   ///< an edge, a side, a segment
  face    ///< a facet, a cap
};

/// The parts of two solids that meet.
std::array<TouchPart, 2> parts_of(ContactFeature feature);

/// Returns a quaternion, not of length 1, of the rotation with these columns. They are orthonormal up to
/// rounding.
std::array<double, 4> quaternion_of(const std::array<Vector3, 3>& columns);

/// Returns a random quaternion with a length of 0.1 to 1.
std::array<double, 4> draw_quaternion(RandomStream& s);

/// Returns the unit direction of an edge, rounded.
Vector3 edge_direction(const Solid& box, std::size_t edge);

/// Turns the solid so that its axis, or an edge drawn from the three, has the unit direction `along`.
void lay_along(Solid& c, const Vector3& along, RandomStream& s);

/// Returns the image of a solid under the matrix M that takes the coordinates in this order and then changes
/// signs. The image of a box's rotation R is M R M'. It turns about the image of R's axis, by the same angle,
/// in the other sense if M is a mirror.
Solid image(const Solid& c, const Eigen::Vector3i& order, const Vector3& signs);

/// The place of a contact in its part, from -1 to 1 each. 0 is the middle of the part and 1 its border.
struct TouchPlace {
  double along, across;
};

/// Turns the core so that the plane square to `n` touches it from outside. `u` is square to `n`; an edge or a
/// side that touches has its direction, and an edge of a facet too. A sphere has one part only. A half-space
/// lies behind the plane. Returns the contact from the centre. Its n.x is the greatest of the core, up to
/// rounding.
Vector3 touch_plane(Solid& c, TouchPart part, const Vector3& n, const Vector3& u, const TouchPlace& place,
                    RandomStream& s);

/// How far from the middle of a side or cap a contact inside it may lie, as a part of the way to its border.
inline constexpr double inside_part = 0.6;

/// Turns a cylinder so that a plane square to `n` touches it inside its side, which lies along n x v, or
/// inside its cap, beside the centre along v. `v` is square to n. Returns the contact from the centre.
Vector3 touch_inside(Solid& c, TouchPart part, const Vector3& n, const Vector3& v, RandomStream& s);

Pair in_any_order(const Pair& pair, RandomStream& s);
/// Returns a power of ten.
double draw_decade(RandomStream& s, std::size_t first, std::size_t last);

/// One coordinate in two is 0, the others are from -1 to 1.
void draw_center(Solid& c, RandomStream& s);

/// Two directions square to each other, one time in four coordinate axes.
struct ContactFrame {
  Vector3 n, u;
};
ContactFrame draw_frame(RandomStream& s);

/// Puts the contacts of the cores apart along n by the roundings and the margin.
void put_beside(Pair& p, const Vector3& on_a, const Vector3& on_b, const Vector3& n, double margin,
                RandomStream& s);

/// Turns and puts two solids so that these parts of them meet, in any order. A gap has this margin, an
/// overlap may be less deep. The lines u of both parts are parallel, 1e-15 to 1 rad from parallel, square, or
/// at any angle. Half of the contacts are at the border of a part.
Pair put_in_contact(Pair p, const std::array<TouchPart, 2>& parts, double margin, RandomStream& s);

}  // namespace cyl
