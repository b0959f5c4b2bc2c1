// SPDX-License-Identifier: MIT
#include "oracles/referee/certificate_check.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
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

Vec3<double> plain(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

double max_abs(const Vec3<double>& v) {
  return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
}

// Returns 2^exponent, which must be a normal double.
double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// Returns x 2^exponent. Clears `exact` if the way back does not give x.
double scaled(double x, int exponent, bool& exact) {
  if (exponent > -1000 && exponent < 1000) {
    const double y = x * power_of_two(exponent);
    if (y * power_of_two(-exponent) != x) exact = false;
    return y;
  }
  const double y = std::ldexp(x, exponent);
  if (std::ldexp(y, -exponent) != x) exact = false;
  return y;
}

Vec3<double> scaled(const Vec3<double>& v, int exponent, bool& exact) {
  return {scaled(v.x, exponent, exact), scaled(v.y, exponent, exact), scaled(v.z, exponent, exact)};
}

// A Hull is a set of coordinates that are 0 in it: bit 1 along the axis, bit 2 across it.
static_assert(static_cast<int>(Hull::plane) == 1 && static_cast<int>(Hull::line) == 2 &&
              static_cast<int>(Hull::center) == 3);
bool level(Hull hull) { return (static_cast<int>(hull) & 1) != 0; }
bool thin(Hull hull) { return (static_cast<int>(hull) & 2) != 0; }
Hull both(Hull x, Hull y) { return static_cast<Hull>(static_cast<int>(x) | static_cast<int>(y)); }

// A flat box has the hull of a disk, segment or point.
Hull own_hull(const Solid& c) {
  if (is_half_space(c)) return Hull::space;
  if (is_box(c)) {
    constexpr std::array hulls{Hull::space, Hull::plane, Hull::line, Hull::center};
    return hulls[static_cast<std::size_t>(std::ranges::count(c.edges, 0.0))];
  }
  return both(c.height == 0 ? Hull::plane : Hull::space, c.radius == 0 ? Hull::line : Hull::space);
}

// The hull that an answer names for a box counts for nothing: its own is always meant.
Hull hull_within(const Solid& c, Hull named) { return is_box(c) ? own_hull(c) : both(own_hull(c), named); }

// Returns the edge that gives the direction of a flat box's hull: its only edge that is 0, or is not 0.
std::size_t hull_edge(const Solid& box) {
  const bool plane = own_hull(box) == Hull::plane;
  for (std::size_t i = 0; i < 2; ++i)
    if ((box.edges[i] == 0) == plane) return i;
  return 2;
}

// Returns the normal of the hull if that is a plane, its direction if it is a line.
Rational3 hull_axis(const Solid& c) {
  return is_box(c) ? edge_directions<mpq_class>(c.quaternion)[hull_edge(c)] : exact(c.axis);
}

}  // namespace

template <class R>
BasicFilter<R>::BasicFilter(const Pair& pair) {
  const Solid &a = pair.a, &b = pair.b;
  double most = std::fmax(std::fmax(a.radius, a.height), std::fmax(b.radius, b.height));
  for (int i = 0; i < 3; ++i) most = std::fmax(most, std::fabs(b.center[i] - a.center[i]));
  most = std::fmax(most, std::fmax(a.rounding, b.rounding));
  for (const Solid* c : {&a, &b}) most = std::fmax(most, std::ranges::max(c->edges));
  if (!std::isfinite(most)) return;
  exponent_ = most > 0 ? std::ilogb(most) : 0;
  bool exact = true;
  auto solid = [&](const Solid& c) {
    Lifted s;
    const Vec3<double> center = scaled(plain(c.center), -exponent_, exact);
    s.center = {center.x, center.y, center.z};
    s.radius = scaled(c.radius, -exponent_, exact);
    s.half = R(scaled(c.height, -exponent_, exact)) / 2;
    s.rounding = scaled(c.rounding, -exponent_, exact);
    s.rounded = c.rounding != 0;
    s.hull = own_hull(c);
    s.box = is_box(c);
    if (s.box) {
      std::array<double, 4> q = c.quaternion;
      const double greatest = std::fmax(max_abs({q[0], q[1], q[2]}), std::fabs(q[3]));
      for (double& x : q) x = scaled(x, -std::ilogb(greatest), exact);
      s.edges = edge_directions<I>(q);
      for (std::size_t i = 0; i < 3; ++i) s.halves[i] = R(scaled(c.edges[i], -exponent_, exact)) / 2;
      s.axis = s.edges[hull_edge(c)];
      return s;
    }
    const Vec3<double> w = plain(c.axis);
    const Vec3<I> axis = lift<I>(scaled(w, -std::ilogb(max_abs(w)), exact));
    s.axis = axis / norm(axis);
    return s;
  };
  a_ = solid(a);
  b_ = solid(b);
  delta_ = lift<I>(b_.center) - lift<I>(a_.center);
  usable_ = exact;
}

