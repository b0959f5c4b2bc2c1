// SPDX-License-Identifier: MIT
#include "oracles/methods/worker.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <type_traits>

#include "base/process/confine.hpp"
#include "base/process/control_words.hpp"
#include "base/process/kept_process.hpp"
#include "base/process/process.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// How often a running worker is looked at: a hang is noticed at most this late.
constexpr milliseconds longest_look_interval{50};

/// Bytes that a worker may have beyond what it has at the fork: a leak in foreign code ends as std::bad_alloc
/// or a crash in the worker, not as the machine's out-of-memory killer.
constexpr rlim_t memory_cap = rlim_t{2} << 30;

/// Bytes that a worker may print, kept in memory; what comes after is lost.
constexpr off_t output_cap = off_t{16} << 20;

/// Exit code of a worker in which a method called exit().
constexpr int exit_called_code = 98;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// Of the parent; the worker maps it read-only.
struct Asked {
  std::atomic<std::uint64_t> number{0};  ///< of the block
  std::size_t count = 0;
  bool one_by_one = false;        ///< also where a method takes many
  Question questions[block_cap];  ///< the pair is the place in `pairs`
  Pair pairs[block_cap];
};

/// Of the worker.
struct Said {
  std::atomic<std::uint64_t> number{0};  ///< of the last block that was answered to its end
  std::atomic<std::size_t> cursor{0};    ///< the question being asked; the number of questions when all are
  std::atomic<int> denied{-1};           ///< the system call that confine() refused
  ContainedAnswer answers[block_cap];
};
static_assert(std::is_trivially_copyable_v<ContainedAnswer>);
static_assert(std::atomic<std::size_t>::is_always_lock_free);

rlim_t address_space_now() {
  unsigned long pages = 0;
  if (std::FILE* f = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(f, "%lu", &pages) != 1) pages = 0;
    std::fclose(f);
  }
  return rlim_t{pages} * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// Threads of this process.
nlink_t count_threads() {
  struct stat s {};
  return stat("/proc/self/task", &s) == 0 ? s.st_nlink : 0;
}

/// Time that the first thread of a process ran or could have run; 0 where the system does not tell.
nanoseconds busy_time_of(pid_t process) {
  char file[40];
  std::snprintf(file, sizeof file, "/proc/%d/schedstat", process);
  long long ran = 0, queued = 0;
  if (std::FILE* f = std::fopen(file, "re")) {
    if (std::fscanf(f, "%lld %lld", &ran, &queued) != 2) ran = queued = 0;
    std::fclose(f);
  }
  return nanoseconds(ran + queued);
}

bool has_ended(const KeptProcess& kept) {
  pollfd end{kept.end(), POLLIN, 0};
  return poll(&end, 1, 0) > 0;
}

// Signals that a terminal or a batch system sends to all are the parent's to handle, or the method that
// happens to be asked would be blamed for them.
void become_worker() {
  for (int s : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXFSZ}) std::signal(s, SIG_IGN);
  limit(RLIMIT_FSIZE, output_cap);
  if (!sanitized) limit(RLIMIT_AS, address_space_now() + memory_cap);
  std::setvbuf(stdout, nullptr, _IONBF, 0);
  // Handlers run last in, first out: exit() in foreign code must not run those of the parent (which may
  // remove its files).
  std::atexit([] { _exit(exit_called_code); });
}

void note(MethodAnswer& answer, SideEffect effect, std::string_view what) {
  if (answer.side_effect != SideEffect::none) return;
  answer.side_effect = effect;
  if (answer.status == Status::answered) answer.set_reason(what);
}

/// The inside of a worker.
class Service {
 public:
  Service(std::span<const std::unique_ptr<Method>> methods, const Asked& asked, Said& said)
      : methods_(methods),
        asked_(asked),
        said_(said),
        words_(read_control_words()),
        threads_(count_threads()) {}

  /// Ends where the guest closed the descriptors, which is no fault.
  void run(int go, int done) {
    pollfd news{go, POLLIN, 0};
    while (poll(&news, 1, -1) >= 0 || errno == EINTR) {
      if ((news.revents & ~POLLIN) != 0) return;
      std::uint64_t wakes;
      if (read(go, &wakes, sizeof wakes) < 0 && errno != EAGAIN) return;
      const std::uint64_t number = asked_.number.load();
      if (number == said_.number.load()) continue;
      answer_block();
      said_.number.store(number);
      const std::uint64_t one = 1;
      if (write(done, &one, sizeof one) < 0 && errno != EAGAIN) return;
    }
  }

