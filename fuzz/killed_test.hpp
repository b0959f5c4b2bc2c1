// SPDX-License-Identifier: MIT
// Campaigns that are ended from outside, at a moment that the campaign's own progress decides.
#pragma once

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <limits>
#include <system_error>

#include "fuzz/campaign.hpp"

namespace cyl {

/// Runs `run`, which hands what it is given to run_campaign as `on_progress` and returns the exit code, in a
/// process of its own; sends that process `signal`, `delay` microseconds after its first new pairs are
/// stored; and returns the status that waitpid gives. Having stored `most` new pairs the campaign stands
/// still, so that it cannot end before.
template <class Run>
int end_on_its_way(const Run& run, int signal, useconds_t delay = 0,
                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  int stored[2];
  if (pipe(stored) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    close(stored[0]);
    bool told = false;
    const int code = run([&](const CampaignProgress& progress) {
      if (progress.session_done > 0 && !told) told = write(stored[1], "", 1) == 1;
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
