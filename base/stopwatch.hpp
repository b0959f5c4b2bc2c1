// SPDX-License-Identifier: MIT
// What one call costs: nanoseconds, and instructions where the machine counts them.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace cyl {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// The cost of one call, on average over many.
struct Cost {
  double ns = not_measured;
  double instructions = not_measured;  ///< in user space; NaN where the machine offers no counter
};

/// Makes all calls once, in the order of the indices given, or in its own where order is nothing to it.
using Series = std::function<void(std::span<const std::size_t> order)>;

/// Another permutation of 0 .. order.size() - 1 at each call; `stride` is what it remembers, at first 0.
void shuffle(std::span<std::size_t> order, std::size_t& stride);

/// Runs a series of `count` calls once to warm up and then as often as fills `least`; a first run that fills
/// it is itself the measurement. The time is the median of the runs', which loses the few that something
/// else interrupted; of a run that others had the processor in, only its own time counts. Each time in
/// another order: branch predictors learn a couple of thousand pairs by heart (a quarter of the time of our
/// verdict on random pairs).
Cost series_cost(const Series& series, std::size_t count, std::chrono::duration<double> least);

/// Over calls, of the time of each.
struct CallTimes {
  double p50_ns = not_measured, p99_ns = not_measured, max_ns = not_measured;
};

/// For i < count the least time of call(i) in `passes`, by a cycle counter that no instruction moves across,
/// less the least time of an empty call.
CallTimes time_calls(const std::function<void(std::size_t)>& call, std::size_t count, int passes);

/// Returns the CPU time of this thread: what others do on the machine is not in it.
double processor_ns();

/// Makes the compiler believe that `value` is looked at.
void keep(double value);

}  // namespace cyl
