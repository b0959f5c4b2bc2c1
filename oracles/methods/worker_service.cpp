// SPDX-License-Identifier: MIT
#include "oracles/methods/worker_service.hpp"

#include <pthread.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <regex>
#include <string>
#include <vector>

#include "base/process/confine.hpp"
#include "base/process/control_words.hpp"
#include "base/process/process.hpp"
#include "oracles/methods/contained.hpp"

namespace cyl {
namespace {

using std::chrono::nanoseconds;

/// The bytes that a worker may use beyond its memory at the fork. A leak in foreign code then ends in
/// std::bad_alloc or a crash of the worker, and the machine's out-of-memory killer has no cause to act.
constexpr rlim_t memory_cap = rlim_t{2} << 30;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer);
#else
constexpr bool sanitized = false;
#endif

rlim_t address_space_now() {
  unsigned long pages = 0;
  if (std::FILE* f = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(f, "%lu", &pages) != 1) pages = 0;
    std::fclose(f);
  }
  return rlim_t{pages} * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// The number of threads of this process.
nlink_t count_threads() {
  struct stat s {};
  return stat("/proc/self/task", &s) == 0 ? s.st_nlink : 0;
}

// Terminals and batch systems send some signals to all processes. The parent handles these signals.
// Otherwise the method that is asked at that moment would be blamed for them.
void become_worker() {
  for (int s : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXFSZ}) std::signal(s, SIG_IGN);
  limit(RLIMIT_FSIZE, output_cap);
  if (!sanitized) limit(RLIMIT_AS, address_space_now() + memory_cap);
  std::setvbuf(stdout, nullptr, _IONBF, 0);
  // Handlers run last in, first out. exit() in foreign code must not run the handlers of the parent, which
  // may remove its files.
  std::atexit([] { _exit(exit_called_code); });
}

sigjmp_buf call_start;
pthread_t asking_thread;
volatile std::sig_atomic_t asking = 0;

// glibc's abort() releases its lock before it raises the signal, so a handler may jump.
void on_abort(int) {
  if (asking && pthread_equal(pthread_self(), asking_thread)) siglongjmp(call_start, 1);
  std::signal(SIGABRT, SIG_DFL);
  std::raise(SIGABRT);  // takes effect after this handler returns
}

/// Returns whether the last words come from an assertion or from ODE's error handler. Messages of a damaged
/// heap do not count, because the process must not go on after them. Allocates nothing.
bool is_assertion(int output) {
  char text[512] = {};
  struct stat s;
  if (fstat(output, &s) != 0) return false;
  const off_t from = std::max<off_t>(0, s.st_size - static_cast<off_t>(sizeof text) + 1);
  if (pread(output, text, sizeof text - 1, from) <= 0) return false;
  return std::strstr(text, "Assertion `") || std::strstr(text, "ODE INTERNAL ERROR");
}

[[noreturn]] void end_by_abort() {
  std::signal(SIGABRT, SIG_DFL);
  std::abort();
}

/// The bytes at the end of a worker's output in which a file and line are searched for.
constexpr std::size_t last_words_cap = 2000;

/// Returns the end of the output that fits, after the file and line in it, in the form that assert() prints.
std::string fitting(const std::string& printed, std::size_t room) {
  if (printed.size() <= room) return printed;
  static const std::regex file_and_line(R"([^\s/:]+:\d+)");
  std::smatch found;
  std::string place;
  if (std::regex_search(printed, found, file_and_line) && found.length() < static_cast<long>(room / 2))
    place = found.str() + " .. ";
  return place + printed.substr(printed.size() - (room - place.size()));
}

/// Asks as ask_noexcept() does. If the library keeps no state between calls (Method::recovers), its failed
/// assertion is a crash as an answer, with the text of the death of a process. Every other
/// abort ends the process, as do assertions beyond `recovery_cap`. The text is taken from standard error,
/// which must be a file that can be truncated.
MethodAnswer ask_recovering(Method& method, const Pair& pair, CallMode mode) {
  static int recovered = 0;
  if (!method.recovers() || recovered >= recovery_cap) return ask_noexcept(method, pair, mode);
  // The handler is installed once, because a call of some hundred nanoseconds affords no system call. For
  // the same reason the signal mask is not saved. It is repaired after a jump.
  [[maybe_unused]] static const auto installed = std::signal(SIGABRT, on_abort);
  asking_thread = pthread_self();
  if (sigsetjmp(call_start, 0) != 0) {
    asking = 0;
    sigset_t abort_alone;
    sigemptyset(&abort_alone);
    sigaddset(&abort_alone, SIGABRT);
    sigprocmask(SIG_UNBLOCK, &abort_alone, nullptr);
    if (!is_assertion(STDERR_FILENO)) end_by_abort();
    ++recovered;
    const std::string reason = with_last_words("SIGABRT", STDERR_FILENO);
    if (ftruncate(STDERR_FILENO, 0) != 0) end_by_abort();
    return failed_answer(Failure::crash, reason);
  }
  asking = 1;
  const MethodAnswer answer = ask_noexcept(method, pair, mode);
  asking = 0;
  return answer;
}

/// The inside of a worker.
class Service {
 public:
  Service(std::span<const std::unique_ptr<Method>> methods, const RequestBlock& asked, ResponseBlock& said)
      : methods_(methods),
        asked_(asked),
        said_(said),
        words_(read_control_words()),
        threads_(count_threads()) {}

