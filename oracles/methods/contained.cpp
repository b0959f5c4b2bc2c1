// SPDX-License-Identifier: MIT
#include "oracles/methods/contained.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>

#include "base/process/child.hpp"
#include "base/process/process.hpp"

namespace cyl {
namespace {

using std::chrono::nanoseconds;

/// How often a running worker is looked at: a hang is noticed at most this late.
constexpr std::chrono::milliseconds longest_look_interval{50};

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

class Descriptor {
 public:
  Descriptor(int fd, const char* what) : fd_(fd) {
    if (fd < 0) throw_errno(what);
  }
  ~Descriptor() { close(fd_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

/// What parent and workers share: the cursor, and an answer for every question.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t count) : bytes_(sizeof(Head) + count * sizeof(ContainedAnswer)) {
    memory_ = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory_ == MAP_FAILED) throw_errno("mmap");
    new (memory_) Head;
  }
  ~SharedMemory() { munmap(memory_, bytes_); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  /// Index of the question being asked; the number of questions when all are answered.
  std::atomic<std::size_t>& cursor() { return static_cast<Head*>(memory_)->cursor; }
  ContainedAnswer* answers() { return reinterpret_cast<ContainedAnswer*>(static_cast<Head*>(memory_) + 1); }

 private:
  struct alignas(64) Head {
    std::atomic<std::size_t> cursor{0};
  };
  static_assert(std::is_trivially_copyable_v<ContainedAnswer>);
  static_assert(std::atomic<std::size_t>::is_always_lock_free);

  std::size_t bytes_;
  void* memory_;
};

rlim_t address_space_now() {
  unsigned long pages = 0;
  if (std::FILE* f = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(f, "%lu", &pages) != 1) pages = 0;
    std::fclose(f);
  }
  return rlim_t{pages} * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

// A worker leaves no core, and meets signals as if no one had touched them, but for
// those a terminal or a batch system sends to the whole group: these are the parent's to handle, or the
// method that happens to be asked would be blamed for them.
void become_worker(int output) {
  for (int s = 1; s < NSIG; ++s) std::signal(s, SIG_DFL);
  for (int s : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXFSZ}) std::signal(s, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);

  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, output_cap);
  if (!sanitized) limit(RLIMIT_AS, address_space_now() + memory_cap);

  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  std::setvbuf(stdout, nullptr, _IONBF, 0);

  // Handlers run last in, first out: exit() in foreign code must not run those of the parent (which may
  // remove its files).
  std::atexit([] { _exit(exit_called_code); });
}

bool all_finite(const MethodAnswer& a) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return (!a.has_distance || finite(a.distance)) &&
         (a.witness == CertificateKind::none ||
          (std::all_of(a.head, a.head + 3, finite) && std::all_of(a.tail, a.tail + 3, finite)));
}

MethodAnswer failed(Failure failure, std::string_view reason) {
  MethodAnswer answer;
  answer.status = Status::failed;
  answer.failure = failure;
  answer.set_reason(reason);
  return answer;
}

MethodAnswer verdict_alone(Verdict verdict) {
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = verdict;
  return answer;
}

MethodAnswer cannot_be_called_so() {
  MethodAnswer answer;
  answer.set_reason("cannot be asked this way");
  return answer;
}

MethodAnswer gave_up(const Caps& caps) {
  MethodAnswer answer;
  answer.set_reason("not asked any more after " + std::to_string(caps.hangs) + " hangs");
  return answer;
}

bool well_formed(const MethodAnswer& a) {
  return a.status <= Status::failed && a.failure <= Failure::reported && a.verdict <= Verdict::invalid &&
         a.witness <= CertificateKind::point;
}

