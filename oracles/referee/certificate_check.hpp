// SPDX-License-Identifier: MIT
// Checks of certificates: is f(D) < 0, does a point lie in both solids? There are three arithmetics, the
// cheapest first. Each answer "yes" is a proof. Nothing here searches.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>

#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/support.hpp"
#include "oracles/referee/interval.hpp"
#include "oracles/referee/twin_interval.hpp"
#include "solver/solid.hpp"

namespace cyl {

using Rational3 = Vec3<mpq_class>;
inline bool is_zero(const Rational3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// The hulls that the caller requires to contain the point, one for each solid. The own hull of a flat solid
/// is always required too: the plane of a disk, the line of a segment, or the point. A box
/// requires the hull of its edges that are not 0, and no other.
using Hulls = std::array<Hull, 2>;
// A Hull is a set of coordinates that are 0 in it: bit 1 along the axis, bit 2 across it.
static_assert(static_cast<int>(Hull::plane) == 1 && static_cast<int>(Hull::line) == 2 &&
              static_cast<int>(Hull::center) == 3);
inline bool level(Hull hull) { return (static_cast<int>(hull) & 1) != 0; }
inline bool thin(Hull hull) { return (static_cast<int>(hull) & 2) != 0; }
inline Hull both(Hull x, Hull y) { return static_cast<Hull>(static_cast<int>(x) | static_cast<int>(y)); }

/// A flat box has the hull of a disk, segment or point.
Hull own_hull(const Solid& c);

/// The own hull and the named one. The hull that an answer names for a box counts for nothing.
Hull hull_within(const Solid& c, Hull named);

/// The edge that gives the direction of a flat box's hull: its only edge that is 0, or is not 0.
std::size_t hull_edge(const Solid& box);

/// The normal of the hull if that is a plane, its direction if it is a line.
Rational3 hull_axis(const Solid& c);

/// The filter, in intervals of doubles or of two doubles. It scales the pair by a power of two, so that its
/// largest length is about 1. If scaling is inexact (the lengths differ by a factor of about 2^1000), the
/// filter is not usable and proves nothing. Cost in doubles: about 0.1 us to set up, 0.1 us a check. In two
/// doubles: ten times that.
template <class I>
class BasicFilter {
 public:
  explicit BasicFilter(const Pair& pair);
  struct Lifted : Terms<I> {  ///< in the filter's unit; the axis of a half-space is its normal
    Vec3<double> center;
    Hull hull;
    bool plane;  ///< is a half-space
    /// The hull and the one that an answer names.
    Hull within(Hull named) const { return this->box ? hull : both(hull, named); }
    /// Whether the point, relative to the centre, is certainly in the core. It lies in the hull.
    bool holds(Hull of, const Vec3<I>& at, bool strictly = false) const;
    Vec3<I> moved(Hull into, const Vec3<I>& from) const;
  };
  bool usable() const { return usable_; }
  const Lifted& a() const { return a_; }
  const Lifted& b() const { return b_; }
  /// One unit of the filter is 2^exponent units of the scene.
  int exponent() const { return exponent_; }
  /// b's centre relative to a's, in the filter's unit.
  const Vec3<I>& delta() const { return delta_; }
  /// Encloses f(direction) of the solids in the filter's unit. Returns everything if the filter is not
  /// usable or a solid is a half-space.
  I support_gap(const Vec3<I>& direction) const;
  /// Returns true if f(direction) < 0 is certain.
  bool separates(const double direction[3]) const;
  bool separates(const Vec3<I>& direction) const;
  /// Returns true if it is certain that head + tail, exactly, is in both cores.
  bool in_both(const double head[3], const double tail[3]) const;
  /// Returns whether the solids certainly overlap at the point of the hulls nearest to head + tail. They
  /// overlap if the point is strictly inside a solid that is not flat, or if two flat ones cross strictly
  /// inside both.
  bool overlap_at(const double head[3], const double tail[3], const Hulls& hulls) const;
  /// The same near a point that is relative to a's centre, in the filter's unit.
  bool overlap_at(Vec3<I> guess, const Hulls& hulls = {}) const;
  /// Returns true if three facts are certain.
  /// 1. The point of a's hull nearest to the first vector is in a's core.
  /// 2. The point of b's hull nearest to the second vector is in b's core.
  /// 3. Their distance is at most the sum of both roundings.
  bool come_near(const ExactVector& on_a, const ExactVector& on_b, const Hulls& hulls) const;
  /// The same, but each vector is relative to the centre of its own solid, in the filter's unit.
  bool come_near(const Vec3<I>& on_a, const Vec3<I>& on_b, const Hulls& hulls = {}) const;

 private:
  /// Returns nothing if the filter's unit makes a number inexact.
  std::optional<Vec3<I>> from_center(const Lifted& s, const double head[3], const double tail[3]) const;
  bool usable_ = false;
  int exponent_ = 0;
  Lifted a_, b_;
  Vec3<I> delta_;
};
using Filter = BasicFilter<Interval>;
using TwinFilter = BasicFilter<TwinInterval>;

/// Returns the sign of f(direction) in MPFI at the given precision, for a direction other than 0. Returns 0
/// if the interval contains 0.
int support_gap_sign(const Pair& pair, const Rational3& direction, int bits);

/// Returns true if f(direction) < 0 is certain, in MPFI at the given precision.
bool separates_in_multiprecision(const Pair& pair, const Rational3& direction, int bits);

/// Returns whether the point is in both cores, decided exactly.
bool in_both_exact(const Pair& pair, const Rational3& point);

/// Returns whether the point, which lies in both cores, shows that the solids overlap and do not only touch.
/// It does if a solid is rounded, if it is strictly inside one, or if two flat solids cross there strictly
/// inside both. Decided exactly.
bool overlap_at(const Pair& pair, const Rational3& point);

/// Returns the point of the hulls nearest to the one given, exactly. Returns nothing if the hulls have no
/// common point.
std::optional<Rational3> project_to_hulls(const Pair& pair, const Rational3& point, const Hulls& hulls = {});

/// Returns the point of the solid's own hull and of `hull` that is nearest to the given point, exactly.
Rational3 project_to_hull(const Solid& c, const Rational3& point, Hull hull = Hull::space);

/// Returns whether the first point is in a's core and the second in b's, decided exactly.
bool in_each_exact(const Pair& pair, const Rational3& on_a, const Rational3& on_b);

/// a.rounding + b.rounding.
mpq_class contact_distance_of(const Pair& pair);

Rational3 exact(const Vector3& v);
/// Encloses each coordinate as narrowly as the kind of interval allows.
template <class I>
Vec3<I> enclosed(const Rational3& v);
Rational3 exact(const ExactVector& v);

}  // namespace cyl
