// SPDX-License-Identifier: MIT
// The decision: do two cylinders intersect? Nothing here prints, throws, allocates, aborts or keeps state.
// The mathematics, in the symbols of the code: derivation.md.
#pragma once

#include "solver/cylinder.hpp"
#include "solver/detail/iteration_cap.hpp"

namespace cyl {

/// A cylinder checked and brought to working form once, for use in many pairs. Make it with prepare().
struct Prepared {
  Vector3 center;     ///< as given
  Vector3 unit_axis;  ///< along the axis, first non-zero coordinate positive; within unit_axis_error of exact
  double radius;      ///< as given
  double height;      ///< as given
  Defect defect;      ///< not none: every call answers `invalid`
  bool ordinary;      ///< not rounded, and `moderate`
  bool moderate;      ///< all numbers 0 or so near 1 that no product in a decision over- or underflows
  bool thin;          ///< `moderate`, and a segment, a point, a capsule or a sphere
  bool ball;          ///< `moderate`, and a point or a sphere
  double rounding;    ///< as given
};

/// Bounds of rounding, as multiples of lengths; derived in derivation.md, section 8.
inline constexpr double unit_roundoff_error = 0x1p-53;              ///< of one operation, relative
inline constexpr double unit_axis_error = 4 * unit_roundoff_error;  ///< of unit_axis, as a vector's length
inline constexpr double separation_error =
    16 * unit_roundoff_error;  ///< of f(D), times |D| (r0+h0/2+r1+h1/2+|Delta|)
inline constexpr double filter_error =
    64 * unit_roundoff_error;  ///< of s f at the five first directions, times the reach above
inline constexpr double point_error =
    2048 * unit_roundoff_error;                ///< of a point built in the first slice, times the same
inline constexpr double least_det = 0x1p-300;  ///< of the system for such a point: below, its square might
                                               ///< lose digits; solids not flat have 2^-200
inline constexpr double parallel_error =
    64 * unit_roundoff_error;  ///< of what is compared where both axes are one, times the same
inline constexpr double membership_error =
    16 * unit_roundoff_error;  ///< of a point's distances to axis and middle plane, times |x| + |Delta|
inline constexpr double underflow_error =
    0x1p-500;  ///< of the same distances, where squares vanish; relative to the pair's largest length

/// Checks the cylinder and brings its axis to unit length, whatever its length was. Call it once for each
/// solid: intersect() then costs a third as much. Never throws; the defect is in the result.
Prepared prepare(const Cylinder& c) noexcept;

/// Which certificate an answer carries.
enum class Proof : unsigned char { none, direction, point, points };

/// A verdict with its certificate, in the frame and unit of the cylinders. Unused fields are 0.
struct Answer {
  Verdict verdict = Verdict::undecided;
  Proof proof = Proof::none;
  /// proof == direction: D with f(D) < 0 and D.(b.center - a.center) > 0, of any length.
  /// proof == point: p = point_head + point_tail (the exact sum; head is the centre of a or of b). The common
  /// point is p or, if a hull is not `space`, the point of both hulls that is nearest to p. It lies in both
  /// solids without their rounding.
  /// proof == points: a.center + point_head lies in a and b.center + point_tail in b, both without their
  /// rounding, and they are no farther apart than a.rounding + b.rounding. If a hull is not `space`, take the
  /// point of that hull nearest to it instead.
  Vector3 direction{0, 0, 0};
  Vector3 point_head{0, 0, 0};
  Vector3 point_tail{0, 0, 0};
  Hull hull_a = Hull::space, hull_b = Hull::space;
  int iterations = 0;  ///< steps inside an edge, at most decide_iteration_cap
};

/// Yes or no, without proof, computed in doubles: `disjoint`, `intersecting` (touching included),
/// `invalid`, or `undecided` at the work cap. Right if |margin| >= 1e-13. Symmetric in its arguments
/// bit for bit. Cost: about 90 operations; if they do not decide, three roots and two divisions more; for a
/// wall against a rim, on average two steps of two roots and three divisions.
Verdict intersect(const Prepared& a, const Prepared& b) noexcept;
Verdict intersect(const Cylinder& a, const Cylinder& b) noexcept;

/// The same decision with its proof: `disjoint` with a direction or `intersecting` with a point, each beyond
/// the rounding bound, else `undecided` (or `invalid`). Never wrong. With t = 1e-13 (r0 + h0 + r1 + h1 and
/// the roundings), a gap is undecided only below t, and an overlap only if no ball of radius t lies in both
/// solids. If one is flat (no thicker than t), a disk or segment of radius t replaces the ball. If both are
/// flat, there is no promise for two segments, for a point, and for planes, or a plane and a line, that cross
/// at a small angle. Cost: three times that of intersect(), twice if the axes are parallel; within 1e-11 of
/// touching and beside flat solids up to 0.3 ms, of rounded solids with tiny cores 0.5 ms.
Answer decide(const Prepared& a, const Prepared& b) noexcept;
Answer decide(const Cylinder& a, const Cylinder& b) noexcept;

/// Whether the solids come within a clearance of each other: the answer of intersect() or decide() after the
/// clearance is added to one rounding. A clearance that is negative or not finite, alone or with the
/// roundings, is `invalid`. Cost: as theirs.
Verdict within(const Prepared& a, const Prepared& b, double clearance) noexcept;
Answer decide_within(const Prepared& a, const Prepared& b, double clearance) noexcept;

}  // namespace cyl
