// SPDX-License-Identifier: MIT
// Ctrl-C as a question: may this end?
#pragma once

#include <csignal>

namespace cyl {

/// Turns SIGINT and SIGTERM into asked() while it lives. One at a time.
class StopSignals {
 public:
  StopSignals() {
    stop_asked_ = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { stop_asked_ = 1; };
    sigaction(SIGINT, &action, &interrupt_before_);
    sigaction(SIGTERM, &action, &terminate_before_);
  }
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals() {
    sigaction(SIGINT, &interrupt_before_, nullptr);
    sigaction(SIGTERM, &terminate_before_, nullptr);
  }
  static bool asked() { return stop_asked_ != 0; }

 private:
  static inline volatile std::sig_atomic_t stop_asked_ = 0;
  struct sigaction interrupt_before_ {
  }, terminate_before_{};
};

}  // namespace cyl
