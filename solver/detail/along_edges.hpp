// SPDX-License-Identifier: MIT
// Vectors along the edges of a box, two coordinates at a time, for the paths that most pairs take.
#pragma once

#include "solver/detail/both_solids.hpp"
#include "solver/detail/rounded_cores.hpp"

namespace cyl {

/// A vector along the edges.
struct Seen {
  Seen(Both first, double last) noexcept : xy(first), z(last) {}
  explicit Seen(const Vector3& x) noexcept : xy{x[0], x[1]}, z(x[2]) {}
  operator Vector3() const noexcept { return {xy[0], xy[1], z}; }
  Both xy;
  double z;
};
inline Seen operator+(Seen a, Seen b) noexcept { return {a.xy + b.xy, a.z + b.z}; }
inline Seen operator-(Seen a, Seen b) noexcept { return {a.xy - b.xy, a.z - b.z}; }
inline Seen operator*(double t, Seen a) noexcept { return {t * a.xy, t * a.z}; }
inline Seen magnitude(Seen a) noexcept { return {magnitude(a.xy), magnitude(a.z)}; }
inline double dot(Seen a, Seen b) noexcept {
  const Both products = a.xy * b.xy;
  return products[0] + products[1] + a.z * b.z;
}
inline Seen cross(Seen a, Seen b) noexcept {
  return {Both{a.xy[1], a.z} * Both{b.z, b.xy[0]} - Both{a.z, a.xy[0]} * Both{b.xy[1], b.z},
          a.xy[0] * b.xy[1] - a.xy[1] * b.xy[0]};
}
/// (a_y b_z + a_z b_y, a_z b_x + a_x b_z, a_x b_y + a_y b_x).
inline Seen crosswise(Seen a, Seen b) noexcept {
  return {Both{a.xy[1], a.z} * Both{b.z, b.xy[0]} + Both{a.z, a.xy[0]} * Both{b.xy[1], b.z},
          a.xy[0] * b.xy[1] + a.xy[1] * b.xy[0]};
}
inline Seen clamped(Seen x, Seen half) noexcept {
  const Both below = x.xy < half.xy ? x.xy : half.xy;
  return {below < -half.xy ? -half.xy : below, clamped(x.z, half.z)};
}
/// Bit i is coordinate i.
inline unsigned are_above(Seen a, Seen b) noexcept { return bits(a.xy > b.xy) | (a.z > b.z ? 4u : 0u); }

/// The edges of a box: their first coordinates, their second, and the last edge.
struct SeenFrom {
  explicit SeenFrom(const Prepared& box) noexcept
      : x{box.unit_axis.x(), box.second_axis.x()},
        y{box.unit_axis.y(), box.second_axis.y()},
        z{box.unit_axis.z(), box.second_axis.z()},
        last(box.unit_axis.cross(box.second_axis)) {}
  Seen operator()(const Vector3& v) const noexcept {
    return {v.x() * x + v.y() * y + v.z() * z, dot(v, last)};
  }
  /// From along the edges. No vector is read as two numbers just after it was written as single ones, because
  /// processors wait then.
  Vector3 world(const Prepared& box, Seen v) const noexcept {
    const Vector3 &e0 = box.unit_axis, &e1 = box.second_axis;
    const Both xy =
        v.xy[0] * Both{e0.x(), e0.y()} + v.xy[1] * Both{e1.x(), e1.y()} + v.z * Both{last.x(), last.y()};
    return {xy[0], xy[1], v.xy[0] * e0.z() + v.xy[1] * e1.z() + v.z * last.z()};
  }

  Both x, y, z;
  Vector3 last;
};

inline Seen half_of(const Prepared& box) noexcept {
  return {0.5 * Both{box.edges[0], box.edges[1]}, 0.5 * box.edges[2]};
}

}  // namespace cyl
