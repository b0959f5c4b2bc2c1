// SPDX-License-Identifier: MIT
#include "fuzz/worst/shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// The size_of a pair, in the scene's unit.
constexpr double least_size = 1e-3, most_size = 1e3;
/// The part of its size that a length may be if it is not 0, and the sizes that a centre may be from the
/// origin.
constexpr double least_part = 1e-6, most_offset = 100;

/// One number in so many is changed, by 10^least_change to 10^most_change decades, radians or sizes.
constexpr std::size_t change_share = 3;
constexpr double least_change = -4, most_change = 0.5;

void scale_lengths(Pair& p, double factor) {
  for_each_length(p, [&](double& x) { x *= factor; });
}

double farthest(const Pair& p) {
  return std::max(p.a.center.cwiseAbs().maxCoeff(), p.b.center.cwiseAbs().maxCoeff());
}

void change_lengths(Pair& p, auto change) {
  for (Solid* c : {&p.a, &p.b})
    for (double* x : {&c->radius, &c->height, &c->rounding, &c->edges[0], &c->edges[1], &c->edges[2]})
      if (*x > 0) change(*x);
}

void turn(Solid& c, const Eigen::Quaterniond& by) {
  c.axis = by * c.axis;
  const auto& [w, x, y, z] = c.quaternion;
  const Eigen::Quaterniond q = by * Eigen::Quaterniond(w, x, y, z);
  c.quaternion = {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace

// By a power of two, so that only lengths that leave the range of doubles are rounded.
std::optional<Pair> bring_into_domain(const Pair& pair) {
  if (has_half_space(pair)) return {};  // no search for these yet
  Pair p = pair;
  const double size = is_legal(p) ? size_of(p) : 0;
  if (!(size > 0)) return {};
  if (size < least_size) scale_lengths(p, std::exp2(std::ceil(std::log2(least_size / size))));
  if (size > most_size) scale_lengths(p, std::exp2(std::floor(std::log2(most_size / size))));
  change_lengths(p, [least = least_part * size_of(p)](double& x) { x = std::max(x, least); });
  if (farthest(p) > most_offset * size_of(p)) {
    p.b.center -= p.a.center;
    p.a.center.setZero();
  }
  if (!is_in_domain(p)) return {};
  return p;
}

bool is_in_domain(const Pair& pair) {
  constexpr double rounding = 0x1p-40;  // of a few products and sums, generously
  if (!is_legal(pair)) return false;
  const double size = size_of(pair);
  return size >= least_size * (1 - rounding) && size <= most_size * (1 + rounding) &&
         farthest(pair) <= most_offset * size * (1 + rounding);
}

// One slide may not quite touch, so there are two.
std::optional<Ray> ray_of(const Pair& pair) {
  Ray ray{pair, {0, 0, 0}, size_of(pair)};
  for (int i = 0; i < 2; ++i) {
    const MeasuredDistance d = approximate_distance(ray.touching);
    if (!(d.direction.norm() > 0.5)) return {};
    ray.direction = d.direction;
    ray.touching.b.center -= d.value * d.direction;
  }
  return ray;
}

// The axis of one solid changes relative to a direction of the other. Factors keep a part that is 0. Two
// boxes change by the factors of a quaternion, which keep a turn about a coordinate axis.
Pair nudged(const Pair& pair, RandomStream& s) {
  const auto some = [&] {
    return s.below(change_share) == 0 ? s.sign() * std::pow(10, s.between(least_change, most_change)) : 0;
  };
  const auto factor = [&] { return std::pow(10, some()); };
  Pair p = pair;
  change_lengths(p, [&](double& x) { x *= factor(); });
  Solid& turned = is_box(p.b) ? p.a : p.b;
  const Solid& other = is_box(p.b) ? p.b : p.a;
  if (is_box(turned)) {
    for (double& q : turned.quaternion) q *= factor();
  } else {
    const Vector3 axis = unit_axis(turned.axis),
                  u = is_box(other) ? edge_direction(other, s.below(3)) : unit_axis(other.axis);
    const Vector3 along = u.dot(axis) * u, across = axis - along;
    turned.axis = factor() * along + factor() * (Eigen::AngleAxisd(some(), u) * across);
  }
  p.b.center += some() * size_of(p) * s.unit_vector();
  scale_lengths(p, factor());
  const Eigen::Quaterniond all(Eigen::AngleAxisd(some(), s.unit_vector()));
  for (Solid* c : {&p.a, &p.b}) {
    turn(*c, all);
    c->center = all * c->center;
  }
  return p;
}

}  // namespace cyl
