// SPDX-License-Identifier: MIT
#include "oracles/referee/tangency.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/half_space.hpp"

namespace cyl {
namespace {

using Root3 = Vec3<RootSum>;

template <class R>
Vec3<R> off(const Vec3<R>& v, const Vec3<R>& axis) {
  return v - R(dot(v, axis) / dot(axis, axis)) * axis;
}

bool is_zero(const Root3& v) { return v.x.sign() == 0 && v.y.sign() == 0 && v.z.sign() == 0; }

Root3 lift(const Rational3& v) { return {RootSum(v.x), RootSum(v.y), RootSum(v.z)}; }

// length * v/|v|.
Root3 along(const mpq_class& length, const Rational3& v) {
  const mpq_class vv = dot(v, v);
  return RootSum::root(length / vv, vv) * lift(v);
}

bool at_most(const RootSum& a, const RootSum& b) { return (b - a).sign() >= 0; }

// The part of a solid that touches its supporting plane perpendicular to D, relative to its centre.
struct Face {
  enum Kind { point, segment, disk } kind;
  Root3 center;
  Rational3 axis;
  mpq_class radius, half;
};

Face face(const Solid& c, const Rational3& d) {
  const Rational3 w = exact(c.axis);
  const mpq_class dw = dot(d, w), radius(c.radius), half = mpq_class(c.height) / 2;
  const Rational3 radial = off(d, w);
  const mpq_class end = dw < 0 ? mpq_class(-half) : half;
  if (is_zero(radial)) return {Face::disk, along(end, w), w, radius, half};
  if (dw == 0) return {Face::segment, along(radius, d), w, radius, half};
  return {Face::point, along(radius, radial) + along(end, w), w, radius, half};
}

// Returns whether two faces in one plane share a point. `delta` leads from the centre of the first to the
// centre of the second.
bool faces_meet(const Face& f, const Face& g, const Root3& delta) {
  if (f.kind < g.kind) return faces_meet(g, f, RootSum(-1) * delta);
  const RootSum square = dot(delta, delta);
  if (f.kind == Face::disk && g.kind != Face::segment) {
    const mpq_class reach = g.kind == Face::disk ? mpq_class(f.radius + g.radius) : f.radius;
    return at_most(square, mpq_class(reach * reach));
  }
  if (f.kind == Face::disk) {
    const mpq_class ww = dot(g.axis, g.axis);
    const RootSum p = dot(delta, lift(g.axis)), limit = mpq_class(f.radius * f.radius);
    if (at_most(p * p, mpq_class(g.half * g.half * ww)))
      return at_most(square - RootSum(mpq_class(1 / ww)) * p * p, limit);
    const RootSum size = p.sign() < 0 ? RootSum(0) - p : p;
    return at_most(square - RootSum::root(2 * g.half / ww, ww) * size + RootSum(mpq_class(g.half * g.half)),
                   limit);
  }
  const mpq_class ww = dot(f.axis, f.axis);
  const RootSum p = dot(delta, lift(f.axis));
  auto on_line = [&] { return is_zero(cross(delta, lift(f.axis))); };
  if (f.kind == Face::segment && g.kind == Face::segment) {
    const Rational3 normal = cross(f.axis, g.axis);
    const mpq_class nn = dot(normal, normal);
    if (nn == 0) {
      const mpq_class reach = f.half + g.half;
      return on_line() && at_most(p * p, mpq_class(reach * reach * ww));
    }
    // delta = s f.axis - t g.axis
    const RootSum s = RootSum(mpq_class(1 / nn)) * dot(cross(delta, lift(g.axis)), lift(normal));
    const RootSum t = RootSum(mpq_class(1 / nn)) * dot(cross(delta, lift(f.axis)), lift(normal));
    const mpq_class gg = dot(g.axis, g.axis);
    return at_most(s * s, mpq_class(f.half * f.half / ww)) && at_most(t * t, mpq_class(g.half * g.half / gg));
  }
  if (f.kind == Face::segment) return on_line() && at_most(p * p, mpq_class(f.half * f.half * ww));
  return is_zero(delta);
}

// Returns a point that two faces in one plane share if they meet, relative to the centre of the first.
Root3 shared_point(const Face& f, const Face& g, const Root3& delta) {
  if (f.kind < g.kind) return delta + shared_point(g, f, RootSum(-1) * delta);
  if (g.kind == Face::point) return delta;
  const auto divided = [&](const mpq_class& x, const mpq_class& y) {
    return x + y == 0 ? delta : RootSum(mpq_class(x / (x + y))) * delta;
  };
  if (g.kind == Face::disk) return divided(f.radius, g.radius);
  const mpq_class gg = dot(g.axis, g.axis);
  if (f.kind == Face::disk) {  // the segment's point nearest to the disk's centre
    const RootSum p = dot(delta, lift(g.axis));
    const RootSum by = at_most(p * p, mpq_class(g.half * g.half * gg))
                           ? RootSum(mpq_class(1 / gg)) * p
                           : RootSum::root(p.sign() * g.half / gg, gg);
    return delta - by * lift(g.axis);
  }
  const Rational3 normal = cross(f.axis, g.axis);
  const mpq_class nn = dot(normal, normal);
  if (nn == 0) return divided(f.half, g.half);
  return (RootSum(mpq_class(1 / nn)) * dot(cross(delta, lift(g.axis)), lift(normal))) * lift(f.axis);
}

std::optional<Rational3> rational(const Root3& v) {
  const auto x = v.x.rational(), y = v.y.rational(), z = v.z.rational();
  if (!x || !y || !z) return std::nullopt;
  return Rational3{*x, *y, *z};
}

// f(D) as a sum of roots. The faces of rounded solids are those of their cores, moved along D.
RootSum support_gap(const Pair& pair, const Rational3& d) {
  RootSum sum = RootSum(0) - RootSum(abs(dot(d, exact(pair.b.center) - exact(pair.a.center))));
  for (const Solid* c : {&pair.a, &pair.b}) sum = sum + exact_core_support(*c, d);
  const mpq_class contact_distance = contact_distance_of(pair);
  return contact_distance == 0 ? sum : sum + RootSum::root(contact_distance, dot(d, d));
}

}  // namespace

std::optional<std::pair<Rational3, Rational3>> contact_points(const Pair& pair, const Rational3& direction) {
  const Rational3 c0 = exact(pair.a.center);
  const Face f = face(pair.a, direction), g = face(pair.b, mpq_class(-1) * direction);
  const Root3 way = along(contact_distance_of(pair), direction),
              delta = lift(exact(pair.b.center) - c0) + g.center - f.center - way;
  const Root3 on_a = f.center + shared_point(f, g, delta);
  const auto x = rational(on_a), y = rational(on_a + way);
  if (!x || !y) return std::nullopt;
  return std::pair{c0 + *x, c0 + *y};
}

RootSum exact_core_support(const Solid& c, const Rational3& d) {
  if (is_box(c)) {
    mpq_class sum = 0;
    const auto edges = edge_directions<mpq_class>(c.quaternion);
    for (std::size_t i = 0; i < 3; ++i) sum += mpq_class(c.edges[i]) / 2 * abs(dot(d, edges[i]));
    return sum;
  }
  const Rational3 w = exact(c.axis), side = cross(d, w);
  const mpq_class ww = dot(w, w), dw = dot(d, w);
  return RootSum::root(c.radius, dot(side, side) / ww) + RootSum::root(mpq_class(c.height) / 2, dw * dw / ww);
}

std::optional<Rational3> farthest_point(const Solid& c, const Rational3& direction) {
  if (is_box(c)) {
    Rational3 x = exact(c.center);
    const auto edges = edge_directions<mpq_class>(c.quaternion);
    for (std::size_t i = 0; i < 3; ++i)
      x = x + mpq_class(sgn(dot(direction, edges[i])) * mpq_class(c.edges[i]) / 2) * edges[i];
    return x;
  }
  const auto offset = rational(face(c, direction).center);
  if (!offset) return std::nullopt;
  return exact(c.center) + *offset;
}

int support_gap_sign(const Pair& pair, const Rational3& direction) {
  if (has_half_space(pair)) {
    const Rational3 n = exact(direction_of_half_space(pair));
    return is_zero(cross(direction, n)) && dot(direction, n) > 0 ? half_space_sign(pair) : 1;
  }
  return support_gap(pair, direction).sign();
}

mpq_class simplest_within(const mpq_class& x, const mpq_class& tolerance) {
  // Tries the convergents of the continued fraction of x until one is near enough.
  mpz_class p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  mpq_class rest = x;
  for (;;) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), rest.get_num_mpz_t(), rest.get_den_mpz_t());
    const mpz_class p2 = whole * p1 + p0, q2 = whole * q1 + q0;
    p0 = p1, q0 = q1, p1 = p2, q1 = q2;
    mpq_class guess(p1, q1);
    guess.canonicalize();
    if (abs(mpq_class(x - guess)) <= tolerance) return guess;  // the last convergent is x
    rest = 1 / mpq_class(rest - whole);
  }
}

