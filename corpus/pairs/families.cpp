// SPDX-License-Identifier: MIT
#include "corpus/pairs/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "corpus/pairs/box_pairs.hpp"
#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/exact_pairs.hpp"
#include "corpus/pairs/near_touching.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/rounded_pairs.hpp"
#include "corpus/pairs/stratum.hpp"

namespace cyl {
namespace {

constexpr std::array<double, 2> moderate{0.1, 1};  // lengths from 0.1 to 10
constexpr std::array<double, 4> slender{1e-6, 1e-5, 1e-4, 1e-3};
constexpr std::span angles = std::span(tenths).subspan<2, 15>();  // 1e-2 .. 1e-16
constexpr std::array<double, 10> large{1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
constexpr std::array<double, 12> scales{1e-300, 1e-200, 1e-150, 1e-100, 1e-50, 1e-20,
                                        1e-10,  1e10,   1e20,   1e50,   1e100, 1e150};
constexpr std::array<double, 9> axis_lengths{1e-150, 1e-100, 1e-50, 1e-10, 1, 1e10, 1e50, 1e100, 1e149};

double reach(const Solid& c) { return std::sqrt(c.radius * c.radius + c.height * c.height / 4); }

Solid draw_solid(RandomStream& s) {
  Solid c;
  c.axis = s.unit_vector();
  c.radius = s.within_decades(moderate);
  c.height = s.within_decades(moderate);
  return c;
}

void draw_center(RandomStream& s, Solid& c) {
  for (int i = 0; i < 3; ++i) c.center[i] = s.between(-1, 1);
}

// Centres are apart by at most 0.9 of the sum of the circumscribed radii. About half of the pairs intersect.
void scatter(RandomStream& s, Pair& p) {
  draw_center(s, p.a);
  const Vector3 direction = s.unit_vector();
  const double distance = s.between(0, 0.9) * (reach(p.a) + reach(p.b));
  p.b.center = p.a.center + distance * direction;
}

// Puts a point of a's axis and a point of b's axis `distance` apart along `direction`.
void link_axes(RandomStream& s, Pair& p, const Vector3& direction, double distance) {
  draw_center(s, p.a);
  const double on_a = s.between(-0.5, 0.5) * p.a.height;
  const double on_b = s.between(-0.5, 0.5) * p.b.height;
  p.b.center = p.a.center + (on_a * p.a.axis - on_b * p.b.axis) + distance * direction;
}

// Puts the solids side by side. The axes are apart by up to twice the sum of the radii.
void lay_beside(RandomStream& s, Pair& p) {
  const Vector3 direction = s.perpendicular(p.a.axis);
  const double distance = s.between(0, 2) * (p.a.radius + p.b.radius);
  link_axes(s, p, direction, distance);
}

// The axes pass each other at up to twice the sum of the radii.
void cross_over(RandomStream& s, Pair& p) {
  p.b.axis = s.unit_vector();
  while (inner_product(p.a.axis.cross(p.b.axis), p.a.axis.cross(p.b.axis)) < 0.01) p.b.axis = s.unit_vector();
  const Vector3 direction = s.sign() * normalise(p.a.axis.cross(p.b.axis));
  const double distance = s.between(0, 2) * (p.a.radius + p.b.radius);
  link_axes(s, p, direction, distance);
}

Pair random_pair(RandomStream& s, std::uint64_t = 0) {
  Pair p{draw_solid(s), draw_solid(s)};
  scatter(s, p);
  return p;
}

template <ContactKind kind>
Pair touching(RandomStream& s, std::uint64_t index) {
  return draw_contact(kind, s, index).pair;
}

Pair axes_parallel(RandomStream& s, std::uint64_t) {
  Pair p = random_pair(s);
  p.b.axis = s.sign() * p.a.axis;
  if (s.coin()) lay_beside(s, p);
  return p;
}

// Below 1e-14, the rounding of a general axis would hide the angle. So a's axis is then a coordinate axis.
Pair axes_nearly_parallel(RandomStream& s, std::uint64_t index) {
  const double angle = angles[(index / 2) % angles.size()];
  Pair p = random_pair(s);
  if (s.coin() || angle < 1e-14) p.a.axis = s.coordinate_axis();
  p.b.axis = p.a.axis + angle * s.perpendicular(p.a.axis);
  if (index % 2 == 1) p.b.axis = -p.b.axis;
  if (s.coin()) lay_beside(s, p);
  return p;
}

Pair axes_perpendicular(RandomStream& s, std::uint64_t) {
  Pair p = random_pair(s);
  if (s.coin()) {
    p.a.axis = s.coordinate_axis();
    do p.b.axis = s.coordinate_axis();
    while (inner_product(p.a.axis, p.b.axis) != 0);
  } else {
    p.b.axis = s.perpendicular(p.a.axis);
  }
  return p;
}

Pair axes_crossing(RandomStream& s, std::uint64_t) {
  Pair p = random_pair(s);
  link_axes(s, p, Vector3(0, 0, 0), 0);
  return p;
}

Pair needles(RandomStream& s, std::uint64_t) {
  Pair p = random_pair(s);
  for (Solid* c : {&p.a, &p.b}) c->radius = c->height * s.within_decades(slender);
  cross_over(s, p);
  return p;
}

Pair disks(RandomStream& s, std::uint64_t) {
  Pair p = random_pair(s);
  for (Solid* c : {&p.a, &p.b}) c->height = c->radius * s.within_decades(slender);
  scatter(s, p);
  return p;
}

// The needle's axis meets the disk's plane within 1.5 of the disk's radius.
Pair needle_and_disk(RandomStream& s, std::uint64_t) {
  Pair p = random_pair(s);
  p.a.radius = p.a.height * s.within_decades(slender);
  p.b.height = p.b.radius * s.within_decades(slender);
  const Vector3 direction = s.perpendicular(p.b.axis);
  const double distance = s.between(0, 1.5) * p.b.radius;
  link_axes(s, p, direction, distance);
  if (s.coin()) std::swap(p.a, p.b);
  return p;
}

/// By index, the length is 0 in a, in b or in both.
void flatten(Pair& p, double Solid::*length, std::uint64_t index) {
  if (index % 3 != 1) p.a.*length = 0;
  if (index % 3 != 0) p.b.*length = 0;
}

Pair segments(RandomStream& s, std::uint64_t index) {
  Pair p = random_pair(s);
  flatten(p, &Solid::radius, index);
  if (s.coin()) cross_over(s, p);
  return p;
}

Pair flat_disks(RandomStream& s, std::uint64_t index) {
  Pair p = random_pair(s);
  flatten(p, &Solid::height, index);
  scatter(s, p);
  return p;
}

// The disks lie almost in one plane, and their edges almost meet. The two axes show nearly the same. The
// difference between them decides.
Pair coins_edge_to_edge(RandomStream& s, std::uint64_t index) {
  constexpr std::array<double, 8> tilts{1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2};
  Pair p = random_pair(s);
  const double tilt = s.pick(tilts), radii = p.a.radius + p.b.radius;
  const Vector3 outwards = s.perpendicular(p.a.axis);
  p.b.axis = s.sign() * (p.a.axis + tilt * s.perpendicular(p.a.axis));
  p.a.height = index % 3 == 0 ? 0 : tilt * p.a.radius * s.unit();
  p.b.height = index % 3 != 2 ? 0 : tilt * p.b.radius * s.unit();
  draw_center(s, p.a);
  const double gap = s.sign() * s.pick(dusts) * radii, lift = tilt * radii * s.between(-1, 1);
  p.b.center = p.a.center + (radii + gap) * outwards + lift * p.a.axis;
  return p;
}

// A point and a solid, in either order. Every third pair has two points, which are equal or apart by as
// little as 1e-16.
Pair points(RandomStream& s, std::uint64_t index) {
  Pair p = random_pair(s);
  Solid& point = index % 3 == 0 ? p.a : p.b;
  point.radius = point.height = 0;
  scatter(s, p);
  if (index % 3 == 2) {
    p.a.radius = p.a.height = 0;
    const double distance = s.pick(dusts);
    p.a.center = Vector3(0, 0, 0);
    p.b.center = distance * s.coordinate_axis();
  }
  return p;
}

// The inner solid lies in a ball that touches the outer one's side or caps, shifted along the outer one.
Pair contained(RandomStream& s, std::uint64_t) {
  Pair p = random_pair(s);
  const double ball = std::min(p.a.radius, p.a.height / 2);
  const double shrink = s.between(0.05, 0.45) * ball / reach(p.b);
  p.b.radius *= shrink, p.b.height *= shrink;
  const double along = s.between(-1, 1) * (p.a.height / 2 - ball);
  const double across = s.between(0, 1) * (p.a.radius - ball);
  const double inside = s.between(0, 0.5) * ball;
  const Vector3 radial = s.perpendicular(p.a.axis);
  const Vector3 direction = s.unit_vector();
  p.b.center = p.a.center + along * p.a.axis + across * radial + inside * direction;
  if (s.coin()) std::swap(p.a, p.b);
  return p;
}

// By index, the ends overlap, one solid is inside the other, or they are apart.
Pair coaxial(RandomStream& s, std::uint64_t index) {
  Pair p = random_pair(s);
  if (s.coin()) p.a.axis = s.coordinate_axis();
  p.b.axis = s.sign() * p.a.axis;
  const double sum = (p.a.height + p.b.height) / 2, difference = std::abs(p.a.height - p.b.height) / 2;
  double along = s.between(difference, sum);
  if (index % 3 == 1) {
    p.b.radius = p.a.radius * s.between(0.1, 0.9);
    p.b.height = p.a.height * s.between(0.1, 0.9);
    along = s.between(0, 0.95) * (p.a.height - p.b.height) / 2;
  } else if (index % 3 == 2) {
    along = s.between(1.001, 2) * sum;
  }
  p.b.center = p.a.center + s.sign() * along * p.a.axis;
  if (s.coin()) std::swap(p.a, p.b);
  return p;
}

Pair equal(RandomStream& s, std::uint64_t index) {
  Pair p = random_pair(s);
  p.b = p.a;
  if (index % 2 == 1) p.b.axis = -p.b.axis;
  return p;
}

Pair far(RandomStream& s, std::uint64_t index) {
  Pair p = random_pair(s);
  const Vector3 offset = large[index % large.size()] * s.unit_vector();
  p.a.center += offset;
  p.b.center += offset;
  return p;
}

Pair tiny_and_huge(RandomStream& s, std::uint64_t index) {
  Pair p = random_pair(s);
  const double scale = scales[index % scales.size()];
  for (Solid* c : {&p.a, &p.b}) c->center *= scale, c->radius *= scale, c->height *= scale;
  return p;
}

// The small solid's centre is within twice its circumscribed radius of a point of the large one's side or
// cap.
Pair mixed_scale(RandomStream& s, std::uint64_t index) {
  Pair p = random_pair(s);
  const double ratio = large[index % large.size()];
  p.b.radius /= ratio, p.b.height /= ratio;
  const Vector3 radial = s.perpendicular(p.a.axis), end = s.sign() * p.a.axis;
  const bool on_cap = s.coin();
  const double along = on_cap ? 0.5 : s.between(-0.5, 0.5);
  const double across = on_cap ? s.unit() : 1;
  const double off = s.between(-2, 2) * reach(p.b);
  p.b.center =
      p.a.center + along * p.a.height * end + across * p.a.radius * radial + off * (on_cap ? end : radial);
  if (s.coin()) std::swap(p.a, p.b);
  return p;
}

Pair raw_axes(RandomStream& s, std::uint64_t) {
  Pair p = random_pair(s);
  for (Solid* c : {&p.a, &p.b}) c->axis *= s.within_decades(axis_lengths);
  return p;
}

template <CloseKind kind>
Pair close(RandomStream& s, std::uint64_t index) {
  return draw_close_contact(kind, s, index).pair;
}

using enum ContactKind;
using enum CloseKind;
using enum SolidKind;

template <SolidKind a, SolidKind b>
Pair rounded_pair(RandomStream& s, std::uint64_t index) {
  return draw_rounded(a, b, s, index);
}

template <HalfSpaceKind kind>
Pair half_space_pair(RandomStream& s, std::uint64_t index) {
  return draw_half_space(kind, s, index);
}

/// A rounded box and a solid of each kind in turn.
Pair rounded_box_pair(RandomStream& s, std::uint64_t index) {
  constexpr std::uint64_t kinds = enum_values<SolidKind>.size();
  return draw_rounded(rounded_box, static_cast<SolidKind>(index % kinds), s, index / kinds);
}

struct Entry {
  std::string_view name, summary;
  Pair (*draw)(RandomStream&, std::uint64_t index);
};

constexpr Entry entries[] = {
    {"random", "any two solids, lengths 0.1 to 10, about half of the pairs intersecting", random_pair},
    {"touching_side_side", "side meets side, 1e-2 to 1e-15 apart or deep", touching<side_side>},
    {"touching_side_rim", "side meets rim, 1e-2 to 1e-15 apart or deep", touching<side_rim>},
    {"touching_rim_rim", "rim meets rim, 1e-2 to 1e-15 apart or deep", touching<rim_rim>},
    {"touching_cap_rim", "a rim stands on a cap, 1e-2 to 1e-15 apart or deep", touching<cap_rim>},
    {"touching_cap_side", "a side lies on a cap, 1e-2 to 1e-15 apart or deep", touching<cap_side>},
    {"touching_cap_cap", "cap faces cap, 1e-2 to 1e-15 apart or deep", touching<cap_cap>},
    {"touching_parallel_sides", "parallel sides, 1e-2 to 1e-15 apart or deep", touching<parallel_sides>},
    {"touching_needles", "crossing needles, 1e-6 to 1e-15 apart or deep", touching<needle_needle>},
    {"touching_disks", "rims of thin disks, 1e-6 to 1e-15 apart or deep", touching<disk_disk>},
    {"axes_parallel", "axes exactly parallel or antiparallel", axes_parallel},
    {"axes_nearly_parallel", "axes 1e-2 to 1e-16 rad from parallel or antiparallel", axes_nearly_parallel},
    {"axes_perpendicular", "axes at right angles, half of them exactly", axes_perpendicular},
    {"axes_crossing", "the two axis segments have a common point, up to rounding", axes_crossing},
    {"needles", "radius 1e-6 to 1e-2 of the height, passing each other closely", needles},
    {"disks", "height 1e-6 to 1e-2 of the radius", disks},
    {"needle_and_disk", "a needle that passes through or beside a thin disk", needle_and_disk},
    {"segments", "radius exactly 0 in one solid or both", segments},
    {"flat_disks", "height exactly 0 in one solid or both", flat_disks},
    {"points", "radius and height exactly 0 in one solid or both", points},
    {"contained", "one solid inside the other", contained},
    {"coaxial", "one common axis line, up to rounding: overlapping, nested or apart", coaxial},
    {"equal", "the same solid twice, every other time with its axis reversed", equal},
    {"far", "a random pair 1e3 to 1e12 away from the origin", far},
    {"tiny_and_huge", "a random pair scaled by 1e-300 to 1e150", tiny_and_huge},
    {"mixed_scale", "a solid 1e3 to 1e12 times smaller than the other, at its surface", mixed_scale},
    {"lattice", "small integers throughout: exact ties", draw_on_lattice},
    {"lattice_dust", "lattice poses turned by 0 to 1e-3 rad: cubes, disks, needles, disk and needle",
     draw_beside_lattice},
    {"raw_axes", "a random pair with axes of length 1e-150 to 1e150", raw_axes},
    {"coins_edge_to_edge", "disks tilted by 1e-9 to 1e-2 rad, edge to edge, flat or nearly",
     coins_edge_to_edge},
    {"close_contacts", "every lie and angle of the axes at margins 1e-1 to 1e-13, lengths 0 and extreme too",
     close<by_decade>},
    {"close_contacts_by_angle", "margins 0.1 to 1 of the axes' small angle, which is 1e-1 to 1e-13 rad",
     close<by_angle>},
    {"close_rods", "overlapping rods 2e-13 to 9e-13 rad from parallel, no deeper than that", close<rods>},
    {"close_rims", "rim on rim, one radius 1e-4 to 1e-1 of the other, margins 1e-1 to 1e-13", close<rims>},
    {"range_ends", "beside the largest and the smallest doubles, and farther apart than either",
     draw_range_end},
    {"whiskers", "exactly touching but for 2^-300 to 2^-900, flat solids' ends and rims", draw_whisker},
    {"sphere_sphere", "two balls", rounded_pair<sphere, sphere>},
    {"sphere_capsule", "a ball and a capsule", rounded_pair<sphere, capsule>},
    {"sphere_cylinder", "a ball and a cylinder", rounded_pair<sphere, cylinder>},
    {"sphere_rounded", "a ball and a rounded cylinder", rounded_pair<sphere, rounded>},
    {"capsule_capsule", "two capsules", rounded_pair<capsule, capsule>},
    {"capsule_cylinder", "a capsule and a cylinder", rounded_pair<capsule, cylinder>},
    {"capsule_rounded", "a capsule and a rounded cylinder", rounded_pair<capsule, rounded>},
    {"cylinder_rounded", "a cylinder and a rounded one", rounded_pair<cylinder, rounded>},
    {"rounded_rounded", "two rounded cylinders", rounded_pair<rounded, rounded>},
    {"rounded_unequal", "nearly touching at margins 1e-1 to 1e-12, one solid 1e-6 to 1 of the other",
     draw_unequal},
    {"half_space_sphere", "a half-space and a ball", rounded_pair<half_space, sphere>},
    {"half_space_capsule", "a half-space and a capsule", rounded_pair<half_space, capsule>},
    {"half_space_cylinder", "a half-space and a cylinder", rounded_pair<half_space, cylinder>},
    {"half_space_rounded", "a half-space and a rounded cylinder", rounded_pair<half_space, rounded>},
    {"half_space_tilted", "a plane up to 1e-3 rad from along or square to the axis",
     half_space_pair<HalfSpaceKind::tilted>},
    {"half_space_thin", "a plane and a solid that is flat, thin or nearly so",
     half_space_pair<HalfSpaceKind::thin>},
    {"half_space_far", "a plane and a solid 1e2 to 1e12 from the origin",
     half_space_pair<HalfSpaceKind::far>},
    {"half_space_normal", "normals of length 1e-300 to 1e300", half_space_pair<HalfSpaceKind::scaled_normal>},
    {"box_sphere", "a box and a ball", rounded_pair<box, sphere>},
    {"box_capsule", "a box and a capsule", rounded_pair<box, capsule>},
    {"box_cylinder", "a box and a cylinder", rounded_pair<box, cylinder>},
    {"box_rounded", "a box and a rounded cylinder", rounded_pair<box, rounded>},
    {"box_half_space", "a box and a half-space", rounded_pair<box, half_space>},
    {"box_box", "two boxes", rounded_pair<box, box>},
    {"rounded_box", "a rounded box and a solid of any kind", rounded_box_pair},
    {"box_edges", "edge meets edge or side at every angle, in the middle or at the corners", draw_box_edges},
    {"box_flush", "a facet meets a facet, edge, cap or side, flat or 1e-15 to 1e-2 rad from it",
     draw_box_flush},
    {"box_stacked", "boxes turned alike, often equal, at facets, edges, corners or one centre",
     draw_box_stacked},
    {"box_nested", "a solid 1e-1 to 1e-12 as large as a box, inside it or through its surface",
     draw_box_nested},
    {"box_thin", "plates, rods and points: edges 0 or nearly, often both solids", draw_box_thin},
    {"box_lattice", "small integers and quarter turns: exact ties", draw_box_lattice},
    {"box_far", "nearly touching 1e2 to 1e12 from the origin", draw_box_far},
    {"box_quaternion", "nearly touching, quaternions of length 1e-300 to 1e300", draw_box_quaternion},
};

template <std::size_t i>
Pair generate(std::uint64_t seed, std::uint64_t index) {
  RandomStream stream(entries[i].name, seed, index);
  return entries[i].draw(stream, index);
}

template <std::size_t... i>
constexpr std::array<Family, sizeof...(i)> make_families(std::index_sequence<i...>) {
  return {Family{entries[i].name, entries[i].summary, generate<i>}...};
}

constexpr auto drawn = make_families(std::make_index_sequence<std::size(entries)>());

/// Returns the families from the first name up to, but without, the second.
constexpr std::span<const Family> part_of(std::string_view first, std::string_view end) {
  const auto at = std::ranges::find(drawn, first, &Family::name);
  return {at, std::ranges::find(drawn, end, &Family::name)};
}

}  // namespace

std::span<const Family> families() { return part_of("random", "sphere_sphere"); }
std::span<const Family> close_families() { return part_of("close_contacts", "sphere_sphere"); }
std::span<const Family> rounded_families() { return part_of("sphere_sphere", "half_space_sphere"); }
std::span<const Family> half_space_families() { return part_of("half_space_sphere", "box_sphere"); }
std::span<const Family> box_families() { return part_of("box_sphere", ""); }
std::span<const Family> campaign_families() { return drawn; }

const Family* find_family(std::string_view name) {
  for (const std::span<const Family> some : {campaign_families(), margin_families()}) {
    const auto found = std::ranges::find(some, name, &Family::name);
    if (found != some.end()) return &*found;
  }
  return nullptr;
}

}  // namespace cyl
