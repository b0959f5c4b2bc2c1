// SPDX-License-Identifier: MIT
// Why one method fails on one pair: around the pair, in its stratum, and under what changes of it or of the
// method's settings it does not.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/explain/calibration_curve.hpp"
#include "reports/explain/failing_region.hpp"
#include "reports/explain/workarounds.hpp"

namespace cyl {

inline constexpr std::uint64_t explain_seed_default = 1;

struct Explanation {
  std::string method;
  Claim claim;
  Trial asked;                            ///< of the method alone: holds the finding
  Classification cause;                   ///< the cause as in triage; none for a hang, because each call
                                          ///< costs a second
  std::vector<FailingRegion> regions;     ///< likewise
  std::optional<CalibrationCurve> curve;  ///< likewise
  std::vector<Workaround> workarounds;
  std::string mechanism;  ///< one sentence that sums up the rest
};

/// Asks the method, contained, about some 6,000 pairs. This takes a second or two, more for a slow method,
/// and a second for each workaround of a hang. The same arguments give the same explanation, except for
/// hangs. Throws UsageError if no method has that name, or if it does not fail in this way on this pair
/// now.
Explanation explain(std::span<const std::unique_ptr<Method>> methods, std::string_view method,
                    FindingKind kind, const Pair& pair, std::uint64_t seed = explain_seed_default);

/// Returns tables for people, ending in the mechanism.
std::string explanation_text(const Explanation& explanation);
/// Returns everything, as one JSON object.
std::string explanation_json(const Explanation& explanation);

}  // namespace cyl
