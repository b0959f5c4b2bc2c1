// SPDX-License-Identifier: MIT
// The support of a solid, and the point test, in numbers of any kind. A solid is the hull of two points and
// at most one disk, grown by a ball. The solver, the Python checker and the checker of the page have their
// own, because their use is to be independent.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/vec3.hpp"
#include "solver/solid.hpp"

namespace cyl {

template <class R>
R square(const R& x) {
  return x * x;
}

/// The length of a vector whose square does not overflow.
template <class R>
R norm(const Vec3<R>& v) {
  using std::sqrt;
  return R(sqrt(square(v.x) + square(v.y) + square(v.z)));
}

template <class R, class V>
Vec3<R> lifted(const V& v) {
  return {R(v[0]), R(v[1]), R(v[2])};
}

/// A solid about its centre, in numbers of kind R: double, long double, an interval, MpFloat or MpInterval.
template <class R>
struct Terms {
  Vec3<R> axis{};  ///< of length 1
  R radius{}, half{}, rounding{};
  bool rounded = false;  ///< rounding != 0; a term that is 0 would widen an interval
};

template <class R>
Terms<R> terms_of(const Solid& c) {
  Vec3<R> w = lifted<R>(c.axis);
  // The squares of all other kinds of numbers neither overflow nor vanish.
  if constexpr (std::is_same_v<R, double>) {
    const int exponent = std::ilogb(std::max({std::fabs(w.x), std::fabs(w.y), std::fabs(w.z)}));
    w = {std::scalbn(w.x, -exponent), std::scalbn(w.y, -exponent), std::scalbn(w.z, -exponent)};
  }
  return {w / norm(w), R(c.radius), R(c.height) / R(2), R(c.rounding), c.rounding != 0};
}

/// The greatest d.x of the core, relative to its centre.
template <class R>
R core_support(const Terms<R>& s, const Vec3<R>& d) {
  using std::abs;
  return s.radius * norm(cross(d, s.axis)) + s.half * R(abs(dot(d, s.axis)));
}
/// The greatest d.x of the solid, relative to its centre.
template <class R>
R support(const Terms<R>& s, const Vec3<R>& d) {
  return core_support(s, d) + s.rounding * norm(d);
}

/// A point of the core, relative to its centre, that is farthest along d: the middle of a cap or side. Near
/// the axis the difference has lost digits, so it is made square to the axis again. If nearly all were lost,
/// the middle of the cap serves.
template <class R>
Vec3<R> farthest(const Terms<R>& s, const Vec3<R>& d) {
  const R along = dot(d, s.axis), zero(0.0);
  const R end = along < zero ? R(zero - s.half) : along > zero ? s.half : zero;
  const Vec3<R> across = d - along * s.axis;
  const R beside = norm(across);
  if (!(beside > zero)) return end * s.axis;
  Vec3<R> out = across / beside;
  out = out - R(dot(out, s.axis)) * s.axis;
  const R kept = norm(out);
  return kept > R(0.5) ? end * s.axis + R(s.radius / kept) * out : end * s.axis;
}

/// f(d) of two solids whose centres differ by `delta`. It is negative if a plane square to d separates them.
template <class R>
R support_gap(const Terms<R>& a, const Terms<R>& b, const Vec3<R>& delta, const Vec3<R>& d) {
  using std::abs;
  R cores = core_support(a, d) + core_support(b, d) - R(abs(dot(d, delta)));
  if (!a.rounded && !b.rounded) return cores;
  return cores + (a.rounding + b.rounding) * norm(d);
}

/// How far a point is beyond the planes of the caps and beyond the wall of the core; negative within.
template <class R>
struct Beyond {
  R caps, wall;
};
template <class R>
Beyond<R> beyond(const Terms<R>& s, const Vec3<R>& from_center) {
  using std::abs;
  return {R(abs(dot(from_center, s.axis))) - s.half, norm(cross(from_center, s.axis)) - s.radius};
}

}  // namespace cyl
