// SPDX-License-Identifier: MIT
// Checking certificates: is f(D) < 0, does a point lie in both solids? Three arithmetics, cheapest first;
// each answer "yes" is a proof. Nothing here searches.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>

#include "corpus/pairs/certificate.hpp"
#include "oracles/referee/interval.hpp"
#include "oracles/referee/vec3.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

using Rational3 = Vec3<mpq_class>;

/// Of a and of b: what a point is said to lie in. A flat solid's own, its disk's plane or its segment's line,
/// counts whatever is said here.
using Hulls = std::array<Hull, 2>;

/// The filter, in intervals of R: double, or long double where that has more digits. Brings the pair to a
/// unit near 1 by powers of two, exactly; where that is not exact (lengths more than about 2^1000 apart) the
/// filter is not usable and proves nothing. Cost in double: about 0.1 us to set up, 0.1 us a check; in long
/// double ten times that.
template <class R>
class BasicFilter {
 public:
  explicit BasicFilter(const Pair& pair);
  /// The scene's unit is 2^exponent of the filter's.
  int exponent() const { return exponent_; }
  using I = BasicInterval<R>;
  /// Unit axes, and b's centre relative to a's in the filter's unit.
  const Vec3<I>& axis_of_a() const { return a_.unit_axis; }
  const Vec3<I>& axis_of_b() const { return b_.unit_axis; }
  const Vec3<I>& delta() const { return delta_; }
  /// Encloses f(direction) of the solids in the filter's unit; everything where the filter is not usable.
  I support_gap(const Vec3<I>& direction) const;
  /// f(direction) < 0 for certain.
  bool separates(const double direction[3]) const;
  bool separates(const Vec3<R>& direction) const;
  /// head + tail, exactly, is in both cores for certain.
  bool in_both(const double head[3], const double tail[3]) const;
  /// Whether the solids meet for certain, and more than touch, at the point of the hulls nearest to the guess
  /// (relative to a's centre, in the filter's unit): strictly inside one with inner points, or where two flat
  /// ones cross strictly inside both.
  bool overlap_at(const Vec3<R>& guess, const Hulls& hulls = {}) const;
  /// The same near head + tail, in the scene's frame and unit.
  bool overlap_at(const double head[3], const double tail[3], const Hulls& hulls) const;
  /// For certain the point of a's hull nearest to the first vector is in a's core, that of b's hull nearest
  /// to the second in b's, and they are no farther apart than both roundings together.
  bool come_near(const ExactVector& on_a, const ExactVector& on_b, const Hulls& hulls) const;
  /// The same near points relative to either's centre, in the filter's unit.
  bool come_near(const Vec3<R>& on_a, const Vec3<R>& on_b) const;

 private:
  struct Solid {
    Vec3<R> center;  // in the filter's unit
    Vec3<I> unit_axis;
    R radius, height;
    Hull hull;
  };
  bool close_at(const Vec3<I>& from_a, const Vec3<I>& from_b, const Hulls& hulls) const;
  bool overlap_near(Vec3<I> guess, const Hulls& hulls) const;
  static Vec3<I> moved(const Solid& s, Hull hull, const Vec3<I>& from);
  bool usable_ = false;
  int exponent_ = 0;
  Solid a_, b_;
  Vec3<I> delta_;
  I room_;  // both roundings together
};

using Filter = BasicFilter<double>;
using LongFilter = BasicFilter<long double>;

/// The sign of f(direction), direction not 0, in MPFI at the given precision; 0 where that does not tell.
int support_gap_sign(const Pair& pair, const Rational3& direction, int bits);

/// f(direction) < 0 for certain, in MPFI at the given precision.
bool separates_in_multiprecision(const Pair& pair, const Rational3& direction, int bits);

/// Whether the point is in both cores, decided exactly.
bool in_both_exact(const Pair& pair, const Rational3& point);

/// Whether the point, one of both cores, shows that the solids overlap and do not only touch: one is rounded,
/// or it is strictly inside one of them, or two flat ones cross there strictly inside both. Decided exactly.
bool overlap_at(const Pair& pair, const Rational3& point);

/// The point of the hulls nearest to the one given, exactly; nothing where the hulls do not meet.
std::optional<Rational3> project_to_hulls(const Pair& pair, const Rational3& point, const Hulls& hulls = {});

/// The point of the solid's own hull and of the one given that is nearest to the point given, exactly.
Rational3 project_to_hull(const Cylinder& c, const Rational3& point, Hull hull = Hull::space);

/// Whether the first point is in a's core, the second in b's; decided exactly.
bool in_each_exact(const Pair& pair, const Rational3& on_a, const Rational3& on_b);

/// a.rounding + b.rounding.
mpq_class contact_distance_of(const Pair& pair);

Rational3 exact(const Vector3& v);
/// Each coordinate between two neighbouring doubles, or so.
Vec3<Interval> enclosed(const Rational3& v);
Rational3 exact(const ExactVector& v);

}  // namespace cyl
