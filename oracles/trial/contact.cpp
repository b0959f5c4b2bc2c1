// SPDX-License-Identifier: MIT
#include "oracles/trial/contact.hpp"

#include <gmpxx.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/half_space.hpp"

namespace cyl {
namespace {

/// A side or an edge, a rim or a vertex, a cap, a facet or a plane.
enum class Part : unsigned char { side, rim, cap };

std::string_view word_of(const Solid& c, Part part) {
  constexpr std::array<std::string_view, 3> of_cylinder{"side", "rim", "cap"},
      of_box{"edge", "vertex", "facet"};
  return (is_box(c) ? of_box : of_cylinder)[static_cast<std::size_t>(part)];
}

/// Scales the largest coordinate to between 1 and 2. This is exact except for subnormal numbers.
Vector3 scaled(const Vector3& v) {
  const double most = v.cwiseAbs().maxCoeff();
  if (most == 0) return v;
  const int e = -std::ilogb(most);
  return v.unaryExpr([&](double x) { return std::ldexp(x, e); });
}

struct Angle {
  double sine, cosine;  // >= 0
};

Angle angle_between(const Vector3& a, const Vector3& b) {
  const Vector3 u = scaled(a), v = scaled(b);
  const double lengths = u.norm() * v.norm();
  return {u.cross(v).norm() / lengths, std::fabs(u.dot(v)) / lengths};
}

Part part_along(const Solid& c, const Vector3& direction) {
  if (is_half_space(c)) return Part::cap;
  if (is_box(c)) {
    int square = 0;  // edges that lie in the farthest face
    for (std::size_t i = 0; i < 3; ++i)
      square += c.edges[i] > 0 && angle_between(edge_direction(c, i), direction).cosine <= flat_tol;
    return square == 0 ? Part::rim : square == 1 ? Part::side : Part::cap;
  }
  const Angle angle = angle_between(c.axis, direction);
  if (angle.sine <= flat_tol && c.radius > 0) return Part::cap;
  if (angle.cosine <= flat_tol && c.height > 0) return Part::side;
  return Part::rim;
}

/// The width that the search may leave open, relative to the size. Flat contacts are kinks of f. At an angle
/// t from one, f is worse by about t heights or radii. So the search finds the kink to less than flat_tol.
constexpr double direction_width_tol = 1e-11;

}  // namespace

ContactFeature feature_along(const Pair& pair, const Vector3& direction) {
  auto [first, second] = std::minmax({part_along(pair.a, direction), part_along(pair.b, direction)});
  switch (second) {
    case Part::side:
      return ContactFeature::side_side;
    case Part::rim:
      return first == Part::side ? ContactFeature::side_rim : ContactFeature::rim_rim;
    case Part::cap:
      return first == Part::side  ? ContactFeature::cap_side
             : first == Part::rim ? ContactFeature::cap_rim
                                  : ContactFeature::cap_cap;
  }
  return ContactFeature::rim_rim;
}

namespace {

/// Rounding of a place in the outer solid, relative to its size and the way between the centres.
constexpr double place_error = 16 * 0x1p-53;

/// A box holds what does not reach beyond its facets. Another solid holds the corners of a box.
bool contains_with_box(const Solid& outer, const Solid& inner) {
  const Vec3<double> d = lifted<double>(Vector3(inner.center - outer.center));
  const Terms<double> of_outer = terms_of<double>(outer), of_inner = terms_of<double>(inner);
  const double rounding = place_error * (outer.radius + outer.height + edges_of(outer) + norm(d));
  if (of_outer.box) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double reach = std::fabs(dot(d, of_outer.edges[i])) + core_support(of_inner, of_outer.edges[i]);
      if (reach + inner.rounding > of_outer.halves[i] + outer.rounding + rounding) return false;
    }
    return true;
  }
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3<double> x = d;
    for (std::size_t i = 0; i < 3; ++i)
      x = x + (corner >> i & 1U ? 1 : -1) * of_inner.halves[i] * of_inner.edges[i];
    const auto [caps, wall] = beyond(of_outer, x);
    const double out = std::hypot(std::max(0.0, caps), std::max(0.0, wall));
    if (out + inner.rounding > outer.rounding + rounding) return false;
  }
  return true;
}

}  // namespace

