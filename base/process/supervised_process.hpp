// SPDX-License-Identifier: MIT
// A process of foreign code, kept apart. Between it and this process stands a keeper, which ends it, with all
// that it started, when this process says so or ends itself, however that happens.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

namespace cyl {

/// What the process has of this one's descriptors; all others are closed in it. Where a stream is negative,
/// nothing can be read from it and what is written to it is lost.
struct KeptDescriptors {
  int input = -1, output = -1, error = -1;
  std::vector<int> others = {};  ///< under the same numbers
};

class SupervisedProcess {
 public:
  /// Calls `run` in a process that leads a session of its own and meets signals as if no one had touched
  /// them; where the system allows it, in a PID namespace of its own too, in which it sees no process of
  /// others and with whose end all of its own end. It ends with status 0, or 1 where `run` throws, and runs
  /// no destructors nor exit handlers. Throws std::system_error where the system has no process or descriptor
  /// left.
  SupervisedProcess(const std::function<void()>& run, const KeptDescriptors& descriptors);
  ~SupervisedProcess();  ///< ends it, where this process started it
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
  /// Waits for the end. Nothing where the keeper itself was killed, which ends the process too.
  const std::optional<Ending>& wait();

 private:
  pid_t owner_, keeper_ = -1, process_ = -1;
  int socket_ = -1;
  bool waited_ = false;
  std::optional<Ending> ending_;
};

}  // namespace cyl
