// SPDX-License-Identifier: MIT
// Compares foreign libraries and the methods of the literature with the referee, in this process, or the
// plug-in that DAYLIGHT_FUZZ_PLUGIN names. The sanitizer reports an invalid access of a library. An abort, a
// call without end, and an invalid access of a plug-in are findings. The target returns from them by a jump
// out of the library. So the library may leak memory and leave data half changed.
#include <setjmp.h>
#include <signal.h>
#include <sys/time.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "fuzz/guided/counters.hpp"
#include "fuzz/guided/fuzz_judge.hpp"
#include "fuzz/guided/record.hpp"
#include "oracles/methods/guest.hpp"

namespace cyl {
namespace {

/// CPU time of one call, a thousand times the usual, after which it counts as a hang.
constexpr suseconds_t call_cpu_cap_us = 200000;
/// Some methods cost a hundred times what the others do.
constexpr std::size_t costly_share = 256;

sigjmp_buf back;
volatile sig_atomic_t asking = 0;
struct sigaction engines[NSIG];

extern "C" void jump_back(int signal) {
  if (asking) {
    asking = 0;
    siglongjmp(back, signal);
  }
  // Not the signal of a library, but of the engine, or a stray one. A late timer is ignored.
  if (signal == SIGVTALRM) return;
  sigaction(signal, &engines[static_cast<std::size_t>(signal)], nullptr);
  raise(signal);
}

void set_timer(suseconds_t microseconds) {
  itimerval timer{};
  timer.it_value.tv_usec = microseconds;
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

MethodAnswer ask_and_return(Method& method, const Pair& pair) {
  MethodAnswer answer;
  const int signal = sigsetjmp(back, 1);
  if (signal == 0) {
    asking = 1;
    set_timer(call_cpu_cap_us);
    try {
      answer = method.ask(pair);
    } catch (const std::exception&) {
      answer = failed_answer(Failure::exception, "");
    }
  } else {
    answer = failed_answer(signal == SIGVTALRM ? Failure::hang : Failure::crash, "");
  }
  asking = 0;
  set_timer(0);
  return answer;
}

class Xcheck {
 public:
  Xcheck() {
    if (const char* plugin = std::getenv("DAYLIGHT_FUZZ_PLUGIN")) {
      for (OpenedGuest& opened : open_plugins({GuestKind::plugin, "", plugin, ""}))
        methods_.push_back(std::move(opened.method));
    } else {
      methods_ = all_methods();
      methods_.erase(methods_.begin(), methods_.begin() + std::ssize(own_methods()));  // which come first
      std::ranges::stable_partition(methods_, [](const auto& method) { return !method->foreign(); });
    }
    literature_ = static_cast<std::size_t>(
        std::ranges::count_if(methods_, [](const auto& method) { return !method->foreign(); }));
    answers_.resize(methods_.size());
  }

  /// Call it after the engine has set its own handlers, which signals that come from elsewhere still reach.
  Xcheck& catch_signals() {
    for (const int signal : {SIGVTALRM, SIGABRT}) catch_signal(signal);
    if (methods_.front()->guest())
      for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) catch_signal(signal);
    return *this;
  }

  void run(const Pair& pair) {
    const bool guest = methods_.front()->guest();
    // A pair that a plug-in declines is of no use to it, so it adds nothing that the engine would keep.
    if (guest && !ask_guest(pair)) return;
    FuzzJudge fuzz_judge(pair, {}, false, sink_, !guest);  // its own branches are to count more
    if (fuzz_judge.truth().verdict == Verdict::invalid) return;
    const std::size_t drawn = literature_ == 0 ? 0 : fuzz_judge.draws().below(literature_);
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      if (!guest) {
        answers_[m] = {};
        if (m < literature_ && m != drawn) continue;
        if (methods_[m]->share() > 1 && !fuzz_judge.drawn(costly_share)) continue;
        answers_[m] = ask_and_return(*methods_[m], fuzz_judge.pair());
      }
      fuzz_judge.record(*methods_[m], answers_[m]);
      for (std::size_t earlier = 0; earlier < m; ++earlier)
        if (differ(answers_[earlier], answers_[m])) count_difference(earlier, m);
    }
  }

 private:
  /// Returns whether a method of the plug-in does not decline the pair.
  bool ask_guest(const Pair& pair) {
    if (!is_legal(pair)) return false;
    for (std::size_t m = 0; m < methods_.size(); ++m) answers_[m] = ask_and_return(*methods_[m], pair);
    return std::ranges::any_of(answers_, [](const auto& said) { return said.status != Status::declined; });
  }

  static bool differ(const MethodAnswer& x, const MethodAnswer& y) {
    return x.status == Status::answered && y.status == Status::answered &&
           (x.verdict == Verdict::disjoint) != (y.verdict == Verdict::disjoint);
  }

  static void catch_signal(int signal) {
    struct sigaction action {};
    action.sa_handler = jump_back;
    action.sa_flags = SA_ONSTACK;  // a stack may be used up
    sigaction(signal, &action, &engines[static_cast<std::size_t>(signal)]);
  }

  std::vector<std::unique_ptr<Method>> methods_;
  std::size_t literature_;  ///< they come first, and a pair is asked of one of them
  std::vector<MethodAnswer> answers_;
  FindingSink sink_;
};

}  // namespace
}  // namespace cyl

extern "C" const char* __lsan_default_options() { return "detect_leaks=0"; }

namespace {

cyl::Xcheck& xcheck() {
  static cyl::Xcheck it;
  return it;
}

}  // namespace

// A plug-in's counters of coverage must be there before the engine begins.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (std::getenv("DAYLIGHT_FUZZ_PLUGIN")) xcheck();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto pair = cyl::decode_record({data, size});
  if (!pair) return -1;  // newer engines keep no such input
  static cyl::Xcheck& target = xcheck().catch_signals();
  target.run(*pair);
  return 0;
}
