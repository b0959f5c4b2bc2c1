// SPDX-License-Identifier: MIT
#include "scenes/study/model_hierarchy.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"

namespace cyl {
namespace {

Proximity proximity_of(Verdict verdict) noexcept {
  return verdict == Verdict::disjoint       ? Proximity::apart
         : verdict == Verdict::intersecting ? Proximity::within
                                            : Proximity::unclear;
}

/// Answers as within() does, for two balls without the call, which costs more than the answer.
bool balls_apart(const Prepared& a, const Prepared& b, double clearance) noexcept {
  if (a.defect != Defect::none || b.defect != Defect::none) return false;
  if (a.shape == Shape::half_space || b.shape == Shape::half_space)
    return cyl::within(a, b, clearance) == Verdict::disjoint;
  const Vector3 way = b.center - a.center;
  const double far = a.rounding + b.rounding + clearance;
  return way.x() * way.x() + way.y() * way.y() + way.z() * way.z() > far * far;
}

/// Models around solids prove only that they are apart, models inside solids only that they are within.
Proximity only(Proximity said, Verdict verdict) noexcept {
  return proximity_of(verdict) == said ? said : Proximity::unclear;
}

/// The capsules are along the longest edge.
ProxyModels models_of_box(const Solid& c) noexcept {
  const double margin = model_margin * (edges_of(c) + c.rounding);
  const auto longest = static_cast<std::size_t>(std::ranges::max_element(c.edges) - c.edges.begin());
  const double x = c.edges[longest], y = c.edges[(longest + 1) % 3], z = c.edges[(longest + 2) % 3];
  const auto [ax, ay, az] = edge_directions<double>(c.quaternion)[longest];
  const auto model = [&](double height, double rounding) {
    return prepare({c.center, {ax, ay, az}, 0, height, rounding});
  };
  const double inside = std::min(y, z);
  Solid box = c;
  for (double& edge : box.edges) edge += 2 * (c.rounding + margin);
  box.rounding = 0;
  return {prepare(c), model(0, std::hypot(x, y, z) / 2 + c.rounding + margin),
          model(x, std::hypot(y, z) / 2 + c.rounding + margin),
          model(x - inside, inside / 2 + c.rounding - margin), prepare(box)};
}

}  // namespace

ProxyModels make_models(const Solid& c) noexcept {
  if (is_box(c)) return models_of_box(c);
  if (is_half_space(c)) return {prepare(c), prepare(c), prepare(c), prepare(c), prepare(c)};
  const double margin = model_margin * (c.radius + c.height + c.rounding);
  const double inside = std::min(c.radius, c.height / 2);
  const auto model = [&](double height, double rounding) {
    return prepare({c.center, c.axis, 0, height, rounding});
  };
  const double wide = 2 * (c.radius + c.rounding + margin);
  const auto q = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), c.axis.stableNormalized());
  return {prepare(c),
          model(0, std::sqrt(c.radius * c.radius + c.height * c.height / 4) + c.rounding + margin),
          model(c.height, c.radius + c.rounding + margin),
          model(c.height - 2 * inside, inside + c.rounding - margin),
          prepare({.center = c.center,
                   .shape = Shape::box,
                   .edges = {wide, wide, c.height + 2 * (c.rounding + margin)},
                   .quaternion = {q.w(), q.x(), q.y(), q.z()}})};
}

std::vector<ProxyModels> models_of(std::span<const Solid> placed) {
  std::vector<ProxyModels> models;
  models.reserve(placed.size());
  for (const Solid& c : placed) models.push_back(make_models(c));
  return models;
}

Proximity proximity(Level level, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept {
  // The clearance acts as a rounding of the models, so it gets their margin.
  const double wide = clearance * (1 + model_margin), narrow = clearance * (1 - model_margin);
  switch (level) {
    case Level::sphere:
      return balls_apart(a.ball, b.ball, wide) ? Proximity::apart : Proximity::unclear;
    case Level::outer:
      return only(Proximity::apart, cyl::within(a.outer, b.outer, wide));
    case Level::inner:
      return only(Proximity::within, cyl::within(a.inner, b.inner, narrow));
    case Level::cylinder:
      return proximity_of(cyl::within(a.solid, b.solid, clearance));
    case Level::distance:
      return proximity_of(distance(a.solid, b.solid), clearance);
    case Level::box:
      return only(Proximity::apart, cyl::within(a.box, b.box, wide));
    case Level::certified:
      break;
  }
  return proximity_of(decide_within(a.solid, b.solid, clearance).verdict);
}

Proximity proximity_of(const Distance& d, double clearance) noexcept {
  if (d.verdict == Verdict::invalid) return Proximity::unclear;
  if (d.value - d.error > clearance) return Proximity::apart;
  return d.value + d.error <= clearance ? Proximity::within : Proximity::unclear;
}

bool accepted(Level level, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept {
  switch (level) {
    case Level::inner:
      return proximity(level, a, b, clearance) == Proximity::within;
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
