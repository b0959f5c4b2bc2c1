// SPDX-License-Identifier: MIT
#include "corpus/pairs/box_pairs.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "corpus/pairs/exact_pairs.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/rounded_pairs.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "corpus/pairs/stratum.hpp"
#include "corpus/pairs/support.hpp"
#include "corpus/pairs/touch_plane.hpp"

namespace cyl {
namespace {

using enum SolidKind;

constexpr std::array<double, 8> quaternion_lengths{1e-300, 1e-150, 1e-20, -1, 3, 1e20, 1e150, 1e300};

SolidKind draw_box_kind(RandomStream& s) { return s.below(4) == 0 ? rounded_box : box; }

template <std::size_t count>
SolidKind draw_one(const std::array<SolidKind, count>& kinds, RandomStream& s) {
  return kinds[s.below(count)];
}

/// A box and a solid of one of the kinds.
template <std::size_t count>
Pair draw_kinds(const std::array<SolidKind, count>& kinds, RandomStream& s,
                double (*length)(RandomStream&) = draw_moderate) {
  Pair p;
  p.a = draw_kind(draw_box_kind(s), s, length);
  p.b = draw_kind(draw_one(kinds, s), s, length);
  return p;
}

double thinned(RandomStream& s, double length) { return s.coin() ? 0 : s.pick(dusts) * length; }

void make_thin(Solid& c, RandomStream& s) {
  if (!is_box(c)) {
    double& length = s.coin() ? c.radius : c.height;
    length = thinned(s, length);
    return;
  }
  constexpr std::array<std::size_t, 8> counts{1, 1, 1, 2, 2, 2, 2, 3};
  const std::size_t count = counts[s.below(counts.size())], first = s.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    double& edge = c.edges[(first + i) % 3];
    edge = thinned(s, edge);
  }
}

Pair draw_near_box(RandomStream& s, std::uint64_t index) {
  constexpr std::array kinds{sphere, capsule, cylinder, rounded, half_space, box, rounded_box};
  const SolidKind first = draw_box_kind(s), second = draw_one(kinds, s);
  return draw_near(first, second, s, index);
}

}  // namespace

Pair draw_box_edges(RandomStream& s, std::uint64_t index) {
  constexpr std::array kinds{box, box, box, rounded_box, capsule, cylinder, rounded};
  Pair p = draw_kinds(kinds, s);
  return put_in_contact(p, {TouchPart::line, TouchPart::line}, margin_at(index), s);
}

// A tilted solid meets the facet in the point of it that is farthest along -n.
Pair draw_box_flush(RandomStream& s, std::uint64_t index) {
  constexpr std::array kinds{box, box, rounded_box, capsule, cylinder, rounded};
  Pair p = draw_kinds(kinds, s);
  const auto [n, u] = draw_frame(s);
  const double x = s.between(-0.6, 0.6), y = s.between(-0.6, 0.6), z = s.between(-0.6, 0.6);
  const Vector3 on_a = touch_plane(p.a, TouchPart::face, n, u, {x, y}, s);
  const auto part = s.coin() ? TouchPart::face : TouchPart::line;
  const bool flat = s.below(4) == 0;
  const Vector3 v = s.coin() ? u : s.perpendicular(n);
  Vector3 on_b;
  if (flat) {
    on_b = touch_plane(p.b, part, -n, v, {z, 0}, s);
  } else {
    const Vector3 towards = normalise(n + draw_decade(s, 2, 15) * s.perpendicular(n));
    touch_plane(p.b, part, -towards, s.perpendicular(towards), {0, 0}, s);
    const Vec3<double> lowest = farthest(terms_of<double>(p.b), Vec3<double>{-n.x(), -n.y(), -n.z()});
    on_b = Vector3(lowest.x, lowest.y, lowest.z);
  }
  put_beside(p, on_a, on_b, n, margin_at(index), s);
  return in_any_order(p, s);
}

Pair draw_box_stacked(RandomStream& s, std::uint64_t index) {
  constexpr std::array<std::array<double, 4>, 4> turns{
      {{1, 0, 0, 0}, {1, 1, 1, 1}, {3, 0, 0, 4}, {-1, 2, 0, -2}}};
  Pair p;
  p.a = draw_kind(draw_box_kind(s), s, draw_moderate);
  const bool rational = s.coin();
  if (rational) {
    p.a.quaternion = turns[s.below(turns.size())];
    for (double& edge : p.a.edges) edge = s.integer(1, 16) / 8.0;
  }
  draw_center(p.a, s);
  p.b = p.a;
  if (s.coin())
    for (double& edge : p.b.edges) edge *= s.coin() ? 1 : s.integer(1, 12) / 8.0;
  if (s.coin())
    for (double& x : p.b.quaternion) x = -x;
  // Along one direction of the edges, b stands on a. Along the others, it is in the middle, flush, or stands
  // at a's end.
  const std::size_t way = s.below(5), first = s.below(3);
  if (way == 0) return p;  // about one centre
  const double margin = way == 1 ? 0 : margin_at(index);
  Vector3 step(0, 0, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool stands = i == first || s.below(4) == 0;
    const double level = s.coin() ? 0 : (p.b.edges[i] - p.a.edges[i]) / 2;
    const double by = stands ? (p.a.edges[i] + p.b.edges[i]) / 2 : level;
    const double apart = i == first ? p.a.rounding + p.b.rounding + margin * size_of(p) : 0;
    step += s.sign() * (by + apart) * edge_direction(p.a, i);
  }
  p.b.center = p.a.center + step;
  return in_any_order(p, s);
}

