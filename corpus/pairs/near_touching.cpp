// SPDX-License-Identifier: MIT
#include "corpus/pairs/near_touching.hpp"

#include <array>
#include <utility>

#include "corpus/pairs/stratum.hpp"

namespace cyl {
namespace {

constexpr std::array<double, 2> slender_decades{1e-4, 1e-3};

bool is_slender(ContactKind kind) {
  return kind == ContactKind::needle_needle || kind == ContactKind::disk_disk;
}

enum class Feature { side, rim, cap };

struct Member {
  Solid solid;      // its centre is set at the end
  Vector3 contact;  // the contact point relative to the centre
};

Member draw_member(ContactKind kind, RandomStream& stream) {
  Member s;
  s.solid.radius = stream.between(0.5, 2);
  s.solid.height = stream.between(0.5, 2);
  if (is_slender(kind)) {
    const double ratio = stream.within_decades(slender_decades);
    (kind == ContactKind::needle_needle ? s.solid.radius : s.solid.height) *= ratio;
  }
  return s;
}

// How far from the middle of a side or cap a contact point may lie, as a part of the way to its border.
constexpr double inside_part = 0.6;

// Sets the axis of `s` for a feature that meets the plane with outward normal `n`, and the contact point on
// it. `v` is a unit vector perpendicular to n that is to be perpendicular to the axis too.
void set_feature(Member& s, Feature feature, const Vector3& n, const Vector3& v, RandomStream& stream) {
  const double r = s.solid.radius, half = s.solid.height / 2;
  const Vector3 third = n.cross(v);
  switch (feature) {
    case Feature::side:
      s.solid.axis = third;
      s.contact = r * n + stream.between(-inside_part, inside_part) * half * third;
      return;
    case Feature::cap: {
      s.solid.axis = stream.sign() * n;
      const double radial = stream.between(0, inside_part) * r;
      s.contact = half * n + radial * v;
      return;
    }
    case Feature::rim: {
      // Axis towards the rim's cap and outward radial direction: n turned in the plane perpendicular to v.
      const double along = stream.between(0.3, 1), across = stream.sign() * stream.between(0.3, 1);
      const Vector3 towards = normalise(along * n + across * third);
      const Vector3 radial = normalise(along * third - across * n) * (across < 0 ? 1 : -1);
      s.solid.axis = stream.sign() * towards;
      s.contact = half * towards + r * radial;
      return;
    }
  }
}

std::pair<Feature, Feature> features_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::side_side:
    case ContactKind::parallel_sides:
    case ContactKind::needle_needle:
      return {Feature::side, Feature::side};
    case ContactKind::side_rim:
      return {Feature::side, Feature::rim};
    case ContactKind::rim_rim:
    case ContactKind::disk_disk:
      return {Feature::rim, Feature::rim};
    case ContactKind::cap_rim:
      return {Feature::cap, Feature::rim};
    case ContactKind::cap_side:
      return {Feature::cap, Feature::side};
    case ContactKind::cap_cap:
      return {Feature::cap, Feature::cap};
  }
  return {Feature::side, Feature::side};
}

}  // namespace

double contact_margin(ContactKind kind, std::uint64_t index) {
  const std::size_t first = is_slender(kind) ? 6 : 2;
  const double margin = tenths[first + index / 2 % (16 - first)];
  return index % 2 == 0 ? margin : -margin;
}

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
  Contact c;
  c.normal = stream.unit_vector();
  auto [first, second] = features_of(kind);
  if (stream.coin()) std::swap(first, second);

  // Two directions perpendicular to the normal. |cos| of their angle is at most 0.6. Parallel sides need one.
  const Vector3 va = stream.perpendicular(c.normal);
  Vector3 vb =
      kind == ContactKind::parallel_sides ? Vector3(stream.sign() * va) : stream.perpendicular(c.normal);
  while (kind != ContactKind::parallel_sides && std::abs(inner_product(va, vb)) > 0.6)
    vb = stream.perpendicular(c.normal);

  Member a = draw_member(kind, stream), b = draw_member(kind, stream);
  set_feature(a, first, c.normal, va, stream);
  set_feature(b, second, -c.normal, vb, stream);

  const double size = a.solid.radius + a.solid.height + b.solid.radius + b.solid.height;
  c.distance = margin * size;
  // Half of the first solids stand at the origin. There the centres' difference is not rounded once more.
  a.solid.center = Vector3(0, 0, 0);
  if (stream.coin())
    for (int i = 0; i < 3; ++i) a.solid.center[i] = stream.between(-1, 1);
  c.point = a.solid.center + a.contact;
  b.solid.center = a.solid.center + ((a.contact - b.contact) + c.distance * c.normal);
  c.pair = {a.solid, b.solid};
  return c;
}

Contact draw_contact(ContactKind kind, RandomStream& stream, std::uint64_t index) {
  return draw_contact_at(kind, stream, contact_margin(kind, index));
}

}  // namespace cyl
