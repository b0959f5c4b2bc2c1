// SPDX-License-Identifier: MIT
// Pairs with a box or a half-space, as intersect(), decide() and distance() pass them on, and what their
// files share. Derivation: boxes.md.
#pragma once

#include <cmath>

#include "solver/detail/rounded_cores.hpp"

namespace cyl {

/// A bound on the rounding error of f(D) over |D|, and of the distance of a point from a facet, if a box
/// takes part. The unit is the reach (boxes.md, section 6).
inline constexpr double box_error = 64 * unit_roundoff_error;
/// The same if the certificate is not measured in the scene, but as seen from the first box.
inline constexpr double quick_error = 4 * box_error;
/// The same of f(n) if the other solid is not a box.
inline constexpr double plane_error = 16 * unit_roundoff_error;
/// The same of a half-space and a solid that is near it, if the vector between them is taken exactly.
inline constexpr double precise_plane_error = 40 * unit_roundoff_error;
/// An error of intersect() for a half-space, relative to the size: half of the least margin.
inline constexpr double plane_tol = 0x1p-44;
/// By how much decide() shrinks cores before it looks for a common point, of the reach.
inline constexpr double box_slack_tol = 2.5 * box_error;

Verdict intersect_shapes(const Prepared& a, const Prepared& b, double clearance) noexcept;
Answer decide_shapes(const Prepared& a, const Prepared& b, double clearance) noexcept;
/// `contact`: by which the distance will be less. A half-space is measured in more digits near that.
Distance distance_of_shapes(const Prepared& a, const Prepared& b, double contact = 0) noexcept;
inline bool has_other_shape(const Prepared& a, const Prepared& b) noexcept {
  return (a.shape != Shape::cylinder) | (b.shape != Shape::cylinder);
}

/// The roles in a fixed order: a half-space first, else a box, and of two boxes the one with the lesser
/// numbers. True if b comes first.
bool boxes_out_of_order(const Prepared& a, const Prepared& b) noexcept;
inline bool shapes_out_of_order(const Prepared& a, const Prepared& b) noexcept {
  const auto rank = [](const Prepared& c) { return -static_cast<unsigned>(c.shape) & 3; };
  static_assert(static_cast<int>(Shape::half_space) == 1 && static_cast<int>(Shape::box) == 2);
  return a.shape == b.shape ? boxes_out_of_order(a, b) : rank(b) > rank(a);
}

/// A pair in its order and in a unit in which nothing overflows.
struct ShapePair {
  const Prepared &a, &b;
  double contact;  ///< both roundings and the clearance
  int exponent;    ///< one unit is 2^exponent units of the scene
};
/// The solids and the numbers of a ShapePair. The first centre goes to 0 if it is not of a half-space, and
/// the largest length is in [1, 2). That length may be less beside a half-space whose point is more than
/// 2^900 of it away.
struct PairInUnit {
  Prepared a, b;
  double contact;
  int exponent;
};
PairInUnit in_unit(const Prepared& a, const Prepared& b, double clearance) noexcept;
inline bool is_in_range(const Prepared& a, const Prepared& b, double contact) noexcept {
  return both_are(Prepared::moderate, a, b) & (contact <= power_of_two(moderate_exponent));
}

/// Returns the result of `ask` for the ShapePair of two solids. `swapped`: whether b comes first.
template <class Ask>
[[gnu::always_inline]] inline auto ask_in_order(const Prepared& a, const Prepared& b, double clearance,
                                                bool swapped, Ask ask) noexcept {
  const Prepared* const roles[] = {&a, &b};  // a table, because a branch would be unpredictable
  const Prepared &first = *roles[swapped], &second = *roles[!swapped];
  const double contact = contact_distance_of(a, b, clearance);
  if (is_in_range(first, second, contact)) return ask(ShapePair{first, second, contact, 0});
  const PairInUnit p = in_unit(first, second, clearance);
  return ask(ShapePair{p.a, p.b, p.contact, p.exponent});
}

/// A bound of the length that needs neither a square nor a root.
inline double length_bound(const Vector3& x) noexcept {
  return std::fabs(x.x()) + std::fabs(x.y()) + std::fabs(x.z());
}

/// The support of a core about its centre, and a bound of it for unit vectors.
double core_support(const Prepared& c, const Vector3& d) noexcept;
inline double core_size(const Prepared& c) noexcept {
  return c.radius + 0.5 * (c.height + c.edges[0] + c.edges[1] + c.edges[2]);
}
/// A point of the core that is farthest along n, from its centre.
Vector3 farthest_of(const Prepared& c, const Vector3& n) noexcept;

/// The first is the half-space.
Verdict intersect_half_space(const Prepared& plane, const Prepared& c, double contact) noexcept;
/// `a` is a box, `b` not a half-space, and not what intersect_thin_and_box() takes.
Verdict intersect_box(const Prepared& a, const Prepared& b, double contact) noexcept;
/// The signed distance from the plane of a centre, n.Delta, and of its core, -f(n), with a bound of their
/// errors. If `contact` is within that of `gap`, more digits are used.
struct AbovePlane {
  double center, gap, error;
};
AbovePlane above_plane(const Prepared& plane, const Prepared& c, double contact) noexcept;
/// The first is the half-space. `swapped`: it is the second solid of the answer.
Answer decide_half_space(const Prepared& plane, const Prepared& c, double clearance, bool swapped) noexcept;
/// The same for a box and a segment or a point, and for a box and anything.
Answer decide_thin_and_box(const Prepared& box, const Prepared& thin, double clearance,
                           bool swapped) noexcept;
Answer decide_box(const Prepared& box, const Prepared& c, double clearance, bool swapped) noexcept;

/// The edges of a box have these directions.
struct Edges {
  explicit Edges(const Prepared& box) noexcept
      : e{box.unit_axis, box.second_axis, box.unit_axis.cross(box.second_axis)} {}
  Vector3 e[3];
  Vector3 seen(const Vector3& x) const noexcept { return {dot(x, e[0]), dot(x, e[1]), dot(x, e[2])}; }
  Vector3 world(const Vector3& x) const noexcept { return x[0] * e[0] + x[1] * e[1] + x[2] * e[2]; }
};

/// The cores of a box and another solid, from the centre of the box and along its edges.
struct BoxView {
  BoxView(const Prepared& a, const Prepared& b) noexcept;
  /// The support of the other core about its centre.
  double support(const Vector3& d) const noexcept;
  /// -f(d), if d points to the other core.
  double gap(const Vector3& d) const noexcept;
  /// The point of the other core that is nearest to x. The core is made smaller by `less` on all sides.
  Vector3 nearest_to(const Vector3& x, double less = 0) const noexcept;
  /// The second derivative along g of half the square of the distance of x from the other core.
  double bend(const Vector3& x, const Vector3& g) const noexcept;