namespace {

// The vectors from which the candidates are made. A candidate is a line. Its length and sense do not matter.
//
// The candidates are the normal of a cap, of two crossing walls, of two parallel walls, and of a wall at the
// point that it meets. Others are perpendicular to the tangents of two rims, or to the tangent of a rim and
// the axis of a wall or segment. If two segments lie on one line, any vector perpendicular to it serves. If
// two points are in one place, any vector serves.
template <class R>
struct Guess {
  Vec3<R> w0, w1, delta, x0, x1, near_direction;
};
template <class R>
Vec3<R> coordinate(int i) {
  return {R(i == 0 ? 1 : 0), R(i == 1 ? 1 : 0), R(0)};
}
template <class R>
using Candidate = Vec3<R> (*)(const Guess<R>&);
template <class R>
constexpr Candidate<R> candidates[] = {
    [](const Guess<R>& g) { return g.w0; },
    [](const Guess<R>& g) { return g.w1; },
    [](const Guess<R>& g) { return cross(g.w0, g.w1); },
    [](const Guess<R>& g) { return off(g.delta, g.w0); },
    [](const Guess<R>& g) { return off(g.delta, g.w1); },
    [](const Guess<R>& g) { return off(g.x0, g.w0); },
    [](const Guess<R>& g) { return off(g.x1, g.w1); },
    [](const Guess<R>& g) { return cross(cross(g.w0, g.x0), cross(g.w1, g.x1)); },
    [](const Guess<R>& g) { return cross(g.w1, cross(g.w0, g.x0)); },
    [](const Guess<R>& g) { return cross(g.w0, cross(g.w1, g.x1)); },
    [](const Guess<R>& g) { return g.delta; },
    [](const Guess<R>& g) { return g.near_direction; },
    [](const Guess<R>& g) { return cross(g.w0, coordinate<R>(0)); },
    [](const Guess<R>& g) { return cross(g.w0, coordinate<R>(1)); },
    [](const Guess<R>&) { return coordinate<R>(0); }};

}  // namespace

