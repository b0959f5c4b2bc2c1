// SPDX-License-Identifier: MIT
// The rows of a bench against each other: ours and the fastest packaged (foreign) method, family by family.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bench/bench.hpp"

namespace cyl {

/// The part of its pairs a method may be wrong, undecided or failed on and still be called right on a family.
inline constexpr double right_tol = 1e-3;

bool is_right(const BenchRow& row);

/// A method that was asked about a share of the pairs only cannot be a competitor, because it may be wrong on
/// the others.
struct Competitor {
  std::string method;  ///< empty: there is none
  double ns = not_measured;
  double ratio = not_measured;  ///< its time over ours
  double right_share = not_measured;
  double max_error = not_measured;
};

/// One query on one family. A number is NaN if it was not measured.
struct Comparison {
  std::string family;
  std::string method;  ///< ours: `intersect` for verdict and raw, else our fastest
  double ns = not_measured;
  double p99_over_median = not_measured;
  double over_verdict = not_measured;  ///< ns over that of the verdict of `intersect`, same family
  double over_random = not_measured;   ///< ns over that on family `random`, same query
  double max_error = not_measured;
  std::size_t wrong_at_margin = 0;
  Competitor right;    ///< the fastest that is_right
  Competitor fastest;  ///< right or wrong, among methods that answer nearly all pairs
};

/// Ratios over the families with such a competitor, or NaN.
struct Ratios {
  double least = not_measured;
  double geometric_mean = not_measured;
};

/// All comparisons of one query. A packaged method answers `certificate` and `batch` with its one-pair
/// verdict.
struct QueryComparisons {
  std::string query;
  std::vector<Comparison> comparisons;
  Ratios right, fastest;
  std::size_t wrong_at_margin = 0;
};

/// Returns the queries that we have rows of, in the order verdict, raw, certificate, batch, distance, depth.
std::vector<QueryComparisons> summarise(std::span<const BenchRow> rows);

/// For rows made with BenchOptions::shapes. Returns a line for each pair of shapes and family, and a table in
/// Markdown with a line for each pair of shapes.
std::string format_shapes(std::span<const QueryComparisons> queries);

}  // namespace cyl
