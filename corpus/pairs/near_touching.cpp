// SPDX-License-Identifier: MIT
#include "corpus/pairs/near_touching.hpp"

#include <utility>

#include "corpus/pairs/touch_plane.hpp"

namespace cyl {
namespace {

constexpr std::array<double, 2> slender_decades{1e-4, 1e-3};

Solid draw_solid(ContactKind kind, RandomStream& stream) {
  Solid c;
  c.radius = stream.between(0.5, 2);
  c.height = stream.between(0.5, 2);
  if (is_slender(kind))
    (kind == ContactKind::needle_needle ? c.radius : c.height) *= stream.within_decades(slender_decades);
  return c;
}

// Turns a solid so that its part meets the plane with outward normal `n`. `v` is a unit vector perpendicular
// to n that is to be perpendicular to the axis of a side or rim too. Returns the contact from the centre.
Vector3 touch(Solid& c, TouchPart part, const Vector3& n, const Vector3& v, RandomStream& stream) {
  if (part != TouchPart::point) return touch_inside(c, part, n, v, stream);
  // Axis towards the rim's cap and outward radial direction: n turned in the plane perpendicular to v.
  const Vector3 third = n.cross(v);
  const double along = stream.between(0.3, 1), across = stream.sign() * stream.between(0.3, 1);
  const Vector3 towards = normalise(along * n + across * third);
  const Vector3 radial = normalise(along * third - across * n) * (across < 0 ? 1 : -1);
  c.axis = stream.sign() * towards;
  return c.height / 2 * towards + c.radius * radial;
}

}  // namespace

// Why the distance is g: p is a point of a with the greatest n.x, and q is a point of b with the least n.x.
// The centres are placed so that q = p + g n. Then f(n) = -g.
//
// Gap (g >= 0): p and q are points of the solids at distance g, and the slab between them is free.
//
// Penetration (g < 0): b moved by -g n touches a, so the depth is at most -g. It is exactly -g if no
// direction m does better. This holds if D(m) >= -g (1 - m.n) for the deficit D(m) = h_a(m) - m.p + h_b(-m)
// + m.q >= 0. Here h is the support function.
//
// Side or cap: if p lies on a side or inside a cap, a ball of radius R fits into a and touches at p. So D(m)
// >= R (1 - m.n), and -g <= R is enough. The same holds for b. A contact point keeps 0.4 of the half height
// from the caps and 0.4 of the radius from the rim. So 0.1 <= R (needles: 5e-5), and -g <= 0.08 (4.1e-6).
//
// Rim to rim: u is the outward radial direction at p, w the axis towards that cap, and v = w x u. The
// deficit of each solid is r (|m - (m.w) w| - m.u) + h (|m.w| - m.w) / 2. That is at least r (m.v)^2 / 2. If
// m.u or m.w is negative, 2r |m.u| or h |m.w| is added to the bound. n is orthogonal to both v's, and |cos|
// of their angle is at most 0.6. So D(m) >= A (1 - (m.n)^2) with A = 0.2 min(r). If m.n < 0, B |m.n| is
// added, with B = 1.4 min(2r, h). The bound is concave in |m.n|, so -g <= A and -2g <= B are enough. Both
// hold, because 0.08 <= 0.1 <= A and 0.16 <= 0.7 <= B (disks: 8.2e-6 <= 7e-5 <= B).
Contact draw_contact_at(ContactKind kind, RandomStream& stream, double margin) {
  const Vector3 normal = stream.unit_vector();
  auto [first, second] = parts_of(features_of_kinds[static_cast<std::size_t>(kind)]);
  if (stream.coin()) std::swap(first, second);

  // Two directions perpendicular to the normal. |cos| of their angle is at most 0.6. Parallel sides need one.
  const Vector3 va = stream.perpendicular(normal);
  Vector3 vb =
      kind == ContactKind::parallel_sides ? Vector3(stream.sign() * va) : stream.perpendicular(normal);
  while (kind != ContactKind::parallel_sides && std::abs(inner_product(va, vb)) > 0.6)
    vb = stream.perpendicular(normal);

  Solid a = draw_solid(kind, stream), b = draw_solid(kind, stream);
  const Vector3 on_a = touch(a, first, normal, va, stream), on_b = touch(b, second, -normal, vb, stream);
  const double distance = margin * (a.radius + a.height + b.radius + b.height);
  // Half of the first solids stand at the origin. There the centres' difference is not rounded once more.
  if (stream.coin())
    for (int i = 0; i < 3; ++i) a.center[i] = stream.between(-1, 1);
  b.center = a.center + ((on_a - on_b) + distance * normal);
  return {{a, b}, distance};
}

Contact draw_contact(ContactKind kind, RandomStream& stream, std::uint64_t index) {
  const std::size_t first = is_slender(kind) ? 6 : 2;
  const double margin = tenths[first + index / 2 % (16 - first)];
  return draw_contact_at(kind, stream, index % 2 == 0 ? margin : -margin);
}

}  // namespace cyl
