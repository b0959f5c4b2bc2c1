// SPDX-License-Identifier: MIT
#include "corpus/pairs/touch_plane.hpp"

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"

namespace cyl {
namespace {

constexpr Eigen::Index index_of(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// Turns the box so that its own directions `out` and `along`, square to each other, become n and u.
void turn_to(Solid& box, const Vector3& out, const Vector3& along, const Vector3& n, const Vector3& u) {
  const Vector3 third = out.cross(along), w = n.cross(u);
  std::array<Vector3, 3> columns;
  for (Eigen::Index i = 0; i < 3; ++i)
    columns[static_cast<std::size_t>(i)] = (out[i] * n + along[i] * u) + third[i] * w;
  box.quaternion = quaternion_of(columns);
}

// All coordinates of `out` in the box's frame that are not 0 are at least 0.2. So the contact is a vertex, an
// edge or a facet with room for roundings.
Vector3 touch_with_box(Solid& box, TouchPart part, const Vector3& n, const Vector3& u,
                       const TouchPlace& place, RandomStream& s) {
  constexpr double least = 0.3;
  const std::size_t i = s.below(3), j = (i + 1) % 3, k = (i + 2) % 3;
  Vector3 out(0, 0, 0), along(0, 0, 0);
  out[index_of(i)] = s.sign() * s.between(least, 1);
  along[index_of(k)] = s.sign();
  if (part != TouchPart::face) out[index_of(j)] = s.sign() * s.between(least, 1);
  if (part == TouchPart::point) {
    out[index_of(k)] = s.sign() * s.between(least, 1);
    along = out.cross(along);
  }
  turn_to(box, normalise(out), normalise(along), n, u);
  Vector3 contact(0, 0, 0);
  for (const std::size_t e : {i, j, k}) {
    const double part_of = e == k ? place.along : place.across, towards = out[index_of(e)];
    const double half = box.edges[e] / 2;
    contact += half * (towards == 0 ? part_of : towards < 0 ? -1 : 1) * edge_direction(box, e);
  }
  return contact;
}

}  // namespace

std::array<TouchPart, 2> parts_of(ContactFeature feature) {
  using enum TouchPart;
  switch (feature) {
    case ContactFeature::side_rim:
      return {line, point};
    case ContactFeature::rim_rim:
      return {point, point};
    case ContactFeature::cap_side:
      return {face, line};
    case ContactFeature::cap_rim:
      return {face, point};
    case ContactFeature::cap_cap:
      return {face, face};
    default:
      return {line, line};
  }
}

// Each element of the symmetric matrix q q^T, times 4 over |q|^2, is a sum of elements of the rotation. A row
// with a large diagonal element is q at some length.
std::array<double, 4> quaternion_of(const std::array<Vector3, 3>& c) {
  const double x = c[0][0], y = c[1][1], z = c[2][2];
  const double wx = c[1][2] - c[2][1], wy = c[2][0] - c[0][2], wz = c[0][1] - c[1][0];
  const double xy = c[0][1] + c[1][0], xz = c[2][0] + c[0][2], yz = c[1][2] + c[2][1];
  if (x + y + z > 0) return {1 + x + y + z, wx, wy, wz};
  if (x >= y && x >= z) return {wx, 1 + x - y - z, xy, xz};
  if (y >= z) return {wy, xy, 1 - x + y - z, yz};
  return {wz, xz, yz, 1 - x - y + z};
}

std::array<double, 4> draw_quaternion(RandomStream& s) {
  for (;;) {
    std::array<double, 4> q;
    double square = 0;
    for (double& x : q) {
      x = s.between(-1, 1);
      square += x * x;
    }
    if (square <= 1 && square >= 1e-2) return q;
  }
}

Solid image(const Solid& c, const Eigen::Vector3i& order, const Vector3& signs) {
  const bool even = order == Eigen::Vector3i(0, 1, 2) || order == Eigen::Vector3i(1, 2, 0) ||
                    order == Eigen::Vector3i(2, 0, 1);
  const double determinant = signs.prod() * (even ? 1 : -1);
  Solid other = c;
  other.center = Vector3(c.center(order)).cwiseProduct(signs);
  if (!is_box(c)) {
    other.axis = Vector3(c.axis(order)).cwiseProduct(signs);
    return other;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto to = static_cast<Eigen::Index>(i);
    const auto from = static_cast<std::size_t>(order[to]);
    other.edges[i] = c.edges[from];
    other.quaternion[i + 1] = determinant * signs[to] * c.quaternion[from + 1];
  }
  return other;
}

Vector3 edge_direction(const Solid& box, std::size_t edge) {
  const Vec3<double> e = edge_directions<double>(box.quaternion)[edge];
  return {e.x, e.y, e.z};
}

void lay_along(Solid& c, const Vector3& along, RandomStream& s) {
  if (!is_box(c)) {
    c.axis = s.sign() * along;
    return;
  }
  Vector3 edge(0, 0, 0), next(0, 0, 0);
  const std::size_t i = s.below(3);
  edge[index_of(i)] = s.sign();
  next[index_of((i + 1) % 3)] = 1;
  turn_to(c, edge, next, along, s.perpendicular(along));
}

Vector3 touch_plane(Solid& c, TouchPart part, const Vector3& n, const Vector3& u, const TouchPlace& place,
                    RandomStream& s) {
  if (is_box(c)) return touch_with_box(c, part, n, u, place, s);
  const Vector3 w = n.cross(u);
  if (is_half_space(c)) {
    c.axis = n;
    return 2 * place.along * u + 2 * place.across * w;
  }
  const double half = c.height / 2;
  if (part == TouchPart::line || (part == TouchPart::face && c.radius == 0)) {
    c.axis = s.sign() * u;
    return c.radius * n + place.along * half * u;
  }
  if (part == TouchPart::face) {
    c.axis = s.sign() * n;
    return half * n + place.along * c.radius * u;
  }
  const double along = s.between(0.3, 1), across = s.between(0.3, 1);
  const Vector3 towards = normalise(along * n + across * w), radial = normalise(across * n - along * w);
  c.axis = s.sign() * towards;
  return half * towards + c.radius * radial;
}

Vector3 touch_inside(Solid& c, TouchPart part, const Vector3& n, const Vector3& v, RandomStream& s) {
  const double half = c.height / 2;
  if (part == TouchPart::line) {
    c.axis = n.cross(v);
    return c.radius * n + s.between(-inside_part, inside_part) * half * c.axis;
  }
  c.axis = s.sign() * n;
  return half * n + s.between(0, inside_part) * c.radius * v;
}

Pair in_any_order(const Pair& p, RandomStream& s) { return s.coin() ? p : Pair{p.b, p.a}; }

double draw_decade(RandomStream& s, std::size_t first, std::size_t last) {
  return tenths[first + s.below(last - first + 1)];
}

void draw_center(Solid& c, RandomStream& s) {
  for (int i = 0; i < 3; ++i) c.center[i] = s.coin() ? 0 : s.between(-1, 1);
}

ContactFrame draw_frame(RandomStream& s) {
  if (s.below(4) != 0) {
    const Vector3 n = s.unit_vector();
    return {n, s.perpendicular(n)};
  }
  const Vector3 n = s.coordinate_axis();
  Vector3 u = s.coordinate_axis();
  while (inner_product(n, u) != 0) u = s.coordinate_axis();
  return {n, u};
}

void put_beside(Pair& p, const Vector3& on_a, const Vector3& on_b, const Vector3& n, double margin,
                RandomStream& s) {
  draw_center(p.a, s);
  p.b.center = p.a.center + (on_a + (p.a.rounding + p.b.rounding + margin * size_of(p)) * n - on_b);
}

namespace {

/// Returns a unit vector square to n. Its angle from u is a power of ten, any, or a right one.
Vector3 turned_about(const Vector3& n, const Vector3& u, RandomStream& s) {
  const Vector3 third = n.cross(u);
  switch (s.below(8)) {
    case 0:
      return s.perpendicular(n);
    case 1:
      return s.sign() * third;
    case 2:
      return u;
    default:
      return normalise(u + s.sign() * draw_decade(s, 0, 15) * third);
  }
}

}  // namespace

Pair put_in_contact(Pair p, const std::array<TouchPart, 2>& parts, double margin, RandomStream& s) {
  const auto [n, u] = draw_frame(s);
  const Vector3 v = turned_about(n, u, s);
  const bool at_border = s.coin();
  const auto draw_place = [&] {
    const double sign = s.sign();
    return TouchPlace{sign * (at_border ? 1 - draw_decade(s, 1, 9) : s.between(0, 0.6)), 0};
  };
  const TouchPlace place_a = draw_place(), place_b = draw_place();
  const Vector3 on_a = touch_plane(p.a, parts[0], n, u, place_a, s);
  const Vector3 on_b = touch_plane(p.b, parts[1], -n, v, place_b, s);
  put_beside(p, on_a, on_b, n, margin, s);
  return in_any_order(p, s);
}

}  // namespace cyl
