// SPDX-License-Identifier: MIT
// Compares foreign libraries with the referee, in this process. The sanitizer reports an invalid access. An
// abort and a call without end are findings. The target returns from them by a jump out of the library. So
// the library may leak memory and leave data half changed.
#include <setjmp.h>
#include <signal.h>
#include <sys/time.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "fuzz/guided/counters.hpp"
#include "fuzz/guided/fuzz_judge.hpp"

namespace cyl {
namespace {

/// CPU time of one call, a thousand times the usual, after which it counts as a hang.
constexpr suseconds_t call_cpu_cap_us = 200000;
/// NLopt costs a hundred times what the others do.
constexpr std::size_t costly_share = 256;

sigjmp_buf back;
volatile sig_atomic_t asking = 0;
struct sigaction engines_abort;

extern "C" void jump_back(int signal) {
  if (asking) {
    asking = 0;
    siglongjmp(back, signal);
  }
  // Not the signal of a library, but of the engine, or a stray one. A late timer is ignored.
  if (signal == SIGABRT) {
    sigaction(SIGABRT, &engines_abort, nullptr);
    raise(SIGABRT);
  }
}

void set_timer(suseconds_t microseconds) {
  itimerval timer{};
  timer.it_value.tv_usec = microseconds;
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

MethodAnswer failed(Failure failure) {
  MethodAnswer answer;
  answer.status = Status::failed;
  answer.failure = failure;
  return answer;
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
      answer = failed(Failure::exception);
    }
  } else {
    answer = failed(signal == SIGABRT ? Failure::crash : Failure::hang);
  }
  asking = 0;
  set_timer(0);
  return answer;
}

class Xcheck {
 public:
  Xcheck() : sink_("fuzz_xcheck") {
    for (auto make : {fcl_methods, bullet_methods, ccd_methods, ode_methods, mujoco_methods, nlopt_methods})
      for (auto& method : make()) methods_.push_back(std::move(method));
    answers_.resize(methods_.size());
    struct sigaction action {};
    action.sa_handler = jump_back;
    sigaction(SIGABRT, &action, &engines_abort);
    sigaction(SIGVTALRM, &action, nullptr);
  }

  void run(const Record& record) {
    FuzzJudge fuzz_judge(record, {}, false, sink_);
    if (fuzz_judge.truth().verdict == Verdict::invalid) return;
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      answers_[m] = {};
      if (methods_[m]->share() > 1 && !fuzz_judge.drawn(costly_share)) continue;
      answers_[m] = ask_and_return(*methods_[m], fuzz_judge.pair());
      fuzz_judge.record(*methods_[m], answers_[m]);
      for (std::size_t earlier = 0; earlier < m; ++earlier)
        if (differ(answers_[earlier], answers_[m])) count_difference(earlier, m);
    }
  }

 private:
  static bool differ(const MethodAnswer& x, const MethodAnswer& y) {
    return x.status == Status::answered && y.status == Status::answered &&
           (x.verdict == Verdict::disjoint) != (y.verdict == Verdict::disjoint);
  }

  std::vector<std::unique_ptr<Method>> methods_;
  std::vector<MethodAnswer> answers_;
  FindingSink sink_;
};

}  // namespace
}  // namespace cyl

extern "C" const char* __lsan_default_options() { return "detect_leaks=0"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size != cyl::record_size) return -1;  // newer engines keep no such input
  static cyl::Xcheck xcheck;
  cyl::Record record;
  std::copy_n(data, size, record.begin());
  xcheck.run(record);
  return 0;
}
