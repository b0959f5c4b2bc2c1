// SPDX-License-Identifier: MIT
#include "base/process/line_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <optional>
#include <sstream>
#include <utility>

namespace cyl {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// The interval at which a silent program is checked. A breach of its time cap is noticed at most this late.
constexpr milliseconds look_interval{20};

/// The time from the end of the program's output until it is ended.
constexpr milliseconds ending_cap{1000};

/// The cap on the bytes that it may print on standard error. They are kept in memory. Later bytes are lost.
constexpr rlim_t output_cap = rlim_t{16} << 20;

/// The bytes of its output that a reason shows, and the bytes in which an exception is searched for.
constexpr std::size_t shown_cap = 90, printed_cap = std::size_t{1} << 16;

/// While it lives, a write to a pipe without readers is an error of this thread, not a signal.
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

/// Writes as much as possible.
void write_text(int fd, const char* text) {
  if (write(fd, text, std::strlen(text)) < 0) return;
}

[[noreturn]] void become_shell(const char* command, const char* folder) {
  limit(RLIMIT_FSIZE, output_cap);
  write_text(open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC), "1000");
  if (chdir(folder) == 0) execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  write_text(STDERR_FILENO, "its folder or /bin/sh is gone");
  _exit(127);
}

/// Returns the last line that states the error. A traceback of Python ends with the exception. Node.js prints
/// the stack, which is indented, and its version after the exception.
std::string error_line(const std::string& printed) {
  std::istringstream lines(printed);
  std::string message;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != ' ' && !line.starts_with("Node.js v")) message = line;
  return message;
}

}  // namespace

LineProgram::LineProgram(const std::string& command, const std::string& folder) {
  int in[2] = {-1, -1}, out[2] = {-1, -1};
  printed_ = memfd_create("guest's standard error", MFD_CLOEXEC);
  try {
    if (printed_ < 0 || pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0)
      throw_errno("starting a program");
    fcntl(printed_, F_SETFL, O_APPEND);
    process_ = std::make_unique<SupervisedProcess>([&] { become_shell(command.c_str(), folder.c_str()); },
                                                   KeptDescriptors{in[0], out[1], printed_, {}});
  } catch (...) {
    close_all({in[0], in[1], out[0], out[1], printed_});
    throw;
  }
  close_all({in[0], out[1]});
  to_ = in[1], from_ = out[0];
  fcntl(to_, F_SETFL, O_NONBLOCK);
  fcntl(from_, F_SETFL, O_NONBLOCK);
}

LineProgram::~LineProgram() { close_all({to_, from_, printed_}); }

bool LineProgram::take_input() {
  char chunk[65536];
  const ssize_t got = read(from_, chunk, sizeof chunk);
  if (got > 0) incoming_.append(chunk, static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
}

bool LineProgram::has_answered_more() {
  take_input();
  return incoming_.size() > taken_;
}

void LineProgram::send(std::string_view text) { outgoing_ += text; }

LineProgram::Read LineProgram::receive(std::string& line, const Cap& cap) {
  const NoPipeSignal quiet;
  // If the answer has already arrived, no clock is read.
  std::optional<nanoseconds> cpu_start, wall_start;
  bool open = true;
  while (true) {
    if (const std::size_t end = incoming_.find('\n', taken_); end != incoming_.npos) {
      line.assign(incoming_, taken_, end - taken_);
      taken_ = end + 1;
      return line.size() > program_line_cap ? Read::too_long : Read::line;
    }
    incoming_.erase(0, std::exchange(taken_, 0));
    if (incoming_.size() > program_line_cap) return Read::too_long;
    if (!open) return Read::ended;
    if (!cpu_start) cpu_start = cpu_time(), wall_start = read_clock(CLOCK_MONOTONIC);
    pollfd ends[] = {{from_, POLLIN, 0}, {to_, POLLOUT, 0}};
    poll(ends, outgoing_.empty() ? 1 : 2, static_cast<int>(look_interval.count()));
    if (ends[0].revents != 0) open = take_input();
    if (ends[1].revents != 0 && !outgoing_.empty()) {
      const ssize_t sent = write(to_, outgoing_.data(), outgoing_.size());
      if (sent > 0) outgoing_.erase(0, static_cast<std::size_t>(sent));
      if (sent < 0 && errno == EPIPE) outgoing_.clear();  // its earlier output is still read to the end
    }
    if (cpu_time() - *cpu_start > cap.cpu) return Read::over_cpu_cap;
    if (read_clock(CLOCK_MONOTONIC) - *wall_start > cap.wall) return Read::over_wall_cap;
  }
}

std::string LineProgram::death() {
  // Its output ends a little before the process does. If the process goes on without output, it is ended.
  pollfd ended{process_->end(), POLLIN, 0};
  if (poll(&ended, 1, static_cast<int>(ending_cap.count())) <= 0) process_->kill_now();
  std::string how = "was ended";
  if (const auto& ending = process_->wait())
    how = WIFSIGNALED(ending->status) ? signal_name(WTERMSIG(ending->status))
                                      : "ended with status " + std::to_string(WEXITSTATUS(ending->status));
  std::string all(printed_cap, '\0');
  const ssize_t got = pread(printed_, all.data(), all.size(), 0);
  all.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  const std::string printed = error_line(all).substr(0, shown_cap);
  return printed.empty() ? how : how + ", after printing: " + printed;
}

}  // namespace cyl
