// SPDX-License-Identifier: MIT
#include "fuzz/guided/mutator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/stratum.hpp"
#include "corpus/pairs/support.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// A power of ten, or some number down to the next: faults may lie between.
double tenth(RandomStream& s) {
  const double sign = s.sign(), decade = s.pick(tenths);
  return sign * decade * (s.coin() ? 1 : s.between(0.1, 1));
}

Solid& either(Pair& p, RandomStream& s) { return s.coin() ? p.a : p.b; }
/// A box if there is one.
Solid& either_box(Pair& p, RandomStream& s) { return is_box(p.a) && (s.coin() || !is_box(p.b)) ? p.a : p.b; }
Solid& other(Pair& p, const Solid& c) { return &c == &p.a ? p.b : p.a; }

double step(double x, RandomStream& s) {
  return std::nextafter(x, s.sign() * std::numeric_limits<double>::infinity());
}

Vector3 direction_of(const Solid& c, RandomStream& s) {
  return is_box(c) ? edge_direction(c, s.below(3)) : unit_axis(c.axis);
}

/// How far the core extends from its centre.
double half_along(const Solid& c, const Vector3& direction) {
  return core_support(terms_of<double>(c), lifted<double>(direction));
}

/// Makes the solid exactly parallel to the other, if both have an axis or both are boxes.
void copy_direction(Solid& c, const Solid& from, const Vector3& along, RandomStream& s) {
  const double sign = s.sign();
  if (is_box(c) && is_box(from))
    for (std::size_t i = 0; i < 4; ++i) c.quaternion[i] = sign * from.quaternion[i];
  else if (is_box(c) || is_box(from))
    lay_along(c, along, s);
  else
    c.axis = sign * from.axis;
}

// Turned axes are of unit length; their lengths are for scale_field.
void turn_to_parallel(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  const Vector3 w = direction_of(other(p, c), s), aside = s.perpendicular(w);
  const double sign = s.sign(), tilt = tenth(s);
  if (s.coin())
    lay_along(c, sign * (w + tilt * aside), s);
  else
    copy_direction(c, other(p, c), w, s);
}

void turn_to_perpendicular(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  const Vector3 w = direction_of(other(p, c), s), aside = s.perpendicular(w);
  const double tilt = tenth(s);
  lay_along(c, s.coin() ? Vector3(aside + tilt * w) : aside, s);
}

// The distance is that of a plane if the solids are apart, and a bound if they overlap. So one slide may not
// reach it, and two do.
void touch(Pair& p) {
  for (int i = 0; i < 2; ++i) {
    const MeasuredDistance d = approximate_distance(p);
    if (d.direction.isZero(0)) return;
    p.b.center -= d.value * d.direction;
  }
}

void slide_to_touching(Pair& p, RandomStream& s) {
  touch(p);
  const MeasuredDistance d = approximate_distance(p);
  switch (s.below(4)) {
    case 0:
      return;
    case 1: {
      double& x = p.b.center[static_cast<Eigen::Index>(s.below(3))];
      x = step(x, s);
      return;
    }
    default:
      p.b.center += (tenth(s) * size_of(p)) * d.direction;
  }
}

void slide_along_contact(Pair& p, RandomStream& s) {
  const MeasuredDistance d = approximate_distance(p);
  if (!(length_of(d.direction) > 0.5)) return;
  const Vector3 aside = s.perpendicular(d.direction);
  p.b.center += (tenth(s) * size_of(p)) * aside;
  touch(p);
}

void slide_ends_level(Pair& p, RandomStream& s) {
  const Vector3 w = direction_of(p.a, s);
  const double of_b = is_box(p.b) ? half_along(p.b, w) : p.b.height / 2,
               ends = (is_box(p.a) ? half_along(p.a, w) : p.a.height / 2) + s.sign() * of_b,
               along = inner_product(w, p.b.center - p.a.center);
  p.b.center += (s.sign() * ends - along) * w;
}

void swap(Pair& p, RandomStream&) { std::swap(p.a, p.b); }

void scale_all(Pair& p, RandomStream& s) { p = scaled(p, s.integer(-40, 40)); }

double& any_number(Solid& c, RandomStream& s) {
  const std::span<const std::size_t> places = places_of(c.shape);
  return *numbers_of(c)[places[s.below(places.size())]];
}

void scale_field(Pair& p, RandomStream& s) {
  double& x = any_number(either(p, s), s);
  x = std::ldexp(x, s.integer(-20, 20));
}

/// The lengths of the shape, roundings too.
std::vector<double*> lengths_of(Solid& c) {
  if (is_box(c)) return {&c.rounding, &c.edges[0], &c.edges[1], &c.edges[2]};
  return {&c.radius, &c.height, &c.rounding};
}