MethodAnswer ask(Method& method, const Pair& pair, CallMode mode) {
  try {
    MethodAnswer answer = call(method, pair, mode);
    if (!well_formed(answer)) {
      return failed(Failure::malformed, "no answer: status " +
                                            std::to_string(static_cast<int>(answer.status)) + ", verdict " +
                                            std::to_string(static_cast<int>(answer.verdict)) + ", witness " +
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
  } catch (const std::exception& e) {
    return failed(Failure::exception, e.what());
  } catch (...) {
    return failed(Failure::exception, "thrown: not a std::exception");
  }
}

/// The question a worker was killed for, and the wall time it had taken.
struct Kill {
  std::size_t question;
  nanoseconds wall;
};

/// Watches a worker until it ends, or ends it.
std::optional<Kill> watch(Child& worker, const std::atomic<std::size_t>& cursor, const Caps& caps) {
  const auto interval = std::clamp(caps.call_cpu / 4, std::chrono::milliseconds(1), longest_look_interval);

  // The times start where a move of the cursor is noticed, so they never count what an earlier call used.
  std::size_t seen = cursor.load();
  nanoseconds cpu_start{0};
  nanoseconds wall_start = read_clock(CLOCK_MONOTONIC);
  pollfd ended{.fd = worker.end(), .events = POLLIN, .revents = 0};
  while (poll(&ended, 1, static_cast<int>(interval.count())) <= 0) {
    const nanoseconds cpu = worker.cpu_time();
    const nanoseconds wall = read_clock(CLOCK_MONOTONIC);
    const std::size_t now = cursor.load();
    if (now != seen) {
      seen = now;
      cpu_start = cpu;
      wall_start = wall;
    } else if (cpu - cpu_start > caps.call_cpu || wall - wall_start > caps.call_wall) {
      worker.kill_now();
      return Kill{seen, wall - wall_start};
    }
  }
  return std::nullopt;
}

std::string describe_hang(const Caps& caps) {
  return "no answer within " + std::to_string(caps.call_cpu.count()) + " ms of CPU time or " +
         std::to_string(caps.call_wall.count()) + " ms in all";
}

/// "SIGABRT, after printing: ...", cut at the front of the printed text so that its end is kept.
std::string describe_death(int status, int output) {
  std::string how;
  if (WIFSIGNALED(status)) {
    how = signal_name(WTERMSIG(status));
  } else if (WEXITSTATUS(status) == exit_called_code) {
    how = "called exit()";
  } else {
    how = "ended its process with status " + std::to_string(WEXITSTATUS(status));
  }
  // Where it printed too much, the end is not known.
  const bool whole = lseek(output, 0, SEEK_END) < output_cap;
  const std::string printed = whole ? last_line(output, sizeof MethodAnswer::reason) : std::string();
  if (printed.empty()) return how;
  how += ", after printing: ";
  const std::size_t room = sizeof MethodAnswer::reason - 1 - how.size();
  return how + (printed.size() > room ? printed.substr(printed.size() - room) : printed);
}

/// A batch of one would show no mix-up of pairs or lanes: before it goes this one, a wall beside a rim, with
/// which our kernel is busy for three steps.
const Pair company{{Vector3(0, 0, 0), Vector3(0, 0, 1), 5, 1}, {Vector3(-5, 5, 1), Vector3(1, -5, 1), 1, 10}};

}  // namespace

MethodAnswer call(Method& method, const Pair& pair, CallMode mode) {
  switch (mode) {
    case CallMode::usual:
      break;
    case CallMode::other_thread: {
      MethodAnswer answer;
      std::exception_ptr thrown;
      std::thread([&] {
        try {
          answer = method.ask(pair);
        } catch (...) {
          thrown = std::current_exception();
        }
      }).join();
      if (thrown) std::rethrow_exception(thrown);
      return answer;
    }
    case CallMode::prepared: {
      const Method::Call call = method.prepare_all({&pair, 1});
      return call ? verdict_alone(call(0)) : cannot_be_called_so();
    }
    case CallMode::batch: {
      const Pair both[] = {company, pair};
      const Method::BatchCall call = method.prepare_batch(both);
      if (!call) return cannot_be_called_so();
      Verdict verdicts[] = {Verdict::undecided, Verdict::undecided};
      call(verdicts);
      return verdict_alone(verdicts[1]);
    }
  }
  return method.ask(pair);
}

std::vector<ContainedAnswer> ask_contained(std::span<const std::unique_ptr<Method>> methods,
                                           std::span<const Pair> pairs, std::span<const Question> questions,
                                           const Caps& caps) {
  if (questions.empty()) return {};
  SharedMemory shared(questions.size());
  const Descriptor output(memfd_create("worker output", MFD_CLOEXEC), "memfd_create");
  fcntl(output.get(), F_SETFL, O_APPEND);
  std::atomic<std::size_t>& cursor = shared.cursor();

  while (cursor.load() < questions.size()) {
    if (ftruncate(output.get(), 0) != 0) throw_errno("ftruncate");
    std::vector<unsigned> hangs(methods.size(), 0);
    for (std::size_t i = 0; i < cursor.load(); ++i)
      hangs[questions[i].method] += shared.answers()[i].answer.failure == Failure::hang;
    Child worker([&]() -> std::string {
      become_worker(output.get());
      for (std::size_t i = cursor.load(); i < questions.size(); cursor.store(++i)) {
        const nanoseconds start = read_clock(CLOCK_MONOTONIC);
        const Question& q = questions[i];
        const MethodAnswer answer =
            hangs[q.method] < caps.hangs ? ask(*methods[q.method], pairs[q.pair], q.mode) : gave_up(caps);
        const nanoseconds end = read_clock(CLOCK_MONOTONIC);
        if (answer.failure == Failure::hang) ++hangs[q.method];  // of a program that the method runs
        shared.answers()[i] = {answer, static_cast<double>((end - start).count())};
      }
      return {};
    });
    const std::optional<Kill> killed_for = watch(worker, cursor, caps);
    const int status = worker.wait();
    const std::size_t i = cursor.load();
    if (i == questions.size()) break;
    // A call may end just before the kill meant for it: then no one is to blame, and the next worker goes on
    // at i.
    if (killed_for && killed_for->question != i) continue;
    if (killed_for) {
      shared.answers()[i] = {failed(Failure::hang, describe_hang(caps)),
                             static_cast<double>(killed_for->wall.count())};
    } else {
      shared.answers()[i] = {failed(Failure::crash, describe_death(status, output.get()))};
    }
    cursor.store(i + 1);
  }
  return {shared.answers(), shared.answers() + questions.size()};
}

}  // namespace cyl
