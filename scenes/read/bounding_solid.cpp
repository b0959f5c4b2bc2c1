// SPDX-License-Identifier: MIT
#include "scenes/read/bounding_solid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cyl {
namespace {

struct Ball {
  Vector3 center{0, 0, 0};
  double radius = 0;
};

using Points = std::span<const Vector3>;
using Support = std::vector<Vector3>;

/// Returns the middle of the sphere through points, in the plane or line that they span. If q_i leads from
/// the first point to the others, then sum_j (q_i q_j) x_j = q_i q_i / 2.
Vector3 middle_of(const Support& points) {
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
  const auto count = static_cast<Eigen::Index>(points.size()) - 1;
  if (count == 0) return points[0];
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> q(3, count);
  for (Eigen::Index i = 0; i < count; ++i) q.col(i) = points[static_cast<std::size_t>(i) + 1] - points[0];
  const Square products = q.transpose() * q;
  return points[0] + q * products.ldlt().solve(0.5 * products.diagonal());
}

const Vector3& farthest(Points points, const Vector3& from) {
  const Vector3* best = points.data();
  double most = -1;
  for (const Vector3& p : points) {
    const double square = (p - from).squaredNorm();
    if (square > most) {
      most = square;
      best = &p;
    }
  }
  return *best;
}

/// Returns the smallest ball around at most five points, and the points that it rests on. It tries the balls
/// through some of the points, widens them until they hold all, and takes the smallest.
std::pair<Ball, Support> ball_around_few(const Support& few) {
  std::pair<Ball, Support> best;
  best.first.radius = INFINITY;
  for (unsigned set = 1; set < 1u << few.size(); ++set) {
    Support chosen;
    for (std::size_t i = 0; i < few.size(); ++i)
      if ((set >> i & 1) != 0) chosen.push_back(few[i]);
    if (chosen.size() > 4) continue;
    const Vector3 center = middle_of(chosen);
    const double radius = (farthest(few, center) - center).norm();
    if (radius < best.first.radius) best = {{center, radius}, std::move(chosen)};
  }
  return best;
}

/// The ball grows over the farthest point until no point is outside. This takes some ten rounds.
constexpr std::size_t rounds_cap = 100;
/// A point may be outside by this part of the radius. The ball is then widened to hold it.
constexpr double outside_tol = 1e-13;

Ball smallest_ball(Points points) {
  Support rest{points[0]};
  Ball ball{points[0], 0};
  for (std::size_t round = 0; round < rounds_cap; ++round) {
    const Vector3 out = farthest(points, ball.center);
    if (!((out - ball.center).norm() > ball.radius * (1 + outside_tol))) break;
    rest.push_back(out);
    std::tie(ball, rest) = ball_around_few(rest);
  }
  ball.radius = (farthest(points, ball.center) - ball.center).norm();
  return ball;
}

/// Factors by which a capsule is tried wider than necessary, because a wider one may be shorter.
constexpr std::array widths{1.0, 1.0625, 1.125, 1.25, 1.5};

/// Returns the least cylinder or capsule along a unit axis. The points' shadow gives its circle.
Solid around_axis(Points points, const Vector3& axis) {
  std::vector<Vector3> shadow(points.begin(), points.end());
  for (Vector3& p : shadow) p -= p.dot(axis) * axis;
  const Ball circle = smallest_ball(shadow);
  double low = INFINITY, high = -INFINITY;
  for (const Vector3& p : points) {
    low = std::min(low, p.dot(axis));
    high = std::max(high, p.dot(axis));
  }
  const Vector3 foot = circle.center - circle.center.dot(axis) * axis;
  Solid best{foot + (low + high) / 2 * axis, axis, circle.radius, high - low, 0};
  for (const double width : widths) {
    const double radius = width * circle.radius;
    double first = INFINITY, last = -INFINITY;  // the ends of the segment
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double reach = std::sqrt(std::max(0.0, radius * radius - (shadow[i] - foot).squaredNorm()));
      first = std::min(first, points[i].dot(axis) + reach);
      last = std::max(last, points[i].dot(axis) - reach);
    }
    const Solid capsule{foot + (first + last) / 2 * axis, axis, 0, std::max(0.0, last - first), radius};
    if (volume_of(capsule) < volume_of(best)) best = capsule;
  }
  return best;
}

/// The first and the last step of an axis in rad, and the share that a step must bring the volume below. The
/// share keeps the axes of a box as they are.
constexpr double first_step = 0.4, last_step = 1e-3, worth = 0.999;

