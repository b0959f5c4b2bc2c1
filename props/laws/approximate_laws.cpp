// SPDX-License-Identifier: MIT
// Laws 20 to 29 hold within a proved allowance. The signed distance is -min f over unit directions D, with
//   f(D) = sum of r |D x w| + h/2 |D.w| + sum of e/2 |D.u| + rounding over both solids, less |D.Delta|.
// So it changes by no more than f does at any D. |D x w|, |D.w| and |D.u| change by at most the change of the
// axis w or of the direction u of an edge e. Hence
//   |change| <= |Delta' - Delta| + sum of |r' - r| + |h' - h| / 2 + |e' - e| / 2 + |rounding' - rounding|
//               + (r + h/2) |w' - w| + e/2 |u' - u|.
// |u' - u| is at most 2 |q' - q| for the unit quaternions. A half-space is asked at its normal alone, which
// turns the plane about its point. So it has |Delta| and the extent of the other solid for its own extent.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "props/laws/law_groups.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

bool is_usable(const Pair& pair) { return is_legal(pair) && is_in_range(pair); }

/// Returns the fault of asked[i], whose signed distance is within `change` of the pair's. Reported distances
/// are held to their allowances, and verdicts to the proof.
std::optional<Violation> break_change(const LawCase& c, std::size_t i, double change) {
  const MethodAnswer &first = c.first, &second = c.answers[i];
  const Pair& changed = c.asked[i].pair;
  if (!is_decided(first) || !is_decided(second)) return {};
  if (first.has_distance && second.has_distance) {
    const double allowed = change + distance_allowance(c, c.pair, first.distance) +
                           distance_allowance(c, changed, second.distance);
    if (std::fabs(second.distance - first.distance) > allowed) {
      return Violation{"the distance goes from " + format_double(first.distance) + " to " +
                       format_double(second.distance) + ", allowed is " + format_double(allowed)};
    }
  }
  if (says_meet(first) == says_meet(second)) return {};
  // Proofs of verdicts are cheap, but proofs of distances are not.
  if (!is_refuted(c, c.pair, first) && !is_refuted(c, changed, second)) return {};
  Trial& proved = c.proofs.of(c.pair);
  if (proved.truth.verdict == Verdict::undecided) return {};
  if (magnitude_against(change, proved).lo <= change) return {};
  return Violation{
      std::string("the verdict turns from ") + to_string(first.verdict) + " to " + to_string(second.verdict),
      severity_of(c, i)};
}

/// The relative error of change_between(), which takes some 20 roundings.
constexpr double sum_error = 0x1p-48;

Eigen::Vector4d unit_quaternion(const Solid& box) {
  return Eigen::Vector4d::Map(box.quaternion.data()).stableNormalized();
}

/// Returns the bound above for the numbers of two pairs, rounded up.
double change_between(const Pair& x, const Pair& y) {
  const Vector3 from = x.b.center - x.a.center, to = y.b.center - y.a.center;
  double change = (to - from).norm(), lost = unit_roundoff_error * (from.norm() + to.norm());
  for (const auto& [p, q] : {std::pair{&x.a, &y.a}, std::pair{&x.b, &y.b}}) {
    const double extent = is_half_space(*p)
                              ? std::max(from.norm(), to.norm()) + core_extent(x.a) + core_extent(x.b)
                              : core_extent(*p);
    change += std::fabs(q->radius - p->radius) + std::fabs(q->height - p->height) / 2 +
              std::fabs(q->rounding - p->rounding);
    for (std::size_t i = 0; i < 3; ++i) change += std::fabs(q->edges[i] - p->edges[i]) / 2;
    if (is_box(*p)) {
      change += 2 * extent * (unit_quaternion(*q) - unit_quaternion(*p)).norm();
      if (q->quaternion != p->quaternion) lost += 4 * unit_axis_error * extent;
    } else {
      change += extent * (direction_of(*q) - direction_of(*p)).norm();
      if (q->axis != p->axis) lost += 2 * unit_axis_error * extent;
    }
  }
  return (change + lost) * (1 + sum_error);
}

std::optional<Violation> break_changes(const LawCase& c) {
  return worst_of(c,
                  [&](std::size_t i) { return break_change(c, i, change_between(c.pair, c.asked[i].pair)); });
}

// The rotation of a quaternion of integers. Its matrix times the sum of their squares has integers only.
struct Rotation {
  Eigen::Quaterniond by;
  Eigen::Matrix3d times_square;
  double square;
};

Rotation rotation(double w, double x, double y, double z) {
  Eigen::Matrix3d m;
  m << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return {{w, x, y, z}, m, w * w + x * x + y * y + z * z};
}

