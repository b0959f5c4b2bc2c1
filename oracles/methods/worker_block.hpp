// SPDX-License-Identifier: MIT
// The memory that a worker and its parent share. Both sides map it. The worker cannot write the questions,
// and the parent checks every value that it reads of the answers.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include "base/process/process.hpp"
#include "oracles/methods/contained.hpp"

namespace cyl {

/// Questions that go to a worker at once. They are so many that the cost of waking it is small, and so few
/// that both sides of the block stay in the cache.
inline constexpr std::size_t block_cap = 256;

/// Written by the parent. The worker maps it read-only.
struct RequestBlock {
  std::atomic<std::uint64_t> number{0};  ///< of the block
  std::size_t count = 0;
  bool one_by_one = false;        ///< even if a method has a batch call
  Question questions[block_cap];  ///< `pair` is an index into `pairs`
  Pair pairs[block_cap];
};

/// Written by the worker.
struct ResponseBlock {
  std::atomic<std::uint64_t> begun{0};   ///< the number of the last block that it began
  std::atomic<std::uint64_t> number{0};  ///< the number of the last block that it completed
  std::atomic<std::size_t> cursor{0};    ///< the question being asked; the number of questions when all are
                                         ///< done
  std::atomic<int> denied{-1};           ///< the system call that confine() refused
  ContainedAnswer answers[block_cap];
};
static_assert(std::is_trivially_copyable_v<ContainedAnswer>);
static_assert(std::atomic<std::size_t>::is_always_lock_free);

/// Memory that two processes map, and no child of this one by the fork alone.
template <class Content>
class Shared {
 public:
  explicit Shared(bool parent_writes_alone) : file_(memfd_create("block", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
    if (file_ < 0 || ftruncate(file_, sizeof(Content)) != 0) throw_errno("memfd_create");
    content_ = new (map(PROT_READ | PROT_WRITE)) Content;
    madvise(content_, sizeof(Content), MADV_DONTFORK);
    // A process that shortens the file would end the other one at its next read.
    const int seals =
        F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL | (parent_writes_alone ? F_SEAL_FUTURE_WRITE : 0);
    if (fcntl(file_, F_ADD_SEALS, seals) != 0) throw_errno("sealing a block");
  }
  ~Shared() {
    munmap(content_, sizeof(Content));
    close(file_);
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  Content* operator->() const { return content_; }
  int file() const { return file_; }
  /// In the worker.
  Content& map_there(int protection) const { return *static_cast<Content*>(map(protection)); }

 private:
  void* map(int protection) const {
    void* const at = mmap(nullptr, sizeof(Content), protection, MAP_SHARED, file_, 0);
    if (at == MAP_FAILED) throw_errno("mmap");
    return at;
  }

  int file_;
  Content* content_;
};

}  // namespace cyl
