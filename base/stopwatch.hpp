// SPDX-License-Identifier: MIT
// The cost of one call in nanoseconds and, if the machine counts them, in instructions.
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
  double instructions = not_measured;  ///< in user space; NaN if the machine has no counter
};

/// Makes all calls once, in the order of the indices, or in its own order if the order does not matter.
using Series = std::function<void(std::span<const std::size_t> order)>;

/// Another permutation of 0 .. order.size() - 1 at each call; `stride` is what it remembers, at first 0.
void shuffle(std::span<std::size_t> order, std::size_t& stride);

/// Runs a series of `count` calls once to warm up, and then repeats it until it fills `least`. If the first
/// run fills `least`, it is the measurement. The time is the median of the runs, which ignores the few
/// interrupted runs. If another process used the processor, only the own time counts. Each run has another
/// order, because branch predictors learn a couple of thousand pairs (a quarter of the time of our verdict on
/// random pairs).
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
