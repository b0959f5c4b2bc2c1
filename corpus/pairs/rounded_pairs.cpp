// SPDX-License-Identifier: MIT
#include "corpus/pairs/rounded_pairs.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/touch_plane.hpp"

namespace cyl {
namespace {

constexpr std::array<double, 2> lengths{0.1, 1};  // 0.1 to 10
constexpr std::array<double, 6> parts{1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
constexpr std::array<double, 5> dusts{1e-15, 1e-12, 1e-9, 1e-6, 1e-3};
constexpr std::array<double, 8> scales{1e-300, 1e-150, 1e-50, 1e-10, 1e10, 1e50, 1e100, 1e150};

bool is_box(SolidKind kind) { return kind == SolidKind::box || kind == SolidKind::rounded_box; }
bool is_bounded(SolidKind kind) { return kind != SolidKind::half_space; }
bool has_radius(SolidKind kind) { return kind == SolidKind::cylinder || kind == SolidKind::rounded; }
bool has_height(SolidKind kind) { return has_radius(kind) || kind == SolidKind::capsule; }
bool has_rounding(SolidKind kind) {
  return is_bounded(kind) && kind != SolidKind::cylinder && kind != SolidKind::box;
}

/// The radius of the ball about the centre that holds the solid.
double reach(const Solid& c) {
  const double edges = c.edges[0] * c.edges[0] + c.edges[1] * c.edges[1] + c.edges[2] * c.edges[2];
  return std::sqrt(c.radius * c.radius + (c.height * c.height + edges) / 4) + c.rounding;
}

}  // namespace

double draw_moderate(RandomStream& s) { return s.between(0.5, 2); }

Solid draw_kind(SolidKind kind, RandomStream& s, double (*length)(RandomStream&)) {
  Solid c;
  if (is_box(kind)) {
    c.shape = Shape::box;
    c.quaternion = draw_quaternion(s);
    for (double& edge : c.edges) edge = length(s);
  } else {
    c.axis = s.unit_vector();
  }
  if (!is_bounded(kind)) c.shape = Shape::half_space;
  if (has_radius(kind)) c.radius = length(s);
  if (has_height(kind)) c.height = length(s);
  if (has_rounding(kind)) c.rounding = length(s);
  return c;
}

void put_anywhere(RandomStream& s, Pair& p) {
  for (int i = 0; i < 3; ++i) p.a.center[i] = s.between(-1, 1);
  const double distance = s.between(0, 0.9) * (reach(p.a) + reach(p.b));
  p.b.center = p.a.center + distance * s.unit_vector();
}

namespace {

Solid draw_any(SolidKind kind, RandomStream& s) {
  return draw_kind(kind, s, [](RandomStream& t) { return t.within_decades(lengths); });
}

Pair draw_anywhere(SolidKind a, SolidKind b, RandomStream& s) {
  Pair p{draw_any(a, s), draw_any(b, s)};
  put_anywhere(s, p);
  return p;
}

/// Turns the core so that the plane square to `n` touches it from outside, in its wall, cap or rim, or in
/// any part of a box. A segment is touched inside it or at its end. A half-space lies behind the plane.
/// Returns the contact from the centre.
Vector3 touch_anywhere(Solid& c, const Vector3& n, RandomStream& s) {
  const Vector3 v = s.perpendicular(n);
  if (is_box(c)) {
    const auto part = static_cast<TouchPart>(s.below(3));
    const double along = s.between(-inside_part, inside_part), across = s.between(-inside_part, inside_part);
    return touch_plane(c, part, n, v, {along, across}, s);
  }
  if (is_half_space(c)) {
    c.axis = n;
    return s.between(-2, 2) * v;
  }
  const std::size_t feature = s.below(c.radius > 0 ? 3 : 2);
  if (feature == 1) return touch_plane(c, TouchPart::point, n, v, {0, 0}, s);
  return touch_inside(c, feature == 0 ? TouchPart::line : TouchPart::face, n, v, s);
}

Pair draw_integers(SolidKind a, SolidKind b, RandomStream& s) {
  const auto length = [](RandomStream& t) { return static_cast<double>(t.integer(1, 4)); };
  Pair p{draw_kind(a, s, length), draw_kind(b, s, length)};
  constexpr std::array<std::array<int, 3>, 6> rational{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 4, 0}, {0, 3, -4}, {1, 2, 2}}};  // their lengths are integers
  constexpr std::array<std::array<double, 4>, 8> turns{{{1, 0, 0, 0},
                                                        {1, 0, 0, 1},
                                                        {1, 1, 0, 0},
                                                        {1, 1, 1, 1},
                                                        {0, 1, -1, 0},
                                                        {3, 0, 1, 0},
                                                        {2, -1, 0, 2},
                                                        {1, 2, 3, -4}}};
  for (Solid* c : {&p.a, &p.b}) {
    if (is_box(*c)) {
      c->quaternion = turns[s.below(turns.size())];
    } else {
      const auto& w = rational[s.below(rational.size())];
      c->axis = Vector3(w[0], w[1], w[2]);
    }
    for (int i = 0; i < 3; ++i) c->center[i] = s.integer(-4, 4);
  }
  return p;
}

Pair draw_awkward(SolidKind a, SolidKind b, RandomStream& s) {
  Pair p = draw_anywhere(a, b, s);
  const Vector3 along = is_box(p.a) ? edge_direction(p.a, s.below(3)) : p.a.axis;
  switch (s.below(6)) {
    case 0:  // in line
      lay_along(p.b, along, s);
      p.b.center = p.a.center + s.between(-1, 1) * (reach(p.a) + reach(p.b)) * along;
      break;
    case 1:  // side by side
      lay_along(p.b, along, s);
      break;
    case 2:
      p.b.center = p.a.center;
      break;
    case 3: {
      const double scale = s.pick(scales);
      for_each_length(p, [&](double& x) { x *= scale; });
      break;
    }
    case 4:  // thinner, shorter
      (has_box(p) ? p.a.edges[s.below(3)] : p.a.radius) *= s.pick(dusts);
      (has_box(p) ? p.b.edges[s.below(3)] : p.b.height) *= s.pick(dusts);
      break;
    default:
      p.a.rounding *= s.pick(dusts);
      p.b.rounding *= s.pick(dusts);
  }
  return p;
}

// Angles by which a contact misses a flat one.
constexpr std::array<double, 6> tilts{0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3};
constexpr std::array<double, 6> offsets{1e2, 1e4, 1e6, 1e8, 1e10, 1e12};
constexpr std::array<double, 7> normal_lengths{1e-300, 1e-150, 1e-20, 3, 1e20, 1e150, 1e300};

}  // namespace

