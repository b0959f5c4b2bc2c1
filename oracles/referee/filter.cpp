// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/solid_hull.hpp"

namespace cyl {
namespace {

using I = Interval;

Vec3<I> lift(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

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

}  // namespace

Filter::Filter(const Pair& pair) {
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
    s.center = center;
    s.radius = scaled(c.radius, -exponent_, exact);
    s.half = scaled(c.height, -exponent_, exact) / 2;
    s.rounding = scaled(c.rounding, -exponent_, exact);
    s.rounded = c.rounding != 0;
    s.hull = own_hull(c);
    s.box = is_box(c);
    if (s.box) {
      std::array<double, 4> q = c.quaternion;
      const double greatest = std::fmax(max_abs({q[0], q[1], q[2]}), std::fabs(q[3]));
      for (double& x : q) x = scaled(x, -std::ilogb(greatest), exact);
      s.edges = edge_directions<I>(q);
      for (std::size_t i = 0; i < 3; ++i) s.halves[i] = scaled(c.edges[i], -exponent_, exact) / 2;
      s.axis = s.edges[hull_edge(c)];
      return s;
    }
    const Vec3<double> w = plain(c.axis);
    const Vec3<I> axis = lift(scaled(w, -std::ilogb(max_abs(w)), exact));
    s.axis = axis / norm(axis);
    return s;
  };
  a_ = solid(a);
  b_ = solid(b);
  delta_ = lift(b_.center) - lift(a_.center);
  usable_ = exact;
}

bool Filter::separates(const double direction[3]) const {
  const Vec3<double> given{direction[0], direction[1], direction[2]};
  const double most = max_abs(given);
  // not covered: our directions are finite, but others may not be
  if (!(most > 0) || !std::isfinite(most)) return false;
  bool exact = true;
  const Vec3<double> d = scaled(given, -std::ilogb(most), exact);
  // not covered: the greatest coordinate of our directions is about 1, as the scale is
  return exact && separates(d);
}

I Filter::support_gap(const Vec3<I>& d) const {
  if (!usable_) return I::everything();
  return cyl::support_gap<I>(a_, b_, delta_, d);
}

bool Filter::separates(const Vec3<double>& direction) const { return support_gap(lift(direction)).hi < 0; }

Hull Filter::Lifted::within(Hull named) const { return this->box ? hull : both(hull, named); }

bool Filter::is_in(const Lifted& s, Hull hull, const Vec3<I>& at) {
  if (s.box) {
    for (std::size_t i = 0; i < 3; ++i)
      if ((hull == Hull::space || s.halves[i].lo > 0) && !(abs(dot(at, s.edges[i])).hi <= s.halves[i].lo))
        return false;
    return true;
  }
  return (level(hull) || abs(dot(at, s.axis)).hi <= s.half.lo) &&
         (thin(hull) || norm(cross(at, s.axis)).hi <= s.radius.lo);
}

bool Filter::is_strictly_in(const Lifted& s, Hull hull, const Vec3<I>& at) {
  if (s.box) {
    for (std::size_t i = 0; i < 3; ++i)
      if ((hull == Hull::space || s.halves[i].lo > 0) && !(abs(dot(at, s.edges[i])).hi < s.halves[i].lo))
        return false;
    return true;
  }
  return (level(hull) || abs(dot(at, s.axis)).hi < s.half.lo) &&
         (thin(hull) || norm(cross(at, s.axis)).hi < s.radius.lo);
}

bool Filter::in_both(const double head[3], const double tail[3]) const {
  if (!usable_) return false;
  bool exact = true;
  const Vec3<double> h = scaled({head[0], head[1], head[2]}, -exponent_, exact);
  const Vec3<double> t = scaled({tail[0], tail[1], tail[2]}, -exponent_, exact);
  // not covered: our tails are sums of multiples of unit axes, whose coordinates are 0 or at least 2^-200
  if (!exact) return false;
  for (const Lifted* s : {&a_, &b_}) {
    const Vec3<I> x = (lift(h) - lift(s->center)) + lift(t);
    if (!is_in(*s, Hull::space, x)) return false;
  }
  return true;
}

bool Filter::overlap_at(const Vec3<double>& guess, const Hulls& hulls) const {
  return usable_ && overlap_near(lift(guess), hulls);
}

bool Filter::overlap_at(const double head[3], const double tail[3], const Hulls& hulls) const {
  bool exact = usable_;
  const Vec3<double> h = scaled({head[0], head[1], head[2]}, -exponent_, exact);
  const Vec3<double> t = scaled({tail[0], tail[1], tail[2]}, -exponent_, exact);
  return exact && overlap_near((lift(h) - lift(a_.center)) + lift(t), hulls);
}

Vec3<I> Filter::moved(const Lifted& s, Hull hull, const Vec3<I>& from) {
  if (hull == Hull::space) return from;
  if (hull == Hull::center) return Vec3<I>{};
  const Vec3<I> along = dot(from, s.axis) * s.axis;
  return hull == Hull::line ? along : from - along;
}

bool Filter::come_near(const ExactVector& on_a, const ExactVector& on_b, const Hulls& hulls) const {
  bool exact = true;
  const auto from_center = [&](const Lifted& s, const ExactVector& v) {
    const Vec3<double> h = scaled({v.head[0], v.head[1], v.head[2]}, -exponent_, exact);
    const Vec3<double> t = scaled({v.tail[0], v.tail[1], v.tail[2]}, -exponent_, exact);
    return (lift(h) - lift(s.center)) + lift(t);
  };
  const Vec3<I> x = from_center(a_, on_a), y = from_center(b_, on_b);
  return exact && close_at(x, y, hulls);
}

bool Filter::come_near(const Vec3<double>& on_a, const Vec3<double>& on_b) const {
  return close_at(lift(on_a), lift(on_b), {});
}

bool Filter::close_at(const Vec3<I>& from_a, const Vec3<I>& from_b, const Hulls& hulls) const {
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
bool Filter::overlap_near(Vec3<I> x, const Hulls& hulls) const {
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

}  // namespace cyl
