// SPDX-License-Identifier: MIT
#include "corpus/pairs/exact_pairs.hpp"

#include <cmath>
#include <utility>

namespace cyl {
namespace {

Vector3 lattice_axis(RandomStream& s) {
  if (s.coin()) return s.coordinate_axis();
  for (;;) {
    Vector3 w;
    for (int i = 0; i < 3; ++i) w[i] = s.integer(-2, 2);
    if (inner_product(w, w) != 0) return w;
  }
}

/// Returns n/64 from 1 to 4, so that the sums of some of them and their halves are exact.
double dyadic(RandomStream& s) { return s.integer(64, 256) / 64.0; }

/// Returns a coordinate vector square to another.
Vector3 beside(RandomStream& s, const Vector3& axis) {
  for (;;)
    if (const Vector3 v = s.coordinate_axis(); inner_product(v, axis) == 0) return v;
}

Pair two_points(RandomStream& s) {
  constexpr std::array<double, 6> units{0x1p-1074, 0x1p-1040, 0x1p-600, 0x1p300, 0x1p600, 0x1p1016};
  Pair p;
  const double unit = s.pick(units);
  for (int i = 0; i < 3; ++i) p.a.center[i] = s.integer(-254, 254) * unit;  // 256 units may be too many
  p.a.axis = s.unit_vector();
  p.b = p.a;
  if (s.coin()) p.b.center += unit * s.coordinate_axis();
  return p;
}

/// Their axes cross 2^1017 beyond the largest double.
Pair rods_beyond_the_largest(RandomStream& s) {
  constexpr double unit = 0x1p1016;
  Pair p;
  const Vector3 u = s.coordinate_axis(), v = beside(s, u);
  double side = 1;
  for (Solid* c : {&p.a, &p.b}) {
    const double aside = side * dyadic(s);
    c->axis = 4 * u - aside * v;
    c->center = 0x1.fcp1023 * u + (aside * unit) * v;  // 2^1024 less 2 units, 4 units from the crossing
    c->height = 2.5 * unit * length_of(c->axis);
    c->radius = s.coin() ? 0 : unit * dyadic(s) / 64;
    side = -1;
  }
  return p;
}

Pair far_apart(RandomStream& s) {
  Pair p;
  const Vector3 u = s.coordinate_axis();
  double side = 0x1p1022;
  for (Solid* c : {&p.a, &p.b}) {
    c->axis = s.unit_vector();
    c->radius = 0x1p1018 * dyadic(s);
    c->height = 0x1p1018 * dyadic(s);
    c->center = side * (2 + dyadic(s) / 4) * u;
    side = -side;
  }
  return p;
}

Pair of_the_smallest(RandomStream& s) {
  Pair p;
  for (Solid* c : {&p.a, &p.b}) {
    for (int i = 0; i < 3; ++i) c->center[i] = s.integer(-8, 8) * 0x1p-1074;
    c->axis = s.coin() ? s.coordinate_axis() : s.unit_vector();
    c->radius = s.integer(0, 8) * 0x1p-1074;
    c->height = s.integer(0, 16) * 0x1p-1074;
  }
  return p;
}

/// Returns the step from a's centre to b's at which the solids touch.
Vector3 touch_exactly(RandomStream& s, std::uint64_t kind, Pair& p) {
  Solid &a = p.a, &b = p.b;
  a.axis = s.coordinate_axis();
  const Vector3 u = a.axis, v = beside(s, u);
  b.axis = s.sign() * u;
  a.height = dyadic(s);
  b.height = dyadic(s);
  const double size = dyadic(s);
  switch (kind) {
    case 0:  // two segments on one line
      return (a.height + b.height) / 2 * u;
    case 1:  // a segment's end, or a place within
      b.height = 0;
      return a.height * (s.coin() ? 0.5 : 0.125) * u;
    case 2:  // a point on a rim, or a segment that goes on from there
      a.radius = size;
      if (s.coin()) {
        b.height = 0;
        b.axis = u + 2 * v + 3 * u.cross(v);
      }
      return a.radius * v + (a.height + b.height) / 2 * u;
    case 3:  // ends of tilted segments, half of length 5 size
      a.axis = 3 * v + 4 * u;
      b.axis = s.sign() * 3 * (s.coin() ? v : u.cross(v)) - 4 * u;
      a.height = b.height = 10 * size;
      return size * (a.axis - b.axis);
    default:  // cap on cap, one of them perhaps a disk
      a.radius = size;
      b.radius = dyadic(s);
      if (s.coin()) a.height = 0;
      return (a.height + b.height) / 2 * u + (s.coin() ? a.radius + b.radius : size / 2) * v;
  }
}

}  // namespace

Pair draw_on_lattice(RandomStream& s, std::uint64_t) {
  Pair p;
  for (Solid* c : {&p.a, &p.b}) {
    for (int i = 0; i < 3; ++i) c->center[i] = s.integer(-3, 3);
    c->axis = lattice_axis(s);
    c->radius = s.integer(1, 3);
    c->height = s.integer(1, 6);
  }
  return p;
}

Pair draw_beside_lattice(RandomStream& s, std::uint64_t index) {
  const double dust = dusts[index % dusts.size()];
  const std::uint64_t shapes = index / dusts.size() % 4;
  Pair p = draw_on_lattice(s, index);
  for (Solid* c : {&p.a, &p.b}) {
    const bool disk = shapes == 1 || (shapes == 3 && c == &p.a);
    const bool needle = shapes == 2 || (shapes == 3 && c == &p.b);
    c->radius = disk ? 4 : needle ? 0.125 : 1;
    c->height = disk ? 0.125 : needle ? 8 : 2;
  }
  const Vector3 w = p.b.axis;
  p.b.axis = w + dust * std::sqrt(inner_product(w, w)) * s.perpendicular(w);
  if (s.coin()) std::swap(p.a, p.b);
  return p;
}

Pair draw_range_end(RandomStream& s, std::uint64_t index) {
  switch (index % 4) {
    case 0:
      return two_points(s);
    case 1:
      return rods_beyond_the_largest(s);
    case 2:
      return far_apart(s);
    default:
      return of_the_smallest(s);
  }
}

Pair draw_whisker(RandomStream& s, std::uint64_t index) {
  constexpr std::array<double, 3> whiskers{0x1p-300, 0x1p-600, 0x1p-900};
  Pair p;
  const double whisker = s.pick(whiskers);
  if (index % 6 < 5) {
    const Vector3 step = touch_exactly(s, index % 6, p);
    p.a.center = whisker * s.coordinate_axis();
    p.b.center = step;
  } else {
    p.a.axis = s.coordinate_axis();
    p.b.axis = p.a.axis + (s.coin() ? 0x1p-52 : 0) * beside(s, p.a.axis);
    p.a.radius = dyadic(s);
    p.b.radius = dyadic(s);
    p.b.height = whisker;
    for (int i = 0; i < 3; ++i) p.a.center[i] = p.b.center[i] = s.sign() * dyadic(s);
  }
  if (s.coin()) std::swap(p.a, p.b);
  return p;
}

}  // namespace cyl
