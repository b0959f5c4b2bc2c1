// SPDX-License-Identifier: MIT
// Laws 10 to 19: one answer bounds another, or a simpler solid in a cylinder's place bounds it.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"
#include "oracles/referee/referee.hpp"
#include "props/laws/law_groups.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

Severity severity_on(const LawCase& c, const Pair& pair) {
  return beyond_claim(c.proofs.of(pair), c.method.claim()) ? Severity::contract : Severity::resolution;
}

std::string verdict_text(const MethodAnswer& answer) {
  return std::string("answers ") + to_string(answer.verdict);
}

/// How much solids grow beyond the need of the claim, in units of the size.
constexpr double growth = 0x1p-20;

/// Makes the core longer by g on every side.
void widen(Solid& c, double g) {
  if (is_box(c)) {
    for (double& edge : c.edges) edge += 2 * g;
  } else if (!is_half_space(c)) {
    c.radius += g;
    c.height += 2 * g;
  }
}

// If a rounding grows by g, the signed distance falls by g. If all radii grow by g and all heights and edges
// by 2 g, each support function rises by g (sin + cos) >= g, for the angle between direction and axis. So the
// signed distance falls by g at least, as a half-space does not grow. An answer `intersecting` within the
// claim means a distance below the reach. With g more than the reach before and after, the solids then
// overlap by more than the reach. One field alone promises less, because a cap on a cap does not depend on
// the radius.
std::vector<LawQuery> grown(const Method& method, const Pair& pair, const MethodAnswer& first) {
  if (!says_meet(first)) return {};
  const double size = size_of(pair);
  const double g = 2 * reach(method.claim(), size) + growth * size;
  Pair wide = pair;
  std::vector<LawQuery> asked;
  for (const auto solid : {&Pair::a, &Pair::b}) {
    widen(wide.*solid, g);
    const auto lengths = numbers_of(std::as_const(pair.*solid)),
               wider = numbers_of(std::as_const(wide.*solid));
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (lengths[i] == wider[i]) continue;
      asked.push_back({pair});
      *numbers_of(asked.back().pair.*solid)[i] = wider[i];
    }
  }
  asked.push_back({wide});
  // Grows a rounding by twice as much. If one solid has none, it would not grow in all directions.
  if (is_rounded(pair)) {
    asked.push_back({pair});
    (pair.a.rounding > 0 ? asked.back().pair.a : asked.back().pair.b).rounding += 2 * g;
  }
  std::erase_if(asked, [](const LawQuery& x) { return !is_legal(x.pair); });
  return asked;
}

std::optional<Violation> break_growing(const LawCase& c) {
  return worst_of(c, [&](std::size_t i) -> std::optional<Violation> {
    if (!is_decided(c.answers[i]) || says_meet(c.answers[i])) return {};
    return Violation{verdict_text(c.first) + ", but disjoint for larger solids", severity_of(c, i)};
  });
}

/// By how much a capsule is too wide or too narrow, so that rounding does not undo the containment.
double slack(const Solid& c) {
  return 0x1p-49 * (c.center.norm() + c.height + c.radius + edges_of(c) + c.rounding);
}

/// A proxy thinner than this, times the solid's largest number, is lost in the rounding of its centre.
constexpr double thinnest_proxy = 0x1p-40;

/// Returns b scaled to half of the width of a's inner proxy and put around `point` on its axis. None of it
/// is outside a.
Solid shrunk_into(const Solid& proxy, const Vector3& point, Solid b) {
  const double extent = core_extent(b) + b.rounding;
  const double factor = extent > 0 ? proxy.rounding / 2 / extent : 0;
  for (double* x : {&b.radius, &b.height, &b.rounding, &b.edges[0], &b.edges[1], &b.edges[2]}) *x *= factor;
  b.center = point;
  return b;
}

/// A ball as large as the solid, behind the plane.
Solid ball_behind(const Solid& plane, const Solid& solid) {
  const double radius = core_extent(solid) + solid.rounding;
  return {.center = plane.center - 2 * radius * direction_of(plane), .rounding = radius};
}

std::vector<LawQuery> inside(const Method&, const Pair& pair, const MethodAnswer&) {
  if (!is_in_range(pair) || !is_legal(pair)) return {};
  const bool of_b = is_half_space(pair.b);
  const Solid &a = of_b ? pair.b : pair.a, &b = of_b ? pair.a : pair.b;
  const Solid proxy = is_half_space(a) ? ball_behind(a, b) : capsule_inside(a);
  const double most = std::max(a.center.lpNorm<Eigen::Infinity>(), core_extent(a) + a.rounding);
  if (!(proxy.rounding > thinnest_proxy * most)) return {};
  const Vector3 to_end = proxy.height / 2 * direction_of(proxy);
  return {{{a, shrunk_into(proxy, proxy.center - to_end, b)}},
          {{shrunk_into(proxy, proxy.center + to_end, b), a}}};
}

std::optional<Violation> break_inside(const LawCase& c) {
  return worst_of(c, [&](std::size_t i) -> std::optional<Violation> {
    if (!is_decided(c.answers[i]) || says_meet(c.answers[i])) return {};
    return Violation{verdict_text(c.answers[i]) + " of a solid and one inside it",
                     severity_on(c, c.asked[i].pair)};
  });
}

