// SPDX-License-Identifier: MIT
#include "solver/literature/octant_2017.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/detail/frame.hpp"

namespace cyl::literature {
namespace {

double own_sign(double given, double x) noexcept { return given != 0 ? given : x > 0 ? 1 : x < 0 ? -1 : 0; }

double eta(const Vector3& w, const Vector3& d, bool printed) noexcept {
  if (!printed) return length(d.cross(w));
  const double along = dot(d, w);
  return std::sqrt(dot(d, d) - along * along);
}

/// Returns the gradient of r |P D| + h Sign(L) D.W with respect to D.
Vector3 rise(const Octant& o, const Vector3& w, double r, double h, double sign, const Vector3& d) noexcept {
  const double root = eta(w, d, o.printed_roots);
  const double side = own_sign(sign, dot(d, w));
  if (!(root > 0) && !o.printed_gradient) return h * side * w;  // the tip of a cone: 0 is a subgradient
  const Vector3 across = o.printed_roots ? Vector3(d - dot(d, w) * w) : w.cross(d.cross(w));
  return r / root * across + h * side * w;
}

}  // namespace

double Octant::along(int i, const Point& x) const noexcept { return dot(at(x), i == 0 ? w0 : w1); }

double Octant::value(const Point& x, Signs signs) const noexcept {
  const Vector3 d = at(x);
  const double l0 = dot(d, w0), l1 = dot(d, w1);
  return r0 * eta(w0, d, printed_roots) + r1 * eta(w1, d, printed_roots) + h0 * own_sign(signs.l0, l0) * l0 +
         h1 * own_sign(signs.l1, l1) * l1 - d.z() * length;
}

Point Octant::gradient(const Point& x, Signs signs) const noexcept {
  const Vector3 d = at(x);
  const Vector3 g = rise(*this, w0, r0, h0, signs.l0, d) + rise(*this, w1, r1, h1, signs.l1, d);
  return {g.x() - g.z() + length, g.y() - g.z() + length};
}

double Octant::across(int i, const Point& x) const noexcept {
  return cyl::length(at(x).cross(i == 0 ? w0 : w1));
}

Point Octant::off_axis(int i, const Point& x, Signs signs) const noexcept {
  Octant rest = *this;
  (i == 0 ? rest.r0 : rest.r1) = 0;
  const Point g = rest.gradient(x, signs);
  const Vector3& w = i == 0 ? w0 : w1;
  const double ac = w.x() - w.z(), bc = w.y() - w.z();
  const double ss = 2 - ac * ac, st = 1 - ac * bc,
               tt = 2 - bc * bc;  // determinant (a+b+c)^2, >= 1 in the octant
  return {st * g.y() - tt * g.x(), st * g.x() - ss * g.y()};
}

Point Cell::middle() const noexcept {
  Point sum(0, 0);
  for (int k = 0; k < count; ++k) sum += corners[k];
  return sum / count;
}

bool Cell::keep(const Octant& octant, int i, double sign) noexcept {
  Point kept[2 * corner_cap];
  int more = 0;
  bool inside = false;
  for (int k = 0; k < count; ++k) {
    const Point& from = corners[k];
    const Point& to = corners[(k + 1) % count];
    const double here = sign * octant.along(i, from), there = sign * octant.along(i, to);
    inside |= here > 0;
    if (here >= 0) kept[more++] = from;
    if (here * there < 0) kept[more++] = from + here / (here - there) * (to - from);
  }
  if (!inside) return false;
  count = std::min(more, corner_cap);
  std::copy_n(kept, count, corners);
  (i == 0 ? signs.l0 : signs.l1) = sign;
  return true;
}

Cell::Interval Cell::chord(const Point& x, const Point& d) const noexcept {
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (int k = 0; k < count; ++k) {
    const Point side = corners[(k + 1) % count] - corners[k], out = x - corners[k];
    const double room = std::max(0.0, side.x() * out.y() - side.y() * out.x());
    const double drift = side.x() * d.y() - side.y() * d.x();  // of the room, a unit of r
    if (drift > 0) low = std::max(low, -room / drift);
    if (drift < 0) high = std::min(high, room / -drift);
  }
  return {low, high};
}

}  // namespace cyl::literature
