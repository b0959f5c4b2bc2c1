// SPDX-License-Identifier: MIT
// The data of the speed charts, from the rows of a bench over families of known margin.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/bench.hpp"

namespace cyl {

/// Returns d for "margin_1e-0d", nothing for another family.
std::optional<int> margin_of_family(std::string_view family);

/// The share of wrong answers that `digits_low` excludes, and how surely.
inline constexpr double low_share_tol = 1e-3, low_confidence = 0.95;

/// The smallest margin at which a method is right. A row is right if every answer is: none is wrong,
/// undecided, declined or failed.
struct Digits {
  /// The largest d such that all rows of margins 1e-1 to 1e-d are right. It is 0 if the first row is not
  /// right, and empty if the first row was not measured.
  std::optional<int> right;
  /// The least d <= right from which, with low_confidence, at most low_share_tol of the answers are not
  /// right. It assumes that a method is not worse farther from touching. Then each right answer at margins
  /// 1e-d to 1e-right is evidence against a greater share at 1e-d, and n of them have a chance of (1 -
  /// share)^n. That is below 1 - low_confidence from n = 2,995 on. The number of margins does not depend on
  /// the answers, so nothing is counted twice.
  std::optional<int> low;
};
/// Returns the digits of one method and query from its rows.
Digits digits_of(std::span<const BenchRow> rows);

/// One method and query over all margins. The time is the mean over the families. p99 and max are the largest
/// of theirs (which bound the joint ones), and counts are sums.
struct SpeedPoint {
  std::string method;
  std::string
      curve;  ///< library and algorithm: methods that differ in a setting only are points of one curve
  std::string setting;  ///< "tol1e-10", "64", "polish4", or "default"
  std::string query;
  double ns = not_measured, p99_ns = not_measured, max_ns = not_measured;
  std::size_t asked = 0, wrong_disjoint = 0, wrong_intersecting = 0;
  Digits digits;
};

/// Returns the points of the queries verdict, batch, certificate and distance, by first appearance; what was
/// not timed is left out. The sign of a distance is its verdict, and all its pairs are disjoint.
std::vector<SpeedPoint> speed_points(std::span<const BenchRow> rows);

/// Returns a line for each point, by curve.
std::string format_curves(std::vector<SpeedPoint> points);

}  // namespace cyl
