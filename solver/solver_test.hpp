// SPDX-License-Identifier: MIT
// Shared by the tests of solver/. It replaces operator new, weakly: several files of a program may include
// it.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

// Counts allocations, so that a test can require none. Not inlined, because gcc would report a mismatch of
// malloc and free through new and delete.
inline std::atomic<long> allocations{0};
[[gnu::noinline, gnu::weak]] void* operator new(std::size_t n) {
  ++allocations;
  if (void* p = std::malloc(n)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline, gnu::weak]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline, gnu::weak]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace cyl {

// A fixed stream of numbers in [0, 1).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double unit() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  // In [-1, 1).
  double either_sign() {
    unit();
    return static_cast<double>(static_cast<std::int64_t>(state_) >> 11) * 0x1p-52;
  }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }

 private:
  std::uint64_t state_;
};

}  // namespace cyl
