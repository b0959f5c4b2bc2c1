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

// n.(C - P) for solids that are far from the point of the plane. The products are exact, and so is their sum,
// whose parts do not overlap (Shewchuk 1997, Grow-Expansion). A coordinate of the normal may be hundreds of
// decades below another, so exponents are kept apart.
double AbovePlane::precisely(const Prepared& plane, const Prepared& c) noexcept {
  const Vector3& given = plane.second_axis;
  const int exponent = exponent_of(max_abs(given));
  const Vector3 normal = times_power(given, -exponent);
  double parts[12];
  int count = 0;
  const auto add = [&](double x) {
    for (int i = 0; i < count; ++i) {
      const DoubleDouble sum = exact_sum(x, parts[i]);
      x = sum.hi;
      parts[i] = sum.lo;
    }
    parts[count++] = x;
  };
  for (int i = 0; i < 3; ++i)
    for (const double x : {c.center[i], -plane.center[i]}) {
      int of_x = 0, of_normal = 0;
      const double x_part = std::frexp(x, &of_x);
      const DoubleDouble product = exact_product(x_part, std::frexp(given[i], &of_normal));
      const int power = of_x + of_normal - exponent;
      add(std::ldexp(product.lo, power));
      add(std::ldexp(product.hi, power));
    }
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum / length(normal);
}

AbovePlane::AbovePlane(const Prepared& plane, const Prepared& c, double contact) noexcept {
  const Vector3& n = plane.unit_axis;
  const Vector3 delta = c.center - plane.center;
  const double support = core_support(c, n), size = core_size(c) + contact;
  error = box_error * (size + length_bound(delta));
  gap = dot(n, delta) - support;
  if (!(std::fabs(gap - contact) > 8 * error)) {
    const double above = precisely(plane, c);
    gap = above - support;
    // The last term is for products that underflow.
    error = precise_plane_error * (size + std::fabs(above)) + 0x1p-1000;
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
  const double gap = above.gap, error = above.error;
  if (gap > p.contact + error) {
    hand_out(normal, answer);
    return;
  }
  if (!(gap < p.contact - 8 * error)) return;
  // The lowest point of the core, moved inwards. The plane may be so far away that `error` is much longer.
  const double room = precise_plane_error * (core_size(c) + p.contact) + underflow_error;
  const double inwards = 2 * room;
  Prepared inner = c;
  Hull hull = Hull::space;
  if (c.shape == Shape::box) {
    for (int i = 0; i < 3; ++i) inner.edges[i] -= 2 * inwards;
    if (!(smaller(smaller(inner.edges[0], inner.edges[1]), inner.edges[2]) > 2 * room)) return;
  } else {
    hull = hull_of(c.radius, 0.5 * c.height, core_size(c) + p.contact);
    const bool line = (hull == Hull::line) | (hull == Hull::center);
    const bool plane = (hull == Hull::plane) | (hull == Hull::center);
    inner.radius = line ? 0 : c.radius - inwards;
    inner.height = plane ? 0 : c.height - 2 * inwards;
  }
  const Vector3 x = farthest_of(inner, -n);
  if (c.shape != Shape::box && !Place(x, c.unit_axis).inside(c.radius, 0.5 * c.height, hull, room)) return;
  const Vector3 tail = times_power(x, p.exponent), given = times_power(tail, -p.exponent);
  // The support of the core, less by what it was moved.
  const double height = gap + core_support(c, n) + dot(n, given);
  if (length(given - x) > room || !(height < p.contact - 4 * error)) return;
  answer.verdict = Verdict::intersecting;
  answer.hull_b = hull;
  answer.proof = Proof::points;
  answer.point_tail = tail;
  if (height < -4 * error) {
    answer.proof = Proof::point;
    return;
  }
  // A point of the half-space below it. Seen from the point of the plane, its coordinates are rounded three
  // times.
  const double rough = 4 * unit_roundoff_error * 0x1p400 * length(0x1p-400 * delta);
  const Vector3 place = delta + given - larger(0, height + 3 * error + rough) * n;
  answer.point_head = times_power(place, p.exponent);
  // In the scene's unit it may be subnormal, or too large.
  const double lost = length(times_power(answer.point_head, -p.exponent) - place);
  if (!(lost <= error && larger(0, height + 5 * error + 2 * rough) < p.contact)) answer = Answer{};
}

}  // namespace cyl
