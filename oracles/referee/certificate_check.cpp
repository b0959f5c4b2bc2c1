// SPDX-License-Identifier: MIT
#include "oracles/referee/certificate_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {
namespace {

template <class R, class T>
Vec3<R> lift(const Vec3<T>& v) {
  return {R(v.x), R(v.y), R(v.z)};
}

}  // namespace

Hull own_hull(const Solid& c) {
  if (is_half_space(c)) return Hull::space;
  if (is_box(c)) {
    constexpr std::array hulls{Hull::space, Hull::plane, Hull::line, Hull::center};
    return hulls[static_cast<std::size_t>(std::ranges::count(c.edges, 0.0))];
  }
  return both(c.height == 0 ? Hull::plane : Hull::space, c.radius == 0 ? Hull::line : Hull::space);
}

Hull hull_within(const Solid& c, Hull named) { return is_box(c) ? own_hull(c) : both(own_hull(c), named); }

std::size_t hull_edge(const Solid& box) {
  const bool plane = own_hull(box) == Hull::plane;
  for (std::size_t i = 0; i < 2; ++i)
    if ((box.edges[i] == 0) == plane) return i;
  return 2;
}

Rational3 hull_axis(const Solid& c) {
  return is_box(c) ? edge_directions<mpq_class>(c.quaternion)[hull_edge(c)] : exact(c.axis);
}

// GMP rounds to double towards 0, and to infinity if the number is too large. So the second of two doubles
// leaves out less than 2^-104 of the number, or of the least double.
template <class I>
Vec3<I> enclosed(const Rational3& v) {
  const auto c = [](const mpq_class& x) {
    const double head = x.get_d();
    if constexpr (std::is_same_v<I, Interval>) {
      return I::outward(head, head);
    } else {
      if (!std::isfinite(head)) return I::everything();
      const double tail = mpq_class(x - head).get_d();
      return I(head) + I(tail) + I(0.0, 0x1p-104 * std::fabs(head) + std::numeric_limits<double>::min());
    }
  };
  return {c(v.x), c(v.y), c(v.z)};
}
template Vec3<Interval> enclosed(const Rational3& v);
template Vec3<TwinInterval> enclosed(const Rational3& v);

Rational3 exact(const Vector3& v) { return {mpq_class(v.x()), mpq_class(v.y()), mpq_class(v.z())}; }

// not covered within: tests and exports read written certificates, and the gate has them in hand
Rational3 exact(const ExactVector& v) {
  const auto c = [&](std::size_t i) {
    return v.exact[i].empty() ? mpq_class(mpq_class(v.head[i]) + mpq_class(v.tail[i]))
                              : mpq_class(v.exact[i]);
  };
  return {c(0), c(1), c(2)};
}

int support_gap_sign(const Pair& pair, const Rational3& direction, int bits) {
  if (has_half_space(pair)) return support_gap_sign(pair, direction);
  const PrecisionScope precision(bits);
  const auto delta = exact(pair.b.center) - exact(pair.a.center);
  const MpInterval f = support_gap(terms_of<MpInterval>(pair.a), terms_of<MpInterval>(pair.b),
                                   lift<MpInterval>(delta), lift<MpInterval>(direction));
  return f.negative() ? -1 : f.positive() ? 1 : 0;
}

bool separates_in_multiprecision(const Pair& pair, const Rational3& direction, int bits) {
  // not covered: our directions and the search's are not 0, but others may be
  return !is_zero(direction) && support_gap_sign(pair, direction, bits) < 0;
}

namespace {

struct Sides {
  int cap, wall;  // of each: -1 strictly inside, 0 on it, 1 outside
};

// Compares x.w/|w| with height/2 and |x x w|/|w| with radius. Both are squared, to need no square root.
Sides sides_of(const Solid& c, const Rational3& point) {
  const Rational3 x = point - exact(c.center), w = exact(c.axis), across = cross(x, w);
  const mpq_class ww = dot(w, w), along = dot(x, w), half = mpq_class(c.height) / 2, radius(c.radius);
  return {cmp(mpq_class(along * along), mpq_class(half * half * ww)),
          cmp(mpq_class(dot(across, across)), mpq_class(radius * radius * ww))};
}

// Returns whether the point is in the box, or strictly inside. Its sides whose edge is 0 are left out if
// `flat`.
bool is_in_box(const Solid& c, const Rational3& point, bool strictly, bool flat) {
  const auto directions = edge_directions<mpq_class>(c.quaternion);
  const Rational3 x = point - exact(c.center);
  for (std::size_t i = 0; i < 3; ++i) {
    if (flat && c.edges[i] == 0) continue;
    const int side = cmp(mpq_class(abs(dot(x, directions[i]))), mpq_class(mpq_class(c.edges[i]) / 2));
    if (side > 0 || (strictly && side == 0)) return false;
  }
  return true;
}

bool is_in(const Solid& c, const Rational3& point) {
  if (is_half_space(c)) return dot(exact(c.axis), point - exact(c.center)) <= 0;
  if (is_box(c)) return is_in_box(c, point, false, false);
  const Sides sides = sides_of(c, point);
  return sides.cap <= 0 && sides.wall <= 0;
}

// A flat solid is taken as a part of its plane or line. The point must be in the solid.
bool strictly_inside(const Solid& c, const Rational3& point, Hull hull) {
  if (is_half_space(c)) return dot(exact(c.axis), point - exact(c.center)) < 0;
  if (is_box(c)) return is_in_box(c, point, true, hull != Hull::space);
  const Sides sides = sides_of(c, point);
  return (level(hull) || sides.cap < 0) && (thin(hull) || sides.wall < 0);
}

// Returns whether the hulls are two planes, or a plane and a line, that are not parallel.
bool cross_at_an_angle(const Pair& pair, Hull hull_a, Hull hull_b) {
  const Rational3 w0 = hull_axis(pair.a), w1 = hull_axis(pair.b), normal = cross(w0, w1);
  if (hull_a == hull_b) return hull_a == Hull::plane && dot(normal, normal) != 0;
  return hull_a != Hull::center && hull_b != Hull::center && dot(w0, w1) != 0;
}

}  // namespace

