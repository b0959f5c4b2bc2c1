// SPDX-License-Identifier: MIT
#include "oracles/methods/worker.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/process/confine.hpp"
#include "base/process/process.hpp"
#include "base/process/supervised_process.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/worker_service.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// The interval at which a running worker is checked. A hang is noticed at most this late.
constexpr milliseconds longest_look_interval{50};

/// How often a worker is started for one block that none takes up.
constexpr int start_cap = 3;

bool has_ended(const SupervisedProcess& kept) {
  pollfd end{kept.end(), POLLIN, 0};
  return poll(&end, 1, 0) > 0;
}

}  // namespace

class Worker::Memory {
 public:
  Shared<RequestBlock> asked{true};
  Shared<ResponseBlock> said{false};
};

/// A process and its own resources.
class Worker::Process {
 public:
  Process(std::span<const std::unique_ptr<Method>> methods, bool confined, const Memory& memory)
      : output_(memfd_create("worker output", MFD_CLOEXEC)),
        go_(eventfd(0, EFD_CLOEXEC)),
        done_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    try {
      if (output_ < 0 || go_ < 0 || done_ < 0) throw_errno("starting a worker");
      fcntl(output_, F_SETFL, O_APPEND);
      const KeptDescriptors kept{-1, output_, output_, {go_, done_, memory.asked.file(), memory.said.file()}};
      kept_.emplace([&] { serve(methods, confined, memory); }, kept);
    } catch (...) {
      close_all({output_, go_, done_});
      throw;
    }
  }
  ~Process() {
    kept_.reset();
    close_all({output_, go_, done_});
  }

  SupervisedProcess& kept() { return *kept_; }
  int output() const { return output_; }
  int done() const { return done_; }
  void wake() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t ignored = write(go_, &one, sizeof one);
  }
  void quiet() const {
    std::uint64_t wakes;
    [[maybe_unused]] const ssize_t ignored = read(done_, &wakes, sizeof wakes);
  }

 private:
  void serve(std::span<const std::unique_ptr<Method>> methods, bool confined, const Memory& memory) const {
    const RequestBlock& asked = memory.asked.map_there(PROT_READ);
    ResponseBlock& said = memory.said.map_there(PROT_READ | PROT_WRITE);
    close_all({memory.asked.file(), memory.said.file()});
    answer_blocks(methods, confined, asked, said, go_, done_);
  }

  int output_, go_, done_;
  std::optional<SupervisedProcess> kept_;
};

Worker::Worker(std::span<const std::unique_ptr<Method>> methods, bool confined, const Caps& caps)
    : methods_(methods), confined_(confined), caps_(caps) {}

Worker::~Worker() = default;

struct Worker::Watched {
  bool lost = false;
  bool out_of_time = false;
  std::string limit;  ///< the limit that question `at` exceeded, so that the worker was ended. Else empty
  std::size_t at = 0;
  nanoseconds cpu{0};  ///< of question `at`
};

void Worker::post(std::span<const Pair> pairs, std::span<const Question> questions) {
  if (process_ && !process_->kept().ours()) {  // the process belongs to the one that this one was forked from
    process_.reset();
    memory_.reset();
  }
  if (process_ && has_ended(process_->kept())) process_.reset();
  if (!memory_) memory_ = std::make_unique<Memory>();
  auto& asked = memory_->asked;
  asked->count = questions.size();
  asked->one_by_one = one_by_one_;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    asked->questions[i] = questions[i];
    asked->questions[i].pair = i;
    asked->pairs[i] = pairs[questions[i].pair];
  }
  memory_->said->cursor.store(0);
  memory_->said->denied.store(-1);
  asked->number.store(asked->number.load() + 1);
  if (!process_) process_ = std::make_unique<Process>(methods_, confined_, *memory_);
  if (ftruncate(process_->output(), 0) != 0) throw_errno("ftruncate");
  process_->wake();
}

bool Worker::has_begun() const { return memory_->said->begun.load() == memory_->asked->number.load(); }