/// More than the rounding errors of the distances of spheres and of the ends of capsules, times the size and
/// the distances of both centres from the origin.
constexpr double proxy_error = 0x1p-45;

double bounding_radius(const Solid& c) {
  if (is_half_space(c)) return std::numeric_limits<double>::infinity();
  if (is_box(c)) return std::hypot(c.edges[0], c.edges[1], c.edges[2]) / 2 + c.rounding;
  return std::hypot(c.radius, c.height / 2) + c.rounding;
}

Enclosure enclosed_distance(const Solid& a, const Solid& b) {
  const Pair pair{a, b};
  return enclose_distance(pair, judge_verdict(pair), gap_width_tol);
}

std::optional<Violation> break_proxies(const LawCase& c) {
  if (!is_decided(c.first) || !is_in_range(c.pair)) return {};
  const Solid &a = c.pair.a, &b = c.pair.b;
  const double lost = proxy_error * (size_of(c.pair) + a.center.norm() + b.center.norm());
  if (says_meet(c.first)) {
    const double spheres = (b.center - a.center).norm() - bounding_radius(a) - bounding_radius(b);
    const double capsules = enclosed_distance(capsule_around(a), capsule_around(b)).lo;
    if (std::max(spheres, capsules) <= lost) return {};
    const char* which = spheres > lost ? "spheres around" : "capsules around";
    return Violation{verdict_text(c.first) + ", but the " + which + " the solids are apart",
                     severity_on(c, c.pair)};
  }
  const Solid in_a = capsule_inside(a), in_b = capsule_inside(b);
  if (in_a.rounding < 0 || in_b.rounding < 0) return {};
  if (enclosed_distance(in_a, in_b).hi >= -lost) return {};
  return Violation{verdict_text(c.first) + ", but the capsules inside the solids meet",
                   severity_on(c, c.pair)};
}

/// How far b is moved, in units of the sum of the size and the distance of the centres.
constexpr double moves[] = {0x1p-20, 0x1p-3, 0x1p10};

std::vector<LawQuery> moved_apart(const Method&, const Pair& pair, const MethodAnswer& first) {
  if (first.verdict != Verdict::disjoint || first.witness != CertificateKind::direction || !is_in_range(pair))
    return {};
  const Vector3 u = offered_direction(pair, first);
  if (!u.allFinite() || u.isZero(0)) return {};
  const double unit = size_of(pair) + (pair.b.center - pair.a.center).norm();
  std::vector<LawQuery> asked;
  for (const double move : moves) {
    asked.push_back({pair});
    asked.back().pair.b.center += move * unit * u;
  }
  return asked;
}

std::optional<Violation> break_moving_apart(const LawCase& c) {
  const Vector3 u = offered_direction(c.pair, c.first);
  return worst_of(c, [&](std::size_t i) -> std::optional<Violation> {
    const MethodAnswer& second = c.answers[i];
    if (!is_decided(second)) return {};
    const Pair& moved = c.asked[i].pair;
    const double shown = shown_by(moved, u);
    if (shown > 0 && says_meet(second)) {
      return Violation{
          verdict_text(second) + " after b moved away along its own direction",
          shown >= reach(c.method.claim(), size_of(moved)) ? Severity::contract : Severity::resolution};
    }
    if (second.has_distance && second.distance < shown - distance_allowance(c, moved, second.distance)) {
      return Violation{"returns the distance " + format_double(second.distance) +
                       ", but its direction proves " + format_double(shown)};
    }
    return {};
  });
}

/// This far inside the ends of the axis, the rounding of a slice's centre does not carry it out.
constexpr double inward = 1 - 0x1p-30;

/// Returns the solid's slice across the middle, and its length along the axis, or along the longest edge of a
/// box. The other edges of a box are a little shorter, since its directions are rounded.
std::pair<Solid, double> slice_of(Solid c) {
  if (!is_box(c)) return {c, std::exchange(c.height, 0)};
  auto longest = std::ranges::max_element(c.edges);
  const double length = std::exchange(*longest, 0);
  for (double& edge : c.edges) edge *= inward;
  return {c, length};
}

// The slice across the middle sweeps a solid along its axis. A sphere sweeps a capsule.
std::vector<LawQuery> swept(const Method&, const Pair& pair, const MethodAnswer&) {
  if ((!is_rounded(pair) && !has_box(pair)) || !is_in_range(pair) || !is_legal(pair)) return {};
  std::vector<LawQuery> asked;
  for (const auto solid : {&Pair::a, &Pair::b}) {
    const Solid& whole = pair.*solid;
    const auto [slice, length] = slice_of(whole);
    const double thinnest = is_box(whole) ? *std::ranges::min_element(whole.edges) : length;
    if (!(thinnest * 0x1p-42 > (whole.center.norm() + (is_box(whole) ? length : 0)) * unit_roundoff_error))
      continue;
    for (const double end : {-1.0, 0.0, 1.0}) {
      asked.push_back({pair});
      asked.back().pair.*solid = slice;
      (asked.back().pair.*solid).center += end * inward * length / 2 * direction_of(whole);
    }
  }
  return asked;
}

