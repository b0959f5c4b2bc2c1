// SPDX-License-Identifier: MIT
// Foreign code is run in a forked worker, a batch at a time, so that an abort, a signal, a hang or an
// exception becomes an answer with a reason and the rest of the batch is still answered.
#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

/// How a method is called. All must give the same verdict, the first two the same answer.
enum class CallMode : unsigned char {
  usual,         ///< Method::ask
  other_thread,  ///< Method::ask, from a thread that is new
  prepared,      ///< Method::prepare_all, then its call: the verdict alone; declined where there is none
  batch          ///< Method::prepare_batch, then its call: likewise; one other pair goes before it
};

/// One question of a batch: which method, which pair (indices into the spans given to ask_contained).
struct Question {
  std::size_t method;
  std::size_t pair;
  CallMode mode = CallMode::usual;
};

/// Asks in this process: throws what the method throws.
MethodAnswer call(Method& method, const Pair& pair, CallMode mode);

struct ContainedAnswer {
  MethodAnswer answer;
  double nanoseconds = 0;  ///< wall time of the call, 0 where it crashed
};

/// CPU time one call may take before the worker is killed and the answer becomes failed(hang).
inline constexpr std::chrono::milliseconds call_cpu_cap{1000};

/// Limits of foreign code.
struct Caps {
  std::chrono::milliseconds call_cpu = call_cpu_cap;
  /// Wall time of one call: who sleeps uses no CPU. Far beyond what a loaded machine makes of the above.
  std::chrono::milliseconds call_wall = 20 * call_cpu;
  /// Hangs of one method in one batch, after which it is not asked any more: declined, with that reason.
  unsigned hangs = std::numeric_limits<unsigned>::max();
};

/// Asks every question in order inside forked workers. Answers come back in the order of the questions, one
/// each, whatever the methods do. Never throws on a method's behaviour; throws std::system_error only where
/// the system refuses a process or memory. What a worker prints is kept off the terminal; the tail of it
/// becomes the reason of a crash. Cost: a fork a batch, and one more each time a worker is lost.
std::vector<ContainedAnswer> ask_contained(std::span<const std::unique_ptr<Method>> methods,
                                           std::span<const Pair> pairs, std::span<const Question> questions,
                                           const Caps& caps = {});

}  // namespace cyl
