// SPDX-License-Identifier: MIT
#include "oracles/methods/contained.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "oracles/methods/acting_method_test.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

TEST(Contained, AnswersInTheOrderOfTheQuestions) {
  const auto methods = fakes({[] {}});
  const auto pairs = numbered_pairs(1000);
  std::vector<Question> questions;
  for (std::size_t i = 0; i < 5000; ++i) questions.push_back({0, i * 7 % 1000});
  const auto answers = ask_contained(methods, pairs, questions);
  ASSERT_EQ(answers.size(), questions.size());
  for (std::size_t i = 0; i < answers.size(); ++i)
    EXPECT_EQ(answers[i].answer.distance, static_cast<double>(questions[i].pair));
}

TEST(Contained, TheFileAndLineOfALongMessageAreKept) {
  const MethodAnswer answer = ask_between_good_ones([] {
    std::fputs(
        ("solver: /somewhere/else/gjk.h:177: " + std::string(300, 'x') + ": Assertion `a > 0' failed.\n")
            .c_str(),
        stderr);
    std::abort();
  });
  const std::string reason = answer.reason;
  EXPECT_TRUE(reason.starts_with("SIGABRT, after printing: gjk.h:177 .. x")) << reason;
  EXPECT_TRUE(reason.ends_with("x: Assertion `a > 0' failed.")) << reason;
}

TEST(Contained, WhatAFreshWorkerPrintsDoesNotBelongToTheNext) {
  const auto methods = fakes({[] {
                                std::puts("first");
                                std::abort();
                              },
                              [] { std::raise(SIGSEGV); }});
  const auto answers = ask_contained(methods, numbered_pairs(1), std::vector<Question>{{0, 0}, {1, 0}});
  EXPECT_STREQ(answers[0].answer.reason, "SIGABRT, after printing: first");
  EXPECT_STREQ(answers[1].answer.reason, "SIGSEGV");
}

TEST(Contained, HandledSignalsStillKillTheWorker) {
  const auto old = std::signal(SIGSEGV, [](int) {});
  const MethodAnswer answer = ask_between_good_ones([] { std::raise(SIGSEGV); });
  std::signal(SIGSEGV, old);
  EXPECT_EQ(answer.failure, Failure::crash);
  EXPECT_STREQ(answer.reason, "SIGSEGV");
}

TEST(Contained, ExceptionsKeepTheirText) {
  MethodAnswer answer = ask_between_good_ones([] { throw std::runtime_error("no convergence"); });
  EXPECT_EQ(answer.status, Status::failed);
  EXPECT_EQ(answer.failure, Failure::exception);
  EXPECT_STREQ(answer.reason, "no convergence");
  answer = ask_between_good_ones([] { throw 7; });
  EXPECT_EQ(answer.failure, Failure::exception);
}

TEST(Contained, ExitDoesNotRunTheHandlersOfTheParent) {
  static int channel[2];
  ASSERT_EQ(pipe(channel), 0);
  static const pid_t parent = getpid();
  std::atexit([] {
    if (getpid() != parent && write(channel[1], "x", 1) != 1) std::abort();
  });
  ask_between_good_ones([] { std::exit(0); });
  close(channel[1]);
  char c;
  EXPECT_EQ(read(channel[0], &c, 1), 0) << "a handler of the parent ran in the worker";
  close(channel[0]);
}

TEST(Contained, WhatIsAskedWhenTheTimeRunsOutIsDeclined) {
  const auto methods = fakes({[] {
    while (true) pause();
  }});
  Caps caps{.call_cpu = no_cap, .call_wall = no_cap};
  caps.until = std::chrono::steady_clock::now() + milliseconds(100);
  const std::vector<Question> questions(3, Question{0, 0});
  for (const auto& said : ask_contained(methods, numbered_pairs(1), questions, caps))
    EXPECT_EQ(said.answer.status, Status::declined);
}

/// Its call for a batch is wrong from a place on.
class FaultOfLanes final : public FakeMethod {
 public:
  explicit FaultOfLanes(std::size_t from)
      : FakeMethod("lanes", [](const Pair&) { return answered(Verdict::disjoint); }), from_(from) {}
  BatchCall prepare_batch(std::span<const Pair>) override {
    return [this](std::span<Verdict> verdicts) {
      for (std::size_t i = 0; i < verdicts.size(); ++i)
        verdicts[i] = i < from_ ? Verdict::disjoint : Verdict::intersecting;
    };
  }

 private:
  std::size_t from_;
};

TEST(Contained, ABatchShowsAFaultOfItsLanes) {
  for (const std::size_t from : {0, 2, 4, 8}) {
    FaultOfLanes method(from);
    EXPECT_EQ(call(method, numbered_pairs(1)[0], CallMode::batch).verdict, Verdict::intersecting) << from;
  }
  FaultOfLanes right(100);
  EXPECT_EQ(call(right, numbered_pairs(1)[0], CallMode::batch).verdict, Verdict::disjoint);
}

/// Right if it is asked about one pair.
class FaultOfMany final : public FakeMethod {
 public:
  explicit FaultOfMany(std::function<void()> fault)
      : FakeMethod("many", [](const Pair&) { return answered(Verdict::disjoint); }),
        fault_(std::move(fault)) {}
  bool has_batch_call() const override { return true; }
  std::size_t ask_many(std::span<const Pair> pairs, std::span<MethodAnswer> answers) override {
    fault_();
    return FakeMethod::ask_many(pairs, answers);
  }

