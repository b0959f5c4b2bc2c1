// SPDX-License-Identifier: MIT
#include "oracles/trial/shown_distance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cyl {
namespace {

/// The error of some forty operations in long double, relative to the lengths in them.
constexpr long double wide_error = 0x1p-57L;
using Wide = Eigen::Matrix<long double, 3, 1>;

/// One solid in long double: its unit axis, its support, and how far an offset from its centre is outside.
struct WideSolid {
  explicit WideSolid(const Cylinder& c)
      : axis(c.axis.cast<long double>().normalized()),
        radius(c.radius),
        half(static_cast<long double>(c.height) / 2),
        rounding(c.rounding) {}
  long double support(const Wide& d) const {
    return radius * d.cross(axis).norm() + half * std::abs(d.dot(axis)) + rounding * d.norm();
  }
  long double outside(const Wide& x) const {
    const long double along = std::abs(x.dot(axis)), across = x.cross(axis).norm();
    return std::max(0.0L,
                    std::hypot(std::max(0.0L, along - half), std::max(0.0L, across - radius)) - rounding);
  }
  Wide axis;
  long double radius, half, rounding;
};

}  // namespace

Enclosure shown_distance(const Pair& pair, const Distance& measured) {
  const WideSolid a(pair.a), b(pair.b);
  const Wide delta = pair.b.center.cast<long double>() - pair.a.center.cast<long double>(),
             u = measured.direction.cast<long double>(), x = measured.on_a.cast<long double>(),
             y = measured.on_b.cast<long double>();
  const long double slack =
      wide_error * (a.radius + a.half + a.rounding + b.radius + b.half + b.rounding + delta.norm());
  const long double least = (u.dot(delta) - a.support(u) - b.support(u)) / u.norm() - slack;
  const long double most =
      measured.value > 0 ? (delta + y - x).norm() + a.outside(x) + b.outside(y) + slack : 0;
  constexpr long double largest = std::numeric_limits<double>::max();
  if (!(std::abs(least) < largest && most < largest))
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  return {static_cast<double>(least), static_cast<double>(most)};
}

}  // namespace cyl