// One length becomes a moderate multiple of any: a fault may need several ratios at once.
void relate_lengths(Pair& p, RandomStream& s) {
  std::vector<double*> lengths = lengths_of(p.a);
  for (double* x : lengths_of(p.b)) lengths.push_back(x);
  const double other = *lengths[s.below(lengths.size())], part = s.between(0.5, 1);
  *lengths[s.below(lengths.size())] = std::ldexp(other * part, s.integer(-3, 4));
}

void change_field(Pair& p, RandomStream& s) {
  double& x = any_number(either(p, s), s);
  x += tenth(s) * (x == 0 ? 1 : x);
}

void snap_to_grid(Pair& p, RandomStream& s) {
  const int bits = s.integer(0, 10);
  for (Solid* c : {&p.a, &p.b})
    for (double* x : numbers_of(*c)) *x = std::ldexp(std::nearbyint(std::ldexp(*x, bits)), -bits);
}

void make_coaxial(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  const Solid& o = other(p, c);
  const Vector3 w = direction_of(o, s);
  copy_direction(c, o, w, s);
  const double ends = half_along(o, w) + half_along(c, w), off = 1 + tenth(s);
  c.center = o.center + (s.sign() * (s.coin() ? ends : ends * off)) * w;
}

void make_equal(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  c = other(p, c);
}

void make_contained(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  const Solid& o = other(p, c);
  const double share = std::fabs(tenth(s));
  c.center = o.center;
  if (is_box(c) != is_box(o)) {  // as large as that part of the other, in its own shape
    const double by = share * size_of({o, Solid{}}) / size_of({c, Solid{}});
    for (double* x : lengths_of(c)) *x *= by;
  } else {
    c.radius = o.radius * share;
    c.height = o.height * share;
    c.rounding = o.rounding * share;
    for (std::size_t i = 0; i < 3; ++i) c.edges[i] = o.edges[i] * share;
  }
  // Against the wall, a facet or the end, from inside.
  for (int i = 0; i < 2; ++i) {
    if (s.coin()) continue;
    const Vector3 w = direction_of(o, s),
                  out = i == 0 && !is_box(o) && !is_half_space(o) ? s.perpendicular(w) : w;
    c.center += (half_along(o, out) - half_along(c, out)) * out;
  }
}

/// Makes it 0 or a small part of the other.
void diminish(double& length, double other, RandomStream& s) {
  length = s.coin() ? 0 : other * std::fabs(tenth(s));
}

void flatten(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  if (is_box(c)) {
    const std::size_t i = s.below(3);
    diminish(c.edges[i], c.edges[(i + 1) % 3], s);
  } else {
    diminish(c.height, c.radius, s);
  }
}

/// Leaves one long edge of a box.
void thin(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  if (is_box(c)) {
    const std::size_t i = s.below(3);
    for (const std::size_t k : {i + 1, i + 2}) diminish(c.edges[k % 3], c.edges[i], s);
  } else {
    diminish(c.radius, c.height, s);
  }
}

void equal_edges(Pair& p, RandomStream& s) {
  Solid& c = either_box(p, s);
  if (!is_box(c)) return;
  const std::size_t i = s.below(3), other = (i + 1 + s.below(2)) % 3;
  c.edges[other] = c.edges[i];
  if (s.coin()) c.edges.fill(c.edges[i]);
}

void round_edges(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  diminish(c.rounding, size_of({c, Solid{}}), s);
}

/// Makes a capsule or a sphere. A box becomes the capsule in its middle.
void round_off(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  if (is_box(c)) {
    const std::size_t i = s.below(3);
    c = {.center = c.center,
         .axis = edge_direction(c, i),
         .radius = c.edges[(i + 1) % 3] / 2,
         .height = c.edges[i],
         .rounding = c.rounding};
  }
  c.rounding += c.radius;
  c.radius = 0;
  if (s.coin()) c.height = 0;
}

/// Makes the box around a cylinder. A half-space becomes a box with a facet at its point.
void make_box(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  if (is_box(c)) return;
  Solid box{.center = c.center, .rounding = c.rounding, .shape = Shape::box};
  const Vector3 w = unit_axis(c.axis), u = s.perpendicular(w);
  box.quaternion = quaternion_of({u, w.cross(u), w});
  box.edges = {2 * c.radius, 2 * c.radius, c.height};
  if (is_half_space(c)) {
    box.edges.fill(size_of(p));
    box.center -= size_of(p) / 2 * w;
  }
  c = box;
}

/// Turns a box to the coordinate axes, exactly or nearly.
void quarter_turn(Pair& p, RandomStream& s) {
  Solid& c = either_box(p, s);
  if (!is_box(c)) return;
  constexpr std::array<std::array<double, 4>, 6> quarters{
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0}, {1, 0, 0, 1}, {1, 1, 1, 1}, {0, 1, 1, 0}}};
  c.quaternion = quarters[s.below(quarters.size())];
  if (s.coin()) c.quaternion[s.below(4)] += tenth(s);
}

