// SPDX-License-Identifier: MIT
// Calibration: how often a method fails in one way at each decade of margin, compared with its claim. The
// pairs have the same contact feature as the explained pair.
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

/// Pairs of a decade, and of a decade whose pairs are brought within ranges, which costs time. Divided by the
/// share of a costly method.
inline constexpr std::uint64_t drawn_per_decade = 400, drawn_within_per_decade = 100;

/// Returns nothing if no stratum fits, because the truth of the failing pair is not decided. The pairs come
/// from corpus/strata: independent, near the origin, at index 0, 1, .. of the seed. With ranges, only pairs
/// with the same contact feature count.
std::optional<CalibrationCurve> calibration_curve(const std::unique_ptr<Method>& method, const Trial& failing,
                                                  std::uint64_t seed,
                                                  std::span<const ParameterRange> within = {});

}  // namespace cyl