std::optional<Violation> break_sweep(const LawCase& c) {
  return worst_of(c, [&](std::size_t i) -> std::optional<Violation> {
    if (!is_decided(c.first) || says_meet(c.first) || !is_decided(c.answers[i]) || !says_meet(c.answers[i]))
      return {};
    return Violation{verdict_text(c.first) + ", but a slice of one solid meets the other", severity_of(c, i)};
  });
}

/// The cylinder along the longest edge of a box that is as wide as the others' diagonal, and `by` more on
/// every side. Its rounding is the box's.
Solid cylinder_around(const Solid& box, double by) {
  auto edges = box.edges;
  std::ranges::sort(edges);
  return {box.center, direction_of(box), std::hypot(edges[0], edges[1]) / 2 + by, edges[2] + 2 * by,
          box.rounding};
}
/// The one that is as wide as the shortest edge, and `by` less.
Solid cylinder_inside(const Solid& box, double by) {
  auto edges = box.edges;
  std::ranges::sort(edges);
  return {box.center, direction_of(box), edges[0] / 2 - by, edges[2] - 2 * by, box.rounding};
}

// A ball and a cylinder take the place of each box, one by one. The ball around equal edges is the tightest.
std::vector<LawQuery> with_stand_ins(const Method&, const Pair& pair, const MethodAnswer& first) {
  if (!has_box(pair) || !is_decided(first) || !is_in_range(pair) || !is_legal(pair)) return {};
  const bool outer = says_meet(first);
  std::vector<LawQuery> asked;
  for (const auto solid : {&Pair::a, &Pair::b}) {
    const Solid& c = pair.*solid;
    if (!is_box(c)) continue;
    const double lost = slack(c), shortest = *std::ranges::min_element(c.edges);
    const double radius = outer ? bounding_radius(c) + lost : shortest / 2 + c.rounding - lost;
    for (const Solid& other : {Solid{.center = c.center, .rounding = radius},
                               outer ? cylinder_around(c, lost) : cylinder_inside(c, lost)}) {
      if (find_defect(other) != Defect::none) continue;
      asked.push_back({pair});
      asked.back().pair.*solid = other;
    }
  }
  return asked;
}

std::optional<Violation> break_stand_ins(const LawCase& c) {
  return worst_of(c, [&](std::size_t i) -> std::optional<Violation> {
    if (!is_decided(c.answers[i]) || says_meet(c.answers[i]) == says_meet(c.first)) return {};
    return Violation{verdict_text(c.first) + ", but " + to_string(c.answers[i].verdict) + " for a solid " +
                         (says_meet(c.first) ? "around" : "inside") + " a box",
                     severity_of(c, i)};
  });
}

}  // namespace

Solid capsule_around(const Solid& c) {
  if (is_half_space(c)) return c;
  const Solid core = is_box(c) ? cylinder_around(c, 0) : c;
  return {c.center, core.axis, 0, core.height, core.radius + c.rounding + slack(c)};
}

Solid capsule_inside(const Solid& c) {
  if (is_half_space(c)) return c;
  const Solid core = is_box(c) ? cylinder_inside(c, 0) : c;
  const double width = std::min(core.radius, core.height / 2);
  return {c.center, core.axis, 0, core.height - 2 * width, width + c.rounding - slack(c)};
}

std::vector<Law> one_sided_laws() {
  return {
      {10, LawKind::one_sided, "growing",
       "intersecting solids do not become disjoint if a radius, height or edge grows, or all of them",
       "if the answer is intersecting", grown, break_growing},
      {11, LawKind::one_sided, "inside", "a small copy of b well inside a, in either order, intersects a",
       "if a capsule fits into a, or a is a half-space; lengths from 2^-200 to 2^200", inside, break_inside},
      {12, LawKind::one_sided, "proxies",
       "solids are disjoint if their bounding spheres or outer capsules are, and intersect if their inner "
       "capsules do",
       "beyond the rounding errors of spheres and capsules; lengths from 2^-200 to 2^200", needs_none,
       break_proxies},
      {13, LawKind::one_sided, "moving apart",
       "b moved by t along the returned direction stays disjoint, and the distance is at least the gap along "
       "it plus t",
       "if the answer is disjoint with a direction; lengths from 2^-200 to 2^200", moved_apart,
       break_moving_apart},
      {14, LawKind::one_sided, "sweep",
       "a slice across the axis or an edge, such as a sphere of a capsule, meets no more than the whole "
       "solid does",
       "for boxes and for rounded solids, longer than the rounding error of their centres; lengths from "
       "2^-200 to 2^200",
       swept, break_sweep},
      {15, LawKind::one_sided, "stand-ins",
       "what meets a box meets a ball and a cylinder around it; what meets those inside it meets the box",
       "for boxes, if the method supports the ball or the cylinder; lengths from 2^-200 to 2^200",
       with_stand_ins, break_stand_ins},
  };
}

}  // namespace cyl