// The inner reaches as far from outer's axis as in the best direction square to it. A coarse search, then
// thirds, find that direction.
bool contains(const Solid& outer, const Solid& inner) {
  if (is_half_space(outer)) {  // the solid is behind the plane as far as it would be before it from outside
    Solid beyond = outer;
    beyond.axis = -outer.axis;
    return half_space_sign({beyond, inner}) <= 0;
  }
  if (is_half_space(inner)) return false;
  if (is_box(outer) || is_box(inner)) return contains_with_box(outer, inner);
  const Vector3 d = inner.center - outer.center, w = scaled(outer.axis).normalized();
  const Vector3 x = w.unitOrthogonal(), y = w.cross(x);
  const Terms<double> of_inner = terms_of<double>(inner);
  const auto reach_along = [&](const Vector3& u) {
    return d.dot(u) + core_support(of_inner, lifted<double>(u));
  };
  const double rounding = place_error * (outer.radius + outer.height + d.norm());
  if (std::max(reach_along(w), reach_along(-w)) > outer.height / 2 + rounding) return false;
  const auto reach = [&](double angle) { return reach_along(std::cos(angle) * x + std::sin(angle) * y); };
  constexpr int looks = 256;
  constexpr double step = 2 * std::numbers::pi / looks;
  double best = 0;
  for (int i = 1; i < looks; ++i)
    if (reach(i * step) > reach(best)) best = i * step;
  double low = best - step, high = best + step;
  for (int i = 0; i < 40; ++i) {
    const double third = (high - low) / 3;
    if (reach(low + third) < reach(high - third))
      low += third;
    else
      high -= third;
  }
  return reach((low + high) / 2) <= outer.radius + rounding;
}

ContactFeature feature_at(const Pair& pair, bool overlap, const Vector3& direction) {
  const bool inside = overlap && (contains(pair.a, pair.b) || contains(pair.b, pair.a));
  return inside ? ContactFeature::containment : feature_along(pair, direction);
}

namespace {

/// The direction in which the signed distance is attained, if there is one.
std::optional<Vector3> contact_direction(const Pair& pair, const Truth& truth) {
  if (truth.verdict == Verdict::invalid || truth.verdict == Verdict::undecided) return {};
  const std::array<double, 3> found = attain_distance(pair, truth, direction_width_tol).direction;
  return Vector3(found[0], found[1], found[2]);
}

}  // namespace

std::optional<ContactFeature> contact_feature(const Pair& pair, const Truth& truth) {
  const auto direction = contact_direction(pair, truth);
  if (!direction) return {};
  return feature_at(pair, truth.verdict == Verdict::intersecting, *direction);
}

std::string contact_in_words(const Pair& pair, const Truth& truth) {
  const auto direction = contact_direction(pair, truth);
  if (!direction) return "unknown";
  const ContactFeature feature = feature_at(pair, truth.verdict == Verdict::intersecting, *direction);
  if (!has_box(pair) || feature == ContactFeature::containment) return to_string(feature);
  const auto part = [&](const Solid& c) {
    const Part p = part_along(c, *direction);
    constexpr std::array<int, 3> places{1, 2, 0};  // "cap-side", "cap-rim", "side-rim"
    return std::pair(places[static_cast<std::size_t>(p)], word_of(c, p));
  };
  const auto [first, second] = std::minmax({part(pair.a), part(pair.b)});
  return std::string(first.second) + '-' + std::string(second.second);
}

std::optional<ContactFeature> contact_feature(const Pair& pair) { return contact_feature(pair, judge(pair)); }

namespace {

/// Greater sines and cosines are not 0. It allows for twenty roundings per coordinate, and the lengths.
constexpr double zero_error = 1e-14;

AxesAngle exact_angle(const Angle& angle, const auto& exact_lines) {
  AxesAngle exactly{angle.sine, angle.cosine, false, false};
  if (std::min(angle.sine, angle.cosine) > zero_error) return exactly;
  const auto [u, v] = exact_lines();
  const Rational3 c = cross(u, v);
  exactly.parallel = c.x == 0 && c.y == 0 && c.z == 0;
  exactly.right = dot(u, v) == 0;
  return exactly;
}

/// The directions of the edges, or the axis.
std::vector<Vector3> lines_of(const Solid& c) {
  if (!is_box(c)) return {c.axis};
  return {edge_direction(c, 0), edge_direction(c, 1), edge_direction(c, 2)};
}
Rational3 exact_line(const Solid& c, std::size_t line) {
  return is_box(c) ? edge_directions<mpq_class>(c.quaternion)[line] : exact(c.axis);
}

}  // namespace

AxesAngle axes_angle(const Pair& pair) {
  AxesAngle least;
  least.sine = 2;
  const std::vector<Vector3> of_a = lines_of(pair.a), of_b = lines_of(pair.b);
  for (std::size_t i = 0; i < of_a.size(); ++i)
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      const AxesAngle found = exact_angle(angle_between(of_a[i], of_b[j]), [&] {
        return std::pair(exact_line(pair.a, i), exact_line(pair.b, j));
      });
      if (found.parallel) return found;
      if (found.sine < least.sine) least = found;
    }
  return least;
}

AngleClass angle_class(const Pair& pair) { return angle_class(axes_angle(pair)); }

AngleClass angle_class(const AxesAngle& angle) {
  if (angle.parallel) return AngleClass::parallel;
  if (angle.right) return AngleClass::right;
  if (angle.sine < 1e-12) return AngleClass::within_1e_12;
  if (angle.sine < 1e-7) return AngleClass::within_1e_7;
  if (angle.sine < 1e-2) return AngleClass::within_1e_2;
  return angle.cosine <= 1e-2 ? AngleClass::near_right : AngleClass::generic;
}

}  // namespace cyl
