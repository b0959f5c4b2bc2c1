// SPDX-License-Identifier: MIT
// A half-space and a solid: one value of f. Derivation: boxes.md, section 1.
#include <cmath>

#include "solver/detail/certify.hpp"
#include "solver/detail/double_double.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {

double core_support(const Prepared& c, const Vector3& n) noexcept {
  if (c.shape == Shape::box) {
    const Vector3 along = Edges(c).seen(n);
    return 0.5 * (c.edges[0] * std::fabs(along[0]) + c.edges[1] * std::fabs(along[1]) +
                  c.edges[2] * std::fabs(along[2]));
  }
  const double along = 0.5 * c.height * std::fabs(dot(n, c.unit_axis));
  return c.radius == 0 ? along : c.radius * length(n.cross(c.unit_axis)) + along;
}

double core_size(const Prepared& c) noexcept {
  return c.radius + 0.5 * (c.height + c.edges[0] + c.edges[1] + c.edges[2]);
}

Vector3 farthest_of(const Prepared& c, const Vector3& n) noexcept {
  if (c.shape == Shape::box) {
    const Edges edges(c);
    const Vector3 along = edges.seen(n);
    Vector3 x(0, 0, 0);
    for (int i = 0; i < 3; ++i)
      if (along[i] != 0) x[i] = std::copysign(0.5 * c.edges[i], along[i]);
    return edges.world(x);
  }
  const Vector3& w = c.unit_axis;
  const double along = dot(n, w);
  Vector3 across = n - along * w;
  across -= dot(across, w) * w;
  const double size = length(across);
  const Vector3 cap = std::copysign(0.5 * c.height, along) * w;
  return size > separation_error ? Vector3(cap + (c.radius / size) * across) : cap;
}

// n.(C - P) in twice the digits, for solids that are far from the point of the plane.
double AbovePlane::precisely(const Prepared& plane, const Prepared& c) noexcept {
  const Vector3 normal = plane.second_axis * unit_of(exponent_of(max_abs(plane.second_axis)));
  DoubleDouble sum = 0.0;
  for (int i = 0; i < 3; ++i) sum = sum + exact_sum(c.center[i], -plane.center[i]) * DoubleDouble(normal[i]);
  return sum.hi / length(normal);
}

AbovePlane::AbovePlane(const Prepared& plane, const Prepared& c, double contact) noexcept {
  const Vector3& n = plane.unit_axis;
  const Vector3 delta = c.center - plane.center;
  const double support = core_support(c, n), size = core_size(c) + contact;
  // Not the length: it is a bound that needs no root.
  error = box_error * (size + (std::fabs(delta.x()) + std::fabs(delta.y()) + std::fabs(delta.z())));
  gap = dot(n, delta) - support;
  if (!(std::fabs(gap - contact) > 8 * error)) {
    const double above = precisely(plane, c);
    gap = above - support;
    // Twice the digits leave 2^-97 of the vector.
    error = precise_plane_error * (size + std::fabs(above)) + 0x1p-40 * error;
  }
}

Verdict intersect_half_space(const Prepared& plane, const Prepared& c, double contact) noexcept {
  return verdict_of(AbovePlane(plane, c, contact).gap <= contact);
}

void decide_half_space(const ShapePair& p, const Vector3& normal, Answer& answer) noexcept {
  const Prepared& c = p.b;
  const Vector3& n = p.a.unit_axis;
  const Vector3 delta = c.center - p.a.center;
  const AbovePlane above(p.a, c, p.contact);
  const double gap = above.gap, error = above.error + underflow_error;
  if (gap > p.contact + error) {
    hand_out(normal, answer);
    return;
  }
  if (!(gap < p.contact - 8 * error)) return;
  // The lowest point of the core, moved inwards.
  const double inwards = 2 * error;
  Prepared inner = c;
  Hull hull = Hull::space;
  if (c.shape == Shape::box) {
    for (int i = 0; i < 3; ++i) inner.edges[i] -= 2 * inwards;
    if (!((inner.edges.array() > 2 * error).all())) return;
  } else {
    hull = hull_of(c.radius, 0.5 * c.height, core_size(c) + p.contact);
    const bool line = (hull == Hull::line) | (hull == Hull::center);
    const bool plane = (hull == Hull::plane) | (hull == Hull::center);
    inner.radius = line ? 0 : c.radius - inwards;
    inner.height = plane ? 0 : c.height - 2 * inwards;
  }
  const Vector3 x = farthest_of(inner, -n);
  if (c.shape != Shape::box && !Place(x, c.unit_axis).inside(c.radius, 0.5 * c.height, hull, error)) return;
  const Vector3 tail = times_power(x, p.exponent), given = times_power(tail, -p.exponent);
  // The support of the core, less by what it was moved.
  const double height = gap + core_support(c, n) + dot(n, given);
  if (length(given - x) > error || !(height < p.contact - 4 * error)) return;
  answer.verdict = Verdict::intersecting;
  answer.hull_b = hull;
  answer.proof = Proof::points;
  answer.point_tail = tail;
  if (height < -4 * error) {
    answer.proof = Proof::point;
    return;
  }
  // A point of the half-space below it. Seen from the point of the plane, its coordinates may be rough.
  const double rough = 6 * unit_roundoff_error * length(delta);
  answer.point_head = times_power(delta + given - larger(0, height + 2 * error + rough) * n, p.exponent);
  if (!(larger(0, height + 4 * error + 2 * rough) < p.contact)) answer = Answer{};
}

}  // namespace cyl
