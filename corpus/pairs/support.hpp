// SPDX-License-Identifier: MIT
// The support of a solid, and the point test, in numbers of any kind. A solid is the hull of two points and
// at most one disk, or a box, grown by a ball. The solver, the Python checker and the checker of the page
// have their own, because their use is to be independent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

/// The unit directions of a box's edges: the columns of the rotation of quaternion/|quaternion|. Exact in
/// rationals.
template <class R>
std::array<Vec3<R>, 3> edge_directions(const std::array<double, 4>& quaternion) {
  std::array<double, 4> q = quaternion;
  // The squares of all other kinds of numbers neither overflow nor vanish.
  if constexpr (std::is_same_v<R, double>) {
    const auto size = [](double x) { return std::fabs(x); };
    const int exponent = std::ilogb(std::ranges::max(q, {}, size));
    for (double& x : q) x = std::scalbn(x, -exponent);
  }
  const R w(q[0]), x(q[1]), y(q[2]), z(q[3]), two(2.0);
  const R ww(w * w), xx(x * x), yy(y * y), zz(z * z), wx(two * w * x), wy(two * w * y), wz(two * w * z),
      xy(two * x * y), xz(two * x * z), yz(two * y * z), n(ww + xx + yy + zz);
  return {Vec3<R>{R(R(ww + xx - yy - zz) / n), R(R(xy + wz) / n), R(R(xz - wy) / n)},
          Vec3<R>{R(R(xy - wz) / n), R(R(ww - xx + yy - zz) / n), R(R(yz + wx) / n)},
          Vec3<R>{R(R(xz + wy) / n), R(R(yz - wx) / n), R(R(ww - xx - yy + zz) / n)}};
}

/// A solid about its centre, in numbers of kind R: double, Twin, an interval, MpFloat or MpInterval.
template <class R>
struct Terms {
  Vec3<R> axis{};  ///< of length 1
  R radius{}, half{}, rounding{};
  bool rounded = false;            ///< rounding != 0; a term that is 0 would widen an interval
  bool box = false;                ///< the core is given by edges and halves, else by axis, radius and half
  std::array<Vec3<R>, 3> edges{};  ///< of length 1
  std::array<R, 3> halves{};       ///< half the lengths of the edges
};

template <class R>
Terms<R> terms_of(const Solid& c) {
  Terms<R> s;
  s.rounding = R(c.rounding);
  s.rounded = c.rounding != 0;
  s.box = c.shape == Shape::box;
  if (s.box) {
    s.edges = edge_directions<R>(c.quaternion);
    for (std::size_t i = 0; i < 3; ++i) s.halves[i] = R(c.edges[i]) / R(2.0);
    return s;
  }
  Vec3<R> w = lifted<R>(c.axis);
  if constexpr (std::is_same_v<R, double>) {
    const int exponent = std::ilogb(std::max({std::fabs(w.x), std::fabs(w.y), std::fabs(w.z)}));
    w = {std::scalbn(w.x, -exponent), std::scalbn(w.y, -exponent), std::scalbn(w.z, -exponent)};
  }
  s.axis = w / norm(w);
  s.radius = R(c.radius);
  s.half = R(c.height) / R(2.0);
  return s;
}

/// The greatest d.x of the core, relative to its centre.
template <class R>
R core_support(const Terms<R>& s, const Vec3<R>& d) {
  using std::abs;
  if (s.box)
    return s.halves[0] * R(abs(dot(d, s.edges[0]))) + s.halves[1] * R(abs(dot(d, s.edges[1]))) +
           s.halves[2] * R(abs(dot(d, s.edges[2])));
  return s.radius * norm(cross(d, s.axis)) + s.half * R(abs(dot(d, s.axis)));
}
/// The greatest d.x of the solid, relative to its centre.
template <class R>
R support(const Terms<R>& s, const Vec3<R>& d) {
  return core_support(s, d) + s.rounding * norm(d);
}

/// A point of the core, relative to its centre, that is farthest along d: the middle of a cap, side, facet or
/// edge. Near an axis the difference has lost digits, so it is made square to the axis again. If nearly all
/// were lost, the middle of the cap serves.
template <class R>
Vec3<R> farthest(const Terms<R>& s, const Vec3<R>& d) {
  const R zero(0.0);
  const auto end_along = [&](const Vec3<R>& axis, const R& half) {
    const R along = dot(d, axis);
    return along < zero ? R(zero - half) : along > zero ? half : zero;
  };
  if (s.box)
    return end_along(s.edges[0], s.halves[0]) * s.edges[0] + end_along(s.edges[1], s.halves[1]) * s.edges[1] +
           end_along(s.edges[2], s.halves[2]) * s.edges[2];
  const R along = dot(d, s.axis), end = end_along(s.axis, s.half);
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

/// How far a point is beyond the planes of the caps and beyond the wall of the core; negative within. For a
/// box, both are the most that it is beyond a facet.
template <class R>
struct Beyond {
  R caps, wall;
};
template <class R>
Beyond<R> beyond(const Terms<R>& s, const Vec3<R>& from_center) {
  using std::abs;
  if (s.box) {
    R most = R(abs(dot(from_center, s.edges[0]))) - s.halves[0];
    for (std::size_t i = 1; i < 3; ++i)
      if (const R by = R(abs(dot(from_center, s.edges[i]))) - s.halves[i]; by > most) most = by;
    return {most, most};
  }
  return {R(abs(dot(from_center, s.axis))) - s.half, norm(cross(from_center, s.axis)) - s.radius};
}

}  // namespace cyl