 private:
  void answer_block() {
    for (std::size_t first = said_.cursor.load(); first < asked_.count;) {
      const Question& q = asked_.questions[first];
      std::size_t end = first + 1;
      while (end < asked_.count && asked_.questions[end].method == q.method &&
             asked_.questions[end].run == q.run)
        ++end;
      // To read the CPU clock is a system call, to read the other none.
      const clockid_t clock = end - first > 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
      const nanoseconds start = read_clock(clock);
      if (!answer_many(first, end))
        for (std::size_t i = first; i < end; said_.cursor.store(++i)) answer(i);
      said_.cursor.store(end);
      const double each =
          static_cast<double>((read_clock(clock) - start).count()) / static_cast<double>(end - first);
      for (std::size_t i = first; i < end; ++i) said_.answers[i].nanoseconds = each;
      first = end;
    }
    if (const nlink_t threads = count_threads(); threads > threads_) {
      threads_ = threads;
      note(said_.answers[asked_.count - 1].answer, SideEffect::thread, "left a thread running");
    }
  }

  /// Asks in one call, and returns whether that was possible and without side effects, of which it would not
  /// be known where they come from.
  bool answer_many(std::size_t first, std::size_t end) {
    const Question& q = asked_.questions[first];
    Method& method = *methods_[q.method];
    if (asked_.one_by_one || q.mode != CallMode::usual || !method.asks_many()) return false;
    const auto pairs = std::span(asked_.pairs).subspan(first, end - first);
    answers_.assign(pairs.size(), {});
    try {
      if (method.ask_many(pairs, answers_) != pairs.size()) return false;
    } catch (...) {
      return false;
    }
    bool quiet = read_control_words() == words_;
    write_control_words(words_);
    for (const MethodAnswer& answer : answers_) quiet = quiet && answer.side_effect == SideEffect::none;
    for (std::size_t i = first; i < end && quiet; ++i) said_.answers[i].answer = checked(answers_[i - first]);
    return quiet;
  }

  void answer(std::size_t i) {
    const Question& q = asked_.questions[i];
    MethodAnswer answer = ask_caught(*methods_[q.method], asked_.pairs[q.pair], q.mode);
    if (const ControlWords left = read_control_words(); left != words_) {
      note(answer, SideEffect::rounding_mode, describe_change(words_, left));
      write_control_words(words_);
    }
    said_.answers[i].answer = answer;
  }

  std::span<const std::unique_ptr<Method>> methods_;
  const Asked& asked_;
  Said& said_;
  const ControlWords words_;
  nlink_t threads_;
  std::vector<MethodAnswer> answers_;
};

/// Memory that two processes map, and no child of this one by the fork alone.
template <class Content>
class Shared {
 public:
  explicit Shared(bool parent_writes_alone) : file_(memfd_create("block", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
    if (file_ < 0 || ftruncate(file_, sizeof(Content)) != 0) throw_errno("memfd_create");
    content_ = new (map(PROT_READ | PROT_WRITE)) Content;
    madvise(content_, sizeof(Content), MADV_DONTFORK);
    if (parent_writes_alone &&
        fcntl(file_, F_ADD_SEALS, F_SEAL_FUTURE_WRITE | F_SEAL_SHRINK | F_SEAL_GROW) != 0)
      throw_errno("sealing a block");
  }
  ~Shared() {
    munmap(content_, sizeof(Content));
    close(file_);
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  Content* operator->() const { return content_; }
  int file() const { return file_; }
  /// In the worker.
  Content& map_there(int protection) const { return *static_cast<Content*>(map(protection)); }

 private:
  void* map(int protection) const {
    void* const at = mmap(nullptr, sizeof(Content), protection, MAP_SHARED, file_, 0);
    if (at == MAP_FAILED) throw_errno("mmap");
    return at;
  }

  int file_;
  Content* content_;
};

bool all_finite(const MethodAnswer& a) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return (!a.has_distance || finite(a.distance)) &&
         (a.witness == CertificateKind::none ||
          (std::all_of(a.head, a.head + 3, finite) && std::all_of(a.tail, a.tail + 3, finite)));
}

bool well_formed(const MethodAnswer& a) {
  return a.status <= Status::failed && a.failure <= Failure::reported && a.verdict <= Verdict::invalid &&
         a.witness <= CertificateKind::point && a.hulls[0] <= Hull::center && a.hulls[1] <= Hull::center &&
         a.side_effect <= SideEffect::slow;
}

}  // namespace

