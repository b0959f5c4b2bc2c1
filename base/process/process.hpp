// SPDX-License-Identifier: MIT
// System calls for processes, in our types. A noexcept function makes system calls only, so it may be called
// between fork and exec.
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

/// Calls fork() and repeats it for up to ten seconds if it fails with EAGAIN. Returns a negative number, with
/// errno set, if all calls fail.
pid_t fork_with_retry() noexcept;

/// Lowers a soft limit of this process to `value`, or to the hard limit if that is lower.
void limit(decltype(RLIMIT_CORE) resource, rlim_t value) noexcept;

std::chrono::nanoseconds read_clock(clockid_t clock) noexcept;

/// Returns the CPU time of a process, or 0 if it has ended.
std::chrono::nanoseconds cpu_time_of(pid_t process) noexcept;

/// Returns the CPU time that the system reports in `used`.
std::chrono::nanoseconds cpu_time_of(const rusage& used) noexcept;

/// Returns that of a process and of all under it that still run, as far as first threads started them.
std::chrono::nanoseconds cpu_time_of_tree(pid_t process);

/// Returns a number that identifies the PID namespace of this process, or 0 if it is unknown.
ino_t pid_namespace() noexcept;

/// Waits for the end of a child of this process and returns its status.
int reap(pid_t child) noexcept;

/// Closes those that are open: the rest are negative.
void close_all(std::initializer_list<int> descriptors) noexcept;

/// Throws std::system_error if the reader has closed the descriptor.
void write_all(int descriptor, std::string_view bytes);

/// Throws std::system_error with errno and `what` failed.
[[noreturn]] void throw_errno(const std::string& what);

/// Redirects standard input from a file, and appends standard output and error to another file. Throws
/// std::system_error if one cannot be opened.
void redirect_streams(const std::string& input, const std::string& output);

/// Replaces this process by a program from PATH with its arguments. Throws std::system_error that names the
/// program if it does not exist.
[[noreturn]] void become_program(const std::vector<std::string>& command);

/// Returns "SIGABRT", or "signal 40" if the signal has no name.
std::string signal_name(int signal);

/// Returns "exit code 77" or "killed by signal 9 (Killed)", for a status as waitpid() gives it.
std::string how_it_ended(int status);

/// Returns at most `cap` bytes from the end of a file, as one line without white space at its end.
std::string last_line(int descriptor, std::size_t cap);

}  // namespace cyl
