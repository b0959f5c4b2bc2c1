// SPDX-License-Identifier: MIT
#include "scenes/model_hierarchy.hpp"

#include <cmath>

#include "solver/distance.hpp"

namespace cyl {
namespace {

double length_squared(const Vector3& v) noexcept { return v.x() * v.x() + v.y() * v.y() + v.z() * v.z(); }

double slack(const Models& a, const Models& b, double clearance) noexcept {
  return seeds::proxy_distance_error * clearance + a.slack + b.slack;
}

/// Whether the balls are farther from each other than the clearance and `more`.
bool balls_apart(const Models& a, const Models& b, double reach) noexcept {
  const double far = a.ball + b.ball + reach;
  return length_squared(b.solid.center - a.solid.center) > far * far;
}

Look look_at_cylinders(const Models& a, const Models& b, double clearance) noexcept {
  if (clearance == 0) {
    const Verdict verdict = intersect(a.solid, b.solid);
    return verdict == Verdict::disjoint       ? Look::apart
           : verdict == Verdict::intersecting ? Look::within
                                              : Look::closer;
  }
  if (intersect(a.grown, b.grown) == Verdict::disjoint) return Look::apart;
  return intersect(a.solid, b.solid) == Verdict::intersecting ? Look::within : Look::closer;
}

Look look_at_distance(const Models& a, const Models& b, double clearance) noexcept {
  const Distance d = distance(a.solid, b.solid);
  if (d.verdict == Verdict::invalid) return Look::closer;
  if (d.value - d.error > clearance) return Look::apart;
  return d.value + d.error <= clearance ? Look::within : Look::closer;
}

Look look_certified(const Models& a, const Models& b, double clearance) noexcept {
  const Verdict verdict = decide(a.solid, b.solid).verdict;
  if (verdict == Verdict::intersecting) return Look::within;
  if (clearance == 0) return verdict == Verdict::disjoint ? Look::apart : Look::closer;
  // Apart, the error of the distance is a proved bound.
  return verdict == Verdict::disjoint ? look_at_distance(a, b, clearance) : Look::closer;
}

}  // namespace

Models make_models(const Cylinder& c, double clearance) noexcept {
  Models m;
  m.solid = prepare(c);
  m.slack = seeds::proxy_distance_error * (std::sqrt(length_squared(c.center)) + c.height + c.radius);
  m.grown = m.solid;
  if (clearance > 0) {
    m.grown =
        prepare({c.center, c.axis, c.radius + clearance / 2 + m.slack, c.height + clearance + 2 * m.slack});
  }
  m.outer = seeds::outer_proxy(m.solid);
  m.inner = seeds::inner_proxy(m.solid);
  m.ball = std::sqrt(c.radius * c.radius + c.height * c.height / 4);
  return m;
}

std::vector<Models> models_of(std::span<const Cylinder> placed, double clearance) {
  std::vector<Models> models;
  models.reserve(placed.size());
  for (const Cylinder& c : placed) models.push_back(make_models(c, clearance));
  return models;
}

Look look(Rung rung, const Models& a, const Models& b, double clearance) noexcept {
  switch (rung) {
    case Rung::sphere:
      return balls_apart(a, b, clearance + slack(a, b, clearance)) ? Look::apart : Look::closer;
    case Rung::outer:
      return seeds::capsule_distance(a.outer, b.outer) > clearance + slack(a, b, clearance) ? Look::apart
                                                                                            : Look::closer;
    case Rung::inner:
      if (a.inner.radius < 0 || b.inner.radius < 0) return Look::closer;
      return seeds::capsule_distance(a.inner, b.inner) <= clearance - slack(a, b, clearance) ? Look::within
                                                                                             : Look::closer;
    case Rung::cylinder:
      return look_at_cylinders(a, b, clearance);
    case Rung::distance:
      return look_at_distance(a, b, clearance);
    case Rung::certified:
      break;
  }
  return look_certified(a, b, clearance);
}

bool trusted(Rung rung, const Models& a, const Models& b, double clearance) noexcept {
  switch (rung) {
    case Rung::inner:
      return look(rung, a, b, clearance) == Look::within;
    case Rung::cylinder:
      return intersect(a.grown, b.grown) != Verdict::disjoint;
    case Rung::distance:
      return !(distance(a.solid, b.solid).value > clearance);
    default:
      return look(rung, a, b, clearance) != Look::apart;
  }
}

bool within(const Plan& plan, const Models& a, const Models& b, double clearance) noexcept {
  if (plan.first[0] && look(Rung::sphere, a, b, clearance) == Look::apart) return false;
  if (plan.first[1] && look(Rung::outer, a, b, clearance) == Look::apart) return false;
  if (plan.first[2] && look(Rung::inner, a, b, clearance) == Look::within) return true;
  return trusted(plan.last, a, b, clearance);
}

}  // namespace cyl
