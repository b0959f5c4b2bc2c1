// SPDX-License-Identifier: MIT
#include "base/process/worker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "base/process/fork_with_retry.hpp"

namespace cyl {
namespace {

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

[[noreturn]] void become(const std::vector<std::string>& command, const std::string& log,
                         const std::string& ledger, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(cannot_run_code);  // it died before the line above
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  const int in = open("/dev/null", O_RDONLY);
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (in < 0 || out < 0) _exit(cannot_run_code);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  unsetenv("DAYLIGHT_FUZZ_ABORT");
  if (ledger.empty())
    unsetenv("DAYLIGHT_FUZZ_OUT");
  else
    setenv("DAYLIGHT_FUZZ_OUT", ledger.c_str(), 1);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(words[0], words.data());
  const std::string line = fmt::format("cannot run {}: {}\n", command[0], std::strerror(errno));
  [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, line.data(), line.size());
  _exit(cannot_run_code);
}

}  // namespace

Worker::Worker(const std::vector<std::string>& command, const std::string& log, const std::string& ledger) {
  const pid_t parent = getpid();
  process_ = patient_fork();
  if (process_ == 0) become(command, log, ledger, parent);
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  setpgid(process_, process_);  // on both sides: whichever runs first
}

Worker::~Worker() {
  kill_now();
  if (!status_) waitpid(process_, nullptr, 0);
}

std::optional<int> Worker::ended() {
  int status = 0;
  rusage used{};
  if (!status_ && wait4(process_, &status, WNOHANG, &used) == process_) {
    status_ = status;
    cpu_seconds_ = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
    kill(-process_, SIGKILL);  // its children, if it left any
  }
  return status_;
}

double Worker::cpu_seconds() {
  clockid_t clock;
  timespec used{};
  if (!ended() && clock_getcpuclockid(process_, &clock) == 0 && clock_gettime(clock, &used) == 0)
    cpu_seconds_ = static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  return cpu_seconds_;
}

void Worker::ask_to_end() {
  if (!status_) kill(process_, SIGUSR1);
}

void Worker::kill_now() {
  if (!status_) kill(-process_, SIGKILL);
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("exit code {}", WEXITSTATUS(status));
}

}  // namespace cyl