/// About a coordinate axis and about other axes, by small and by large angles.
const std::array rotations{rotation(2, 1, 0, 0), rotation(7, 0, 1, -1), rotation(1, 2, 3, -4)};

// A centre takes three products, two sums and a quotient: 4 u |c| in each coordinate, as the rows are of
// unit length. So it takes 7 u |c| in all. An axis takes 4 u of unit_axis, and 5.2 u of |w| by products and
// sums. A coordinate of a quaternion takes 4 u of |q|, so a direction 16 u. A normal is also multiplied by
// the distance of the centres. All stay below this bound, times |c| and times the extent.
constexpr double rotation_error = 18 * unit_roundoff_error;

double rotation_change(const Pair& pair) {
  double lengths = 0;
  for (const Solid* c : {&pair.a, &pair.b}) lengths += c->center.norm() + core_extent(*c) + c->rounding;
  return rotation_error * lengths;
}

// In numbers of order 1, as the quaternion may have any length.
void turn(Solid& box, const Eigen::Quaterniond& by) {
  const Eigen::Vector4d q = unit_quaternion(box);
  const Eigen::Quaterniond turned = by * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  box.quaternion = {turned.w(), turned.x(), turned.y(), turned.z()};
}

std::vector<LawQuery> rotated(const Method&, const Pair& pair, const MethodAnswer&) {
  if (!is_usable(pair)) return {};
  std::vector<LawQuery> asked;
  for (const Rotation& rotation : rotations) {
    asked.push_back({pair});
    for (Solid* c : {&asked.back().pair.a, &asked.back().pair.b}) {
      c->center = rotation.times_square * c->center / rotation.square;
      if (is_box(*c))
        turn(*c, rotation.by);
      else
        c->axis = rotation.times_square * direction_of(*c);
    }
  }
  return asked;
}

std::optional<Violation> break_rotation(const LawCase& c) {
  return worst_of(c, [&](std::size_t i) { return break_change(c, i, rotation_change(c.pair)); });
}

/// How far the scene is moved, in units of its size.
constexpr double translations[] = {0x1p-3, 3, 0x1p10, 0x1p20};

std::vector<LawQuery> translated(const Method&, const Pair& pair, const MethodAnswer&) {
  if (!is_usable(pair)) return {};
  std::vector<LawQuery> asked;
  for (const double length : translations) {
    const Vector3 move = length * size_of(pair) * Vector3(2, -1, 2) / 3;
    asked.push_back({pair});
    asked.back().pair.a.center += move;
    asked.back().pair.b.center += move;
  }
  return asked;
}

/// How much a and b are changed, in units of the size, and in radians. A jump shows if it is larger than the
/// change.
constexpr double coarse = 0x1p-10, fine = 0x1p-30;

std::vector<LawQuery> nearby(const Method&, const Pair& pair, const MethodAnswer&) {
  if (!is_usable(pair)) return {};
  std::vector<LawQuery> asked;
  for (const auto& [solid, by] : {std::pair{&Pair::a, coarse}, std::pair{&Pair::b, fine}}) {
    const double length = by * size_of(pair);
    const auto push = [&, solid = solid]() -> Solid& {
      asked.push_back({pair});
      return asked.back().pair.*solid;
    };
    push().center += length * Vector3(2, -1, 2) / 3;
    if (is_box(pair.*solid)) {
      for (std::size_t i = 0; i < 3; ++i) push().edges[i] += 2 * length;
      turn(push(), {1, by * 2 / 3, -by / 3, by * 2 / 3});
      continue;
    }
    if (!is_half_space(pair.*solid)) {
      push().radius += length;
      push().height += 2 * length;
    }
    Solid& turned = push();
    const Vector3 w = direction_of(turned);
    Eigen::Index least;
    w.cwiseAbs().minCoeff(&least);
    turned.axis = w + by * w.cross(Vector3::Unit(least));
  }
  return asked;
}

/// How deep b is pushed into a, in units of the size.
constexpr double depths[] = {0x1p-33, 0x1p-20, 0x1p-7};