template <class R>
bool BasicFilter<R>::separates(const double direction[3]) const {
  const Vec3<double> given{direction[0], direction[1], direction[2]};
  const double most = max_abs(given);
  // not covered: our directions are finite, but others may not be
  if (!(most > 0) || !std::isfinite(most)) return false;
  bool exact = true;
  const Vec3<double> d = scaled(given, -std::ilogb(most), exact);
  // not covered: the greatest coordinate of our directions is about 1, as the scale is
  return exact && separates(Vec3<R>{d.x, d.y, d.z});
}

template <class R>
auto BasicFilter<R>::support_gap(const Vec3<I>& d) const -> I {
  if (!usable_) return I::everything();
  return cyl::support_gap<I>(a_, b_, delta_, d);
}

template <class R>
bool BasicFilter<R>::separates(const Vec3<R>& direction) const {
  return support_gap(lift<I>(direction)).hi < 0;
}

template <class R>
Hull BasicFilter<R>::Lifted::within(Hull named) const {
  return this->box ? hull : both(hull, named);
}

template <class R>
bool BasicFilter<R>::is_in(const Lifted& s, Hull hull, const Vec3<I>& at) {
  if (s.box) {
    for (std::size_t i = 0; i < 3; ++i)
      if ((hull == Hull::space || s.halves[i].lo > 0) && !(abs(dot(at, s.edges[i])).hi <= s.halves[i].lo))
        return false;
    return true;
  }
  return (level(hull) || abs(dot(at, s.axis)).hi <= s.half.lo) &&
         (thin(hull) || norm(cross(at, s.axis)).hi <= s.radius.lo);
}

template <class R>
bool BasicFilter<R>::is_strictly_in(const Lifted& s, Hull hull, const Vec3<I>& at) {
  if (s.box) {
    for (std::size_t i = 0; i < 3; ++i)
      if ((hull == Hull::space || s.halves[i].lo > 0) && !(abs(dot(at, s.edges[i])).hi < s.halves[i].lo))
        return false;
    return true;
  }
  return (level(hull) || abs(dot(at, s.axis)).hi < s.half.lo) &&
         (thin(hull) || norm(cross(at, s.axis)).hi < s.radius.lo);
}

template <class R>
bool BasicFilter<R>::in_both(const double head[3], const double tail[3]) const {
  if (!usable_) return false;
  bool exact = true;
  const Vec3<double> h = scaled({head[0], head[1], head[2]}, -exponent_, exact);
  const Vec3<double> t = scaled({tail[0], tail[1], tail[2]}, -exponent_, exact);
  // not covered: our tails are sums of multiples of unit axes, whose coordinates are 0 or at least 2^-200
  if (!exact) return false;
  for (const Lifted* s : {&a_, &b_}) {
    const Vec3<I> x = (lift<I>(h) - lift<I>(s->center)) + lift<I>(t);
    if (!is_in(*s, Hull::space, x)) return false;
  }
  return true;
}

template <class R>
bool BasicFilter<R>::overlap_at(const Vec3<R>& guess, const Hulls& hulls) const {
  return usable_ && overlap_near(lift<I>(guess), hulls);
}

template <class R>
bool BasicFilter<R>::overlap_at(const double head[3], const double tail[3], const Hulls& hulls) const {
  bool exact = usable_;
  const Vec3<double> h = scaled({head[0], head[1], head[2]}, -exponent_, exact);
  const Vec3<double> t = scaled({tail[0], tail[1], tail[2]}, -exponent_, exact);
  return exact && overlap_near((lift<I>(h) - lift<I>(a_.center)) + lift<I>(t), hulls);
}

