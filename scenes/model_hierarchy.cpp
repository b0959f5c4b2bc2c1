// SPDX-License-Identifier: MIT
#include "scenes/model_hierarchy.hpp"

#include <cmath>

#include "solver/distance.hpp"

namespace cyl {
namespace {

double length_squared(const Vector3& v) noexcept { return v.x() * v.x() + v.y() * v.y() + v.z() * v.z(); }

double slack(const ProxyModels& a, const ProxyModels& b, double clearance) noexcept {
  return proxy_distance_error * clearance + a.slack + b.slack;
}

/// Whether the balls are farther from each other than the clearance and `more`.
bool balls_apart(const ProxyModels& a, const ProxyModels& b, double reach) noexcept {
  const double far = a.ball + b.ball + reach;
  return length_squared(b.solid.center - a.solid.center) > far * far;
}

Proximity proximity_of(Verdict verdict) noexcept {
  return verdict == Verdict::disjoint       ? Proximity::apart
         : verdict == Verdict::intersecting ? Proximity::within
                                            : Proximity::unclear;
}

Proximity compare_distance(const ProxyModels& a, const ProxyModels& b, double clearance) noexcept {
  const Distance d = distance(a.solid, b.solid);
  if (d.verdict == Verdict::invalid) return Proximity::unclear;
  if (d.value - d.error > clearance) return Proximity::apart;
  return d.value + d.error <= clearance ? Proximity::within : Proximity::unclear;
}

}  // namespace

ProxyModels make_models(const Cylinder& c) noexcept {
  ProxyModels m;
  m.solid = prepare(c);
  m.slack = proxy_distance_error * (std::sqrt(length_squared(c.center)) + c.height + c.radius + c.rounding);
  m.outer = outer_proxy(m.solid);
  m.inner = inner_proxy(m.solid);
  m.ball = std::sqrt(c.radius * c.radius + c.height * c.height / 4) + c.rounding;
  return m;
}

std::vector<ProxyModels> models_of(std::span<const Cylinder> placed) {
  std::vector<ProxyModels> models;
  models.reserve(placed.size());
  for (const Cylinder& c : placed) models.push_back(make_models(c));
  return models;
}

Proximity proximity(Level level, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept {
  switch (level) {
    case Level::sphere:
      return balls_apart(a, b, clearance + slack(a, b, clearance)) ? Proximity::apart : Proximity::unclear;
    case Level::outer:
      return capsule_distance(a.outer, b.outer) > clearance + slack(a, b, clearance) ? Proximity::apart
                                                                                     : Proximity::unclear;
    case Level::inner:
      if (a.inner.radius < 0 || b.inner.radius < 0) return Proximity::unclear;
      return capsule_distance(a.inner, b.inner) <= clearance - slack(a, b, clearance) ? Proximity::within
                                                                                      : Proximity::unclear;
    case Level::cylinder:
      return proximity_of(cyl::within(a.solid, b.solid, clearance));
    case Level::distance:
      return compare_distance(a, b, clearance);
    case Level::certified:
      break;
  }
  return proximity_of(decide_within(a.solid, b.solid, clearance).verdict);
}

bool accepted(Level level, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept {
  switch (level) {
    case Level::inner:
      return proximity(level, a, b, clearance) == Proximity::within;
    case Level::cylinder:
      return cyl::within(a.solid, b.solid, clearance) != Verdict::disjoint;
    case Level::distance:
      return !(distance(a.solid, b.solid).value > clearance);
    default:
      return proximity(level, a, b, clearance) != Proximity::apart;
  }
}

bool within(const Cascade& cascade, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept {
  if (cascade.first[0] && proximity(Level::sphere, a, b, clearance) == Proximity::apart) return false;
  if (cascade.first[1] && proximity(Level::outer, a, b, clearance) == Proximity::apart) return false;
  if (cascade.first[2] && proximity(Level::inner, a, b, clearance) == Proximity::within) return true;
  return accepted(cascade.last, a, b, clearance);
}

}  // namespace cyl
