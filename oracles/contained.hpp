// SPDX-License-Identifier: MIT
// Foreign code is run in a forked worker, a batch at a time, so that an abort, a signal, a hang or an
// exception becomes an answer with a reason and the rest of the batch is still answered.
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <vector>

#include "oracles/method.hpp"

namespace cyl {

/// One question of a batch: which method, which pair (indices into the spans given to ask_contained).
struct Question {
  std::size_t method;
  std::size_t pair;
};

struct ContainedAnswer {
  MethodAnswer answer;
  double nanoseconds = 0;  ///< wall time of the call inside the worker, 0 where it died
};

/// CPU time one call may take before the worker is killed and the answer becomes failed(hang).
inline constexpr std::chrono::milliseconds call_cpu_cap{1000};

/// Asks every question in order inside forked workers. Answers come back in the order of the questions, one
/// each, whatever the methods do. Never throws on a method's behaviour; throws std::system_error only where
/// the system refuses a process or memory. What a worker prints is kept off the terminal; the tail of it
/// becomes the reason of a crash.
std::vector<ContainedAnswer> ask_contained(std::span<const std::unique_ptr<Method>> methods,
                                           std::span<const Pair> pairs, std::span<const Question> questions,
                                           std::chrono::milliseconds cpu_cap = call_cpu_cap);

}  // namespace cyl