// If the solids are g apart, b is pushed by g and t more against the offered direction. Then they overlap by
// t at most. If they overlap by d, b is pulled out by d. Then no gap can arise in any direction.
std::vector<LawQuery> slid(const Method&, const Pair& pair, const MethodAnswer& first) {
  if (!is_decided(first) || !first.has_distance || !is_usable(pair)) return {};
  std::vector<LawQuery> asked;
  const Vector3 delta = pair.b.center - pair.a.center;
  const auto slide = [&](const Vector3& way, double length) {
    const Vector3 u = way.stableNormalized();
    if (!u.allFinite() || u.isZero(0)) return;
    asked.push_back({pair});
    asked.back().pair.b.center += (u.dot(delta) < 0 ? -length : length) * u;
  };
  if (first.distance > 0) {
    const bool offered = first.witness == CertificateKind::direction;
    for (const double depth : depths)
      slide(offered ? offered_direction(pair, first) : delta, -first.distance - depth * size_of(pair));
  } else {
    const Vector3 w0 = direction_of(pair.a), w1 = direction_of(pair.b);
    for (const Vector3& way : {w0, w1, Vector3(w0.cross(w1)), delta}) slide(way, -first.distance);
  }
  return asked;
}

/// The solids c of the triangle. One lies beyond b. Small ones lie in the middle, so the inequality is nearly
/// tight. They are like b, or a if b is a half-space, then capsules and boxes.
std::array<Solid, 4> third_solids(const Pair& pair) {
  const Vector3 delta = pair.b.center - pair.a.center, middle = pair.a.center + delta / 2;
  const Solid& like = is_half_space(pair.b) ? pair.a : pair.b;
  const double small = 0x1p-10 * core_extent(like);
  Solid beyond = like, tiny = like;
  beyond.center = pair.b.center + delta;
  tiny.center = middle;
  for (double* x :
       {&tiny.radius, &tiny.height, &tiny.rounding, &tiny.edges[0], &tiny.edges[1], &tiny.edges[2]})
    *x *= 0x1p-10;
  if (!is_box(beyond)) beyond.axis = pair.a.axis;
  return {beyond, tiny, Solid{.center = middle, .axis = {1, 2, 2}, .height = small, .rounding = small / 2},
          Solid{.center = middle,
                .shape = Shape::box,
                .edges = {small, small / 2, small / 4},
                .quaternion = {1, 2, 3, 4}}};
}

std::vector<LawQuery> with_a_third(const Method& method, const Pair& pair, const MethodAnswer& first) {
  if (!first.has_distance || !is_usable(pair)) return {};
  std::vector<LawQuery> asked;
  for (const Solid& c : third_solids(pair)) {
    if (!method.supports(kind_of(c))) continue;
    asked.push_back({{pair.b, c}});
    asked.push_back({{pair.a, c}});
  }
  return asked;
}

/// A half-space in the middle makes a gap of any length.
double diameter(const Solid& c) {
  if (is_half_space(c)) return std::numeric_limits<double>::infinity();
  const double core =
      is_box(c) ? std::hypot(c.edges[0], c.edges[1], c.edges[2]) : std::hypot(2 * c.radius, c.height);
  return (core + 2 * c.rounding) * (1 + sum_error);
}

// The path leads from the nearest point of one solid to that of another, through the middle solid. Its two
// points there are at most the diameter of the middle solid apart. So no side of the triangle is longer than
// the two others and the diameter together.
std::optional<Violation> break_triangle(const LawCase& c) {
  for (std::size_t i = 0; i + 1 < c.answers.size(); i += 2) {
    const MethodAnswer &ab = c.first, &bc = c.answers[i], &ac = c.answers[i + 1];
    if (!is_decided(ab) || !is_decided(bc) || !is_decided(ac) || !bc.has_distance || !ac.has_distance)
      continue;
    const Pair &second = c.asked[i].pair, &third = c.asked[i + 1].pair;
    const double allowed = distance_allowance(c, c.pair, ab.distance) +
                           distance_allowance(c, second, bc.distance) +
                           distance_allowance(c, third, ac.distance);
    const double x = std::max(0.0, ab.distance), y = std::max(0.0, bc.distance),
                 z = std::max(0.0, ac.distance);
    const double over = std::max(
        {z - x - y - diameter(c.pair.b), y - x - z - diameter(c.pair.a), x - y - z - diameter(second.b)});
    if (over > allowed) {
      return Violation{"a gap is longer by " + format_double(over) +
                       " than the way through the third solid, allowed is " + format_double(allowed)};
    }
  }
  return {};
}

/// How much wider the roundings get, in units of the size.
constexpr double widths[] = {0x1p-20, 0x1p-3};

std::vector<LawQuery> widened(const Method&, const Pair& pair, const MethodAnswer& first) {
  if (!is_rounded(pair) || !first.has_distance || !is_usable(pair)) return {};
  std::vector<LawQuery> asked;
  for (const double width : widths)
    for (const bool of_b : {false, true}) {
      Pair wider = pair;
      Solid& c = of_b ? wider.b : wider.a;
      if (c.rounding > 0) c.rounding += width * size_of(pair);
      if (c.rounding > 0) asked.push_back({wider});
    }
  return asked;
}

