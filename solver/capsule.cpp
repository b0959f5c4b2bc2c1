// SPDX-License-Identifier: MIT
#include "solver/capsule.hpp"

#include <algorithm>
#include <cmath>

#include "solver/detail/frame.hpp"

namespace cyl {
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

double slack(const Prepared& c) noexcept {
  return proxy_error * (length(c.center) + c.height + c.radius + c.rounding);
}

}  // namespace

// The error of segment_distance. u = 2^-53. All terms are of first order in u, except for those that are
// marked. P = p0 p1 and Q = q0 q1 are the segments. A and B are their largest |end|, h and k their lengths, d
// and e their vectors, D their distance.
//
// 1. One candidate. The vector x - p0 - t d is off by u |x - p0| + 2u t h + u |itself|, and t <= 1/2 from the
//    nearer end. So it is off by 2u (A + B) + u h, and its length by 2.5u (A + B) more. The parameter t is a
//    quotient of dots of rounded differences, so t h is off by 11u (A + B). So the distance of an end is
//    right within 16u (A + B) + u (h + k).
//
// 2. Too small. Each candidate is the distance of a point of P from one of Q, except that p0 + s d is off the
//    line by 2u h + u A. So the least candidate is at most 17u (A + B) + 3u (h + k) below D.
//
// 3. Too large. The candidate of the normal n matters only if the nearest points are inside both segments.
//    Let sigma be the sine between d and e, s the true parameter, and l the shorter of h and k. From the
//    nearest points go along P, and along Q at the foot of the perpendicular, until an end comes. After the
//    way z in P the distance has become sqrt(D^2 + (z sigma)^2). That is at most D + z sigma, and at most D +
//    (z sigma)^2 / 2D. An end comes at z sigma <= l sigma. So with z the error of s times h, the least
//    candidate is at most that far above D.
//
// 3.1. The normal is off by 4 sqrt(2) u h k < 6u h k. It has four roundings, and sums such as |d_y e_z| +
// |d_z e_y| have a norm of at most sqrt(2) h k. In the same way (q0 - p0) x e is off by 6u |q0 - p0| k.
//
// 3.2. If sigma <= 24u, an end shows a distance that is too large by at most 24u l. Else n is off by at most
// a quarter of itself, which makes the first order good within 16/9.
//
// 3.3. The error of s moves z sigma by three terms.
// * 9u |q0 - p0|: the dot and the other product.
// * 6u (D / sigma + h): n in the dot. There |(q0 - p0) x e| is at most (D + h sigma) k.
// * 19u h: n twice below, its square, the quotient and s d.
//
// 3.4. Times 16/9 that is 16u (A + B) + 45u h, and 11u D / sigma. The last term adds at most (11u D /
// sigma)^2 / 2D to the distance. The nearest end adds (l sigma)^2 / 2D. The smaller of the two is at most
// their geometric mean, 6u l.
//
// 4. In all. With the roundings of its own distance the least is at most 33u (A + B) + 54u (h + k) above D. A
//    is at most |middle| + h / 2. So the error is below 33u |middles| + 71u (h + k). The two sums of
//    capsule_distance add 2u of the same. That is 75u in all, and proxy_distance_error is 256u.
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

Capsule outer_proxy(const Prepared& c) noexcept {
  return along(c, c.height / 2, c.radius + c.rounding + slack(c));
}
Capsule outer_proxy(const Cylinder& c) noexcept { return outer_proxy(prepare(c)); }

Capsule inner_proxy(const Cylinder& c) noexcept { return inner_proxy(prepare(c)); }
Capsule inner_proxy(const Prepared& c) noexcept {
  const double radius = std::min(c.radius, c.height / 2);
  return along(c, c.height / 2 - radius, radius + c.rounding - slack(c));
}

}  // namespace cyl
