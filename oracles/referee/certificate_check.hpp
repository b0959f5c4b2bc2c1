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
#include "solver/solid.hpp"

namespace cyl {

using Rational3 = Vec3<mpq_class>;

/// The hulls that the caller requires to contain the point, one for each solid. The own hull of a flat solid
/// is always required too: the plane of a disk, the line of a segment, or the point. A box
/// requires the hull of its edges that are not 0, and no other.
using Hulls = std::array<Hull, 2>;

/// The filter, in intervals of doubles. It scales the pair by a power of two, so that its largest length is
/// about 1. If scaling is inexact (the lengths differ by a factor of about 2^1000), the filter is not usable
/// and proves nothing. Cost: about 0.1 us to set up, 0.1 us a check.
class Filter {
 public:
  explicit Filter(const Pair& pair);
  /// One unit of the filter is 2^exponent units of the scene.
  int exponent() const { return exponent_; }
  /// Unit axes, and b's centre relative to a's in the filter's unit.
  const Vec3<Interval>& axis_of_a() const { return a_.axis; }
  const Vec3<Interval>& axis_of_b() const { return b_.axis; }
  const Vec3<Interval>& delta() const { return delta_; }
  /// Encloses f(direction) of the solids in the filter's unit. Returns everything if the filter is not
  /// usable.
  Interval support_gap(const Vec3<Interval>& direction) const;
  /// Returns true if f(direction) < 0 is certain.
  bool separates(const double direction[3]) const;
  bool separates(const Vec3<double>& direction) const;
  /// Returns true if it is certain that head + tail, exactly, is in both cores.
  bool in_both(const double head[3], const double tail[3]) const;
  /// Returns whether the solids certainly overlap at the point of the hulls nearest to the guess. The guess
  /// is relative to a's centre, in the filter's unit. They overlap if the point is strictly inside a solid
  /// that is not flat, or if two flat ones cross strictly inside both.
  bool overlap_at(const Vec3<double>& guess, const Hulls& hulls = {}) const;
  /// Like overlap_at() above, but the guess is head + tail, in the scene's frame and unit.
  bool overlap_at(const double head[3], const double tail[3], const Hulls& hulls) const;
  /// Returns true if three facts are certain.
  /// 1. The point of a's hull nearest to the first vector is in a's core.
  /// 2. The point of b's hull nearest to the second vector is in b's core.
  /// 3. Their distance is at most the sum of both roundings.
  bool come_near(const ExactVector& on_a, const ExactVector& on_b, const Hulls& hulls) const;
  /// Like come_near() above, but each vector is relative to the centre of its own solid, in the filter's
  /// unit.
  bool come_near(const Vec3<double>& on_a, const Vec3<double>& on_b) const;

 private:
  struct Lifted : Terms<Interval> {  // in the filter's unit
    Vec3<double> center;
    Hull hull;
    Hull within(Hull named) const;  ///< the hull and the one that an answer names
  };
  bool close_at(const Vec3<Interval>& from_a, const Vec3<Interval>& from_b, const Hulls& hulls) const;
  bool overlap_near(Vec3<Interval> guess, const Hulls& hulls) const;
  static bool is_in(const Lifted& s, Hull hull, const Vec3<Interval>& at);
  static bool is_strictly_in(const Lifted& s, Hull hull, const Vec3<Interval>& at);
  static Vec3<Interval> moved(const Lifted& s, Hull hull, const Vec3<Interval>& from);
  bool usable_ = false;
  int exponent_ = 0;
  Lifted a_, b_;
  Vec3<Interval> delta_;
};

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

/// Returns whether the core lies in a plane.
bool is_flat(const Solid& c);

/// Returns the point of the solid's own hull and of `hull` that is nearest to the given point, exactly.
Rational3 project_to_hull(const Solid& c, const Rational3& point, Hull hull = Hull::space);

/// Returns whether the first point is in a's core and the second in b's, decided exactly.
bool in_each_exact(const Pair& pair, const Rational3& on_a, const Rational3& on_b);

/// a.rounding + b.rounding.
mpq_class contact_distance_of(const Pair& pair);

Rational3 exact(const Vector3& v);
/// Encloses each coordinate between two doubles that are neighbours, or nearly so.
Vec3<Interval> enclosed(const Rational3& v);
Rational3 exact(const ExactVector& v);

}  // namespace cyl
