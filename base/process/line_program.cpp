// SPDX-License-Identifier: MIT
#include "base/process/line_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <system_error>
#include <utility>

#include "base/process/process.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// How often a silent program is looked at: its time cap is noticed at most this late.
constexpr milliseconds look_interval{20};

/// From the end of its output on, until it is ended.
constexpr milliseconds ending_cap{1000};

/// Bytes that it may print on standard error, kept in memory; what comes after is lost.
constexpr rlim_t output_cap = rlim_t{16} << 20;

/// Bytes of what it printed that a reason shows.
constexpr std::size_t shown_cap = 90;

/// While it lives, writing to a pipe that nobody reads is an error of this thread, no signal.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoPipeSignal() {
    const timespec now{};
    if (!sigismember(&before_, SIGPIPE)) {
      while (sigtimedwait(&pipe_, nullptr, &now) < 0 && errno == EINTR) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  sigset_t pipe_, before_;
};

// From here to the end of watch(): between fork and exec, maybe of a process with threads. Nothing but system
// calls.

/// As far as it can be.
void write_text(int fd, const char* text) {
  if (write(fd, text, std::strlen(text)) < 0) return;
}

[[noreturn]] void become_shell(const char* command, const char* folder, int in, int out, int error) {
  setpgid(0, 0);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(error, STDERR_FILENO);
  for (int s = 1; s < NSIG; ++s) std::signal(s, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, output_cap);
  limit(RLIMIT_AS, RLIM_INFINITY);  // a worker's cap is not for engines that reserve what they never touch
  write_text(open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC), "1000");
  if (chdir(folder) == 0) execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  write_text(STDERR_FILENO, "its folder or /bin/sh is gone");
  _exit(127);
}

/// Starts the program, reports its number, and waits until it ends or until nobody holds the other end of
/// `life` any more; then ends what is left of its group and reports how it ended.
[[noreturn]] void watch(const char* command, const char* folder, int in, int out, int error, int life,
                        int report) {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  const pid_t program = fork_with_retry();
  if (program == 0) become_shell(command, folder, in, out, error);
  if (program < 0 || write(report, &program, sizeof program) < 0) _exit(1);
  setpgid(program, program);
  const int ended = static_cast<int>(syscall(SYS_pidfd_open, program, 0));
  if (ended < 0) kill(program, SIGKILL);
  // Ends that belong to others must close when those close them.
  dup2(life, 0);
  dup2(report, 1);
  dup2(ended, 2);
  close_range(3, ~0u, 0);
  pollfd either[] = {{0, POLLIN, 0}, {2, POLLIN, 0}};
  while (poll(either, 2, -1) < 0 && errno == EINTR) {
  }
  if (either[1].revents == 0) kill(program, SIGKILL);
  const int status = reap(program);
  kill(-program, SIGKILL);
  _exit(write(1, &status, sizeof status) < 0);
}

bool read_whole(int fd, void* to, std::size_t size) {
  ssize_t got = 0;
  while ((got = read(fd, to, size)) < 0 && errno == EINTR) {
  }
  return got == static_cast<ssize_t>(size);
}

}  // namespace

LineProgram::LineProgram(const std::string& command, const std::string& folder) : owner_(getpid()) {
  int in[2] = {-1, -1}, out[2] = {-1, -1}, life[2] = {-1, -1}, report[2] = {-1, -1};
  answers_ = memfd_create("guest's standard error", MFD_CLOEXEC);
  const bool made = answers_ >= 0 && pipe2(in, O_CLOEXEC) == 0 && pipe2(out, O_CLOEXEC) == 0 &&
                    pipe2(life, O_CLOEXEC) == 0 && pipe2(report, O_CLOEXEC) == 0;
  if (made) {
    fcntl(answers_, F_SETFL, O_APPEND);
    fcntl(in[1], F_SETFL, O_NONBLOCK);
    fcntl(out[0], F_SETFL, O_NONBLOCK);
    watchdog_ = fork_with_retry();
    if (watchdog_ == 0) {
      close_all({in[1], out[0], life[1], report[0]});
      watch(command.c_str(), folder.c_str(), in[0], out[1], answers_, life[0], report[1]);
    }
  }
  const int error = errno;
  to_ = in[1], from_ = out[0], pipe_ = life[1], report_ = report[0];
  close_all({in[0], out[1], life[0], report[1]});
  if (watchdog_ >= 0 && read_whole(report_, &program_, sizeof program_)) return;
  close_all({to_, from_, pipe_, report_, answers_});
  if (watchdog_ >= 0) reap(watchdog_);
  errno = made && watchdog_ >= 0 ? EAGAIN : error;
  throw_errno("starting a program");
}

LineProgram::~LineProgram() {
  close_all({to_, from_, pipe_, report_, answers_});
  if (ours()) reap(watchdog_);
}

bool LineProgram::ours() const { return getpid() == owner_; }

bool LineProgram::take_input() {
  char chunk[4096];
  const ssize_t got = read(from_, chunk, sizeof chunk);
  if (got > 0) buffer_.append(chunk, static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
}

bool LineProgram::has_answered_more() {
  take_input();
  return !buffer_.empty();
}

LineProgram::Read LineProgram::exchange(std::string_view text, std::string& line, const Cap& cap) {
  const NoPipeSignal quiet;
  const nanoseconds cpu_start = cpu_time_of(program_), wall_start = read_clock(CLOCK_MONOTONIC);
  bool open = true;
  while (true) {
    if (const std::size_t end = buffer_.find('\n'); end != buffer_.npos) {
      line.assign(buffer_, 0, end);
      buffer_.erase(0, end + 1);
      return line.size() > program_line_cap ? Read::too_long : Read::line;
    }
    if (buffer_.size() > program_line_cap) return Read::too_long;
    if (!open) return Read::ended;
    pollfd ends[] = {{from_, POLLIN, 0}, {to_, POLLOUT, 0}};
    poll(ends, text.empty() ? 1 : 2, static_cast<int>(look_interval.count()));
    if (ends[0].revents != 0) open = take_input();
    if (ends[1].revents != 0 && !text.empty()) {
      const ssize_t sent = write(to_, text.data(), text.size());
      if (sent > 0) text.remove_prefix(static_cast<std::size_t>(sent));
      if (sent < 0 && errno == EPIPE) text = {};  // what it has said already is read to its end
    }
    if (cpu_time_of(program_) - cpu_start > cap.cpu || read_clock(CLOCK_MONOTONIC) - wall_start > cap.wall)
      return Read::late;
  }
}

std::string LineProgram::death() {
  // Its output ends a little before it does, or without it: then it is ended.
  pollfd reported{report_, POLLIN, 0};
  poll(&reported, 1, static_cast<int>(ending_cap.count()));
  close_all({std::exchange(to_, -1), std::exchange(pipe_, -1)});
  int status = 0;
  std::string how = "ended";
  if (read_whole(report_, &status, sizeof status))
    how = WIFSIGNALED(status) ? signal_name(WTERMSIG(status))
                              : "ended with status " + std::to_string(WEXITSTATUS(status));
  const std::string printed = last_line(answers_, shown_cap);
  return printed.empty() ? how : how + ", after printing: " + printed;
}

}  // namespace cyl
