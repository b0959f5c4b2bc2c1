// SPDX-License-Identifier: MIT
#include "corpus/pairs/vector_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "corpus/pairs/support.hpp"

namespace cyl {
namespace {

Wide3 wide(const Vector3& v) { return v.cast<long double>(); }

/// Returns the gap that planes square to the direction show, up to rounding.
long double gap_along(const Pair& p, const Vector3& direction) {
  const Wide3 d = wide(direction).normalized();
  long double gap = std::abs(d.dot(wide(p.b.center) - wide(p.a.center)));
  for (const Solid* c : {&p.a, &p.b})
    gap -= core_support(terms_of<long double>(*c), lifted<long double>(d)) + c->rounding;
  return gap;
}

/// Returns the nearest float. It is volatile because g++ 12 -O3 drops both casts at a vectorised loop's end.
double as_float(double x) {
  const volatile float nearest = static_cast<float>(x);
  return static_cast<double>(nearest);
}

Pair cycled(Pair p) {
  for (Solid* c : {&p.a, &p.b})
    for (Vector3* v : {&c->center, &c->axis}) *v = Vector3((*v)[2], (*v)[0], (*v)[1]);
  return p;
}

Pair mirrored(Pair p) {
  for (Solid* c : {&p.a, &p.b})
    for (Vector3* v : {&c->center, &c->axis}) (*v)[0] = 0 - (*v)[0];
  return p;
}

constexpr ExactChange changes[] = {
    {"exchanged",
     [](Pair p) {
       return Pair{p.b, p.a};
     }},
    {"axis of a reversed",
     [](Pair p) {
       p.a.axis = Vector3(0, 0, 0) - p.a.axis;
       return p;
     }},
    {"coordinates cycled", cycled},
    {"mirrored in x", mirrored},
    {"scaled by 8", [](Pair p) { return scaled(p, 3); }},
    {"axis of b doubled",
     [](Pair p) {
       p.b.axis *= 2;
       return p;
     }},
};

}  // namespace

long double scale_of(const Pair& p) {
  return (wide(p.b.center) - wide(p.a.center)).norm() + p.a.radius + p.a.height + p.a.rounding + p.b.radius +
         p.b.height + p.b.rounding;
}

// The part taken off is far above all rounding errors.
double proved_below(const Pair& p, const Vector3& direction) {
  const auto low = static_cast<double>(gap_along(p, direction) - 0x1p-58L * scale_of(p));
  return std::nextafter(low, -std::numeric_limits<double>::infinity());
}

std::optional<Vector3> touching_direction(const Pair& p) {
  const Vector3 delta = p.b.center - p.a.center, normal = p.a.axis.cross(p.b.axis);
  const auto has_root = [](double square) { return std::sqrt(square) * std::sqrt(square) == square; };
  for (const Vector3& d : {p.a.axis, p.b.axis, normal, delta, Vector3(p.a.axis.cross(delta).cross(p.a.axis)),
                           Vector3(p.b.axis.cross(delta).cross(p.b.axis))}) {
    if (d.isZero(0) || !d.allFinite() || d.cwiseAbs().maxCoeff() > 1e5) continue;
    bool rational = d == Vector3(d.array().round()) && has_root(d.squaredNorm());
    for (const Solid* c : {&p.a, &p.b})
      rational = rational && has_root(c->axis.squaredNorm()) && has_root(d.cross(c->axis).squaredNorm());
    if (rational && std::abs(gap_along(p, d)) <= 0x1p-58L * scale_of(p)) return d;
  }
  return {};
}

bool is_float(const Pair& p) {
  for (const double x : numbers_of(p)) {
    const bool normal = x == 0 || (std::abs(x) >= std::numeric_limits<float>::min() &&
                                   std::abs(x) <= std::numeric_limits<float>::max());
    if (!normal || as_float(x) != x) return false;
  }
  return true;
}

bool is_everyday(const Pair& p) {
  for (const Solid* c : {&p.a, &p.b}) {
    for (const double x : {c->radius, c->height, c->rounding})
      if (x != 0 && (x < 0.1 || x > 10)) return false;
    if (c->center.cwiseAbs().maxCoeff() > 100 || std::abs(c->axis.norm() - 1) > 1e-6) return false;
  }
  return true;
}

std::string flags_of(const Pair& p, Verdict result, std::optional<ContactFeature> feature, AngleClass angle,
                     double margin) {
  std::string flags;
  const auto flag = [&](bool has, std::string_view name) {
    if (has) flags += fmt::format("{}\"{}\"", flags.empty() ? "" : ",", name);
  };
  const auto either = [&](auto has) { return has(p.a) || has(p.b); };
  const Vector3 delta = p.b.center - p.a.center;
  const double size = size_of(p), of_a = p.a.radius + p.a.height + p.a.rounding, of_b = size - of_a;
  const bool has_axes = !either([](const Solid& c) { return c.radius + c.height == 0; });
  const double off = delta.cross(p.a.axis.stableNormalized()).norm();
  flag(has_axes && angle == AngleClass::parallel, "ParallelAxes");
  flag(has_axes && angle > AngleClass::parallel && angle < AngleClass::generic, "NearlyParallelAxes");
  flag(has_axes && angle == AngleClass::right, "SquareAxes");
  flag(has_axes && angle == AngleClass::near_right, "NearlySquareAxes");
  flag(has_axes && angle == AngleClass::parallel && off <= 1e-12 * size, "Coaxial");
  flag(delta.isZero(0), "Concentric");
  flag(feature == ContactFeature::containment, "Contained");
  flag(feature == ContactFeature::cap_cap, "FaceOnFace");
  flag(feature == ContactFeature::rim_rim, "RimOnRim");
  flag(feature == ContactFeature::side_rim || feature == ContactFeature::cap_rim, "RimOnFace");
  flag(result == Verdict::touching, "Touching");
  flag(result != Verdict::touching && margin < 1e-6, "NearlyTouching");
  flag(either([](const Solid& c) { return c.rounding == 0 && c.radius * c.height == 0; }), "Flat");
  flag(either([](const Solid& c) { return c.height > 0 && c.radius > 0 && c.radius < 0.01 * c.height; }),
       "Needle");
  flag(either([](const Solid& c) { return c.radius > 0 && c.height > 0 && c.height < 0.01 * c.radius; }),
       "Coin");
  flag(either([](const Solid& c) { return kind_of(c) == SolidKind::sphere; }), "Sphere");
  flag(either([](const Solid& c) { return kind_of(c) == SolidKind::capsule; }), "Capsule");
  flag(either([](const Solid& c) { return kind_of(c) == SolidKind::rounded; }), "RoundedEdges");
  flag(size < 1e-3 || size > 1e3, "UnusualSize");
  flag(std::max(p.a.center.stableNorm(), p.b.center.stableNorm()) > 1000 * size, "FarAway");
  flag(std::min(of_a, of_b) > 0 && std::max(of_a, of_b) > 1000 * std::min(of_a, of_b), "MixedSizes");
  flag(either([](const Solid& c) { return std::abs(c.axis.stableNorm() - 1) > 1e-6; }), "AxisOfAnyLength");
  return flags;
}

AxisTurn turn_of(const Solid& c, bool in_floats) {
  Wide3 axis = wide(c.axis).normalized();
  if (axis[2] < 0) axis = -axis;
  const long double w = std::sqrt((1 + axis[2]) / 2);
  const auto rounded = [&](long double x) {
    return in_floats ? as_float(static_cast<double>(x)) : static_cast<double>(x);
  };
  AxisTurn q{rounded(w), rounded(-axis[1] / (2 * w)), rounded(axis[0] / (2 * w)), 0, 0};
  const long double W = q.w, X = q.x, Y = q.y;
  const Wide3 got(2 * W * Y, -2 * W * X, W * W - X * X - Y * Y);
  long double sine = got.normalized().cross(axis).norm();
  const bool same = got.cwiseAbs().maxCoeff() == got.cwiseAbs().sum() && axis.cwiseAbs().sum() == 1;
  q.off = same ? 0 : (2 * sine + 0x1p-58L) * (c.radius + c.height / 2.0L);
  return q;
}

std::vector<Vector3> prism(const Solid& c, int sides, bool around) {
  const Vector3 w = c.axis.normalized(), u = w.unitOrthogonal(), v = w.cross(u);
  const double more = around ? 1 + 0x1p-20 : 1 - 0x1p-20;
  const double r = c.radius * more / (around ? std::cos(std::numbers::pi / sides) : 1);
  std::vector<Vector3> corners;
  for (const double end : {-0.5, 0.5})
    for (int i = 0; i < sides; ++i) {
      const double t = 2 * std::numbers::pi * i / sides;
      corners.push_back(c.center + end * more * c.height * w + r * (std::cos(t) * u + std::sin(t) * v));
    }
  return corners;
}

Pair in_floats(const Pair& p) {
  Pair q = p;
  for (Solid* c : {&q.a, &q.b})
    for (double* x : numbers_of(*c)) *x = as_float(*x);
  return q;
}

std::span<const ExactChange> exact_changes() { return changes; }

}  // namespace cyl
