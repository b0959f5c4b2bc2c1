// SPDX-License-Identifier: MIT
#include "reports/explain/workarounds.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/adapter.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {
namespace {

std::optional<Pair> rescaled(const Pair& pair) {
  const double size = size_of(pair);
  if (!(size > 0)) return {};
  return scaled_exactly(pair, -std::ilogb(size));
}

std::optional<Pair> transformed(Transformation transformation, Pair pair) {
  switch (transformation) {
    case Transformation::setting:
      return pair;
    case Transformation::rescaled:
      return rescaled(pair);
    case Transformation::at_origin:
      pair.b.center -= pair.a.center;
      pair.a.center.setZero();
      if (!pair.b.center.allFinite()) return {};
      return pair;
    case Transformation::exchanged:
      std::swap(pair.a, pair.b);
      return pair;
    case Transformation::unit_axes:
      pair.a.axis = unit_axis(pair.a.axis);
      pair.b.axis = unit_axis(pair.b.axis);
      return pair;
  }
  return {};
}

WorkaroundOutcome outcome_of(const Trial& before, Trial& after) {
  if (fails_alike(before, after)) return WorkaroundOutcome::still_fails;
  if (!after.decided() || after.meets() != before.meets()) return WorkaroundOutcome::truth_changed;
  if (after.finding()) return WorkaroundOutcome::other_failure;
  if (!after.right()) return WorkaroundOutcome::no_answer;
  return cures(before, after) ? WorkaroundOutcome::right : WorkaroundOutcome::still_fails;
}

}  // namespace

std::vector<Workaround> try_workarounds(std::span<const std::unique_ptr<Method>> methods,
                                        const std::unique_ptr<Method>& method, const Trial& failing) {
  std::vector<Workaround> tried;
  for (const auto& other : methods) {
    if (!differ_in_setting(*method, *other)) continue;
    Trial after = try_method(other, failing.pair);
    const WorkaroundOutcome outcome = outcome_of(failing, after);
    tried.push_back({Transformation::setting, std::string(other->name()), outcome, std::move(after)});
  }
  for (const Transformation transformation : {Transformation::rescaled, Transformation::at_origin,
                                              Transformation::exchanged, Transformation::unit_axes}) {
    Workaround w{transformation, std::string(method->name()), WorkaroundOutcome::no_change, {}};
    const auto pair = transformed(transformation, failing.pair);
    if (pair && format_pair(*pair) != format_pair(failing.pair)) {
      w.after = try_method(method, *pair);
      w.outcome = outcome_of(failing, w.after);
    }
    tried.push_back(std::move(w));
  }
  return tried;
}

}  // namespace cyl