std::optional<Tangency> prove_tangency(const Pair& pair, const Rational3& near_point,
                                       const Rational3& near_other, const Rational3& near_direction) {
  const Rational3 c0 = exact(pair.a.center), delta = exact(pair.b.center) - c0;
  const Guess<mpq_class> guess{
      exact(pair.a.axis), exact(pair.b.axis), delta, near_point - c0, near_other - exact(pair.b.center),
      near_direction};
  // Most candidates are far from f(D) = 0, and intervals show it cheaply.
  const Filter filter(pair);
  const TwinFilter twins(pair);
  const auto enclosed_guess = [&]<class I>(const BasicFilter<I>& in) {
    return Guess<I>{in.a().axis,           in.b().axis,           in.delta(),
                    enclosed<I>(guess.x0), enclosed<I>(guess.x1), enclosed<I>(guess.near_direction)};
  };
  const Guess<Interval> roughly = enclosed_guess(filter);
  const Guess<TwinInterval> nearly = enclosed_guess(twins);
  std::vector<Rational3> seen;  // f > 0 there
  for (std::size_t i = 0; i < std::size(candidates<Interval>); ++i) {
    if (surely_less(0.0, filter.support_gap(candidates<Interval>[i](roughly)))) continue;
    const TwinInterval gap = twins.support_gap(candidates<TwinInterval>[i](nearly));
    if (surely_less(0.0, gap)) continue;
    Rational3 d = candidates<mpq_class>[i](guess);
    if (is_zero(d)) continue;
    if (dot(d, delta) < 0) d = mpq_class(-1) * d;
    const auto parallel = [&](const Rational3& o) {
      return d.x * o.y == d.y * o.x && d.y * o.z == d.z * o.y && d.z * o.x == d.x * o.z;
    };
    if (std::any_of(seen.begin(), seen.end(), parallel)) continue;
    const int sign = surely_less(gap, 0.0) ? -1 : support_gap_sign(pair, d);
    if (sign > 0) {
      seen.push_back(d);
      continue;
    }
    if (sign < 0) return Tangency{d, false};
    const Rational3 back = mpq_class(-1) * d;
    const Face f = face(pair.a, d), g = face(pair.b, back);
    const mpq_class contact_distance = contact_distance_of(pair);
    const Root3 between = lift(delta) + g.center - f.center;
    return Tangency{d,
                    faces_meet(f, g, contact_distance == 0 ? between : between - along(contact_distance, d))};
  }
  return std::nullopt;
}

}  // namespace cyl
