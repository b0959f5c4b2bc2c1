// SPDX-License-Identifier: MIT
// Laws 20 to 29 hold within a proved allowance. The signed distance is -min f over unit directions D, with
//   f(D) = sum of r |D x w| + h/2 |D.w| + rounding over both solids, less |D.Delta|.
// So it changes by no more than f does at any D. |D x w| and |D.w| change by at most the change of w. Hence
//   |change| <= |Delta' - Delta| + sum of |r' - r| + |h' - h| / 2 + |rounding' - rounding|
//               + (r + h/2) |w' - w|.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
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

/// Returns the bound above for the numbers of two pairs, rounded up.
double change_between(const Pair& x, const Pair& y) {
  const Vector3 from = x.b.center - x.a.center, to = y.b.center - y.a.center;
  double change = (to - from).norm(), lost = unit_roundoff_error * (from.norm() + to.norm());
  for (const auto& [p, q] : {std::pair{&x.a, &y.a}, std::pair{&x.b, &y.b}}) {
    const double extent = p->radius + p->height / 2;
    change += std::fabs(q->radius - p->radius) + std::fabs(q->height - p->height) / 2 +
              std::fabs(q->rounding - p->rounding) +
              extent * (prepare(*q).unit_axis - prepare(*p).unit_axis).norm();
    if (q->axis != p->axis) lost += 2 * unit_axis_error * extent;
  }
  return (change + lost) * (1 + sum_error);
}

std::optional<Violation> break_changes(const LawCase& c) {
  return worst_of(c,
                  [&](std::size_t i) { return break_change(c, i, change_between(c.pair, c.asked[i].pair)); });
}

// The rotation of a quaternion of integers. Its matrix times the sum of their squares has integers only.
struct Rotation {
  Eigen::Matrix3d times_square;
  double square;
};

Rotation rotation(double w, double x, double y, double z) {
  Eigen::Matrix3d m;
  m << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return {m, w * w + x * x + y * y + z * z};
}

/// About a coordinate axis and about other axes, by small and by large angles.
const std::array rotations{rotation(2, 1, 0, 0), rotation(7, 0, 1, -1), rotation(1, 2, 3, -4)};

// A centre takes three products, two sums and a quotient: 4 u |c| in each coordinate, as the rows are of
// unit length. So it takes 7 u |c| in all. An axis takes 4 u of unit_axis, and 5.2 u of |w| by products and
// sums. Both stay below this bound, times |c| and times the extent.
constexpr double rotation_error = 16 * unit_roundoff_error;

double rotation_change(const Pair& pair) {
  double lengths = 0;
  for (const Solid* c : {&pair.a, &pair.b})
    lengths += c->center.norm() + c->radius + c->height / 2 + c->rounding;
  return rotation_error * lengths;
}

std::vector<LawQuery> rotated(const Method&, const Pair& pair, const MethodAnswer&) {
  if (!is_usable(pair)) return {};
  std::vector<LawQuery> asked;
  for (const Rotation& turn : rotations) {
    asked.push_back({pair});
    for (Solid* c : {&asked.back().pair.a, &asked.back().pair.b}) {
      c->center = turn.times_square * c->center / turn.square;
      c->axis = turn.times_square * prepare(*c).unit_axis;
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
    push().radius += length;
    push().height += 2 * length;
    push().center += length * Vector3(2, -1, 2) / 3;
    Solid& turned = push();
    const Vector3 w = prepare(turned).unit_axis;
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
    const Vector3 w0 = prepare(pair.a).unit_axis, w1 = prepare(pair.b).unit_axis;
    for (const Vector3& way : {w0, w1, Vector3(w0.cross(w1)), delta}) slide(way, -first.distance);
  }
  return asked;
}

/// The solids c of the triangle. One lies beyond b. A small one lies in the middle, so the inequality is
/// nearly tight.
std::array<Solid, 2> third_solids(const Pair& pair) {
  const Vector3 delta = pair.b.center - pair.a.center;
  constexpr double small = 0x1p-10;
  return {Solid{pair.b.center + delta, pair.a.axis, pair.b.radius, pair.a.height, pair.b.rounding},
          Solid{pair.a.center + delta / 2, pair.b.axis, small * pair.b.radius, small * pair.a.height,
                small * pair.b.rounding}};
}

std::vector<LawQuery> with_a_third(const Method&, const Pair& pair, const MethodAnswer& first) {
  if (!first.has_distance || !is_usable(pair)) return {};
  std::vector<LawQuery> asked;
  for (const Solid& c : third_solids(pair)) {
    asked.push_back({{pair.b, c}});
    asked.push_back({{pair.a, c}});
  }
  return asked;
}

double diameter(const Solid& c) {
  return (std::hypot(2 * c.radius, c.height) + 2 * c.rounding) * (1 + sum_error);
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
       "the distance changes by at most the change of a radius, half height or centre, or of an axis times "
       "radius and half height; the verdict stays if the distance is larger",
       "lengths from 2^-200 to 2^200", nearby, break_changes},
      {23, LawKind::approximate, "triangle",
       "of three solids no gap is larger than the sum of the other two and the diameter of the middle solid",
       "for methods with distances; lengths from 2^-200 to 2^200", with_a_third, break_triangle},
      {24, LawKind::approximate, "slide",
       "b moved by t changes the distance by no more than t, so no depth exceeds the way back to touching",
       "for methods with distances; lengths from 2^-200 to 2^200", slid, break_changes},
      {25, LawKind::approximate, "rounding",
       "a rounding that grows shortens a gap by as much, and no distance grows",
       "for rounded solids and methods with distances; lengths from 2^-200 to 2^200", widened,
       break_widening},
  };
}

}  // namespace cyl