  void run(int go, int done) {
    while (true) {
      std::uint64_t wakes;
      if (read(go, &wakes, sizeof wakes) < 0) {
        if (errno == EINTR) continue;
        return;
      }
      const std::uint64_t number = asked_.number.load();
      if (number == said_.number.load()) continue;
      initialize();
      said_.begun.store(number);
      answer_block();
      said_.number.store(number);
      const std::uint64_t one = 1;
      if (write(done, &one, sizeof one) < 0 && errno != EAGAIN) return;
    }
  }

 private:
  /// Threads that exist after this are not counted as side effects.
  void initialize() {
    for (std::size_t i = 0; i < asked_.count; ++i) {
      const std::size_t m = asked_.questions[i].method;
      if (ready_.size() <= m) ready_.resize(methods_.size(), false);
      if (ready_[m]) continue;
      ready_[m] = true;
      try {
        methods_[m]->initialize();
      } catch (...) {  // ask() will report it
      }
      write_control_words(words_);
      threads_ = count_threads();
    }
  }

  void answer_block() {
    for (std::size_t first = said_.cursor.load(); first < asked_.count;) {
      const Question& q = asked_.questions[first];
      std::size_t end = first + 1;
      while (end < asked_.count && asked_.questions[end].method == q.method &&
             asked_.questions[end].run == q.run && asked_.questions[end].mode == q.mode)
        ++end;
      // To read the CPU clock takes a system call, to read the other clock takes none.
      const clockid_t clock = end - first > 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
      const nanoseconds start = read_clock(clock);
      fault_of_many_ = {};
      if (!answer_many(first, end)) {
        for (std::size_t i = first; i < end; said_.cursor.store(++i)) answer(i);
        blame_one_call(first, end);
      }
      said_.cursor.store(end);
      const double each =
          static_cast<double>((read_clock(clock) - start).count()) / static_cast<double>(end - first);
      for (std::size_t i = first; i < end; ++i) said_.answers[i].nanoseconds = each;
      first = end;
    }
    if (const nlink_t threads = count_threads(); threads > threads_) {
      threads_ = threads;
      said_.answers[asked_.count - 1].answer.note(SideEffect::thread, "left a thread running");
    }
  }

  /// A fault of the call for many pairs that no single call shows goes to the first of them.
  void blame_one_call(std::size_t first, std::size_t end) {
    if (fault_of_many_.status != Status::failed && fault_of_many_.side_effect == SideEffect::none) return;
    for (std::size_t i = first; i < end; ++i) {
      const MethodAnswer& single = said_.answers[i].answer;
      if (single.status == Status::failed || single.side_effect != SideEffect::none) return;
    }
    MethodAnswer& blamed = said_.answers[first].answer;
    const std::string reason = "in one call for many pairs: " + std::string(fault_of_many_.reason);
    if (fault_of_many_.status == Status::failed)
      blamed = failed_answer(fault_of_many_.failure, reason);
    else
      blamed.note(fault_of_many_.side_effect, reason);
  }

  /// Asks in one call. Returns whether that was possible and without side effects. The question that causes
  /// a side effect would not be known.
  bool answer_many(std::size_t first, std::size_t end) {
    const Question& q = asked_.questions[first];
    Method& method = *methods_[q.method];
    if (asked_.one_by_one || q.mode != CallMode::usual || !method.has_batch_call()) return false;
    const auto pairs = std::span(asked_.pairs).subspan(first, end - first);
    answers_.assign(pairs.size(), {});
    try {
      if (method.ask_many(pairs, answers_) != pairs.size()) return false;
    } catch (const std::exception& error) {
      fault_of_many_ = failed_answer(Failure::exception, error.what());
      return false;
    } catch (...) {
      fault_of_many_ = failed_answer(Failure::exception, "not a std::exception");
      return false;
    }
    const ControlWords left = read_control_words();
    if (left != words_) fault_of_many_.note(SideEffect::rounding_mode, describe_change(words_, left));
    write_control_words(words_);
    for (const MethodAnswer& answer : answers_)
      if (answer.side_effect != SideEffect::none) fault_of_many_.note(answer.side_effect, answer.reason);
    const bool quiet = fault_of_many_.side_effect == SideEffect::none;
    for (std::size_t i = first; i < end && quiet; ++i) said_.answers[i].answer = checked(answers_[i - first]);
    return quiet;
  }

  void answer(std::size_t i) {
    const Question& q = asked_.questions[i];
    MethodAnswer answer = ask_recovering(*methods_[q.method], asked_.pairs[q.pair], q.mode);
    if (const ControlWords left = read_control_words(); left != words_) {
      if (answer.failure != Failure::crash)
        answer.note(SideEffect::rounding_mode, describe_change(words_, left));
      write_control_words(words_);
    }
    said_.answers[i].answer = answer;
  }

  std::span<const std::unique_ptr<Method>> methods_;
  const RequestBlock& asked_;
  ResponseBlock& said_;
  const ControlWords words_;
  nlink_t threads_;
  std::vector<bool> ready_;  ///< by method
  std::vector<MethodAnswer> answers_;
  MethodAnswer fault_of_many_;  ///< of the last call for many pairs: a failure or a side effect
};

}  // namespace

std::string with_last_words(const std::string& how, int output) {
  // If it printed too much, the end is not known.
  const bool whole = lseek(output, 0, SEEK_END) < output_cap;
  const std::string printed = whole ? last_line(output, last_words_cap) : std::string();
  if (printed.empty()) return how;
  const std::string start = how + ", after printing: ";
  return start + fitting(printed, sizeof MethodAnswer::reason - 1 - start.size());
}

void answer_blocks(std::span<const std::unique_ptr<Method>> methods, bool confined, const RequestBlock& asked,
                   ResponseBlock& said, int go, int done) {
  become_worker();
  if (confined) confine(said.denied);
  Service(methods, asked, said).run(go, done);
}

}  // namespace cyl
