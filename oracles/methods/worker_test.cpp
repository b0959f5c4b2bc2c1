// SPDX-License-Identifier: MIT
// Tests workers from the outside: which of them live on, what a guest may do, and the reports.
#include "oracles/methods/worker.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "oracles/methods/acting_method_test.hpp"
#include "oracles/methods/worker_service.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

TEST(Worker, AWorkerLivesOnAndKnowsWhatCameBefore) {
  const auto methods = fakes({[] {}});
  std::vector<std::unique_ptr<Method>> counting;
  counting.push_back(fake_method("counting", [n = 0](const Pair&) mutable {
    MethodAnswer answer = answered(Verdict::disjoint);
    answer.has_distance = true;
    answer.distance = ++n;
    return answer;
  }));
  Asker asker(counting);
  const std::vector<Question> one{{0, 0}};
  for (int i = 1; i <= 3; ++i) EXPECT_EQ(asker.ask(numbered_pairs(1), one)[0].answer.distance, i);
  EXPECT_EQ(ask_contained(counting, numbered_pairs(1), one)[0].answer.distance, 1);
}

/// Asks a method of a guest's library, which is confined.
MethodAnswer ask_guest(std::function<void()> act, const Caps& caps = {}) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("guest",
                                [act = std::move(act)](const Pair&) {
                                  act();
                                  return answered(Verdict::disjoint);
                                },
                                {.guest = true}));
  return ask_contained(methods, numbered_pairs(1), std::vector<Question>{{0, 0}}, caps)[0].answer;
}

TEST(Worker, AGuestReachesNoOtherProcess) {
  const std::pair<std::function<void()>, const char*> attempts[] = {
      // Signal 0 reaches no process if the filter fails.
      {[] { kill(getppid(), 0); }, "called kill(), which a method may not"},
      {[] { kill(-1, 0); }, "called kill(), which a method may not"},
      {[] { kill(0, 0); }, "called kill(), which a method may not"},
      {[] { fork(); }, "called clone(), which a method may not"},
      {[] { execl("/bin/true", "true", nullptr); }, "called execve(), which a method may not"},
      {[] { std::raise(SIGSEGV); }, "SIGSEGV"},
      {[] { std::abort(); }, "SIGABRT"},
  };
  for (const auto& [act, reason] : attempts) {
    const MethodAnswer answer = ask_guest(act);
    EXPECT_EQ(answer.failure, Failure::crash) << reason;
    EXPECT_STREQ(answer.reason, reason);
  }
}

/// A method that answers the distance `n` at its n-th call in one process. Every other call fails by `fail`.
std::vector<std::unique_ptr<Method>> failing_every_other_time(std::function<void()> fail) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("fails",
                                [fail = std::move(fail), n = 0](const Pair&) mutable {
                                  if (++n % 2 == 0) fail();
                                  MethodAnswer answer = answered(Verdict::disjoint);
                                  answer.has_distance = true;
                                  answer.distance = n;
                                  return answer;
                                },
                                {.recovers = true}));
  return methods;
}

void fail_an_assertion() {
  std::fputs("lib: gjk.h:177: Assertion `index != -1' failed.\n", stderr);
  std::abort();
}

TEST(Worker, AnAssertionOfALibraryWithoutStateCostsNoProcess) {
  const auto methods = failing_every_other_time(fail_an_assertion);
  std::vector<Question> questions(2 * recovery_cap + 4, {0, 0});
  const auto answers = ask_contained(methods, numbered_pairs(1), questions);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const MethodAnswer& answer = answers[i].answer;
    if (i % 2 == 0) {
      // After this many failures, and the one that ends the process, the count starts again.
      EXPECT_EQ(answer.distance, i < 2 * recovery_cap + 2 ? i + 1 : i - (2 * recovery_cap + 1)) << i;
    } else {
      EXPECT_EQ(answer.failure, Failure::crash) << i;
      EXPECT_STREQ(answer.reason, "SIGABRT, after printing: lib: gjk.h:177: Assertion `index != -1' failed.")
          << i;
    }
  }
}

