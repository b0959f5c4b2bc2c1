// SPDX-License-Identifier: MIT
// The results of a bench, as text and as JSON. NaN is written "-" and null.
#pragma once

#include <span>
#include <string>

#include "bench/bench.hpp"
#include "bench/bench_summary.hpp"
#include "bench/lower_bounds.hpp"

namespace cyl {

/// A table a family. The column `ratio` is the time over that of `intersect`, same family, same query (a
/// certificate's over its verdict).
std::string format_bench_table(std::span<const BenchRow> rows);
std::string format_comparisons(std::span<const QueryComparisons> queries);
/// The lower bounds, and the times of our methods in units of them, on `random` if it is among the rows, else
/// on their first family.
std::string format_lower_bounds(const LowerBounds& lower_bounds, std::span<const BenchRow> rows);
/// One line for each method and query, and one column for each family or, if all rows have one family, number
/// of pairs. A '!' after a time means that the method is not right there.
std::string format_growth(std::span<const BenchRow> rows);

/// Members of a JSON object: "results" (the fields of BenchRow by name, `pairs` as "n", `spread_percent` as
/// "spread"), "summary" (by query) and "floors".
std::string bench_json(std::span<const BenchRow> rows, std::span<const QueryComparisons> queries,
                       const LowerBounds& lower_bounds);

}  // namespace cyl
