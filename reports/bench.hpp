// SPDX-License-Identifier: MIT
// Nanoseconds a pair, by method and family, with the method's faults on the same pairs beside them. Every
// verdict is held against the referee before anything is timed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cyl {

struct BenchOptions {
  std::string methods;       ///< spec of select_methods; empty: all
  std::string families;      ///< same rule; empty: all
  std::uint64_t seed = 1;    ///< of the families
  std::size_t pairs = 2000;  ///< of each family; a method asked on a share of indices only gets its share
  int passes = 9;            ///< over all pairs, the methods taking turns
};

struct BenchRow {
  std::string method;
  std::string family;
  std::string query;  ///< "prepared": shapes are built before the clock starts; "raw": inside the call
  bool foreign = false;
  std::size_t pairs = 0;  ///< asked, those it failed on included
  double median_ns = 0;   ///< a pair: the median of the passes' means; NaN where every pair failed
  double p99_ns = 0;      ///< over pairs, of the least time of each; NaN likewise
  std::size_t wrong_disjoint = 0;
  std::size_t wrong_intersecting = 0;
  std::size_t wrong_below_claim = 0;  ///< those of the two above that the method's own claim allows
  std::size_t undecided = 0;          ///< or declined
  std::size_t failed = 0;             ///< crashed, threw or hung; left out of the times
};

/// Foreign methods run in a forked child. `progress` is told what is being done, in words.
std::vector<BenchRow> bench(const BenchOptions& options,
                            const std::function<void(std::string_view)>& progress);

/// A table for people. The column `ratio` is the time over that of `intersect`, same family, same query.
std::string format_bench_table(std::span<const BenchRow> rows);
/// One JSON object, the fields above by name, `pairs` as "n"; NaN becomes null.
std::string format_bench_row(const BenchRow& row);

}  // namespace cyl