/// Negates a quaternion, or multiplies it.
void scale_quaternion(Pair& p, RandomStream& s) {
  Solid& c = either_box(p, s);
  if (!is_box(c)) return;
  const double by = s.coin() ? -1 : s.coin() ? std::ldexp(1, s.integer(-400, 400)) : s.between(0.5, 2);
  for (double& x : c.quaternion) x *= by;
}

void make_half_space(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  c = {.center = c.center, .axis = c.axis, .shape = Shape::half_space};
}

void move_far(Pair& p, RandomStream& s) {
  const double away = std::ldexp(size_of(p), s.integer(1, 50));
  const Vector3 by = away * (s.coin() ? s.coordinate_axis() : s.unit_vector());
  p.a.center += by;
  p.b.center += by;
}

void move_to_origin(Pair& p, RandomStream&) {
  p.b.center -= p.a.center;
  p.a.center.setZero();
}

void copy_field(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  const std::span<const std::size_t> places = places_of(c.shape);
  const std::size_t i = places[s.below(places.size())];
  *numbers_of(c)[i] = *numbers_of(other(p, c))[i];
}

void step_field(Pair& p, RandomStream& s) {
  double& x = any_number(either(p, s), s);
  x = step(x, s);
}

void zero_coordinate(Pair& p, RandomStream& s) {
  Solid& c = either(p, s);
  const std::size_t i = s.below(is_box(c) ? 7 : 6);
  *numbers_of(c)[is_box(c) && i > 2 ? i + 9 : i] = 0;
}

constexpr Move all_moves[] = {
    {"turn_to_parallel", turn_to_parallel},
    {"turn_to_perpendicular", turn_to_perpendicular},
    {"slide_to_touching", slide_to_touching},
    {"slide_along_contact", slide_along_contact},
    {"slide_ends_level", slide_ends_level},
    {"swap", swap},
    {"scale_all", scale_all},
    {"scale_field", scale_field},
    {"relate_lengths", relate_lengths},
    {"change_field", change_field},
    {"snap_to_grid", snap_to_grid},
    {"make_coaxial", make_coaxial},
    {"make_equal", make_equal},
    {"make_contained", make_contained},
    {"flatten", flatten},
    {"thin", thin},
    {"round_edges", round_edges},
    {"round_off", round_off},
    {"make_half_space", make_half_space},
    {"make_box", make_box},
    {"quarter_turn", quarter_turn},
    {"scale_quaternion", scale_quaternion},
    {"equal_edges", equal_edges},
    {"move_far", move_far},
    {"move_to_origin", move_to_origin},
    {"copy_field", copy_field},
    {"step_field", step_field},
    {"zero_coordinate", zero_coordinate},
};

/// The solid with every number that is at fault put right.
Solid legalised(Solid c) {
  for (double* x : numbers_of(c))
    if (!std::isfinite(*x)) *x = 1;
  if (c.axis.isZero(0)) c.axis = {0, 0, 1};
  c.radius = std::fabs(c.radius);
  c.height = std::fabs(c.height);
  c.rounding = std::fabs(c.rounding);
  for (double& edge : c.edges) edge = is_box(c) ? std::fabs(edge) : 0;
  if (c.shape != Shape::cylinder) c.radius = c.height = 0;
  if (is_half_space(c)) c.rounding = 0;
  if (std::ranges::all_of(c.quaternion, [](double x) { return x == 0; })) c.quaternion = {1, 0, 0, 0};
  return c;
}

Pair legal_pair(const Solid& a, const Solid& b) {
  Pair p{legalised(a), legalised(b)};
  if (is_half_space(p.a) && is_half_space(p.b)) p.b.shape = Shape::cylinder;
  return p;
}

void apply(const Move& move, Pair& pair, RandomStream& stream) {
  Pair moved = pair;
  move.apply(moved, stream);
  if (is_legal(moved)) pair = moved;
}

}  // namespace

std::span<const Move> moves() { return all_moves; }

Pair mutate(const Pair& pair, std::uint64_t seed) {
  RandomStream stream("mutate", seed, 0);
  Pair p = legal_pair(pair.a, pair.b);
  const std::size_t count = 1 + stream.below(3);
  for (std::size_t i = 0; i < count; ++i) apply(all_moves[stream.below(std::size(all_moves))], p, stream);
  // Most turns and changes of form leave the boundary; half of them return to it.
  if (stream.coin()) apply({"slide_to_touching", slide_to_touching}, p, stream);
  return p;
}

Pair cross_over(const Pair& x, const Pair& y, std::uint64_t seed) {
  RandomStream stream("cross_over", seed, 0);
  const Solid& first = stream.coin() ? x.a : x.b;
  const Solid& second = stream.coin() ? y.a : y.b;
  Pair p = legal_pair(first, second);
  if (stream.coin()) apply({"slide_to_touching", slide_to_touching}, p, stream);
  return p;
}

}  // namespace cyl