template <class R>
auto BasicFilter<R>::moved(const Lifted& s, Hull hull, const Vec3<I>& from) -> Vec3<I> {
  if (hull == Hull::space) return from;
  if (hull == Hull::center) return Vec3<I>{};
  const Vec3<I> along = dot(from, s.axis) * s.axis;
  return hull == Hull::line ? along : from - along;
}

template <class R>
bool BasicFilter<R>::come_near(const ExactVector& on_a, const ExactVector& on_b, const Hulls& hulls) const {
  bool exact = true;
  const auto from_center = [&](const Lifted& s, const ExactVector& v) {
    const Vec3<double> h = scaled({v.head[0], v.head[1], v.head[2]}, -exponent_, exact);
    const Vec3<double> t = scaled({v.tail[0], v.tail[1], v.tail[2]}, -exponent_, exact);
    return (lift<I>(h) - lift<I>(s.center)) + lift<I>(t);
  };
  const Vec3<I> x = from_center(a_, on_a), y = from_center(b_, on_b);
  return exact && close_at(x, y, hulls);
}

template <class R>
bool BasicFilter<R>::come_near(const Vec3<R>& on_a, const Vec3<R>& on_b) const {
  return close_at(lift<I>(on_a), lift<I>(on_b), {});
}

template <class R>
bool BasicFilter<R>::close_at(const Vec3<I>& from_a, const Vec3<I>& from_b, const Hulls& hulls) const {
  const Hull hull_a = a_.within(hulls[0]), hull_b = b_.within(hulls[1]);
  const Vec3<I> x = moved(a_, hull_a, from_a), y = moved(b_, hull_b, from_b);
  return usable_ && is_in(a_, hull_a, x) && is_in(b_, hull_b, y) &&
         norm(delta_ + y - x).hi <= (a_.rounding + b_.rounding).lo;
}

// The points move by vectors that are known only as intervals. The exact unit axes give the point that is
// meant. It lies in the hulls exactly, so a coordinate that is 0 there needs no proof.
//
// Two flat solids overlap if their planes, or a plane and a line, cross at a point strictly inside both.
// Then a - b holds a ball about 0, so f > 0 in every direction.
template <class R>
bool BasicFilter<R>::overlap_near(Vec3<I> x, const Hulls& hulls) const {
  const Hull hull_a = a_.within(hulls[0]), hull_b = b_.within(hulls[1]);
  if (hull_a != Hull::space && hull_b != Hull::space) {
    const bool swap = hull_b != Hull::plane;  // now `second` lies in a plane
    const Lifted &first = swap ? b_ : a_, &second = swap ? a_ : b_;
    const Hull hull = swap ? hull_b : hull_a;
    if ((swap && hull_a != Hull::plane) || hull == Hull::center) return false;
    const Vec3<I>&w0 = first.axis, &w1 = second.axis;
    const Vec3<I> to_second = swap ? I(-1) * delta_ : delta_;
    const Vec3<I> slide = hull == Hull::plane ? w1 - dot(w0, w1) * w0 : w0;  // within the first solid
    Vec3<I> y = moved(first, hull, swap ? x - delta_ : x);
    y = y - (dot(y - to_second, w1) / dot(slide, w1)) * slide;  // everything if the two may be parallel
    return is_strictly_in(first, hull, y) && is_strictly_in(second, Hull::plane, y - to_second);
  }
  if (hull_a != Hull::space) x = moved(a_, hull_a, x);
  if (hull_b != Hull::space) x = moved(b_, hull_b, x - delta_) + delta_;
  return is_strictly_in(a_, hull_a, x) && is_strictly_in(b_, hull_b, x - delta_);
}

template class BasicFilter<double>;
template class BasicFilter<long double>;

// GMP rounds to double towards 0, and to infinity if the number is too large.
Vec3<Interval> enclosed(const Rational3& v) {
  const auto c = [](const mpq_class& x) { return Interval::outward(x.get_d(), x.get_d()); };
  return {c(v.x), c(v.y), c(v.z)};
}

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
  if (direction.x == 0 && direction.y == 0 && direction.z == 0) return false;
  return support_gap_sign(pair, direction, bits) < 0;
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

bool is_flat(const Solid& c) { return own_hull(c) != Hull::space; }

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