  Edges edges;             ///< of the box, in the scene
  Vector3 half;            ///< of the box
  Vector3 d;               ///< centre of the other core
  bool box;                ///< whether that is a box
  Vector3 e[3];            ///< its edges. A cylinder has only an axis, e[0]
  Vector3 half1{0, 0, 0};  ///< of a box
  double r, h;             ///< of a cylinder: radius and half height
};

inline Vector3 clamped(const Vector3& x, const Vector3& half) noexcept {
  return {clamped(x[0], half[0]), clamped(x[1], half[1]), clamped(x[2], half[2])};
}

/// The directions that are tried first. For two boxes they are the normals and the products of the edges. For
/// a cylinder they are the normals, the axis, its products with the edges, and the way to the nearest point
/// of the box. They decide two boxes, and a box and a segment.
inline constexpr int box_axes = 15, cylinder_axes = 8;
/// Returns the first that separates, or -1.
int separating_axis(const BoxView& v) noexcept;
/// The same for the normals of the boxes, or of the box and the caps, if the gap is more than `slack`.
int separating_normal(const BoxView& v, double slack) noexcept;
/// The same for the others.
int separating_product(const BoxView& v) noexcept;
Vector3 axis_of(const BoxView& v, int index) noexcept;

/// The point of a clipped edge or of the section of a facet and a cap that is nearest to the axis.
struct ClippedBox {
  bool meets = false;        ///< it is in the cylinder
  Vector3 at{0, 0, 0};       ///< the point
  Vector3 out{0, 0, 0};      ///< from the axis
  int edge = -1;             ///< it lies on an edge along this, or in a facet if -1
  double square = 0x1p1000;  ///< of its distance from the axis
};
/// A box and a cylinder whose radius is > 0.
ClippedBox clip(const BoxView& v) noexcept;

/// For cores that are apart, with `way` between their nearest points, which ends at on1. Finds directions.
/// One of them shows the gap but for rounding. They are those of axis_of(), `way`, and the directions of the
/// outline (boxes.md, sections 4 and 5). `way` is also made square to edges and to the rim at on1, if it
/// nearly is. Others are square to the rim and to an edge. Returns their number.
inline constexpr int direction_cap = box_axes + 12;
int find_directions(const BoxView& v, const Vector3& on1, const Vector3& way,
                    Vector3 (&found)[direction_cap]) noexcept;

/// Returns the place of the maximum of a function in [lo, hi] that has only one, by so many golden sections.
template <class Value>
double golden_section(Value value, double lo, double hi, int steps) noexcept {
  constexpr double golden = 0.6180339887498949;
  double x = hi - golden * (hi - lo), y = lo + golden * (hi - lo), at_x = value(x), at_y = value(y);
  for (int i = 0; i < steps; ++i) {
    if (at_x > at_y) {
      hi = y, y = x, at_y = at_x, x = hi - golden * (hi - lo), at_x = value(x);
    } else {
      lo = x, x = y, at_x = at_y, y = lo + golden * (hi - lo), at_y = value(y);
    }
  }
  return x;
}

/// Returns the direction at most 2^-4 off `way` that shows the greatest gap. This search of 0.05 ms is for a
/// cap that nearly lies on a facet. The way between the nearest points is then mostly rounding.
Vector3 best_direction(const BoxView& v, const Vector3& way) noexcept;

/// The segment d + t e[0] and the box: finds t of the nearest point, unless `contact` >= 0 and it is known
/// before whether the distance is at most that.
struct SegmentPoint {
  double t;
  Vector3 way;  ///< from the box
  double gap;   ///< -f(way), if asked with a contact
  bool near;
};
SegmentPoint nearest_on_segment(const BoxView& v, double contact) noexcept;
/// A box and a point, or a box and a segment with a contact > 0.
Verdict intersect_thin_and_box(const Prepared& a, const Prepared& b, double contact) noexcept;
/// Whether the other core holds the point by `slack`.
bool holds(const BoxView& v, const Vector3& at, double slack) noexcept;
/// A point of both cores, if there is one beyond rounding.
bool find_common_point(const BoxView& v, Vector3& at) noexcept;

/// The nearest points of cores that do not meet. If `contact` >= 0, this ends as soon as it is known whether
/// their distance is at most that.
struct NearestPoints {
  Vector3 on0, on1;
  double square;       ///< of the distance of the points
  bool apart = false;  ///< shown to be farther apart than `contact`
  int steps = 0;
};
NearestPoints nearest_points(const BoxView& v, double contact) noexcept;

}  // namespace cyl
