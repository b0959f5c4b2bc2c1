// SPDX-License-Identifier: MIT
#include "base/process/supervised_process.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/process/process.hpp"

namespace cyl {
namespace {

void close_all_but(std::vector<int> kept) {
  std::sort(kept.begin(), kept.end());
  unsigned from = STDERR_FILENO + 1;
  for (const int descriptor : kept) {
    const auto at = static_cast<unsigned>(descriptor);
    if (descriptor <= STDERR_FILENO) continue;
    if (at > from) close_range(from, at - 1, 0);
    from = at + 1;
  }
  close_range(from, ~0u, 0);
}

void set_streams(int input, int output, int error) {
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  const int wanted[] = {input, output, error};
  for (int stream = 0; stream < 3; ++stream) dup2(wanted[stream] < 0 ? nothing : wanted[stream], stream);
}

void write_file_once(const char* file, const char* text) {
  const int at = open(file, O_WRONLY | O_CLOEXEC);
  if (at >= 0 && write(at, text, std::strlen(text)) < 0) errno = 0;  // continues with the rights that it has
  close_all({at});
}

/// Continues in a child, as the first process of a PID namespace. If the system allows user namespaces,
/// every user may create one in them. This process only waits for the child.
void go_apart_as_user() {
  char user[40], group[40];
  std::snprintf(user, sizeof user, "%u %u 1", getuid(), getuid());
  std::snprintf(group, sizeof group, "%u %u 1", getgid(), getgid());
  if (unshare(CLONE_NEWUSER | CLONE_NEWPID) != 0) return;
  write_file_once("/proc/self/uid_map", user);
  write_file_once("/proc/self/setgroups", "deny");
  write_file_once("/proc/self/gid_map", group);
  const pid_t first = fork_with_retry();
  if (first == 0) return;
  setsid();
  set_streams(-1, -1, -1);
  close_all_but({});
  _exit(first < 0 || reap(first) != 0);
}

/// Does what fork() does. If the system allows it, the child is the first process of a PID namespace of its
/// own. Later children of this process are born beside this process again.
pid_t fork_apart() {
  const int home = open("/proc/self/ns/pid", O_RDONLY | O_CLOEXEC);
  const bool apart = home >= 0 && unshare(CLONE_NEWPID) == 0;
  const pid_t process = fork_with_retry();
  const int error = errno;
  if (process != 0 && apart && setns(home, CLONE_NEWPID) != 0) std::abort();  // or it keeps all later ones
  if (process == 0 && !apart) go_apart_as_user();
  close_all({home});
  errno = error;
  return process;
}

/// Returns whether a signal to all processes reaches only this process and its descendants. That is so if it
/// is the first process of a PID namespace other than `home`, the namespace of the process that started it.
bool is_alone(ino_t home) {
  return getpid() == 1 && home != 0 && pid_namespace() != 0 && pid_namespace() != home;
}

/// Sends a byte. With it comes the number by which the other side knows this process.
void send_own_number(int socket) {
  char byte = 0;
  if (send(socket, &byte, 1, MSG_NOSIGNAL) != 1) _exit(1);
}

pid_t receive_number(int socket) {
  char byte;
  iovec to{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(ucred))] = {};
  msghdr message{};
  message.msg_iov = &to;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  ssize_t got = 0;
  while ((got = recvmsg(socket, &message, 0)) < 0 && errno == EINTR) {
  }
  const cmsghdr* sent = got == 1 ? CMSG_FIRSTHDR(&message) : nullptr;
  if (!sent || sent->cmsg_type != SCM_CREDENTIALS) return -1;
  ucred who;
  std::memcpy(&who, CMSG_DATA(sent), sizeof who);
  return who.pid;
}

[[noreturn]] void become_kept(int socket, const std::function<void()>& run,
                              const KeptDescriptors& descriptors) {
  setsid();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  send_own_number(socket);
  set_streams(descriptors.input, descriptors.output, descriptors.error);
  close_all_but(descriptors.others);
  for (int s = 1; s < NSIG; ++s) std::signal(s, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  limit(RLIMIT_CORE, 0);
  try {
    run();
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

/// Kills each process whose parent is this one.
void kill_children() {
  DIR* all = opendir("/proc");
  if (!all) return;
  while (const dirent* entry = readdir(all)) {
    const pid_t process = std::atoi(entry->d_name);
    if (process <= 1) continue;
    char file[32], text[512] = {};
    std::snprintf(file, sizeof file, "/proc/%d/stat", process);
    const int stat = open(file, O_RDONLY | O_CLOEXEC);
    if (stat < 0) continue;
    const ssize_t got = read(stat, text, sizeof text - 1);
    close(stat);
    const char* name_end = got > 0 ? std::strrchr(text, ')') : nullptr;
    int parent = 0;
    if (name_end && std::sscanf(name_end, ") %*c %d", &parent) == 1 && parent == getpid())
      kill(process, SIGKILL);
  }
  closedir(all);
}

/// Ends the remaining processes. Orphans become children of the keeper. Returns how many there were.
int end_the_rest(ino_t home) {
  const bool alone = is_alone(home);
  int left = 0;
  while (true) {
    if (alone)
      kill(-1, SIGKILL);  // all of the namespace but this
    else
      kill_children();
    const pid_t ended = waitpid(-1, nullptr, alone ? 0 : WNOHANG);
    if (ended < 0 && errno == ECHILD) return left;
    left += ended > 0;
    if (ended == 0) usleep(1000);
  }
}

[[noreturn]] void keep(int socket, int parent, ino_t home, const std::function<void()>& run,
                       const KeptDescriptors& descriptors) {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  setsid();
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const pid_t process = fork_with_retry();
  if (process == 0) become_kept(socket, run, descriptors);
  if (process < 0) _exit(1);
  const int ended = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
  if (ended < 0) kill(process, SIGKILL);
  set_streams(-1, -1, -1);
  close_all_but({socket, parent, ended});
  pollfd any[] = {{ended, POLLIN, 0}, {socket, POLLIN, 0}, {parent, POLLIN, 0}};
  while (ended >= 0 && poll(any, 3, -1) < 0 && errno == EINTR) {
  }
  if (any[0].revents == 0) kill(process, SIGKILL);
  SupervisedProcess::Ending ending{reap(process)};
  ending.left = end_the_rest(home);
  _exit(send(socket, &ending, sizeof ending, MSG_NOSIGNAL) < 0);
}

}  // namespace

SupervisedProcess::SupervisedProcess(const std::function<void()>& run, const KeptDescriptors& descriptors)
    : owner_(getpid()) {
  int ends[2] = {-1, -1};
  const int self = static_cast<int>(syscall(SYS_pidfd_open, owner_, 0));
  const ino_t home = pid_namespace();
  const int yes = 1;
  const bool made = self >= 0 && socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) == 0 &&
                    setsockopt(ends[0], SOL_SOCKET, SO_PASSCRED, &yes, sizeof yes) == 0;
  std::fflush(nullptr);  // or the child might print it once more
  if (made) keeper_ = fork_apart();
  if (made && keeper_ == 0) {
    close(ends[0]);
    keep(ends[1], self, home, run, descriptors);
  }
  const int error = errno;
  close_all({self, ends[1]});
  socket_ = ends[0];
  process_ = keeper_ > 0 ? receive_number(socket_) : -1;
  if (process_ > 0) return;
  close_all({socket_});
  if (keeper_ > 0) reap(keeper_);
  errno = keeper_ > 0 ? EAGAIN : error;
  throw_errno("starting a process");
}

SupervisedProcess::~SupervisedProcess() {
  if (ours()) {
    kill_now();
    wait();
  }
  close_all({socket_});
}

bool SupervisedProcess::ours() const { return getpid() == owner_; }

std::chrono::nanoseconds SupervisedProcess::cpu_time() const { return cpu_time_of(process_); }

void SupervisedProcess::kill_now() {
  if (!waited_) send(socket_, "k", 1, MSG_NOSIGNAL);
}

const std::optional<SupervisedProcess::Ending>& SupervisedProcess::wait() {
  if (waited_) return ending_;
  Ending received{};
  ssize_t got = 0;
  // The socket first reports that an ended keeper did not read all. The bytes that it sent come after that.
  while ((got = recv(socket_, &received, sizeof received, 0)) < 0 &&
         (errno == EINTR || errno == ECONNRESET)) {
  }
  if (got == sizeof received) ending_ = received;
  reap(keeper_);
  waited_ = true;
  return ending_;
}

}  // namespace cyl
