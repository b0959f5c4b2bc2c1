// SPDX-License-Identifier: MIT
// Calibration: how often a method fails in one way, decade of margin by decade, against what it claims, on
// pairs on which what meets is the same as on the pair that is to be explained.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/statistics.hpp"
#include "corpus/pairs/stratum.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/explain/failing_region.hpp"

namespace cyl {

struct CalibrationPoint {
  int decade = 0;              ///< margins in (10^(-decade-1), 10^-decade], as drawn
  std::uint64_t drawn = 0;     ///< pairs asked about
  std::uint64_t trials = 0;    ///< of them, those it answered and on which it could fail so: of a wrong
                               ///< verdict, pairs of the other one
  std::uint64_t failures = 0;  ///< of them
  RateBounds rate;
};

struct CalibrationCurve {
  ContactFeature feature;
  std::uint64_t seed = 0;
  int exponent = 0;  ///< the drawn pairs, of sizes about 1 to 10, are scaled by 2^exponent to the pair's size
  std::vector<CalibrationPoint> points;  ///< decades from 1 to 15; those without such pairs are absent
};

/// Pairs of a decade, and of one whose pairs are put within ranges, which costs time; divided by the method's
/// share where it is costly.
inline constexpr std::uint64_t drawn_per_decade = 400, drawn_within_per_decade = 100;

/// Returns nothing where no stratum fits: the truth of the failing pair is not decided. The pairs are
/// corpus/strata's: independent, near the origin, at index 0, 1, .. of the seed; put within the ranges, those
/// on which the same parts still meet.
std::optional<CalibrationCurve> calibration_curve(const std::unique_ptr<Method>& method, const Trial& failing,
                                                  std::uint64_t seed,
                                                  std::span<const ParameterRange> within = {});

}  // namespace cyl
