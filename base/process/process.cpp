// SPDX-License-Identifier: MIT
#include "base/process/process.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace cyl {
namespace {

constexpr int attempt_cap = 200;
constexpr timespec pause_between{0, 50'000'000};  // 50 ms

void put_in_place(const std::string& file, int flags, std::initializer_list<int> streams) {
  const int opened = open(file.c_str(), flags | O_CLOEXEC, 0666);
  if (opened < 0) throw_errno(file);
  for (const int stream : streams) dup2(opened, stream);
  close(opened);
}

}  // namespace

pid_t fork_with_retry() noexcept {
  pid_t process = fork();
  for (int attempt = 1; process < 0 && errno == EAGAIN && attempt < attempt_cap; ++attempt) {
    nanosleep(&pause_between, nullptr);
    process = fork();
  }
  return process;
}

void limit(decltype(RLIMIT_CORE) resource, rlim_t value) noexcept {
  rlimit r;
  getrlimit(resource, &r);
  r.rlim_cur = std::min(value, r.rlim_max);
  setrlimit(resource, &r);
}

std::chrono::nanoseconds read_clock(clockid_t clock) noexcept {
  timespec t{};
  clock_gettime(clock, &t);
  return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
}

std::chrono::nanoseconds cpu_time_of(pid_t process) noexcept {
  clockid_t clock;
  return clock_getcpuclockid(process, &clock) == 0 ? read_clock(clock) : std::chrono::nanoseconds(0);
}

std::chrono::nanoseconds cpu_time_of(const rusage& used) noexcept {
  return std::chrono::seconds(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         std::chrono::microseconds(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

std::chrono::nanoseconds cpu_time_of_tree(pid_t process) {
  std::chrono::nanoseconds sum = cpu_time_of(process);
  const std::string id = std::to_string(process);
  std::ifstream children("/proc/" + id + "/task/" + id + "/children");
  for (pid_t child; children >> child;) sum += cpu_time_of_tree(child);
  return sum;
}

ino_t pid_namespace() noexcept {
  struct stat names;
  return stat("/proc/self/ns/pid", &names) == 0 ? names.st_ino : 0;
}

int reap(pid_t child) noexcept {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void close_all(std::initializer_list<int> descriptors) noexcept {
  for (const int descriptor : descriptors)
    if (descriptor >= 0) close(descriptor);
}

void write_all(int descriptor, std::string_view bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(descriptor, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_errno("cannot hand over a result");
    done += static_cast<std::size_t>(written);
  }
}

void throw_errno(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

void redirect_streams(const std::string& input, const std::string& output) {
  put_in_place(input, O_RDONLY, {STDIN_FILENO});
  put_in_place(output, O_WRONLY | O_CREAT | O_APPEND, {STDOUT_FILENO, STDERR_FILENO});
}

void become_program(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words.front(), words.data());
  throw_errno(command.front());
}

std::string signal_name(int signal) {
  const char* name = sigabbrev_np(signal);
  return name ? std::string("SIG") + name : "signal " + std::to_string(signal);
}

std::string how_it_ended(int status) {
  if (!WIFSIGNALED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
  return "killed by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
}

std::string last_line(int descriptor, std::size_t cap) {
  struct stat s;
  if (fstat(descriptor, &s) != 0) return {};
  std::string text(std::min(cap, static_cast<std::size_t>(s.st_size)), '\0');
  const ssize_t got =
      pread(descriptor, text.data(), text.size(), s.st_size - static_cast<off_t>(text.size()));
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  for (char& c : text)
    if (std::iscntrl(static_cast<unsigned char>(c))) c = ' ';
  return text;
}

}  // namespace cyl
