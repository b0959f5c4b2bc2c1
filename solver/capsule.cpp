// SPDX-License-Identifier: MIT
#include "solver/capsule.hpp"

#include <algorithm>
#include <cmath>

#include "solver/detail/frame.hpp"

namespace cyl::seeds {
namespace {

double distance_to_segment(const Vector3& x, const Vector3& p0, const Vector3& p1) noexcept {
  const Vector3 d = p1 - p0;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(x - p0, d) / square, 0.0, 1.0) : 0;
  // From the nearer end, so that the end itself is met exactly.
  return t <= 0.5 ? length(x - p0 - t * d) : length(x - p1 + (1 - t) * d);
}

Capsule along(const Prepared& c, double half_length, double radius) noexcept {
  const Vector3 reach = half_length * c.unit_axis;
  return {c.center - reach, c.center + reach, radius};
}

double slack(const Prepared& c) noexcept { return proxy_error * (length(c.center) + c.height + c.radius); }

}  // namespace

double segment_distance(const Vector3& p0, const Vector3& p1, const Vector3& q0, const Vector3& q1) noexcept {
  // The minimum is at an end of one of them, or inside both. Each candidate is the distance of two points of
  // the segments, so a bad one costs nothing: the least is the answer.
  double least = std::min({distance_to_segment(p0, q0, q1), distance_to_segment(p1, q0, q1),
                           distance_to_segment(q0, p0, p1), distance_to_segment(q1, p0, p1)});
  const Vector3 d = p1 - p0, e = q1 - q0, n = d.cross(e);
  const double square = dot(n, n);
  if (square > 0) {
    // By the normal, not by |d|^2 |e|^2 - (d.e)^2, which for nearly parallel segments is rounding alone.
    const double s = dot((q0 - p0).cross(e), n) / square;
    if (s > 0 && s < 1) least = std::min(least, distance_to_segment(p0 + s * d, q0, q1));
  }
  return least;
}

double capsule_distance(const Capsule& a, const Capsule& b) noexcept {
  return segment_distance(a.from, a.to, b.from, b.to) - (a.radius + b.radius);
}

Capsule outer_proxy(const Prepared& c) noexcept { return along(c, c.height / 2, c.radius + slack(c)); }
Capsule outer_proxy(const Cylinder& c) noexcept { return outer_proxy(prepare(c)); }

Capsule inner_proxy(const Cylinder& c) noexcept { return inner_proxy(prepare(c)); }
Capsule inner_proxy(const Prepared& c) noexcept {
  const double radius = std::min(c.radius, c.height / 2);
  return along(c, c.height / 2 - radius, radius - slack(c));
}

}  // namespace cyl::seeds
