// SPDX-License-Identifier: MIT
// Shared by the tests of killed campaigns: a campaign that is killed again and again and still completes on
// any machine.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <stdexcept>
#include <system_error>

#include "fuzz/campaign/campaign.hpp"

namespace cyl {

/// A splitmix64 step: the tests' own random numbers.
inline std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// A session of a campaign, which passes its argument on as the callback.
using Session = std::function<void(const std::function<void(const CampaignProgress&)>&)>;

/// Runs `session` in one child after the other until one ends by itself, and returns how many were killed.
/// Each is killed a random time after a random number of commits, 0 to `most`, so at any place of its work.
/// At commit most + 1 it kills itself. So a session with more work does not end by itself, even if this
/// process is slow. Once one commit is drawn there is progress, even if it is fast.
inline int kill_until_done(std::uint64_t seed, std::uint64_t most, const Session& session) {
  constexpr std::uint64_t longest_microseconds = 20'000;  // some batches, if nothing else runs
  for (int kills = 0;; ++kills) {
    const std::uint64_t drawn = mix(seed + static_cast<std::uint64_t>(kills)), wanted = drawn % (most + 1);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      std::uint64_t done = 0, commits = 0;
      try {
        session([&](const CampaignProgress& progress) {
          if (progress.session_done == done) return;
          done = progress.session_done;
          if (++commits > most || write(ends[1], "c", 1) != 1) raise(SIGKILL);
        });
      } catch (const std::exception&) {
        _exit(1);
      }
      _exit(0);
    }
    close(ends[1]);
    char commit;
    for (std::uint64_t n = 0; n < wanted && read(ends[0], &commit, 1) == 1;) ++n;
    usleep(static_cast<useconds_t>((drawn >> 32) % longest_microseconds));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    close(ends[0]);
    if (!WIFEXITED(status)) continue;
    EXPECT_EQ(WEXITSTATUS(status), 0);
    return kills;
  }
}

/// Runs `run` in a process of its own. It passes its argument to run_campaign as `on_progress` and returns
/// the exit code. Sends the process `signal`, `delay` microseconds after its first new pairs are stored,
/// and returns the status of waitpid. After `most` new pairs the campaign pauses, so that it cannot end
/// before.
template <class Run>
int end_on_its_way(const Run& run, int signal, useconds_t delay = 0,
                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  int stored[2];
  if (pipe(stored) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    close(stored[0]);
    bool reported = false;
    const int code = run([&](const CampaignProgress& progress) {
      if (progress.session_done > 0 && !reported) reported = write(stored[1], "", 1) == 1;
      while (progress.session_done >= most) pause();
    });
    _exit(code);
  }
  close(stored[1]);
  char byte;
  if (read(stored[0], &byte, 1) == 1) {  // else it has ended, with nothing left to do
    usleep(delay);
    kill(child, signal);
  }
  close(stored[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

}  // namespace cyl