MethodAnswer checked(MethodAnswer answer) {
  answer.reason[sizeof answer.reason - 1] = 0;
  if (!well_formed(answer)) {
    return failed_answer(Failure::malformed,
                         "no answer: status " + std::to_string(static_cast<int>(answer.status)) +
                             ", verdict " + std::to_string(static_cast<int>(answer.verdict)) + ", witness " +
                             std::to_string(static_cast<int>(answer.witness)));
  }
  if (answer.status == Status::answered && !all_finite(answer)) {
    answer.status = Status::failed;
    answer.failure = Failure::non_finite;
    answer.set_reason(answer.has_distance && !std::isfinite(answer.distance)
                          ? "distance is " + std::to_string(answer.distance)
                          : "the witness is not finite");
  }
  return answer;
}

MethodAnswer ask_caught(Method& method, const Pair& pair, CallMode mode) {
  try {
    return checked(call(method, pair, mode));
  } catch (const std::exception& e) {
    return failed_answer(Failure::exception, e.what());
  } catch (...) {
    return failed_answer(Failure::exception, "thrown: not a std::exception");
  }
}

class Worker::Memory {
 public:
  Shared<Asked> asked{true};
  Shared<Said> said{false};
};

/// A process, and what it alone has.
class Worker::Process {
 public:
  Process(std::span<const std::unique_ptr<Method>> methods, bool confined, const Memory& memory)
      : output_(memfd_create("worker output", MFD_CLOEXEC)),
        go_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
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

  KeptProcess& kept() { return *kept_; }
  int output() const { return output_; }
  int done() const { return done_; }
  void wake() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t ignored = write(go_, &one, sizeof one);  // it is awake where this fails
  }
  void quiet() const {
    std::uint64_t wakes;
    [[maybe_unused]] const ssize_t ignored = read(done_, &wakes, sizeof wakes);
  }

 private:
  void serve(std::span<const std::unique_ptr<Method>> methods, bool confined, const Memory& memory) const {
    const Asked& asked = memory.asked.map_there(PROT_READ);
    Said& said = memory.said.map_there(PROT_READ | PROT_WRITE);
    close_all({memory.asked.file(), memory.said.file()});
    become_worker();
    if (confined) confine(said.denied);
    Service(methods, asked, said).run(go_, done_);
  }

  int output_, go_, done_;
  std::optional<KeptProcess> kept_;
};

Worker::Worker(std::span<const std::unique_ptr<Method>> methods, bool confined, const Caps& caps)
    : methods_(methods), confined_(confined), caps_(caps) {}

Worker::~Worker() = default;

struct Worker::Watched {
  bool lost = false;
  std::string limit;  ///< that the question `at` broke, for which the worker was ended; else empty
  std::size_t at = 0;
  nanoseconds wall{0};
  std::vector<std::pair<std::size_t, nanoseconds>> waits;  ///< questions that slept, and how long
};

