// SPDX-License-Identifier: MIT
#include "oracles/trial/contact.hpp"

#include <gmpxx.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/half_space.hpp"

namespace cyl {
namespace {

enum class Part : unsigned char { side, rim, cap };

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

// Along outer's axis, the inner reaches |d.w| + h/2 |cos| + r sin. In the plane perpendicular to w, with x
// along the inner's axis, its rims are ellipses about (+-h/2 sin, 0) with half axes r |cos| and r. Their
// farthest point lies in the quarter away from outer's axis. A coarse search, then thirds, find its t, the
// one with the greatest square distance
//     (X + r |cos| cos t)^2 + (Y + r sin t)^2,  X = |x| + h/2 sin,  Y = |y|.
bool contains(const Solid& outer, const Solid& inner) {
  if (is_half_space(outer)) {  // the solid is behind the plane as far as it would be before it from outside
    Solid beyond = outer;
    beyond.axis = -outer.axis;
    return half_space_sign({beyond, inner}) <= 0;
  }
  if (is_half_space(inner)) return false;
  const Vector3 d = inner.center - outer.center;
  const Vector3 w = scaled(outer.axis).normalized(), v = scaled(inner.axis).normalized();
  const double cosine = std::fabs(w.dot(v)), sine = w.cross(v).norm();
  const double r = inner.radius, half = inner.height / 2, height = d.dot(w);
  const double rounding = 16 * 0x1p-53 * (outer.radius + outer.height + d.norm());
  if (std::fabs(height) + half * cosine + r * sine > outer.height / 2 + rounding) return false;
  const Vector3 across = d - height * w, flat = v - v.dot(w) * w;
  const Vector3 e = sine > 0 ? flat.stableNormalized() : across.stableNormalized();
  const double x = std::fabs(across.dot(e)), y = (across - across.dot(e) * e).norm();
  const auto reach = [&](double t) {
    return std::hypot(x + half * sine + r * cosine * std::cos(t), y + r * std::sin(t));
  };
  constexpr int looks = 64;
  constexpr double quarter = 1.5707963267948966, step = quarter / looks;
  double best = 0;
  for (int i = 0; i <= looks; ++i)
    if (reach(i * step) > reach(best)) best = i * step;
  double low = std::max(0.0, best - step), high = std::min(quarter, best + step);
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

std::optional<ContactFeature> contact_feature(const Pair& pair, const Truth& truth) {
  if (truth.verdict == Verdict::invalid || truth.verdict == Verdict::undecided) return {};
  const std::array<double, 3> found = attain_distance(pair, truth, direction_width_tol).direction;
  return feature_at(pair, truth.verdict == Verdict::intersecting, Vector3(found[0], found[1], found[2]));
}

std::optional<ContactFeature> contact_feature(const Pair& pair) { return contact_feature(pair, judge(pair)); }

AxesAngle axes_angle(const Pair& pair) {
  const Angle angle = angle_between(pair.a.axis, pair.b.axis);
  AxesAngle exactly{angle.sine, angle.cosine, false, false};
  /// Greater sines and cosines are not 0. It allows for three roundings per coordinate, and the lengths.
  constexpr double zero_error = 1e-15;
  if (angle.sine <= zero_error) {
    const Rational3 c = cross(exact(pair.a.axis), exact(pair.b.axis));
    exactly.parallel = c.x == 0 && c.y == 0 && c.z == 0;
  }
  if (angle.cosine <= zero_error) exactly.right = dot(exact(pair.a.axis), exact(pair.b.axis)) == 0;
  return exactly;
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
