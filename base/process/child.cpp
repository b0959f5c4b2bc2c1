// SPDX-License-Identifier: MIT
#include "base/process/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <system_error>

#include "base/process/process.hpp"

namespace cyl {
namespace {

void put_on_standard_input(const std::string& text) {
  const int file = memfd_create("standard input", MFD_CLOEXEC);
  if (file < 0) throw_errno("memfd_create");
  write_all(file, text);
  lseek(file, 0, SEEK_SET);
  dup2(file, STDIN_FILENO);
}

[[noreturn]] void run_as_child(pid_t parent, const ChildOptions& options, const std::function<void()>& run) {
  std::string failure;
  try {
    if (options.own_group) setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // the parent died before the line above
    if (options.own_group)
      for (const int stop : {SIGINT, SIGTERM}) std::signal(stop, SIG_DFL);
    run();
    _exit(0);
  } catch (const std::exception& error) {
    failure = error.what();
  } catch (...) {
    failure = "an exception of no known type";
  }
  failure = "daylight: " + options.failure + ": " + failure + '\n';
  [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, failure.data(), failure.size());
  _exit(1);
}

}  // namespace

Child::Child(const std::function<std::string()>& work, const ChildOptions& options) {
  start([&](int output) { write_all(output, work()); }, options);
}

Child::Child(const std::function<void(int output)>& work, const ChildOptions& options) {
  start(work, options);
}

Child::Child(const std::vector<std::string>& command, const ChildOptions& options) {
  const auto run = [&](int output) {
    dup2(output, STDOUT_FILENO);
    if (!options.input.empty()) put_on_standard_input(options.input);
    become_program(command);
  };
  start(run, options);
}

void Child::start(const std::function<void(int output)>& run, const ChildOptions& options) {
  own_group_ = options.own_group;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw_errno("pipe");
  std::fflush(nullptr);  // or the child might print it once more
  const pid_t parent = getpid();
  process_ = fork_with_retry();
  if (process_ == 0) run_as_child(parent, options, [&] { run(ends[1]); });
  const int error = errno;
  close(ends[1]);
  if (process_ < 0) {
    close(ends[0]);
    throw std::system_error(error, std::generic_category(), "fork");
  }
  output_ = ends[0];
  if (own_group_) setpgid(process_, process_);  // on both sides, because either may run first
  fcntl(output_, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  kill_now();
  if (!ended_) reap(process_);
  close_all({output_, end_});
}

bool Child::advance() {
  if (ended_) return true;
  siginfo_t end{};
  const bool gone = waitid(P_PID, static_cast<id_t>(process_), &end, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                    end.si_pid == process_;
  char part[65536];
  for (ssize_t got = 1; got > 0 || (got < 0 && errno == EINTR);) {
    got = read(output_, part, sizeof part);
    if (got > 0) bytes_.append(part, static_cast<std::size_t>(got));
    output_ended_ = got == 0;
  }
  if (!gone) return false;
  // Kills the processes that it left. Until it is reaped, no other group can have its number.
  if (own_group_) kill(-process_, SIGKILL);
  rusage used{};
  wait4(process_, &status_, 0, &used);
  cpu_time_ = cpu_time_of(used);
  return ended_ = true;
}

int Child::wait() {
  while (!advance()) {
    pollfd news[] = {{end(), POLLIN, 0}, {output_ended_ ? -1 : output_, POLLIN, 0}};
    poll(news, 2, -1);
  }
  return status_;
}

int Child::end() {
  if (end_ < 0) end_ = static_cast<int>(syscall(SYS_pidfd_open, process_, 0));
  if (end_ < 0) throw_errno("pidfd_open");
  return end_;
}

std::chrono::nanoseconds Child::cpu_time() const { return ended_ ? cpu_time_ : cpu_time_of(process_); }

void Child::kill_now() {
  if (!ended_) kill(own_group_ ? -process_ : process_, SIGKILL);
}

void Child::send(int signal) const {
  if (!ended_) kill(process_, signal);
}

}  // namespace cyl