Solid along_the_best_axis(Points points) {
  Solid best = around_axis(points, {0, 0, 1});
  const auto better = [&](const Vector3& axis, double share) {
    const Solid tried = around_axis(points, axis.normalized());
    if (!(volume_of(tried) < share * volume_of(best))) return false;
    best = tried;
    return true;
  };
  for (const int odd :
       {1, 2, 3})  // coordinates that are not 0: first axes, then diagonals of faces, then of the cube
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = 0; z <= 1; ++z)
          if (std::abs(x) + std::abs(y) + z == odd) better(Vector3(x, y, z), worth);
  for (double step = first_step; step > last_step;) {
    const Vector3 axis = best.axis, across = axis.unitOrthogonal(), other = axis.cross(across);
    const bool moved = better(axis + step * across, worth) || better(axis - step * across, worth) ||
                       better(axis + step * other, worth) || better(axis - step * other, worth);
    if (!moved) step /= 2;
  }
  return best;
}

/// The ball that is found has at least this part of the best radius. The smallest half edge of a square.
constexpr double wanted_part = 0.9, least_half = 0x1p-10;

/// Returns the radius of a ball in the hull of points, or 0. The hull holds it if no unit direction n has
/// less than this as the maximum h(n) of n.(p - center). Two unit directions differ by at most as much as
/// points on a cube around them, and h by at most `reach` times that. So h in the middle of a square of the
/// cube bounds h all over it. A square whose bound is too low is cut in four.
double ball_in_hull(Points points, const Vector3& center) {
  struct Square {
    int face;
    double u, v, half;
  };
  std::vector<Square> left;
  for (int face = 0; face < 6; ++face) left.push_back({face, 0, 0, 1});
  double most = INFINITY, least = INFINITY;
  const double reach = (farthest(points, center) - center).norm();
  while (!left.empty()) {
    const auto [face, u, v, half] = left.back();
    left.pop_back();
    Vector3 n;
    n[face % 3] = face < 3 ? 1 : -1;
    n[(face + 1) % 3] = u;
    n[(face + 2) % 3] = v;
    n.normalize();
    double h = -INFINITY;
    for (const Vector3& p : points) h = std::max(h, n.dot(p - center));
    most = std::min(most, h);
    const double bound = h - std::numbers::sqrt2 * half * reach;
    if (bound >= wanted_part * most) {
      least = std::min(least, bound);
      continue;
    }
    if (!(most > 0) || half <= least_half) return 0;
    for (const double du : {-half / 2, half / 2})
      for (const double dv : {-half / 2, half / 2}) left.push_back({face, u + du, v + dv, half / 2});
  }
  return std::max(0.0, least);
}

/// If there are more points, only those that are farthest out in some direction serve to find an axis.
constexpr std::size_t shell_cap = 400;

std::vector<Vector3> shell_of(Points points) {
  if (points.size() <= shell_cap) return {points.begin(), points.end()};
  std::vector<Vector3> shell;
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = 0; z <= 3; ++z) {
        const Vector3 *first = points.data(), *last = first;
        const Vector3 direction(x, y, z);
        double low = first->dot(direction), high = low;
        for (const Vector3& p : points) {
          const double at = p.dot(direction);
          if (at < low) low = at, first = &p;
          if (at > high) high = at, last = &p;
        }
        shell.push_back(*first);
        shell.push_back(*last);
      }
    }
  }
  const auto before = [](const Vector3& a, const Vector3& b) {
    return std::ranges::lexicographical_compare(a, b);
  };
  std::ranges::sort(shell, before);
  shell.erase(std::unique(shell.begin(), shell.end()), shell.end());
  return shell;
}

void grow(Solid& solid, double by) {
  if (solid.radius > 0 || solid.rounding == 0) {
    solid.radius += by;
    solid.height += 2 * by;
  } else {
    solid.rounding += by;
  }
}

}  // namespace

double volume_of(const Solid& c) noexcept {
  const double wide = c.radius + c.rounding;
  return std::numbers::pi * wide * wide * c.height +
         4 * std::numbers::pi / 3 * c.rounding * c.rounding * c.rounding;
}

std::array<Vector3, 8> corners_of(const Vector3& size) {
  std::array<Vector3, 8> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners[i] = 0.5 * Vector3((i & 1) != 0 ? size.x() : -size.x(), (i & 2) != 0 ? size.y() : -size.y(),
                               (i & 4) != 0 ? size.z() : -size.z());
  return corners;
}