// The inner solid touches a plane from inside. The margin is from the plane to the facet, in sizes of the
// inner solid. A negative one is beyond the facet.
Pair draw_box_nested(RandomStream& s, std::uint64_t index) {
  constexpr std::array kinds{sphere, capsule, cylinder, rounded, box, box, rounded_box};
  Pair p = draw_kinds(kinds, s);
  const double part = draw_decade(s, 1, 12) * s.between(0.3, 1);
  for (double* x : {&p.b.radius, &p.b.height, &p.b.rounding, &p.b.edges[0], &p.b.edges[1], &p.b.edges[2]})
    *x *= part;
  const auto [n, u] = draw_frame(s);
  const double x = s.between(-0.3, 0.3), y = s.between(-0.3, 0.3);
  const Vector3 on_a = touch_plane(p.a, TouchPart::face, n, u, {x, y}, s);
  const Vector3 on_b = touch_plane(p.b, static_cast<TouchPart>(s.below(3)), n, s.perpendicular(n), {0, 0}, s);
  draw_center(p.a, s);
  const double size = size_of({p.b, Solid{}});
  p.b.center = p.a.center + (on_a + (p.a.rounding - p.b.rounding - margin_at(index) * size) * n - on_b);
  return in_any_order(p, s);
}

Pair draw_box_thin(RandomStream& s, std::uint64_t index) {
  constexpr std::array kinds{sphere, capsule, cylinder, rounded, half_space, box, rounded_box};
  Pair p = draw_kinds(kinds, s);
  make_thin(p.a, s);
  if (s.coin()) make_thin(p.b, s);
  if (size_of(p) == 0) p.a.edges[0] = 1;
  if (index % 4 < 2)
    p = put_near(p, s, index / 4 * 2 + index % 2);
  else
    put_anywhere(s, p);
  return in_any_order(p, s);
}

// All numbers are integers or halves, so the solids touch exactly along a coordinate axis. Square to it they
// lie over each other or beside.
Pair draw_box_lattice(RandomStream& s, std::uint64_t) {
  constexpr std::array kinds{sphere, capsule, cylinder, rounded, box, box, box, rounded_box};
  constexpr std::array<std::array<double, 4>, 10> quarters{{{1, 0, 0, 0},
                                                            {1, 1, 0, 0},
                                                            {1, 0, -1, 0},
                                                            {1, 0, 0, 1},
                                                            {1, 1, 1, 1},
                                                            {1, -1, 1, 1},
                                                            {0, 1, 0, 0},
                                                            {0, 1, 1, 0},
                                                            {0, 0, 2, -2},
                                                            {-3, 3, 3, 3}}};
  Pair p = draw_kinds(kinds, s, [](RandomStream& r) { return static_cast<double>(r.integer(1, 4)); });
  for (Solid* c : {&p.a, &p.b}) {
    c->axis = is_box(*c) ? Vector3(0, 0, 1) : s.coordinate_axis();
    c->quaternion = {1, 0, 0, 0};
    if (is_box(*c)) c->quaternion = quarters[s.below(quarters.size())];
    if (is_box(*c) && s.below(6) == 0) c->edges[s.below(3)] = 0;
    for (int i = 0; i < 3; ++i) c->center[i] = s.integer(-4, 4) / 2.0;
  }
  const Vector3 n = s.coordinate_axis();
  const auto extent = [&](const Solid& c) {
    return support(terms_of<double>(c), Vec3<double>{n.x(), n.y(), n.z()});
  };
  const double reach = extent(p.a) + extent(p.b);
  for (Eigen::Index i = 0; i < 3; ++i)
    if (n[i] != 0) p.b.center[i] = p.a.center[i] + n[i] * reach;
  switch (s.below(3)) {
    case 0:  // nearly a quarter
      p.a.quaternion[s.below(4)] += s.sign() * draw_decade(s, 3, 16);
      break;
    case 1: {
      double& x = p.b.center[static_cast<Eigen::Index>(s.below(3))];
      x = std::nextafter(x, s.sign() * std::numeric_limits<double>::infinity());
      break;
    }
    default:
      break;
  }
  return in_any_order(p, s);
}

Pair draw_box_far(RandomStream& s, std::uint64_t index) {
  Pair p = draw_near_box(s, index);
  move_far(p, s);
  return in_any_order(p, s);
}

Pair draw_box_quaternion(RandomStream& s, std::uint64_t index) {
  Pair p = draw_near_box(s, index);
  for (Solid* c : {&p.a, &p.b}) {
    const double length = s.pick(quaternion_lengths);
    for (double& x : c->quaternion)
      if (is_box(*c)) x *= length;
  }
  return in_any_order(p, s);
}

}  // namespace cyl
