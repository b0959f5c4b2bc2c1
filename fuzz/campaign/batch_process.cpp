// SPDX-License-Identifier: MIT
#include "fuzz/campaign/batch_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/process/fork_with_retry.hpp"
#include "corpus/store/batch_text.hpp"

namespace cyl {
namespace {

void write_all(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(descriptor, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0)
      throw std::system_error(errno, std::generic_category(), "cannot send a batch to the campaign");
    done += static_cast<std::size_t>(written);
  }
}

// A limit of the process itself would be inherited by the contained workers and blamed on whom they happen to
// ask.
std::chrono::seconds cpu_time_of(pid_t process) {
  clockid_t clock;
  timespec used{};
  if (clock_getcpuclockid(process, &clock) == 0) clock_gettime(clock, &used);
  return std::chrono::seconds(used.tv_sec);
}

[[noreturn]] void run_child(int descriptor, pid_t parent, const std::function<void(int)>& work) {
  int code = 1;
  try {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // it died before the line above
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    work(descriptor);
    code = 0;
  } catch (const std::exception& e) {
    const std::string line = fmt::format("daylight: a batch failed: {}\n", e.what());
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, line.data(), line.size());
  } catch (...) {
    constexpr std::string_view line = "daylight: a batch failed: an exception of no known type\n";
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, line.data(), line.size());
  }
  _exit(code);
}

/// Its standard output goes to the descriptor.
void become(const std::vector<std::string>& command, int descriptor) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  dup2(descriptor, STDOUT_FILENO);
  execv(words.front(), words.data());
  throw std::system_error(errno, std::generic_category(), command.front());
}

std::chrono::milliseconds milliseconds_of(const timeval& time) {
  return std::chrono::milliseconds(time.tv_sec * 1000 + time.tv_usec / 1000);
}

}  // namespace

Flight::Flight(std::uint64_t first, std::uint64_t next, const std::function<BatchRecord()>& make,
               std::chrono::seconds cpu_cap)
    : first_(first), next_(next), cpu_cap_(cpu_cap) {
  launch([&](int descriptor) { write_all(descriptor, format_batch(make())); });
}

Flight::Flight(std::uint64_t first, std::uint64_t next, const std::vector<std::string>& command,
               std::chrono::seconds cpu_cap)
    : first_(first), next_(next), cpu_cap_(cpu_cap) {
  launch([&](int descriptor) { become(command, descriptor); });
}

void Flight::launch(const std::function<void(int descriptor)>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t parent = getpid();
  process_ = patient_fork();
  if (process_ == 0) run_child(ends[1], parent, work);
  close(ends[1]);
  descriptor_ = ends[0];
  if (process_ < 0) {
    close(descriptor_);
    throw std::system_error(errno, std::generic_category(), "fork");
  }
  setpgid(process_, process_);  // on both sides: whichever runs first
  fcntl(descriptor_, F_SETFL, O_NONBLOCK);
}

Flight::Flight(Flight&& other) noexcept
    : first_(other.first_),
      next_(other.next_),
      cpu_cap_(other.cpu_cap_),
      process_(std::exchange(other.process_, -1)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      ended_(other.ended_),
      over_cap_(other.over_cap_),
      status_(other.status_),
      cpu_time_(other.cpu_time_),
      received_(std::move(other.received_)) {}

Flight::~Flight() {
  if (process_ > 0 && !ended_) {
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  if (descriptor_ >= 0) close(descriptor_);
}

// The end of the process counts, not the end of the pipe: a contained worker that outlives it may hold the
// pipe open.
bool Flight::advance() {
  if (ended_) return true;
  rusage used{};
  const bool gone = wait4(process_, &status_, WNOHANG, &used) == process_;
  char buffer[65536];
  for (;;) {
    const ssize_t count = read(descriptor_, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    received_.append(buffer, static_cast<std::size_t>(count));
  }
  if (gone) {
    cpu_time_ = milliseconds_of(used.ru_utime) + milliseconds_of(used.ru_stime);
    kill(-process_, SIGKILL);  // its workers, if it left any
  } else if (cpu_time_of(process_) > cpu_cap_) {
    over_cap_ = true;
    kill(-process_, SIGKILL);
  }
  return ended_ = gone;
}

BatchRecord Flight::take() const {
  if (over_cap_) {
    throw std::runtime_error(fmt::format("no end after {} s of CPU time", cpu_cap_.count()));
  }
  if (WIFSIGNALED(status_)) {
    throw std::runtime_error(
        fmt::format("killed by signal {} ({})", WTERMSIG(status_), strsignal(WTERMSIG(status_))));
  }
  if (WEXITSTATUS(status_) != 0) throw std::runtime_error(fmt::format("exit code {}", WEXITSTATUS(status_)));
  BatchRecord batch = parse_batch(received_);
  batch.first = first_;
  batch.next = next_;
  return batch;
}

}  // namespace cyl