TEST(Worker, AnyOtherAbortEndsTheProcess) {
  const auto counts_on = [](std::function<void()> fail) {
    const auto methods = failing_every_other_time(std::move(fail));
    return ask_contained(methods, numbered_pairs(1), std::vector<Question>(3, {0, 0}))[2].answer.distance ==
           3;
  };
  EXPECT_TRUE(counts_on(fail_an_assertion));
  EXPECT_FALSE(counts_on([] { std::abort(); }));
  EXPECT_FALSE(counts_on([] {
    std::fputs("malloc(): unaligned tcache chunk detected\n", stderr);
    std::abort();
  })) << "the heap may be locked";
  EXPECT_FALSE(counts_on([] { std::thread(fail_an_assertion).join(); })) << "another thread";
  EXPECT_FALSE(counts_on([] { std::raise(SIGSEGV); }));
}

TEST(Worker, AGuestMayStartThreads) {
  const MethodAnswer answer = ask_guest([] { std::thread([] {}).join(); });
  EXPECT_EQ(answer.status, Status::answered) << answer.reason;
  EXPECT_EQ(answer.side_effect, SideEffect::none) << answer.reason;
}

TEST(Worker, AChangedRoundingModeIsReportedAndPutBack) {
  const MethodAnswer answer = ask_between_good_ones([] { std::fesetround(FE_UPWARD); });
  EXPECT_EQ(answer.status, Status::answered);
  EXPECT_EQ(answer.side_effect, SideEffect::rounding_mode);
  EXPECT_STREQ(answer.reason, "left the rounding mode changed, the x87 control word changed");
  const auto methods = fakes({[] { std::fesetround(FE_UPWARD); },
                              [] {
                                if (std::fegetround() != FE_TONEAREST)
                                  throw std::runtime_error("rounds upward");
                              }});
  const auto answers = ask_contained(methods, numbered_pairs(1), std::vector<Question>{{0, 0}, {1, 0}});
  EXPECT_STREQ(answers[1].answer.reason, "");
}

TEST(Worker, WhichLimitBrokeIsReported) {
  const Caps caps{.call_cpu = short_cap, .call_wall = milliseconds(2000)};
  const auto endless = [] {
    volatile bool forever = true;
    while (forever) {
    }
  };
  EXPECT_STREQ(ask_between_good_ones(endless, {.call_cpu = short_cap, .call_wall = no_cap}).reason,
               "no answer within 60 ms of CPU time");
  EXPECT_STREQ(ask_between_good_ones([] { std::raise(SIGSTOP); }, caps).reason, "no answer within 2000 ms");
}

/// Does something when it is loaded, and is always right.
class Loading final : public FakeMethod {
 public:
  explicit Loading(std::function<void()> load)
      : FakeMethod("loading", [](const Pair&) { return answered(Verdict::disjoint); }),
        load_(std::move(load)) {}
  void initialize() override { load_(); }

 private:
  std::function<void()> load_;
};

MethodAnswer ask_one_that_loads(std::function<void()> load, const Caps& caps) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Loading>(std::move(load)));
  return ask_contained(methods, numbered_pairs(1), std::vector<Question>{{0, 0}}, caps).front().answer;
}

TEST(Worker, LoadingIsNoCall) {
  const Caps caps{.call_cpu = short_cap, .call_wall = 2 * short_cap};
  EXPECT_EQ(ask_one_that_loads([] { usleep(500'000); }, caps).status, Status::answered);
  EXPECT_STREQ(ask_one_that_loads([] { std::raise(SIGSEGV); }, caps).reason, "while it was loaded: SIGSEGV");
  EXPECT_STREQ(ask_one_that_loads([] { std::raise(SIGSTOP); }, {.load = milliseconds(300)}).reason,
               "no answer within 300 ms to load");
  const auto start_thread = [] { std::thread([] { pause(); }).detach(); };
  EXPECT_EQ(ask_one_that_loads(start_thread, {}).side_effect, SideEffect::none)
      << "a pool of threads is no fault";
}

}  // namespace
}  // namespace cyl