 private:
  std::function<void()> fault_;
};

TEST(Contained, AFaultOfTheCallForManyIsAFindingThoughNoSingleCallHasIt) {
  const std::pair<std::function<void()>, Failure> faults[] = {
      {[] { throw std::runtime_error("lane"); }, Failure::exception}, {[] { std::abort(); }, Failure::crash}};
  for (const auto& [fault, failure] : faults) {
    std::vector<std::unique_ptr<Method>> methods;
    methods.push_back(std::make_unique<FaultOfMany>(fault));
    std::vector<Question> questions;
    for (std::size_t i = 0; i < 8; ++i) questions.push_back({0, i});
    const auto said = ask_contained(methods, numbered_pairs(8), questions, {});
    EXPECT_EQ(std::ranges::count(said, failure, [](const auto& each) { return each.answer.failure; }), 1);
    const auto at = std::ranges::find(said, failure, [](const auto& each) { return each.answer.failure; });
    ASSERT_NE(at, said.end());
    EXPECT_TRUE(std::string(at->answer.reason).starts_with("in one call for many pairs: "))
        << at->answer.reason;
  }
}

TEST(Contained, ACallForManyAnswersNoQuestionOfAnotherMode) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<FaultOfMany>([] {}));  // it cannot prepare
  std::vector<Question> questions;
  for (std::size_t i = 0; i < 8; ++i)
    questions.push_back({0, 0, i % 2 ? CallMode::prepared : CallMode::usual});
  const auto said = ask_contained(methods, numbered_pairs(1), questions, {});
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(said[i].answer.status, i % 2 ? Status::declined : Status::answered) << i;
}

TEST(Contained, TheCapIsForOneCallNotForTheBatch) {
  const auto methods = fakes({[] {
    const std::clock_t start = std::clock();
    while (std::clock() - start < CLOCKS_PER_SEC / 16) {
    }
  }});
  const std::vector<Question> questions(8, Question{0, 0});
  for (const auto& a : ask_contained(methods, numbered_pairs(1), questions,
                                     {.call_cpu = milliseconds(200), .call_wall = no_cap}))
    EXPECT_EQ(a.answer.status, Status::answered) << a.answer.reason;
}

TEST(Contained, NumbersThatAreNotFiniteFail) {
  const auto methods = fakes({[] {}});
  auto pairs = numbered_pairs(3);
  pairs[0].a.radius = std::numeric_limits<double>::quiet_NaN();
  pairs[1].a.radius = std::numeric_limits<double>::infinity();
  const auto answers = ask_contained(methods, pairs, std::vector<Question>{{0, 0}, {0, 1}, {0, 2}});
  for (int i : {0, 1}) {
    EXPECT_EQ(answers[static_cast<std::size_t>(i)].answer.status, Status::failed);
    EXPECT_EQ(answers[static_cast<std::size_t>(i)].answer.failure, Failure::non_finite);
  }
  EXPECT_STREQ(answers[0].answer.reason, "distance is nan");
  EXPECT_EQ(answers[2].answer.status, Status::answered);
}

TEST(Contained, PrintingWithoutEndTakesBoundedMemory) {
  const MethodAnswer answer = ask_between_good_ones([] {
    const std::string megabyte(1 << 20, 'x');
    for (int i = 0; i < 32; ++i) std::fputs(megabyte.c_str(), stdout);
    struct stat s;
    if (fstat(STDOUT_FILENO, &s) != 0 || s.st_size > 17 << 20) throw std::runtime_error("all was kept");
  });
  EXPECT_EQ(answer.status, Status::answered) << answer.reason;
}

TEST(Contained, AnInterruptForTheGroupIsNotTheMethodsFault) {
  const MethodAnswer answer = ask_between_good_ones([] {
    std::raise(SIGINT);
    std::raise(SIGTERM);
  });
  EXPECT_EQ(answer.status, Status::answered) << answer.reason;
}

/// A page that this process, its children and their workers see.
std::atomic<int>& shared_counter() {
  void* const page =
      mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return *new (page) std::atomic<int>{0};
}

TEST(Contained, AWorkerDiesWithItsParent) {
  std::atomic<int>& beats = shared_counter();
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::thread([&] {
      while (beats.load() == 0) usleep(1000);
      kill(getpid(), SIGKILL);
    }).detach();
    const auto methods = fakes({[&] {
      for (;; ++beats) usleep(1000);
    }});
    ask_contained(methods, numbered_pairs(1), std::vector<Question>{{0, 0}},
                  {.call_cpu = no_cap, .call_wall = no_cap});
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  int before = -1;
  for (int i = 0; i < 1000 && before != beats.load(); ++i) {
    before = beats.load();
    usleep(100'000);
  }
  EXPECT_EQ(before, beats.load()) << "the worker lives on";
}

TEST(Contained, WhatItStartedEndsWithIt) {
  std::atomic<int>& beats = shared_counter();
  const MethodAnswer answer = ask_between_good_ones([&] {
    if (fork() == 0) {
      setsid();
      for (;; ++beats) usleep(1000);
    }
    while (beats.load() == 0) usleep(1000);
  });
  EXPECT_EQ(answer.status, Status::answered) << answer.reason;
  const int before = beats.load();  // ask_contained() has returned, and with it the keeper
  usleep(100'000);
  EXPECT_EQ(before, beats.load()) << "an orphan lives on";
}

}  // namespace
}  // namespace cyl