// The clock of a question starts when the parent sees the cursor on it. So it never counts time that an
// earlier call used.
Worker::Watched Worker::watch() {
  const auto interval = std::clamp(caps_.call_cpu / 4, milliseconds(1), longest_look_interval);
  const auto& said = *memory_->said.operator->();
  SupervisedProcess& kept = process_->kept();
  Watched watched;
  struct Times {
    nanoseconds wall, cpu;
  };
  std::size_t seen = said.cursor.load();
  std::optional<Times> start;
  bool loaded = false;
  pollfd news[] = {{process_->done(), POLLIN, 0}, {kept.end(), POLLIN, 0}};
  while (true) {
    const int changes = poll(news, 2, static_cast<int>(interval.count()));
    if (changes > 0 && news[0].revents != 0) process_->quiet();
    if (said.number.load() == memory_->asked->number.load()) return watched;
    if (changes > 0 && news[1].revents != 0) {
      watched.lost = true;
      return watched;
    }
    const Times looked{read_clock(CLOCK_MONOTONIC), kept.cpu_time()};
    const std::size_t cursor = said.cursor.load();
    const bool was_loaded = std::exchange(loaded, has_begun());
    if (!start || cursor != seen || loaded != was_loaded) {
      seen = cursor;
      start = looked;
      continue;
    }
    const nanoseconds wall = looked.wall - start->wall, cpu = looked.cpu - start->cpu;
    const auto cpu_cap = loaded ? caps_.call_cpu : caps_.load,
               wall_cap = loaded ? caps_.call_wall : caps_.load;
    watched.out_of_time = caps_.out_of_time();
    if (cpu <= cpu_cap && wall <= wall_cap && !watched.out_of_time) continue;
    watched.limit = cpu > cpu_cap ? std::to_string(cpu_cap.count()) + " ms of CPU time"
                                  : std::to_string(wall_cap.count()) + " ms";
    if (!loaded) watched.limit += " to load";
    watched.lost = true;
    watched.at = seen;
    watched.cpu = cpu;
    kept.kill_now();
    return watched;
  }
}

/// "SIGABRT, after printing: ..."
std::string describe_death(const std::optional<SupervisedProcess::Ending>& ending, int denied, int output) {
  std::string how = "its process was ended from outside";
  if (ending && WIFSIGNALED(ending->status)) {
    how = signal_name(WTERMSIG(ending->status));
  } else if (ending && WEXITSTATUS(ending->status) == denied_code && denied >= 0) {
    how = "called " + system_call_name(denied) + "(), which a method may not";
  } else if (ending && WEXITSTATUS(ending->status) == exit_called_code) {
    how = "called exit()";
  } else if (ending) {
    how = "ended its process with status " + std::to_string(WEXITSTATUS(ending->status));
  }
  return with_last_words(how, output);
}

ContainedAnswer Worker::describe_loss(const Watched& watched) {
  if (watched.out_of_time) return {};
  if (!watched.limit.empty()) {
    return {failed_answer(Failure::hang, "no answer within " + watched.limit),
            static_cast<double>(watched.cpu.count())};
  }
  const auto& ending = process_->kept().wait();
  const std::string death = describe_death(ending, memory_->said->denied.load(), process_->output());
  return {failed_answer(Failure::crash, (has_begun() ? "" : "while it was loaded: ") + death)};
}

std::vector<ContainedAnswer> Worker::ask(std::span<const Pair> pairs, std::span<const Question> questions) {
  Watched watched;
  // If a process ends on earlier questions, before it takes up this block, a new one is started.
  for (int attempt = 0; attempt < start_cap; ++attempt) {
    post(pairs, questions);
    watched = watch();
    if (!watched.lost) break;
    process_->kept().kill_now();
    process_->kept().wait();
    if (has_begun() || !watched.limit.empty()) break;
  }
  const ContainedAnswer* const answers = memory_->said->answers;
  const bool whole = memory_->said->number.load() == memory_->asked->number.load();
  const std::size_t cursor = std::min(memory_->said->cursor.load(), questions.size());
  std::vector<ContainedAnswer> said(answers, answers + (whole ? questions.size() : cursor));
  for (ContainedAnswer& each : said) each.answer = checked(each.answer);
  // After a loss in one call for many, the question at fault is not known. The next block goes one by one.
  const bool in_one_call = watched.lost && said.size() < questions.size() && !one_by_one_ &&
                           methods_[questions[said.size()].method]->has_batch_call();
  const auto failed = [](const ContainedAnswer& each) { return each.answer.status == Status::failed; };
  if (lost_in_one_call_ && !watched.lost && !said.empty() && std::ranges::none_of(said, failed))
    said.front() = *lost_in_one_call_;
  lost_in_one_call_.reset();
  one_by_one_ = in_one_call;
  if (in_one_call) {
    lost_in_one_call_ = describe_loss(watched);
    lost_in_one_call_->answer.set_reason("in one call for many pairs: " +
                                         std::string(lost_in_one_call_->answer.reason));
    process_.reset();
  }
  if (watched.lost && !in_one_call) {
    // A call may end just before the kill meant for it. Then no call is at fault.
    const bool blamed = watched.limit.empty() || watched.at == said.size() || said.empty();
    if (said.size() < questions.size() && blamed) said.push_back(describe_loss(watched));
    process_.reset();
  }
  return said;
}

}  // namespace cyl
