// SPDX-License-Identifier: MIT
// A function or a program that runs in a process of its own and returns bytes. A fault in it does not end
// this process. If this process ends, so does the child.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace cyl {

struct ChildOptions {
  /// Precedes the reason on standard error if the child throws: "daylight: a batch failed: ...".
  std::string failure = "a process failed";
  /// Whether the child leads a process group. Then a Ctrl-C meant for this process does not reach it, it ends
  /// on SIGINT and SIGTERM, and all that it started in its group ends with it.
  bool own_group = false;
  std::string input = {};  ///< standard input of a program; if empty, that of this process
};

class Child {
 public:
  /// Forks and calls `work` in the child, which returns the bytes. The child ends with status 0, or 1 if
  /// `work` throws. It runs no destructors and no exit handlers. It is killed when the thread that made it
  /// ends. Throws std::system_error if the system has no process or pipe left.
  explicit Child(const std::function<std::string()>& work, const ChildOptions& options = {});
  /// Does the same for a program, which is looked for in PATH, with its arguments. The bytes are those that
  /// it prints on standard output.
  explicit Child(const std::vector<std::string>& command, const ChildOptions& options = {});
  /// Does the same for work that hands over its bytes itself, as they come.
  explicit Child(const std::function<void(int output)>& work, const ChildOptions& options = {});
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();  ///< kills what still runs

  /// Reads the bytes that have arrived, without waiting, and returns whether the child has ended. The end of
  /// the process counts, because a process that survives it may keep the pipe open.
  bool advance();
  /// Waits for the end and returns the status. Throws std::system_error if the system has no descriptor
  /// left.
  int wait();
  /// Returns the status that waitpid() gives, once it has ended.
  int status() const { return status_; }
  const std::string& bytes() const { return bytes_; }
  void forget_bytes(std::size_t count) { bytes_.erase(0, count); }  ///< the first of them
  /// Returns the CPU time of the process; once it has ended, with that of the children that it waited for.
  std::chrono::nanoseconds cpu_time() const;
  bool ended() const { return ended_; }
  int output() const { return output_; }  ///< to poll for reading
  /// Returns a descriptor to poll for the end. Throws std::system_error if the system has none left.
  int end();
  void kill_now();              ///< with its group, if that is its own
  void send(int signal) const;  ///< to the process alone

 private:
  void start(const std::function<void(int output)>& run, const ChildOptions& options);

  bool own_group_ = false;
  pid_t process_ = -1;
  int output_ = -1, end_ = -1;
  bool ended_ = false;
  bool output_ended_ = false;
  int status_ = 0;
  std::chrono::nanoseconds cpu_time_{0};
  std::string bytes_;
};

}  // namespace cyl
