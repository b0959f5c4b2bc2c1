// SPDX-License-Identifier: MIT
// A half-space and a solid: one value of f. Derivation: boxes.md, section 1.
#include <cmath>

#include "solver/detail/certify.hpp"
#include "solver/detail/double_double.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {

namespace {

[[gnu::always_inline]] inline double support_of(const Prepared& c, const Vector3& n) noexcept {
  if (c.shape == Shape::box) {
    const Vector3 along = Edges(c).seen(n);
    return 0.5 * (c.edges[0] * std::fabs(along[0]) + c.edges[1] * std::fabs(along[1]) +
                  c.edges[2] * std::fabs(along[2]));
  }
  const double along = 0.5 * c.height * std::fabs(dot(n, c.unit_axis));
  return c.radius == 0 ? along : c.radius * length(n.cross(c.unit_axis)) + along;
}

Vector3 farthest_on_box(const Prepared& c, const Vector3& half, const Vector3& n) noexcept {
  const Edges edges(c);
  const Vector3 along = edges.seen(n);
  Vector3 x(0, 0, 0);
  for (int i = 0; i < 3; ++i)
    if (along[i] != 0) x[i] = std::copysign(half[i], along[i]);
  return edges.world(x);
}

// `h`: half the height.
Vector3 farthest_on_cylinder(const Vector3& w, double r, double h, const Vector3& n) noexcept {
  const double along = dot(n, w);
  const Vector3 cap = std::copysign(h, along) * w;
  if (r == 0) return cap;
  Vector3 across = n - along * w;
  across -= dot(across, w) * w;
  const double size = length(across);
  return size > separation_error ? Vector3(cap + (r / size) * across) : cap;
}

// n.(C - P) for solids that are far from the point of the plane. The products are exact, and so is their sum,
// whose parts do not overlap (Shewchuk 1997, Grow-Expansion). A coordinate of the normal may be hundreds of
// decades below another, so exponents are kept apart.
[[gnu::noinline]] double exactly_above(const Prepared& plane, const Prepared& c) noexcept {
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

// The same, in twice the digits if they are enough: then the error is below 2^-96 |C - P| and u size / 8.
[[gnu::noinline]] double precisely_above(const Prepared& plane, const Prepared& c, double size) noexcept {
  const Vector3& normal = plane.second_axis;
  if (!(max_abs(normal) <= 4 && length_bound(c.center - plane.center) <= 0x1p40 * size))
    return exactly_above(plane, c);
  DoubleDouble sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble delta = exact_sum(c.center[i], -plane.center[i]),
                       product = exact_product(delta.hi, normal[i]);
    sum = sum + DoubleDouble(product.hi, product.lo + delta.lo * normal[i]);
  }
  return sum.hi / length(normal);
}

double error_of(const Prepared& c) noexcept {
  return c.shape == Shape::box ? precise_plane_error : plane_error;
}

[[gnu::always_inline]] inline AbovePlane above(const Prepared& plane, const Prepared& c, double contact,
                                               double times) noexcept {
  const Vector3& n = plane.unit_axis;
  const Vector3 delta = c.center - plane.center;
  const double support = support_of(c, n), size = core_size(c) + contact, center = dot(n, delta);
  const double error = error_of(c) * (size + length_bound(delta));
  if (std::fabs(center - support - contact) > times * error) return {center, center - support, error};
  const double precise = precisely_above(plane, c, size);
  // The last term is for products that underflow.
  return {precise, precise - support, precise_plane_error * (size + std::fabs(precise)) + 0x1p-1000};
}

}  // namespace

double core_support(const Prepared& c, const Vector3& n) noexcept { return support_of(c, n); }

Vector3 farthest_of(const Prepared& c, const Vector3& n) noexcept {
  return c.shape == Shape::box ? farthest_on_box(c, 0.5 * c.edges, n)
                               : farthest_on_cylinder(c.unit_axis, c.radius, 0.5 * c.height, n);
}

AbovePlane above_plane(const Prepared& plane, const Prepared& c, double contact) noexcept {
  return above(plane, c, contact, 1);
}

Verdict intersect_half_space(const Prepared& plane, const Prepared& c, double contact) noexcept {
  if (c.shape == Shape::half_space) return Verdict::invalid;
  const Vector3& n = plane.unit_axis;
  const Vector3 delta = c.center - plane.center;
  double support = 0, size = 0.5 * c.height;
  if ((c.traits & Prepared::thin) == 0) {
    support = support_of(c, n);
    size = core_size(c);
  } else if ((c.traits & Prepared::ball) == 0) {
    support = size * std::fabs(dot(n, c.unit_axis));
  }
  size += contact;
  const double gap = dot(n, delta) - support;
  if (std::fabs(gap - contact) > error_of(c) * (size + length_bound(delta)) - plane_tol * size)
    return verdict_of(gap <= contact);
  return verdict_of(precisely_above(plane, c, size) - support <= contact);
}

void decide_half_space(const ShapePair& p, const Vector3& normal, const Vector3& of_second,
                       Answer& answer) noexcept {
  const Prepared& c = p.b;
  const Vector3& n = p.a.unit_axis;
  const auto [center, gap, error] = above(p.a, c, p.contact, 8);
  if (gap > p.contact + error) {
    hand_out(normal, answer);
    return;
  }
  if (!(gap < p.contact - 8 * error)) return;
  // The lowest point of the core, moved inwards by twice `room`, which is more than it is off by. The plane
  // may be so far away that `error` is much longer.
  const double size = core_size(c) + p.contact, room = precise_plane_error * size + underflow_error;
  const double inwards = 2 * room;
  Hull hull = Hull::space;
  Vector3 x;
  if (c.shape == Shape::box) {
    const Vector3 half = 0.5 * c.edges - Vector3(inwards, inwards, inwards);
    if (!(smaller(smaller(half[0], half[1]), half[2]) > room)) return;
    x = farthest_on_box(c, half, -n);
  } else {
    hull = hull_of(c.radius, 0.5 * c.height, size);
    const bool line = (hull == Hull::line) | (hull == Hull::center);
    const bool plane = (hull == Hull::plane) | (hull == Hull::center);
    const double r = line ? 0 : c.radius - inwards, h = plane ? 0 : 0.5 * c.height - inwards;
    if (!((line | (r > room)) & (plane | (h > room)))) return;
    x = farthest_on_cylinder(c.unit_axis, r, h, -n);
  }
  const Vector3 tail = times_power(x, p.exponent), given = times_power(tail, -p.exponent);
  const double height = center + dot(n, given);
  if ((p.exponent != 0 && length(given - x) > room) || !(height < p.contact - 4 * error)) return;
  // A point of the half-space, at x or below it. Seen from the point of the plane, its coordinates are
  // rounded three times.
  const Vector3 delta = c.center - p.a.center;
  const double rough = 4 * unit_roundoff_error * length_bound(delta);
  const Vector3 place = delta + given - larger(0, height + 3 * error + rough) * n,
                head = times_power(place, p.exponent);
  // In the scene's unit it may be subnormal, or too large.
  const double lost = p.exponent == 0 ? 0 : length(times_power(head, -p.exponent) - place);
  if ((lost <= error) & (larger(error, height + 5 * error) + 2 * rough < p.contact))
    hand_out(Proof::points, head, tail, Hull::space, hull, answer);
  else if (height < -4 * error)
    hand_out(Proof::point, of_second, tail, Hull::space, hull, answer);
}

}  // namespace cyl