std::optional<Violation> break_widening(const LawCase& c) {
  return worst_of(c, [&](std::size_t i) -> std::optional<Violation> {
    const MethodAnswer& second = c.answers[i];
    const Pair& wider = c.asked[i].pair;
    if (!is_decided(c.first) || !is_decided(second) || !second.has_distance) return {};
    const double by = (wider.a.rounding - c.pair.a.rounding) + (wider.b.rounding - c.pair.b.rounding);
    // A method that does not report the least depth may report several depths of an overlap.
    const bool apart = c.first.distance > 0 && second.distance > 0;
    const double off =
        apart ? std::fabs(c.first.distance - by - second.distance) : second.distance - c.first.distance;
    const double allowed = distance_allowance(c, c.pair, c.first.distance) +
                           distance_allowance(c, wider, second.distance) + sum_error * size_of(wider);
    if (!(off > allowed)) return {};
    return Violation{"the distance goes from " + format_double(c.first.distance) + " to " +
                     format_double(second.distance) + " when a rounding grows by " + format_double(by)};
  });
}

/// How far a solid slides along the plane, in units of the size.
constexpr double slides[] = {0x1p-3, 3, 0x1p10};

// The way is exactly square to the normal. So only the rounding of centres brings solids nearer.
std::vector<LawQuery> along_the_plane(const Method&, const Pair& pair, const MethodAnswer&) {
  if (!has_half_space(pair) || !is_usable(pair)) return {};
  const bool plane_is_b = is_half_space(pair.b);
  const Vector3& n = (plane_is_b ? pair.b : pair.a).axis;
  Eigen::Index least;
  n.cwiseAbs().minCoeff(&least);
  const Eigen::Index i = (least + 1) % 3, j = (least + 2) % 3;
  Vector3 way = Vector3::Zero();
  const double largest = n.cwiseAbs().maxCoeff();
  way[i] = std::scalbn(n[j], -std::ilogb(largest));
  way[j] = -std::scalbn(n[i], -std::ilogb(largest));
  std::vector<LawQuery> asked;
  for (const double slide : slides)
    for (const auto solid : {&Pair::a, &Pair::b}) {
      asked.push_back({pair});
      (asked.back().pair.*solid).center += std::exp2(std::ilogb(slide * size_of(pair))) * way;
    }
  return asked;
}

// Each moved centre is rounded in two coordinates.
std::optional<Violation> break_sliding(const LawCase& c) {
  return worst_of(c, [&](std::size_t i) {
    const Pair& moved = c.asked[i].pair;
    return break_change(c, i, 2 * unit_roundoff_error * (moved.a.center.norm() + moved.b.center.norm()));
  });
}

}  // namespace

std::vector<Law> approximate_laws() {
  return {
      {20, LawKind::approximate, "rotation",
       "a rotation of both solids about the origin keeps the verdict and distance",
       "verdicts only if the distance exceeds 2^-49 of centres and lengths; lengths from 2^-200 to 2^200",
       rotated, break_rotation},
      {21, LawKind::approximate, "translation",
       "a translation of both solids by 1/8 to 2^20 of their size keeps the verdict and distance",
       "verdicts only if the distance exceeds the rounding error of the centres; lengths from 2^-200 to "
       "2^200",
       translated, break_changes},
      {22, LawKind::approximate, "Lipschitz",
       "the distance changes by at most the change of a radius, half height, half edge or centre, or of a "
       "direction times these; the verdict stays if the distance is larger",
       "lengths from 2^-200 to 2^200", nearby, break_changes},
      {23, LawKind::approximate, "triangle",
       "of three solids no gap is larger than the sum of the other two and the diameter of the middle solid",
       "for methods with distances, also with a third solid that is a capsule or a box if they support it; "
       "lengths from 2^-200 to 2^200",
       with_a_third, break_triangle},
      {24, LawKind::approximate, "slide",
       "b moved by t changes the distance by no more than t, so no depth exceeds the way back to touching",
       "for methods with distances; lengths from 2^-200 to 2^200", slid, break_changes},
      {25, LawKind::approximate, "rounding",
       "a rounding that grows shortens a gap by as much, and no distance grows",
       "for rounded solids and methods with distances; lengths from 2^-200 to 2^200", widened,
       break_widening},
      {26, LawKind::approximate, "along the plane",
       "a solid or the plane's point moved along the plane of a half-space keeps the verdict and distance",
       "for half-spaces; verdicts only if the distance exceeds the rounding error of the centres; lengths "
       "from 2^-200 to 2^200",
       along_the_plane, break_sliding},
  };
}

}  // namespace cyl
