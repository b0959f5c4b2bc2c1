// SPDX-License-Identifier: MIT
// Two times below which no decision about a pair can come: one evaluation at a direction, one pass over the
// data.
#pragma once

#include "bench/bench.hpp"

namespace cyl {

/// Times in nanoseconds a pair, medians of the rounds, on pairs of family `random`.
struct LowerBounds {
  /// One evaluation of f (Equation 6) on prepared solids, at random directions: throughput, not latency.
  double equation_6_ns = not_measured;
  /// Reading every cache line of prepared solids and of pairs of indices, writing verdicts: of as many pairs
  /// as the families have, and of large_batch.
  double memory_pass_ns = not_measured;
  double large_memory_pass_ns = not_measured;
};

inline constexpr std::size_t large_batch = 1'000'000;  ///< pairs: far beyond every cache

LowerBounds measure_lower_bounds(const BenchOptions& options);

}  // namespace cyl
