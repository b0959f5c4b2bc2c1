// SPDX-License-Identifier: MIT
#include "reports/explain/calibration_curve.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/strata.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {
namespace {

/// The fewest pairs of a decade. They are few, because hangs and crashes cost much more than answers.
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

/// Moves a drawn pair into the ranges, with a margin of the decade and its sign. Returns nothing if the pair
/// then has another contact feature.
std::optional<Pair> put_within(const Pair& drawn, std::span<const ParameterRange> ranges,
                               ContactFeature feature, int decade, std::uint64_t seed, std::uint64_t index) {
  RandomStream r("within ranges", seed, index);
  const double share = r.unit(), margin = std::pow(10, -decade - r.unit());
  const bool overlap = feature == ContactFeature::containment || index % 2 == 1;
  const auto pair = brought_within(drawn, ranges, share, overlap ? -margin : margin);
  if (!pair || contact_feature(*pair) != feature) return {};
  return pair;
}

}  // namespace

std::optional<CalibrationCurve> calibration_curve(const std::unique_ptr<Method>& method, const Trial& failing,
                                                  std::uint64_t seed,
                                                  std::span<const ParameterRange> within) {
  const auto feature = contact_feature(failing.pair, failing.truth);
  const double size = size_of(failing.pair);
  if (!feature || !(size > 0)) return {};
  CalibrationCurve curve{*feature, seed, std::ilogb(size) - 2, {}};
  const std::uint64_t drawn = within.empty() ? drawn_per_decade : drawn_within_per_decade,
                      count = std::max(least_drawn, drawn / method->share());
  const FindingKind kind = failing.finding()->kind;
  for (int decade = first_decade; decade <= last_decade; ++decade) {
    std::vector<Pair> pairs;
    for (std::uint64_t i = 0; i < count; ++i)
      if (const auto pair = draw_in_stratum(*feature, decade, seed, i)) {
        const Pair sized = scaled(*pair, curve.exponent);
        if (within.empty())
          pairs.push_back(sized);
        else if (const auto put = put_within(sized, within, *feature, decade, seed, i))
          pairs.push_back(*put);
      }
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
