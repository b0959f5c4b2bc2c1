// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/certificate_check.hpp"

namespace cyl {
namespace {

template <class I>
Vec3<I> lift(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
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

}  // namespace

template <class I>
BasicFilter<I>::BasicFilter(const Pair& pair) {
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
    s.plane = is_half_space(c);
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
    const Vec3<I> axis = lift<I>(scaled(w, -std::ilogb(max_abs(w)), exact));
    s.axis = axis / norm(axis);
    return s;
  };
  a_ = solid(a);
  b_ = solid(b);
  delta_ = lift<I>(b_.center) - lift<I>(a_.center);
  usable_ = exact;
}

template <class I>
bool BasicFilter<I>::separates(const double direction[3]) const {
  const Vec3<double> given{direction[0], direction[1], direction[2]};
  const double most = max_abs(given);
  // not covered: our directions are finite, but others may not be
  if (!(most > 0) || !std::isfinite(most)) return false;
  bool exact = true;
  const Vec3<double> d = scaled(given, -std::ilogb(most), exact);
  // not covered: the greatest coordinate of our directions is about 1, as the scale is
  return exact && separates(lift<I>(d));
}

template <class I>
I BasicFilter<I>::support_gap(const Vec3<I>& d) const {
  if (!usable_ || a_.plane || b_.plane) return I::everything();
  return cyl::support_gap<I>(a_, b_, delta_, d);
}

template <class I>
bool BasicFilter<I>::separates(const Vec3<I>& direction) const {
  return surely_less(support_gap(direction), I(0.0));
}

template <class I>
bool BasicFilter<I>::Lifted::holds(Hull of, const Vec3<I>& at, bool strictly) const {
  const auto below = [&](const I& x, const I& most) {
    return strictly ? surely_less(x, most) : surely_at_most(x, most);
  };
  if (plane) return below(dot(at, this->axis), I(0.0));
  if (!this->box)
    return (level(of) || below(abs(dot(at, this->axis)), this->half)) &&
           (thin(of) || below(norm(cross(at, this->axis)), this->radius));
  for (std::size_t i = 0; i < 3; ++i)
    if ((of == Hull::space || surely_less(I(0.0), this->halves[i])) &&
        !below(abs(dot(at, this->edges[i])), this->halves[i]))
      return false;
  return true;
}

template <class I>
std::optional<Vec3<I>> BasicFilter<I>::from_center(const Lifted& s, const double head[3],
                                                   const double tail[3]) const {
  bool exact = usable_;
  const Vec3<double> h = scaled({head[0], head[1], head[2]}, -exponent_, exact);
  const Vec3<double> t = scaled({tail[0], tail[1], tail[2]}, -exponent_, exact);
  // not covered: our tails are sums of multiples of unit axes, whose coordinates are 0 or at least 2^-200
  if (!exact) return {};
  return (lift<I>(h) - lift<I>(s.center)) + lift<I>(t);
}

template <class I>
bool BasicFilter<I>::in_both(const double head[3], const double tail[3]) const {
  for (const Lifted* s : {&a_, &b_})
    if (const auto x = from_center(*s, head, tail); !x || !s->holds(Hull::space, *x)) return false;
  return true;
}

template <class I>
bool BasicFilter<I>::overlap_at(const double head[3], const double tail[3], const Hulls& hulls) const {
  const auto x = from_center(a_, head, tail);
  return x && overlap_at(*x, hulls);
}

template <class I>
Vec3<I> BasicFilter<I>::Lifted::moved(Hull into, const Vec3<I>& from) const {
  if (into == Hull::space) return from;
  if (into == Hull::center) return Vec3<I>{};
  const Vec3<I> along = dot(from, this->axis) * this->axis;
  return into == Hull::line ? along : from - along;
}

template <class I>
bool BasicFilter<I>::come_near(const ExactVector& on_a, const ExactVector& on_b, const Hulls& hulls) const {
  const auto x = from_center(a_, on_a.head.data(), on_a.tail.data()),
             y = from_center(b_, on_b.head.data(), on_b.tail.data());
  return x && y && come_near(*x, *y, hulls);
}

template <class I>
bool BasicFilter<I>::come_near(const Vec3<I>& on_a, const Vec3<I>& on_b, const Hulls& hulls) const {
  const Hull hull_a = a_.within(hulls[0]), hull_b = b_.within(hulls[1]);
  const Vec3<I> x = a_.moved(hull_a, on_a), y = b_.moved(hull_b, on_b);
  return usable_ && a_.holds(hull_a, x) && b_.holds(hull_b, y) &&
         surely_at_most(norm(delta_ + y - x), a_.rounding + b_.rounding);
}

// The points move by vectors that are known only as intervals. The exact unit axes give the point that is
// meant. It lies in the hulls exactly, so a coordinate that is 0 there needs no proof.
//
// Two flat solids overlap if their planes, or a plane and a line, cross at a point strictly inside both.
// Then a - b holds a ball about 0, so f > 0 in every direction.
template <class I>
bool BasicFilter<I>::overlap_at(Vec3<I> x, const Hulls& hulls) const {
  if (!usable_) return false;
  const Hull hull_a = a_.within(hulls[0]), hull_b = b_.within(hulls[1]);
  if (hull_a != Hull::space && hull_b != Hull::space) {
    const bool swap = hull_b != Hull::plane;  // now `second` lies in a plane
    const Lifted &first = swap ? b_ : a_, &second = swap ? a_ : b_;
    const Hull hull = swap ? hull_b : hull_a;
    if ((swap && hull_a != Hull::plane) || hull == Hull::center) return false;
    const Vec3<I>&w0 = first.axis, &w1 = second.axis;
    const Vec3<I> to_second = swap ? I(-1.0) * delta_ : delta_;
    const Vec3<I> slide = hull == Hull::plane ? w1 - dot(w0, w1) * w0 : w0;  // within the first solid
    Vec3<I> y = first.moved(hull, swap ? x - delta_ : x);
    y = y - (dot(y - to_second, w1) / dot(slide, w1)) * slide;  // everything if the two may be parallel
    return first.holds(hull, y, true) && second.holds(Hull::plane, y - to_second, true);
  }
  x = a_.moved(hull_a, x);
  if (hull_b != Hull::space) x = b_.moved(hull_b, x - delta_) + delta_;
  return a_.holds(hull_a, x, true) && b_.holds(hull_b, x - delta_, true);
}

template class BasicFilter<Interval>;
template class BasicFilter<TwinInterval>;

}  // namespace cyl