bool in_both_exact(const Pair& pair, const Rational3& point) {
  return is_in(pair.a, point) && is_in(pair.b, point);
}

bool in_each_exact(const Pair& pair, const Rational3& on_a, const Rational3& on_b) {
  return is_in(pair.a, on_a) && is_in(pair.b, on_b);
}

mpq_class contact_distance_of(const Pair& pair) {
  return mpq_class(pair.a.rounding) + mpq_class(pair.b.rounding);
}

Rational3 project_to_hull(const Solid& c, const Rational3& point, Hull hull) {
  const Hull in = hull_within(c, hull);
  const Rational3 center = exact(c.center);
  if (in == Hull::space) return point;
  if (in == Hull::center) return center;
  const Rational3 w = hull_axis(c), x = point - center;
  const Rational3 along = mpq_class(dot(x, w) / dot(w, w)) * w;
  return center + (in == Hull::line ? along : x - along);
}

bool overlap_at(const Pair& pair, const Rational3& point) {
  if (is_rounded(pair)) return true;
  const Hull hull_a = own_hull(pair.a), hull_b = own_hull(pair.b);
  if (hull_a == Hull::space || hull_b == Hull::space)
    return strictly_inside(pair.a, point, Hull::space) || strictly_inside(pair.b, point, Hull::space);
  return cross_at_an_angle(pair, hull_a, hull_b) && strictly_inside(pair.a, point, hull_a) &&
         strictly_inside(pair.b, point, hull_b);
}

std::optional<Rational3> project_to_hulls(const Pair& pair, const Rational3& point, const Hulls& hulls) {
  // A hull lies in planes x.normal = offset: in one if it is a plane, two if a line, three if a centre. Each
  // is made orthogonal to the planes before it. If nothing is left of a normal, its offset must be 0 too.
  struct Plane {
    Rational3 normal;
    mpq_class offset;
  };
  std::vector<Plane> planes;
  bool empty = false;
  auto add = [&](Rational3 normal, const Rational3& through) {
    mpq_class offset = dot(normal, through);
    for (const Plane& p : planes) {
      const mpq_class share = dot(normal, p.normal) / dot(p.normal, p.normal);
      normal = normal - share * p.normal;
      offset -= share * p.offset;
    }
    if (dot(normal, normal) != 0)
      planes.push_back({normal, offset});
    else if (offset != 0)
      empty = true;
  };
  for (const bool second : {false, true}) {
    const Solid& c = second ? pair.b : pair.a;
    const Hull hull = hull_within(c, hulls[second ? 1 : 0]);
    if (hull == Hull::space) continue;
    const Rational3 w = hull_axis(c), center = exact(c.center);
    if (level(hull)) add(w, center);
    if (thin(hull)) {
      // Any vector not along w gives a first normal; the coordinate vector of w's least coordinate is one.
      const bool x_least = abs(w.x) <= abs(w.y) && abs(w.x) <= abs(w.z), y_least = abs(w.y) <= abs(w.z);
      const Rational3 other{x_least ? 1 : 0, !x_least && y_least ? 1 : 0, !x_least && !y_least ? 1 : 0};
      const Rational3 first = cross(w, other);
      add(first, center);
      add(cross(w, first), center);
    }
  }
  if (empty) return std::nullopt;
  Rational3 x = point;
  for (const Plane& p : planes) {
    const mpq_class share = (p.offset - dot(p.normal, x)) / dot(p.normal, p.normal);
    x = x + share * p.normal;
  }
  return x;
}

}  // namespace cyl
