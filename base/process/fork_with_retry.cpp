// SPDX-License-Identifier: MIT
#include "base/process/fork_with_retry.hpp"

#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace cyl {
namespace {

constexpr int attempt_cap = 200;
constexpr timespec pause_between{0, 50'000'000};  // 50 ms

}  // namespace

pid_t patient_fork() noexcept {
  pid_t process = fork();
  for (int attempt = 1; process < 0 && errno == EAGAIN && attempt < attempt_cap; ++attempt) {
    nanosleep(&pause_between, nullptr);
    process = fork();
  }
  return process;
}

}  // namespace cyl