Bound bound_of(Points points) {
  if (points.empty()) throw std::runtime_error("no points");
  if (!std::ranges::all_of(points, [](const Vector3& p) { return p.allFinite(); }))
    throw std::runtime_error("a point is not finite");
  const Ball ball = smallest_ball(points);
  Bound bound{around_axis(points, along_the_best_axis(shell_of(points)).axis), 0, 0, points[0], points[0]};
  Solid& solid = bound.solid;
  if (ball.radius == 0 || 4 * std::numbers::pi / 3 * std::pow(ball.radius, 3) < volume_of(solid))
    solid = {ball.center, {0, 0, 1}, 0, 0, ball.radius};
  for (const Vector3& p : points) {
    const Vector3 way = p - solid.center;
    const double along = std::fabs(way.dot(solid.axis)),
                 across = (way - way.dot(solid.axis) * solid.axis).norm();
    const double beyond = std::max(0.0, along - solid.height / 2);
    bound.outside = std::max(bound.outside, solid.rounding > 0 ? std::hypot(across, beyond) - solid.rounding
                                                               : std::max(across - solid.radius, beyond));
    bound.reach = std::max(bound.reach, p.norm());
    bound.low = bound.low.cwiseMin(p);
    bound.high = bound.high.cwiseMax(p);
  }
  return bound;
}

// A hull holds two balls with the capsule around them. That of fewer points is smaller.
std::optional<Solid> capsule_in_hull(Points points, const Bound& bound) {
  const std::vector<Vector3> shell = shell_of(points);
  std::optional<Solid> best;
  for (const double part : {0.0, 0.25, 0.5, 0.75}) {
    Solid inner = bound.solid;
    inner.height *= part;
    const Vector3 end = inner.height / 2 * inner.axis;
    inner.radius = 0;
    inner.rounding = ball_in_hull(shell, inner.center - end);
    if (part > 0) inner.rounding = std::min(inner.rounding, ball_in_hull(shell, inner.center + end));
    if (inner.rounding > 0 && (!best || volume_of(inner) > volume_of(*best))) best = inner;
  }
  return best;
}

// An ellipsoid with half axes a >= b >= c is in the capsule of radius b and length 2a. Its point (a cos t,
// b sin t) is within b of the segment if (b - a) (1 - cos t) <= 0. It holds the ellipsoid with half axes a, c
// and c. If d <= (a^2 - c^2) / a, the largest ball in this that is d from the middle on the long axis has the
// radius c sqrt(1 - d^2 / (a^2 - c^2)).
void bound_ellipsoid(Body& body, const Vector3& half, const Pose& pose) {
  int longest = 0;
  half.maxCoeff(&longest);
  Vector3 sorted = half;
  std::ranges::sort(sorted);
  const double a = sorted[2], b = sorted[1], c = sorted[0], beyond = a * a - c * c,
               d = std::min(std::sqrt(beyond / 2), beyond / a);
  body.solid = {pose.translation(), pose.linear().col(longest), 0, 2 * (a - b), b + bound_error * a};
  body.box = BoxShape{"ellipsoid", pose, 2 * half};
  body.inner = body.solid;
  body.inner->height = 2 * d;
  body.inner->rounding = std::max(0.0, c * std::sqrt(beyond > 0 ? 1 - d * d / beyond : 1) - bound_error * a);
}

// The solid grows by how far points are computed to be outside, and by the errors of moving and computing.
Solid moved(const Bound& bound, const Pose& pose) {
  Solid solid = bound.solid;
  const double lengths = pose.translation().norm() + solid.center.norm() + bound.reach;
  grow(solid, bound.outside + bound_error * lengths + bound_underflow_error);
  solid.center = pose * solid.center;
  solid.axis = pose.linear() * solid.axis;
  if (const Defect defect = find_defect(solid); defect != Defect::none)
    throw std::runtime_error(std::string("its bound has no doubles: ") + to_string(defect));
  return solid;
}

Body bounded_body(std::string name, std::size_t link, std::string shape, const Bound& bound,
                  const Pose& pose) {
  Body body{std::move(name), link, moved(bound, pose), 1, 1, std::nullopt};
  const Vector3 size = bound.high - bound.low;
  if (bound.inner) {
    body.inner = body.solid;
    body.inner->radius = 0;
    body.inner->height = bound.inner->height;
    body.inner->rounding = bound.inner->rounding - bound_error * (pose.translation().norm() + bound.reach);
    if (!(body.inner->rounding > 0)) body.inner.reset();
  }
  body.box = BoxShape{std::move(shape), pose * Eigen::Translation3d(bound.low + size / 2), size};
  return body;
}

}  // namespace cyl
