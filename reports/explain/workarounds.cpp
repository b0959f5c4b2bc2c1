// SPDX-License-Identifier: MIT
#include "reports/explain/workarounds.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/trial/algorithm_groups.hpp"

namespace cyl {
namespace {

/// Nothing where a number would be rounded.
std::optional<Pair> rescaled(Pair pair) {
  const double size = size_of(pair);
  if (!(size > 0)) return {};
  const int exponent = -std::ilogb(size);
  bool exact = true;
  const auto scale = [&](double& x) {
    const double y = std::ldexp(x, exponent);
    exact = exact && std::isfinite(y) && std::ldexp(y, -exponent) == x;
    x = y;
  };
  for (Cylinder* c : {&pair.a, &pair.b}) {
    for (double& x : c->center) scale(x);
    scale(c->radius);
    scale(c->height);
  }
  if (!exact) return {};
  return pair;
}

std::optional<Pair> treated(Remedy remedy, Pair pair) {
  switch (remedy) {
    case Remedy::setting:
      return pair;
    case Remedy::rescaled:
      return rescaled(pair);
    case Remedy::at_origin:
      pair.b.center -= pair.a.center;
      pair.a.center.setZero();
      if (!pair.b.center.allFinite()) return {};
      return pair;
    case Remedy::exchanged:
      std::swap(pair.a, pair.b);
      return pair;
    case Remedy::unit_axes:
      pair.a.axis = unit_axis(pair.a.axis);
      pair.b.axis = unit_axis(pair.b.axis);
      return pair;
  }
  return {};
}

bool meet(const Probe& p) { return p.truth.verdict != Verdict::disjoint; }

Effect effect_of(const Probe& before, const Probe& after) {
  if (after.fails(before.finding->kind)) return Effect::not_cured;
  if (!after.decided() || meet(after) != meet(before)) return Effect::truth_turned;
  if (after.finding) return Effect::other_failure;
  return after.right() ? Effect::cured : Effect::no_answer;
}

}  // namespace

std::vector<Cure> try_cures(std::span<const std::unique_ptr<Method>> methods,
                            const std::unique_ptr<Method>& method, const Probe& failing) {
  std::vector<Cure> cures;
  for (const auto& other : methods) {
    if (!differ_in_setting(method->name(), other->name())) continue;
    const Probe after = probe_one(other, failing.pair);
    cures.push_back({Remedy::setting, std::string(other->name()), effect_of(failing, after), after});
  }
  for (const Remedy remedy : {Remedy::rescaled, Remedy::at_origin, Remedy::exchanged, Remedy::unit_axes}) {
    Cure cure{remedy, std::string(method->name()), Effect::no_change, {}};
    const auto pair = treated(remedy, failing.pair);
    if (pair && format_pair(*pair) != format_pair(failing.pair)) {
      cure.after = probe_one(method, *pair);
      cure.effect = effect_of(failing, cure.after);
    }
    cures.push_back(std::move(cure));
  }
  return cures;
}

}  // namespace cyl
