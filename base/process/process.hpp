// SPDX-License-Identifier: MIT
// What the system says and does about processes, in our types. Those that are noexcept make system calls
// alone, so they may be called between fork and exec.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <ctime>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace cyl {

/// Does what fork() does, but where the system says "try again" (EAGAIN) it does, for up to ten seconds.
/// Returns a negative number, with errno set, where that did not help.
pid_t fork_with_retry() noexcept;

/// Lowers a soft limit of this process to `value`, or to the hard limit where that is lower.
void limit(decltype(RLIMIT_CORE) resource, rlim_t value) noexcept;

std::chrono::nanoseconds read_clock(clockid_t clock) noexcept;

/// Returns the CPU time of a process; 0 where it has ended.
std::chrono::nanoseconds cpu_time_of(pid_t process) noexcept;

/// Returns the CPU time that the system reports in `used`.
std::chrono::nanoseconds cpu_time_of(const rusage& used) noexcept;

/// Returns that of a process and of all under it that still run, as far as first threads started them.
std::chrono::nanoseconds cpu_time_of_tree(pid_t process);

/// Returns a number that identifies the PID namespace of this process; 0 if the system does not say.
ino_t pid_namespace() noexcept;

/// Waits for the end of a child of this process and returns its status.
int reap(pid_t child) noexcept;

/// Closes those that are open: the rest are negative.
void close_all(std::initializer_list<int> descriptors) noexcept;

/// Throws std::system_error where nobody reads any more.
void write_all(int descriptor, std::string_view bytes);

/// Throws std::system_error with errno and `what` failed.
[[noreturn]] void throw_errno(const std::string& what);

/// Reads standard input from a file, and puts standard output and error at the end of another. Throws
/// std::system_error where one cannot be opened.
void redirect_streams(const std::string& input, const std::string& output);

/// Becomes a program with its arguments, looked for in PATH. Throws std::system_error that names it where
/// there is none.
[[noreturn]] void become_program(const std::vector<std::string>& command);

/// Returns "SIGABRT", or "signal 40" where that has no name.
std::string signal_name(int signal);

/// Returns "exit code 77" or "killed by signal 9 (Killed)", for a status as waitpid() gives it.
std::string how_it_ended(int status);

/// Returns at most `cap` bytes from the end of a file, as one line without white space at its end.
std::string last_line(int descriptor, std::size_t cap);

}  // namespace cyl