void Worker::post(std::span<const Pair> pairs, std::span<const Question> questions) {
  if (process_ && !process_->kept().ours()) {  // it is of the process that this one was forked from
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

// The times of a question start where the move of the cursor to it is noticed, so they never count what an
// earlier call used.
Worker::Watched Worker::watch() {
  const auto interval = std::clamp(caps_.call_cpu / 4, milliseconds(1), longest_look_interval);
  const auto& said = *memory_->said.operator->();
  KeptProcess& kept = process_->kept();
  Watched watched;
  struct Times {
    nanoseconds wall, cpu, busy;
  };
  const auto now = [&] {
    return Times{read_clock(CLOCK_MONOTONIC), kept.cpu_time(), busy_time_of(kept.id())};
  };
  std::size_t seen = said.cursor.load();
  std::optional<Times> start;
  pollfd news[] = {{process_->done(), POLLIN, 0}, {kept.end(), POLLIN, 0}};
  while (true) {
    const int changes = poll(news, 2, static_cast<int>(interval.count()));
    if (changes > 0 && news[0].revents != 0) process_->quiet();
    if (said.number.load() == memory_->asked->number.load()) return watched;
    if (changes > 0 && news[1].revents != 0) {
      watched.lost = true;
      return watched;
    }
    const Times looked = now();
    const std::size_t cursor = said.cursor.load();
    if (!start || cursor != seen) {
      seen = cursor;
      start = looked;
      continue;
    }
    const nanoseconds wall = looked.wall - start->wall, cpu = looked.cpu - start->cpu;
    const nanoseconds waited = wall - (looked.busy - start->busy);
    if (looked.busy.count() > 0 && waited > caps_.call_wait) {
      if (watched.waits.empty() || watched.waits.back().first != seen)
        watched.waits.push_back({seen, waited});
      watched.waits.back().second = waited;
    }
    if (cpu <= caps_.call_cpu && wall <= caps_.call_wall) continue;
    watched.limit = cpu > caps_.call_cpu ? std::to_string(caps_.call_cpu.count()) + " ms of CPU time"
                                         : std::to_string(caps_.call_wall.count()) + " ms";
    watched.lost = true;
    watched.at = seen;
    watched.wall = wall;
    kept.kill_now();
    return watched;
  }
}

/// "SIGABRT, after printing: ...", cut at the front of the printed text so that its end is kept.
std::string describe_death(const std::optional<KeptProcess::Ending>& ending, int denied, int output) {
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
  // Where it printed too much, the end is not known.
  const bool whole = lseek(output, 0, SEEK_END) < output_cap;
  const std::string printed = whole ? last_line(output, sizeof MethodAnswer::reason) : std::string();
  if (printed.empty()) return how;
  how += ", after printing: ";
  const std::size_t room = sizeof MethodAnswer::reason - 1 - how.size();
  return how + (printed.size() > room ? printed.substr(printed.size() - room) : printed);
}

ContainedAnswer Worker::describe_loss(const Watched& watched) {
  if (!watched.limit.empty()) {
    return {failed_answer(Failure::hang, "no answer within " + watched.limit),
            static_cast<double>(watched.wall.count())};
  }
  const auto& ending = process_->kept().wait();
  return {failed_answer(Failure::crash,
                        describe_death(ending, memory_->said->denied.load(), process_->output()))};
}

std::vector<ContainedAnswer> Worker::ask(std::span<const Pair> pairs, std::span<const Question> questions) {
  post(pairs, questions);
  const Watched watched = watch();
  if (watched.lost) {
    process_->kept().kill_now();
    process_->kept().wait();
  }
  const ContainedAnswer* const answers = memory_->said->answers;
  const bool whole = memory_->said->number.load() == memory_->asked->number.load();
  const std::size_t cursor = std::min(memory_->said->cursor.load(), questions.size());
  std::vector<ContainedAnswer> said(answers, answers + (whole ? questions.size() : cursor));
  for (ContainedAnswer& each : said) each.answer = checked(each.answer);
  for (const auto& [i, waited] : watched.waits) {
    if (i < said.size())
      note(said[i].answer, SideEffect::slow,
           "waited for " + std::to_string(std::chrono::duration_cast<milliseconds>(waited).count()) + " ms");
  }
  // Where many were asked in one call it is not known whose fault that is: the next block goes one by one.
  const bool in_one_call = watched.lost && said.size() < questions.size() && !one_by_one_ &&
                           methods_[questions[said.size()].method]->asks_many();
  one_by_one_ = in_one_call;
  if (in_one_call) process_.reset();
  if (watched.lost && !in_one_call) {
    // A call may end just before the kill meant for it: then no one is to blame.
    const bool blamed = watched.limit.empty() || watched.at == said.size() || said.empty();
    if (said.size() < questions.size() && blamed) said.push_back(describe_loss(watched));
    process_.reset();
  }
  return said;
}

}  // namespace cyl
