// SPDX-License-Identifier: MIT
// The decision: do two solids intersect? Nothing here prints, throws, allocates, aborts or keeps state.
// The mathematics, in the symbols of the code: derivation.md, rounded.md and boxes.md.
#pragma once

#include "solver/detail/iteration_cap.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// A solid checked and brought to working form once, for use in many pairs. Make it with prepare().
struct Prepared {
  Vector3 center;     ///< as given
  Vector3 unit_axis;  ///< along the axis, first non-zero coordinate positive; within unit_axis_error of
                      ///< exact. It is the outward normal of a half-space, and the first edge of a box
  double radius;      ///< as given
  double height;      ///< as given
  Defect defect;      ///< if not `none`, every call returns `invalid`
  /// Bits, because compilers make two branches of a test of two bools.
  enum Trait : unsigned char {
    ordinary = 1,  ///< `moderate` and not rounded
    moderate = 2,  ///< each number is 0 or so close to 1 that no product in a decision over- or underflows
    thin = 4,      ///< `moderate`, and a segment, a point, a capsule or a sphere
    ball = 8       ///< `moderate`, and a point or a sphere
  };
  unsigned char traits;
  Shape shape;                   ///< if not a cylinder, it has no trait but `moderate`
  double rounding;               ///< as given
  Vector3 second_axis{0, 0, 0};  ///< the second edge of a box, or a positive multiple of the normal, exactly
  Vector3 edges{0, 0, 0};        ///< of a box: as given
};

/// Bounds of rounding errors, derived in derivation.md, section 8. Most are relative to the reach of the
/// pair, r0 + h0/2 + r1 + h1/2 + |Delta|. Delta is the vector between the centres. s is the sine of the angle
/// of the axes. f(D) is |D| times the overlap of both projections on D (derivation.md). If
/// f(D) < 0, D separates the solids.
inline constexpr double unit_roundoff_error = 0x1p-53;  ///< of one operation, relative to its result
inline constexpr double unit_axis_error =
    4 * unit_roundoff_error;  ///< of unit_axis: the length of the difference
inline constexpr double separation_error =
    16 * unit_roundoff_error;  ///< of f(D), relative to |D| times the reach
inline constexpr double filter_error =
    64 * unit_roundoff_error;  ///< of s f(D) for the five directions tried first, relative to the reach
inline constexpr double point_error =
    2048 * unit_roundoff_error;                ///< of the first common point, relative to the reach
inline constexpr double least_det = 0x1p-300;  ///< least determinant for a common point, so
                                               ///< that its square keeps its digits
inline constexpr double parallel_error =
    64 * unit_roundoff_error;  ///< of the gaps along and across parallel axes, relative to the reach
inline constexpr double membership_error =
    16 * unit_roundoff_error;  ///< of the distances of a point to axis and middle plane, relative to
                               ///< |Delta| plus its distance from the first centre
inline constexpr double underflow_error =
    0x1p-500;  ///< of the same distances if squares underflow, relative to the largest length

/// Checks the solid and normalises its axis or quaternion of any length. Call it once for each solid:
/// intersect() then costs a third as much. Never throws; the defect is in the result.
Prepared prepare(const Solid& c) noexcept;

/// Which certificate an answer carries.
enum class Proof : unsigned char { none, direction, point, points };

/// A verdict with its certificate, in the frame and unit of the cylinders. Unused fields are 0.
struct Answer {
  Verdict verdict = Verdict::undecided;
  Proof proof = Proof::none;
  /// The certificate, by `proof`:
  /// * direction: D with f(D) < 0 and D.(b.center - a.center) > 0, of any length.
  /// * point: let p = point_head + point_tail, exactly. The head is the centre of a or of b. If both hulls
  ///   (solid.hpp) are `space`, the common point is p. Otherwise the common point is the point of both
  ///   hulls that is nearest to p. It lies in both cores. A core is the solid without its rounding.
  /// * points: a.center + point_head lies in the core of a, and b.center + point_tail in the core of b. Their
  ///   distance is at most a.rounding + b.rounding. If hull_a is not `space`, replace the point of a by the
  ///   point of hull_a that is nearest to it. The same holds for b.
  Vector3 direction{0, 0, 0};
  Vector3 point_head{0, 0, 0};
  Vector3 point_tail{0, 0, 0};
  Hull hull_a = Hull::space, hull_b = Hull::space;
  int iterations = 0;  ///< of the search along an edge, at most decide_iteration_cap
};

/// Yes or no, without proof, computed in doubles: `disjoint`, `intersecting` (touching included),
/// `invalid`, or `undecided` at the limit of iterations. Right if |margin| >= 1e-13. Symmetric in its
/// arguments bit for bit. Cost: about 90 operations in most cases. The other cases add three roots and two
/// divisions. If a side meets a rim, they also add two steps on average, each of two roots and three
/// divisions.
/// With a box or a half-space it is right for the same margins. Two half-spaces are `invalid`. A sphere takes
/// 20 operations beside a half-space and 40 beside a box. Most pairs of a capsule and a box take 110. Two
/// boxes take 175, or 290 if no normal decides. docs/bench.md has the times of all pairs of shapes.
Verdict intersect(const Prepared& a, const Prepared& b) noexcept;
Verdict intersect(const Solid& a, const Solid& b) noexcept;

/// The same decision with its proof: `disjoint` with a direction, or `intersecting` with a point. The proved
/// gap or overlap exceeds the bound of the rounding errors. Otherwise the verdict is `undecided` (or
/// `invalid`). A verdict is never wrong. Let t = 1e-13 (r0 + h0 + r1 + h1 + a.rounding + b.rounding).
/// * Every gap of at least t is decided.
/// * Every overlap is decided if a ball of radius t lies in both solids. For a flat solid (no thicker than
///   t), a disk of radius t or a segment of length 2 t takes the ball's place.
/// * An overlap of two flat solids may stay undecided if both are segments, or if one is a point. The same
///   holds if a disk crosses a disk or a segment at a small angle.
/// * None of this holds for subnormal lengths.
/// * With a box or a half-space, an overlap may stay undecided if an edge of a box is below 2 t. The same
///   holds if a half-space and a rounded solid have in common less than 2e-15 of the distance of the centres.
///   It also holds if that distance overflows or is 1e400 sizes.
/// Cost: three times that of intersect(), twice if the axes are parallel. It takes up to 0.3 ms within 1e-11
/// of touching or for flat solids, and 0.5 ms for rounded solids with tiny cores.
Answer decide(const Prepared& a, const Prepared& b) noexcept;
Answer decide(const Solid& a, const Solid& b) noexcept;

/// Whether the solids come within a clearance of each other: the answer of intersect() or decide() after
/// `clearance` is added to the field `rounding` of one solid. The verdict is `invalid` if the clearance is
/// negative or not finite, or if its sum with both `rounding` fields is not finite. Same cost.
Verdict within(const Prepared& a, const Prepared& b, double clearance) noexcept;
Answer decide_within(const Prepared& a, const Prepared& b, double clearance) noexcept;

}  // namespace cyl
