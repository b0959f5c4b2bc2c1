// SPDX-License-Identifier: MIT
// The results of a bench, as text and as JSON. NaN is written "-" and null.
#pragma once

#include <span>
#include <string>

#include "base/json.hpp"
#include "bench/bench.hpp"
#include "bench/bench_summary.hpp"

namespace cyl {

/// A table a family. The column `ratio` is the time over that of `intersect`, same family, same query (a
/// certificate's over its verdict).
std::string format_bench_table(std::span<const BenchRow> rows);
std::string format_comparisons(std::span<const QueryComparisons> queries);
/// An array with the fields of BenchRow by name, `pairs` as "n", `spread_percent` as "spread".
nlohmann::ordered_json bench_json(std::span<const BenchRow> rows);

}  // namespace cyl
