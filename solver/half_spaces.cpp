// SPDX-License-Identifier: MIT
// A half-space and a solid: one value of f. Derivation: boxes.md, section 1.
#include <cmath>

#include "solver/detail/along_edges.hpp"
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

// `support` and `size` are of the core, `size` with the contact.
[[gnu::always_inline]] inline AbovePlane above(const Prepared& plane, const Prepared& c, double support,
                                               double size, double contact, double times) noexcept {
  const Vector3 delta = c.center - plane.center;
  const double center = dot(plane.unit_axis, delta), error = error_of(c) * (size + length_bound(delta));
  if (std::fabs(center - support - contact) > times * error) return {center, center - support, error};
  const double precise = precisely_above(plane, c, size);
  // The last term is for products that underflow.
  return {precise, precise - support, precise_plane_error * (size + std::fabs(precise)) + 0x1p-1000};
}

// The lowest point of a core over a plane, moved inwards by twice `room`, from its centre.
struct Lowest {
  double support, depth;  // of the core, and of the point
  Vector3 at;
  Hull hull;
  bool fits;  // there is such a point
};

[[gnu::always_inline]] inline Lowest lowest_of(const Prepared& c, const Vector3& n, double size,
                                               double room) noexcept {
  if (c.shape == Shape::box) {
    const SeenFrom seen(c);
    const Seen along = seen(n), share = magnitude(along), half = half_of(c),
               inner = half - Seen(both(2 * room), 2 * room);
    const auto end = [](double most, double way) { return way != 0 ? std::copysign(most, -way) : 0; };
    const Seen at(Both{end(inner.xy[0], along.xy[0]), end(inner.xy[1], along.xy[1])}, end(inner.z, along.z));
    return {dot(half, share), dot(inner, share), seen.world(c, at), Hull::space,
            smaller(smaller(inner.xy[0], inner.xy[1]), inner.z) > room};
  }
  const Vector3& w = c.unit_axis;
  const double along = dot(n, w), half = 0.5 * c.height;
  const Hull hull = hull_of(c.radius, half, size);
  const double h = in_plane(hull) ? 0 : half - 2 * room;
  Lowest lowest{half * std::fabs(along), h * std::fabs(along), std::copysign(h, -along) * w, hull,
                in_plane(hull) || h > room};
  if (c.radius == 0) return lowest;
  // As long as what n has across w, which is w x (n x w).
  const Vector3 turned = n.cross(w);
  const double across = length(turned), r = on_line(hull) ? 0 : c.radius - 2 * room;
  lowest.support += c.radius * across;
  lowest.depth += r * across;
  lowest.at += r / larger(across, 0x1p-500) * turned.cross(w);
  lowest.fits &= on_line(hull) || r > room;
  return lowest;
}

// A half-space and a core with that lowest point. `plane` is the half-space, and `middle` the centre, in the
// scene.
[[gnu::always_inline]] inline Answer prove_half_space(const ShapePair& p, const Lowest& lowest, double size,
                                                      double room, const Prepared& plane,
                                                      const Vector3& middle, bool swapped) noexcept {
  const auto [center, gap, error] = above(p.a, p.b, lowest.support, size, p.contact, 8);
  const Vector3 tail = times_power(lowest.at, p.exponent), given = times_power(tail, -p.exponent);
  const Vector3 &n = p.a.unit_axis, delta = p.b.center - p.a.center;
  double height = center - lowest.depth, lost = 0;
  bool fits = lowest.fits;
  if (p.exponent != 0) {
    height += dot(n, given - lowest.at);
    fits &= length(given - lowest.at) <= room;
  }
  // A point of the half-space, at the lowest point or below it. Seen from the point of the plane, its
  // coordinates are rounded three times.
  const double rough = 4 * unit_roundoff_error * length_bound(delta),
               down = positive(height + 3 * error + rough);
  const Vector3 place = delta + given - down * n, head = times_power(place, p.exponent);
  // In the scene's unit it may be subnormal, or too large.
  if (p.exponent != 0) lost = length(times_power(head, -p.exponent) - place);
  const bool apart = gap > p.contact + error, deep = fits & (height < -4 * error),
             near = fits & (lost <= error) & (error + 2 * rough < p.contact) &
                    (down + 2 * error + rough < p.contact);
  constexpr double turns[] = {1, -1};
  const Vector3 direction = turns[swapped] * plane.second_axis;
  if (p.contact > 0 && !none_of(apart, near))
    return proof_of(near, Proof::points, direction, head, tail, Hull::space, lowest.hull, swapped);
  if (none_of(apart, deep)) return {};
  return proof_of(deep, Proof::point, direction, middle, tail, Hull::space, lowest.hull, swapped);
}

}  // namespace

double core_support(const Prepared& c, const Vector3& n) noexcept { return support_of(c, n); }

Vector3 farthest_of(const Prepared& c, const Vector3& n) noexcept { return lowest_of(c, -n, 0, 0).at; }

AbovePlane above_plane(const Prepared& plane, const Prepared& c, double contact) noexcept {
  return above(plane, c, support_of(c, plane.unit_axis), core_size(c) + contact, contact, 1);
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

Answer decide_half_space(const Prepared& plane, const Prepared& c, double clearance, bool swapped) noexcept {
  if (c.shape == Shape::half_space) return Answer{.verdict = Verdict::invalid};
  return ask_in_order(
      plane, c, clearance, false, [&](const ShapePair& p) __attribute__((always_inline)) {
        const auto prove = [&](double size, double room, const Lowest& lowest)
            __attribute__((always_inline)) {
          return prove_half_space(p, lowest, size, room, plane, c.center, swapped);
        };
        if ((p.b.traits & Prepared::ball) != 0)
          return prove(p.contact, 0, {0, 0, {0, 0, 0}, Hull::center, true});
        // The plane may be so far away that rounding is much more than `room`.
        const double size = core_size(p.b) + p.contact, room = precise_plane_error * size + underflow_error;
        return prove(size, room, lowest_of(p.b, p.a.unit_axis, size, room));
      });
}

}  // namespace cyl
