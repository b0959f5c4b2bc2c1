// SPDX-License-Identifier: MIT
#include "scenes/study/all_cores.hpp"

#include <algorithm>
#include <atomic>
#include <semaphore>
#include <thread>
#include <vector>

namespace cyl {
namespace {

constexpr std::chrono::milliseconds tick_interval{100};

}  // namespace

bool Workforce::out_of_time() const {
  return deadline != std::chrono::steady_clock::time_point::max() &&
         std::chrono::steady_clock::now() >= deadline;
}

void on_all_cores(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task,
                  const std::function<void(std::size_t)>& tick) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next{0}, done{0};
  std::counting_semaphore<> ended{0};
  std::vector<std::jthread> workers;
  for (std::size_t i = 0; i < std::min<std::size_t>(threads, count); ++i)
    workers.emplace_back([&] {
      for (std::size_t at = next++; at < count; at = next++) {
        task(at);
        ++done;
      }
      ended.release();
    });
  tick(0);
  for (std::size_t i = 0; i < workers.size(); ++i)
    while (!ended.try_acquire_for(tick_interval)) tick(done);
}

}  // namespace cyl
