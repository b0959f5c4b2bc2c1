// SPDX-License-Identifier: MIT
#include "base/process/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <system_error>
#include <utility>

#include "base/process/fork_with_retry.hpp"

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
constexpr off_t shown_cap = 90;

void close_all(std::initializer_list<int> descriptors) {
  for (const int fd : descriptors)
    if (fd >= 0) close(fd);
}

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

nanoseconds read_clock(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return std::chrono::seconds(t.tv_sec) + nanoseconds(t.tv_nsec);
}

/// Of a process that may have ended: then nothing.
nanoseconds cpu_of(pid_t process) {
  clockid_t clock;
  return clock_getcpuclockid(process, &clock) == 0 ? read_clock(clock) : nanoseconds(0);
}

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

// From here to the end of keep(): between fork and exec, maybe of a process with threads. Nothing but system
// calls.

void limit(decltype(RLIMIT_CORE) resource, rlim_t value) {
  rlimit r;
  getrlimit(resource, &r);
  r.rlim_cur = std::min(value, r.rlim_max);
  setrlimit(resource, &r);
}

/// As far as it can be.
void write_text(int fd, const char* text) {
  if (write(fd, text, std::strlen(text)) < 0) return;
}

[[noreturn]] void become_program(const char* command, const char* folder, int in, int out, int said) {
  setpgid(0, 0);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(said, STDERR_FILENO);
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
[[noreturn]] void keep(const char* command, const char* folder, int in, int out, int said, int life,
                       int report) {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  const pid_t program = patient_fork();
  if (program == 0) become_program(command, folder, in, out, said);
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
  int status = 0;
  while (waitpid(program, &status, 0) < 0 && errno == EINTR) {
  }
  kill(-program, SIGKILL);
  _exit(write(1, &status, sizeof status) < 0);
}

bool read_whole(int fd, void* to, std::size_t size) {
  ssize_t got = 0;
  while ((got = read(fd, to, size)) < 0 && errno == EINTR) {
  }
  return got == static_cast<ssize_t>(size);
}

std::string end_of(int said) {
  struct stat s;
  if (fstat(said, &s) != 0) return {};
  char tail[shown_cap];
  const off_t length = std::min<off_t>(s.st_size, shown_cap);
  const ssize_t got = pread(said, tail, static_cast<std::size_t>(length), s.st_size - length);
  std::string text(tail, got > 0 ? static_cast<std::size_t>(got) : 0);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  for (char& c : text)
    if (std::iscntrl(static_cast<unsigned char>(c))) c = ' ';
  return text;
}

}  // namespace

Child::Child(const std::string& command, const std::string& folder) : owner_(getpid()) {
  int in[2] = {-1, -1}, out[2] = {-1, -1}, life[2] = {-1, -1}, report[2] = {-1, -1};
  said_ = memfd_create("guest's standard error", MFD_CLOEXEC);
  const bool made = said_ >= 0 && pipe2(in, O_CLOEXEC) == 0 && pipe2(out, O_CLOEXEC) == 0 &&
                    pipe2(life, O_CLOEXEC) == 0 && pipe2(report, O_CLOEXEC) == 0;
  if (made) {
    fcntl(said_, F_SETFL, O_APPEND);
    fcntl(in[1], F_SETFL, O_NONBLOCK);
    fcntl(out[0], F_SETFL, O_NONBLOCK);
    keeper_ = patient_fork();
    if (keeper_ == 0) {
      close_all({in[1], out[0], life[1], report[0]});
      keep(command.c_str(), folder.c_str(), in[0], out[1], said_, life[0], report[1]);
    }
  }
  const int error = errno;
  to_ = in[1], from_ = out[0], life_ = life[1], report_ = report[0];
  close_all({in[0], out[1], life[0], report[1]});
  if (keeper_ >= 0 && read_whole(report_, &child_, sizeof child_)) return;
  close_all({to_, from_, life_, report_, said_});
  if (keeper_ >= 0) waitpid(keeper_, nullptr, 0);
  errno = made && keeper_ >= 0 ? EAGAIN : error;
  throw_errno("starting a program");
}

Child::~Child() {
  close_all({to_, from_, life_, report_, said_});
  while (ours() && waitpid(keeper_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool Child::ours() const { return getpid() == owner_; }

bool Child::take_input() {
  char chunk[4096];
  const ssize_t got = read(from_, chunk, sizeof chunk);
  if (got > 0) buffer_.append(chunk, static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
}

bool Child::has_said_more() {
  take_input();
  return !buffer_.empty();
}

Child::Read Child::exchange(std::string_view text, std::string& line, const Cap& cap) {
  const NoPipeSignal quiet;
  const nanoseconds cpu_start = cpu_of(child_), wall_start = read_clock(CLOCK_MONOTONIC);
  bool open = true;
  while (true) {
    if (const std::size_t end = buffer_.find('\n'); end != buffer_.npos) {
      line.assign(buffer_, 0, end);
      buffer_.erase(0, end + 1);
      return line.size() > child_line_cap ? Read::too_long : Read::line;
    }
    if (buffer_.size() > child_line_cap) return Read::too_long;
    if (!open) return Read::ended;
    pollfd ends[] = {{from_, POLLIN, 0}, {to_, POLLOUT, 0}};
    poll(ends, text.empty() ? 1 : 2, static_cast<int>(look_interval.count()));
    if (ends[0].revents != 0) open = take_input();
    if (ends[1].revents != 0 && !text.empty()) {
      const ssize_t sent = write(to_, text.data(), text.size());
      if (sent > 0) text.remove_prefix(static_cast<std::size_t>(sent));
      if (sent < 0 && errno == EPIPE) text = {};  // what it has said already is read to its end
    }
    if (cpu_of(child_) - cpu_start > cap.cpu || read_clock(CLOCK_MONOTONIC) - wall_start > cap.wall)
      return Read::late;
  }
}

std::string Child::death() {
  // Its output ends a little before it does, or without it: then it is ended.
  pollfd reported{report_, POLLIN, 0};
  poll(&reported, 1, static_cast<int>(ending_cap.count()));
  close_all({std::exchange(to_, -1), std::exchange(life_, -1)});
  int status = 0;
  std::string how = "ended";
  if (read_whole(report_, &status, sizeof status)) {
    if (WIFSIGNALED(status)) {
      const char* name = sigabbrev_np(WTERMSIG(status));
      how = name ? std::string("SIG") + name : "signal " + std::to_string(WTERMSIG(status));
    } else {
      how = "ended with status " + std::to_string(WEXITSTATUS(status));
    }
  }
  const std::string printed = end_of(said_);
  return printed.empty() ? how : how + ", after printing: " + printed;
}

}  // namespace cyl
