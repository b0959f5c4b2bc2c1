// SPDX-License-Identifier: MIT
#include "oracles/methods/abort_recovery.hpp"

#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csetjmp>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <string>

#include "base/process/process.hpp"
#include "oracles/methods/ask_noexcept.hpp"
#include "oracles/methods/worker_service.hpp"

namespace cyl {
namespace {

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

}  // namespace

std::string with_last_words(const std::string& how, int output) {
  // If it printed too much, the end is not known.
  const bool whole = lseek(output, 0, SEEK_END) < output_cap;
  const std::string printed = whole ? last_line(output, last_words_cap) : std::string();
  if (printed.empty()) return how;
  const std::string start = how + ", after printing: ";
  return start + fitting(printed, sizeof MethodAnswer::reason - 1 - start.size());
}

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

}  // namespace cyl
