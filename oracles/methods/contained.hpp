// SPDX-License-Identifier: MIT
// Foreign code runs in workers, which are processes of their own. So an abort, a signal, a hang or an
// exception becomes an answer with a reason, and all other questions are still answered.
#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

/// How a method is called. All modes must give the same verdict. The first two must give the same answer.
enum class CallMode : unsigned char {
  usual,         ///< Method::ask
  other_thread,  ///< Method::ask, from a new thread
  prepared,      ///< Method::prepare_all, then its call. Gives the verdict alone. Declined if there is no
                 ///< such call.
  batch          ///< The same with Method::prepare_batch, at several places among other pairs.
};

/// One question of a batch: a method and a pair, as indices into the spans given to ask_contained.
struct Question {
  std::size_t method;
  std::size_t pair;
  CallMode mode = CallMode::usual;
  unsigned run = 0;  ///< questions of one method and run in a row are timed together
};

/// Asks in this process. Throws what the method throws.
MethodAnswer call(Method& method, const Pair& pair, CallMode mode);

/// Asks in this process. An exception, an unknown value of an enum, or a number that is not finite becomes a
/// failure.
MethodAnswer ask_noexcept(Method& method, const Pair& pair, CallMode mode);

/// Returns the answer. An answer with an unknown value of an enum, or a number that is not finite, becomes a
/// failure.
MethodAnswer checked(MethodAnswer answer);

struct ContainedAnswer {
  MethodAnswer answer;
  /// CPU time of the run that this call belongs to, divided by the calls in it. For a run of one call: its
  /// wall time. For a hang: the CPU time up to its end. 0 if the run ended in a crash.
  double nanoseconds = 0;
  bool asked = true;  ///< false if the method had hung or crashed too often, or no time was left
};

/// CPU time that one call may take before the worker is killed and the answer becomes failed(hang).
inline constexpr std::chrono::milliseconds call_cpu_cap{1000};

/// The same for the methods of this build, whose cost is known. The slowest is NLopt, which takes 4 ms in the
/// mean.
inline constexpr std::chrono::milliseconds library_cpu_cap{250};

/// Limits of foreign code in a worker. A command obeys `hangs` alone: its times are in command_method.cpp.
struct Caps {
  std::chrono::milliseconds call_cpu = call_cpu_cap;  ///< for a method of this build at most library_cpu_cap
  /// Wall time of one call, because a call that sleeps uses no CPU. Far above the delays of a loaded machine.
  std::chrono::milliseconds call_wall = 20 * call_cpu;
  /// CPU time and wall time that a library may take to load.
  std::chrono::milliseconds load = 20 * call_cpu_cap;
  /// Hangs of one method in one call of ask(). After these, its questions are declined, with that
  /// reason.
  unsigned hangs = std::numeric_limits<unsigned>::max();
  /// The same limit for crashes of a program. It is started again after each, which may take a second.
  unsigned program_crashes = std::numeric_limits<unsigned>::max();
  /// From then on, questions are declined, and a call that a worker is in is ended and counts as declined.
  std::chrono::steady_clock::time_point until = std::chrono::steady_clock::time_point::max();

  bool out_of_time() const { return std::chrono::steady_clock::now() >= until; }
};

/// Returns the caps of commands that people wait for, such as gate and triage. The CPU time is that of a
/// campaign, so that all commands agree on what hangs. A call that sleeps is given up sooner.
constexpr Caps attended_caps(unsigned hangs) { return {.call_wall = 4 * call_cpu_cap, .hangs = hangs}; }

/// Returns the CPU time that a call of the method may take, with the usual caps.
std::chrono::milliseconds cpu_cap_of(const Method& method);

/// Asks methods in workers, which are kept between calls.
/// 1. The methods of this build share one worker.
/// 2. Each guest's library has its own, which may not start processes or signal others.
/// 3. A guest that is a program runs as it is, and this process talks to it.
/// 4. A worker that is lost is replaced.
class Asker {
 public:
  /// `methods` must outlive it. Starts nothing yet.
  explicit Asker(std::span<const std::unique_ptr<Method>> methods, const Caps& caps = {});
  ~Asker();
  Asker(Asker&&) noexcept;
  Asker& operator=(Asker&&) noexcept;

  /// Asks every question, those of one worker in order.
  /// 1. Returns one answer for each question, in the order of the questions, for any behaviour of the
  ///    methods.
  /// 2. Throws std::system_error if the system refuses a process or memory, and nothing else.
  /// 3. The output of a worker does not reach the terminal. Its tail becomes the reason of a crash.
  std::vector<ContainedAnswer> ask(std::span<const Pair> pairs, std::span<const Question> questions);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// Asks in the same way, in workers that are started for this call.
std::vector<ContainedAnswer> ask_contained(std::span<const std::unique_ptr<Method>> methods,
                                           std::span<const Pair> pairs, std::span<const Question> questions,
                                           const Caps& caps = {});

}  // namespace cyl
