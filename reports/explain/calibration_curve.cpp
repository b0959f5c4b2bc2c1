// SPDX-License-Identifier: MIT
#include "reports/explain/calibration_curve.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/strata.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {
namespace {

/// Hangs and crashes cost much more than answers.
constexpr std::uint64_t least_drawn = 50;

bool could_fail(const Trial& p, FindingKind kind) {
  if (!p.decided() || p.answer().status == Status::declined) return false;
  const bool disjoint = p.truth.verdict == Verdict::disjoint;
  const bool answered = p.answer().status == Status::answered && p.answer().verdict != Verdict::undecided;
  switch (kind) {
    case FindingKind::wrong_disjoint:
      return answered && !disjoint;
    case FindingKind::wrong_intersecting:
      return answered && disjoint;
    default:
      return true;
  }
}

}  // namespace

std::optional<CalibrationCurve> calibration_curve(const std::unique_ptr<Method>& method, const Trial& failing,
                                                  std::uint64_t seed) {
  const auto feature = contact_feature(failing.pair, failing.truth);
  const double size = size_of(failing.pair);
  if (!feature || !(size > 0)) return {};
  CalibrationCurve curve{*feature, seed, std::ilogb(size) - 2, {}};
  const std::uint64_t count = std::max(least_drawn, drawn_per_decade / method->share());
  const FindingKind kind = failing.finding()->kind;
  for (int decade = first_decade; decade <= last_decade; ++decade) {
    std::vector<Pair> pairs;
    for (std::uint64_t i = 0; i < count; ++i)
      if (const auto pair = draw_in_stratum(*feature, decade, seed, i))
        pairs.push_back(scaled(*pair, curve.exponent));
    if (pairs.empty()) continue;
    CalibrationPoint point{decade, pairs.size(), 0, 0, {}};
    for (const Trial& p : try_method(method, pairs)) {
      point.trials += could_fail(p, kind);
      point.failures += could_fail(p, kind) && fails_alike(failing, p);
    }
    point.rate = rate_bounds(point.trials, point.failures);
    curve.points.push_back(point);
  }
  return curve;
}

}  // namespace cyl