// The cores lie on either side of two parallel planes. The planes are as far apart as both roundings and the
// margin together. So the cores are too, at the two contacts.
Pair put_near(Pair p, RandomStream& s, std::uint64_t index) {
  const Vector3 n = s.unit_vector();
  const Vector3 on_a = touch_anywhere(p.a, n, s), on_b = touch_anywhere(p.b, -n, s);
  for (int i = 0; i < 3; ++i) p.a.center[i] = s.between(-1, 1);
  // An overlap deeper than both roundings would make the cores overlap, so the cores then touch. With a box
  // they overlap.
  const double apart = p.a.rounding + p.b.rounding + margin_at(index) * size_of(p);
  p.b.center = p.a.center + (on_a + (has_box(p) ? apart : std::fmax(0, apart)) * n - on_b);
  return p;
}

Pair draw_near(SolidKind a, SolidKind b, RandomStream& s, std::uint64_t index, double b_to_a) {
  Pair p{draw_kind(a, s, draw_moderate), draw_kind(b, s, draw_moderate)};
  for (double* x : {&p.b.radius, &p.b.height, &p.b.rounding, &p.b.edges[0], &p.b.edges[1], &p.b.edges[2]})
    *x *= b_to_a;
  return put_near(p, s, index);
}

void move_far(Pair& p, RandomStream& s) {
  const Vector3 away = s.pick(offsets) * s.unit_vector();
  for (Solid* c : {&p.a, &p.b}) {
    c->center += away;
    if (is_half_space(*c) && s.coin()) c->center += s.pick(offsets) * s.perpendicular(c->axis);
  }
}

Pair draw_half_space(HalfSpaceKind kind, RandomStream& s, std::uint64_t index) {
  constexpr std::array kinds{SolidKind::sphere, SolidKind::capsule, SolidKind::cylinder, SolidKind::rounded};
  Pair p = draw_near(SolidKind::half_space, kinds[s.below(kinds.size())], s, index);
  switch (kind) {
    case HalfSpaceKind::tilted: {  // a flat contact that is not quite flat
      const Vector3 n = p.a.axis;
      p.b.axis = s.coin() ? n : s.perpendicular(n);
      p.b.axis += s.pick(tilts) * s.perpendicular(n);
      break;
    }
    case HalfSpaceKind::thin:
      (s.coin() ? p.b.radius : p.b.height) *= s.coin() ? 0 : s.pick(dusts);
      break;
    case HalfSpaceKind::far:
      move_far(p, s);
      break;
    case HalfSpaceKind::scaled_normal:
      p.a.axis *= s.pick(normal_lengths);
  }
  return in_any_order(p, s);
}

Pair draw_rounded(SolidKind a, SolidKind b, RandomStream& s, std::uint64_t index) {
  if (s.coin()) std::swap(a, b);
  switch (index % 4) {
    case 0:
      return draw_anywhere(a, b, s);
    case 1:
    case 2:
      return draw_near(a, b, s, index / 4 * 2 + index % 4 - 1);
    default:
      return index % 8 == 3 ? draw_integers(a, b, s) : draw_awkward(a, b, s);
  }
}

Pair draw_unequal(RandomStream& s, std::uint64_t index) {
  constexpr std::array kinds{SolidKind::sphere, SolidKind::capsule, SolidKind::rounded, SolidKind::cylinder};
  const SolidKind a = kinds[s.below(kinds.size())], b = kinds[s.below(kinds.size() - 1)];  // one is round
  constexpr std::uint64_t resolved_cap = 24;  // margins 1e-1 to 1e-12, which both signs have
  const Pair p = draw_near(a, b, s, index % resolved_cap, s.within_decades(parts));
  return in_any_order(p, s);
}

}  // namespace cyl
