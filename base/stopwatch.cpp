// SPDX-License-Identifier: MIT
#include "base/stopwatch.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

#include "base/statistics.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;

volatile double sink;

/// Counts the instructions of this thread in user space from its construction on. Reads NaN if the machine
/// has no such counter (virtual machines, containers).
class InstructionCounter {
 public:
  InstructionCounter() {
    perf_event_attr what{};
    what.type = PERF_TYPE_HARDWARE;
    what.size = sizeof what;
    what.config = PERF_COUNT_HW_INSTRUCTIONS;
    what.exclude_kernel = 1;
    what.exclude_hv = 1;
    file_ = static_cast<int>(syscall(SYS_perf_event_open, &what, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
  }
  ~InstructionCounter() {
    if (file_ >= 0) close(file_);
  }
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;

  double read() const {
    std::uint64_t count = 0;
    if (file_ < 0 || ::read(file_, &count, sizeof count) != sizeof count || count == 0) return not_measured;
    return static_cast<double>(count);
  }

 private:
  int file_;
};

std::uint64_t ticks() {
#if defined(__x86_64__)
  _mm_lfence();
  const std::uint64_t now = __rdtsc();
  _mm_lfence();
  return now;
#else
  return static_cast<std::uint64_t>(Clock::now().time_since_epoch().count());
#endif
}

}  // namespace

double processor_ns() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) * 1e9 + static_cast<double>(used.tv_nsec);
}

void keep(double value) { sink = value; }

// Steps whose length has no common divisor with the count reach every place. From half the count on, short
// runs of neighbours do not repeat.
void shuffle(std::span<std::size_t> order, std::size_t& stride) {
  const std::size_t count = order.size();
  if (stride == 0) stride = count / 2;
  do ++stride;
  while (std::gcd(stride, count) != 1);
  for (std::size_t i = 0, at = 0; i < count; ++i, at = (at + stride) % count) order[i] = at;
}

Cost series_cost(const Series& series, std::size_t count, std::chrono::duration<double> least) {
  const InstructionCounter counter;
  std::vector<std::size_t> order(count);
  std::size_t stride = 0;
  const auto run_once = [&] {
    shuffle(order, stride);
    const double before = counter.read(), processor_start = processor_ns();
    const auto start = Clock::now();
    series(order);
    const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
    // The second time is longer by the cost of reading it, unless another process had its turn.
    return Cost{std::min(spent.count(), processor_ns() - processor_start), counter.read() - before};
  };
  double spent = 0, instructions = 0;
  std::vector<double> runs;
  const auto take = [&](const Cost& once) {
    spent += once.ns;
    instructions += once.instructions;
    runs.push_back(once.ns);
  };
  const double least_ns = least.count() * 1e9;
  if (const Cost first = run_once(); first.ns >= least_ns) take(first);
  while (runs.empty() || spent < least_ns) take(run_once());
  const double calls = static_cast<double>(count);
  return {quantile(runs, 0.5) / calls, instructions / static_cast<double>(runs.size()) / calls};
}

CallTimes time_calls(const std::function<void(std::size_t)>& call, std::size_t count, int passes) {
  constexpr auto never = std::numeric_limits<std::uint64_t>::max();
  const std::function<void(std::size_t)> nothing = [](std::size_t) { keep(0); };
  const auto time = [](const std::function<void(std::size_t)>& timed, std::size_t i) {
    const std::uint64_t start = ticks();
    timed(i);
    return ticks() - start;
  };
  std::vector<std::uint64_t> least(count, never);
  std::uint64_t empty = never;
  const auto start = Clock::now();
  const std::uint64_t start_ticks = ticks();
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < count; ++i) {
      least[i] = std::min(least[i], time(call, i));
      empty = std::min(empty, time(nothing, i));
    }
  }
  const double all_ticks = static_cast<double>(ticks() - start_ticks);
  const std::chrono::duration<double, std::nano> all = Clock::now() - start;
  std::vector<double> ns;
  for (const std::uint64_t t : least)
    ns.push_back(static_cast<double>(t - std::min(t, empty)) * all.count() / all_ticks);
  return {quantile(ns, 0.5), quantile(ns, 0.99), quantile(ns, 1)};
}

}  // namespace cyl
