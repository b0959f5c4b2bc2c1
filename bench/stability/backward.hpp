// SPDX-License-Identifier: MIT
// The backward error of wrong verdicts: the distance to the nearest input for which the answer is right.
//
// It is |signed distance|, as the length by which the solids move. Proof:
// 1. It suffices. Translate b by minus the signed distance, along the direction in which that is attained.
//    Then it touches a. There a wrong "intersecting" or "touching" is right. Any farther, a wrong "disjoint"
//    is right.
// 2. Nothing less does, for any change of centres, axes, radii and heights. Let no point of the solid a move
//    by more than x, and no point of b by more than y, to become the changed solids (the Hausdorff distance).
//    Then the support functions change by at most x and y in every unit direction. The signed distance is an
//    extreme of their sums, so it changes by at most x + y. So x + y is at least |signed distance|.
//
// In the input's own numbers, a change of a centre or radius moves a solid by as much, and a change of a
// height by half of that. A turn of an axis moves it by at most its angle times sqrt(r^2 + h^2/4).
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/store/run_store.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {

/// Quantiles over the wrong verdicts of one method, relative to the size: half of them are right for an input
/// within p50, ..
struct BackwardError {
  std::string method;
  std::uint64_t wrong = 0;
  double p50 = 0, p99 = 0, max = 0;
};

/// Returns the backward error of one wrong verdict relative to the size, to a thousandth of itself and never
/// less, at most the largest double; 0 for what touches. Returns nothing if the truth of the pair is not
/// decided, or if such a verdict about it is right: then nothing need move.
std::optional<double> backward_error(const Pair& pair, Verdict wrong);

struct WrongVerdict {
  std::string method;
  double backward;
};
/// Returns the wrong verdicts among the stored findings of a run: the first of each kind and family, and the
/// worst. Their quantiles do not describe any other distribution.
std::vector<WrongVerdict> wrong_verdicts(const std::vector<FindingRecord>& findings);
/// Returns those on a fixed sample next to touching: pairs of every stratum (corpus/pairs/strata.hpp),
/// seed 1.
std::vector<WrongVerdict> wrong_verdicts(std::span<const std::unique_ptr<Method>> methods);

/// Returns the errors by method, by first appearance. A quantile is the least value that so many do not
/// exceed.
std::vector<BackwardError> backward_errors(std::span<const WrongVerdict> wrong);

nlohmann::json backward_json(std::span<const BackwardError> errors);

}  // namespace cyl
