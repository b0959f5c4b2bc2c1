// SPDX-License-Identifier: MIT
// Foreign code is run in workers, processes that are kept apart, so that an abort, a signal, a hang or an
// exception becomes an answer with a reason and the rest is still answered.
#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
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
  unsigned run = 0;  ///< questions of one method and run in a row are timed together
};

/// Asks in this process: throws what the method throws.
MethodAnswer call(Method& method, const Pair& pair, CallMode mode);

struct ContainedAnswer {
  MethodAnswer answer;
  /// CPU time of its run divided by the calls in it; of a run of one, the wall time of the call; of a hang,
  /// the CPU time up to its end. 0 if the run ended in a crash.
  double nanoseconds = 0;
};

/// CPU time that one call may take before the worker is killed and the answer becomes failed(hang).
inline constexpr std::chrono::milliseconds call_cpu_cap{1000};

/// The same for the methods of this build, whose calls are known: the slowest, NLopt's, take 4 ms in the
/// mean.
inline constexpr std::chrono::milliseconds library_cpu_cap{250};

/// Limits of foreign code.
struct Caps {
  std::chrono::milliseconds call_cpu = call_cpu_cap;  ///< of a method of this build at most library_cpu_cap
  /// Wall time of one call: who sleeps uses no CPU. Far beyond what a loaded machine makes of the above.
  std::chrono::milliseconds call_wall = 20 * call_cpu;
  /// Time, of the processor and in all, that a library may take to load.
  std::chrono::milliseconds load = 20 * call_cpu_cap;
  /// Time that one call may sleep or wait, from where on that is told as a side effect.
  std::chrono::milliseconds call_wait = 2 * call_cpu;
  /// Hangs of one method in one call of ask(), after which it is not asked any more: declined, with that
  /// reason.
  unsigned hangs = std::numeric_limits<unsigned>::max();
};

/// Asks methods in workers that live on: the methods of this build share one, each guest's library has its
/// own, which may start no process and signal none but itself; a guest that is a program runs beside, and is
/// talked to from here. A worker that is lost is started again.
class Asker {
 public:
  /// `methods` must outlive it. Starts nothing yet.
  explicit Asker(std::span<const std::unique_ptr<Method>> methods, const Caps& caps = {});
  ~Asker();
  Asker(Asker&&) noexcept;
  Asker& operator=(Asker&&) noexcept;

  /// Asks every question, those of one worker in order. Answers come back in the order of the questions, one
  /// each, whatever the methods do. Never throws on a method's behaviour; throws std::system_error only where
  /// the system refuses a process or memory. What a worker prints is kept off the terminal; the tail of it
  /// becomes the reason of a crash.
  std::vector<ContainedAnswer> ask(std::span<const Pair> pairs, std::span<const Question> questions);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// Asks likewise, in workers that were started for it.
std::vector<ContainedAnswer> ask_contained(std::span<const std::unique_ptr<Method>> methods,
                                           std::span<const Pair> pairs, std::span<const Question> questions,
                                           const Caps& caps = {});

}  // namespace cyl
