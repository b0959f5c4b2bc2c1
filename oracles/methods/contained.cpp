// SPDX-License-Identifier: MIT
#include "oracles/methods/contained.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
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
#include <system_error>
#include <thread>
#include <type_traits>

#include "base/process/fork_with_retry.hpp"

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

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

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
class Board {
 public:
  explicit Board(std::size_t count) : bytes_(sizeof(Head) + count * sizeof(ContainedAnswer)) {
    memory_ = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory_ == MAP_FAILED) throw_errno("mmap");
    new (memory_) Head;
  }
  ~Board() { munmap(memory_, bytes_); }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

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

void limit(decltype(RLIMIT_CORE) resource, rlim_t value) {
  rlimit r;
  getrlimit(resource, &r);
  r.rlim_cur = std::min(value, r.rlim_max);
  setrlimit(resource, &r);
}

// A worker dies with its parent, leaves no core, and meets signals as if no one had touched them, but for
// those a terminal or a batch system sends to the whole group: these are the parent's to handle, or the
// method that happens to be asked would be blamed for them.
void become_worker(pid_t parent, int output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);

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
         (a.witness == WitnessKind::none ||
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

MethodAnswer has_no_such_way() {
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
  return a.status <= Status::failed && a.failure <= Failure::malformed && a.verdict <= Verdict::invalid &&
         a.witness <= WitnessKind::point;
}

MethodAnswer ask(Method& method, const Pair& pair, Way way) {
  try {
    MethodAnswer answer = put(method, pair, way);
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

nanoseconds read_clock(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return std::chrono::seconds(t.tv_sec) + nanoseconds(t.tv_nsec);
}

/// The question a worker was killed for, and the wall time it had taken.
struct Kill {
  std::size_t question;
  nanoseconds wall;
};

/// Watches a worker until it ends, or ends it. It is not yet reaped.
std::optional<Kill> watch(pid_t worker, std::atomic<std::size_t>& cursor, const Caps& caps) {
  const Descriptor handle(static_cast<int>(syscall(SYS_pidfd_open, worker, 0)), "pidfd_open");
  clockid_t cpu_clock;
  if (const int error = clock_getcpuclockid(worker, &cpu_clock))
    throw std::system_error(error, std::generic_category(), "clock_getcpuclockid");
  const auto interval = std::clamp(caps.call_cpu / 4, std::chrono::milliseconds(1), longest_look_interval);

  // The times start where a move of the cursor is noticed, so they never count what an earlier call used.
  std::size_t seen = cursor.load();
  nanoseconds cpu_start{0};
  nanoseconds wall_start = read_clock(CLOCK_MONOTONIC);
  pollfd ended{.fd = handle.get(), .events = POLLIN, .revents = 0};
  while (poll(&ended, 1, static_cast<int>(interval.count())) <= 0) {
    const nanoseconds cpu = read_clock(cpu_clock);
    const nanoseconds wall = read_clock(CLOCK_MONOTONIC);
    const std::size_t now = cursor.load();
    if (now != seen) {
      seen = now;
      cpu_start = cpu;
      wall_start = wall;
    } else if (cpu - cpu_start > caps.call_cpu || wall - wall_start > caps.call_wall) {
      kill(worker, SIGKILL);
      return Kill{seen, wall - wall_start};
    }
  }
  return std::nullopt;
}

int reap(pid_t worker) {
  int status = 0;
  while (waitpid(worker, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// The end of what the worker printed, on one line; empty where nothing, or too much to know the end.
std::string last_output(int output) {
  struct stat s;
  if (fstat(output, &s) != 0 || s.st_size >= output_cap) return {};
  char tail[sizeof MethodAnswer::reason];
  const off_t length = std::min<off_t>(s.st_size, sizeof tail);
  const ssize_t got = pread(output, tail, static_cast<std::size_t>(length), s.st_size - length);
  std::string text(tail, got > 0 ? static_cast<std::size_t>(got) : 0);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  for (char& c : text)
    if (std::iscntrl(static_cast<unsigned char>(c))) c = ' ';
  return text;
}

std::string describe_hang(const Caps& caps) {
  return "no answer within " + std::to_string(caps.call_cpu.count()) + " ms of CPU time or " +
         std::to_string(caps.call_wall.count()) + " ms in all";
}

/// "SIGABRT, after printing: ...", cut at the front of the printed text so that its end is kept.
std::string describe_death(int status, int output) {
  std::string how;
  if (WIFSIGNALED(status)) {
    const char* abbreviation = sigabbrev_np(WTERMSIG(status));
    how = abbreviation ? std::string("SIG") + abbreviation : "signal " + std::to_string(WTERMSIG(status));
  } else if (WEXITSTATUS(status) == exit_called_code) {
    how = "called exit()";
  } else {
    how = "ended its process with status " + std::to_string(WEXITSTATUS(status));
  }
  const std::string printed = last_output(output);
  if (printed.empty()) return how;
  how += ", after printing: ";
  const std::size_t room = sizeof MethodAnswer::reason - 1 - how.size();
  return how + (printed.size() > room ? printed.substr(printed.size() - room) : printed);
}

/// A batch of one would show no mix-up of pairs or lanes: before it goes this one, a wall beside a rim, with
/// which our kernel is busy for three steps.
const Pair company{{Vector3(0, 0, 0), Vector3(0, 0, 1), 5, 1}, {Vector3(-5, 5, 1), Vector3(1, -5, 1), 1, 10}};

}  // namespace

MethodAnswer put(Method& method, const Pair& pair, Way way) {
  switch (way) {
    case Way::usual:
      break;
    case Way::other_thread: {
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
    case Way::prepared: {
      const Method::Call call = method.prepare_all({&pair, 1});
      return call ? verdict_alone(call(0)) : has_no_such_way();
    }
    case Way::batch: {
      const Pair both[] = {company, pair};
      const Method::BatchCall call = method.prepare_batch(both);
      if (!call) return has_no_such_way();
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
  Board board(questions.size());
  const Descriptor output(memfd_create("worker output", MFD_CLOEXEC), "memfd_create");
  fcntl(output.get(), F_SETFL, O_APPEND);
  std::atomic<std::size_t>& cursor = board.cursor();

  while (cursor.load() < questions.size()) {
    if (ftruncate(output.get(), 0) != 0) throw_errno("ftruncate");
    std::fflush(nullptr);
    std::vector<unsigned> hangs(methods.size(), 0);
    for (std::size_t i = 0; i < cursor.load(); ++i)
      hangs[questions[i].method] += board.answers()[i].answer.failure == Failure::hang;
    const pid_t parent = getpid();
    const pid_t worker = patient_fork();
    if (worker < 0) throw_errno("fork");
    if (worker == 0) {
      become_worker(parent, output.get());
      for (std::size_t i = cursor.load(); i < questions.size(); cursor.store(++i)) {
        const nanoseconds start = read_clock(CLOCK_MONOTONIC);
        const Question& q = questions[i];
        const MethodAnswer answer =
            hangs[q.method] < caps.hangs ? ask(*methods[q.method], pairs[q.pair], q.way) : gave_up(caps);
        const nanoseconds end = read_clock(CLOCK_MONOTONIC);
        if (answer.failure == Failure::hang) ++hangs[q.method];  // of a program that the method runs
        board.answers()[i] = {answer, static_cast<double>((end - start).count())};
      }
      _exit(0);
    }

    std::optional<Kill> killed_for;
    try {
      killed_for = watch(worker, cursor, caps);
    } catch (...) {
      kill(worker, SIGKILL);
      reap(worker);
      throw;
    }
    const int status = reap(worker);
    const std::size_t i = cursor.load();
    if (i == questions.size()) break;
    // A call may end just before the kill meant for it: then no one is to blame, and the next worker goes on
    // at i.
    if (killed_for && killed_for->question != i) continue;
    if (killed_for) {
      board.answers()[i] = {failed(Failure::hang, describe_hang(caps)),
                            static_cast<double>(killed_for->wall.count())};
    } else {
      board.answers()[i] = {failed(Failure::crash, describe_death(status, output.get()))};
    }
    cursor.store(i + 1);
  }
  return {board.answers(), board.answers() + questions.size()};
}

}  // namespace cyl
