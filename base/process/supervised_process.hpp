// SPDX-License-Identifier: MIT
// An isolated process of foreign code. A keeper stands between it and this process. The keeper ends it, with
// all its descendants, on request or when this process ends.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

namespace cyl {

/// Descriptors that the process inherits. All others are closed in it. If a stream is negative, it reads
/// nothing and loses what is written to it.
struct KeptDescriptors {
  int input = -1, output = -1, error = -1;
  std::vector<int> others = {};  ///< under the same numbers
};

class SupervisedProcess {
 public:
  /// Calls `run` in a process that leads a session of its own and has the default signal handlers. If
  /// the system allows it, the process is in a PID namespace of its own. There it sees no other process,
  /// and its descendants end with it. It ends with status 0, or 1 if `run` throws, and runs no
  /// destructors or exit handlers. Throws std::system_error if the system has no process or descriptor
  /// left.
  SupervisedProcess(const std::function<void()>& run, const KeptDescriptors& descriptors);
  ~SupervisedProcess();  ///< ends the process, if this process started it
  SupervisedProcess(const SupervisedProcess&) = delete;
  SupervisedProcess& operator=(const SupervisedProcess&) = delete;

  bool ours() const;  ///< this process started it
  pid_t id() const { return process_; }
  std::chrono::nanoseconds cpu_time() const;  ///< 0 once it has ended
  int end() const { return socket_; }         ///< to poll for reading: it has ended
  void kill_now();                            ///< asks the keeper to end it, with all that it started

  struct Ending {
    int status;    ///< as waitpid() gives it
    int left = 0;  ///< processes that it started and left, which the keeper ended
  };
  /// Waits for the end. Empty if the keeper itself was killed, which also ends the process.
  const std::optional<Ending>& wait();

 private:
  pid_t owner_, keeper_ = -1, process_ = -1;
  int socket_ = -1;
  bool waited_ = false;
  std::optional<Ending> ending_;
};

}  // namespace cyl
