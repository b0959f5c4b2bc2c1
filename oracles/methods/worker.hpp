// SPDX-License-Identifier: MIT
// A process in which foreign methods are asked, block after block, until it is lost; then the next block
// starts another.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "oracles/methods/worker_block.hpp"

namespace cyl {

class Worker {
 public:
  /// `confined`: it may start no process and signal none but itself, where the kernel sees to that.
  Worker(std::span<const std::unique_ptr<Method>> methods, bool confined, const Caps& caps);
  ~Worker();

  /// Asks at most block_cap questions in order. Returns their answers; where the worker is lost, those up to
  /// the question that it did not survive, whose answer says how it ended, or as many as it gave.
  std::vector<ContainedAnswer> ask(std::span<const Pair> pairs, std::span<const Question> questions);

 private:
  class Memory;
  class Process;
  struct Watched;

  void post(std::span<const Pair> pairs, std::span<const Question> questions);
  bool has_begun() const;  ///< the block that was posted last
  Watched watch();
  ContainedAnswer describe_loss(const Watched& watched);

  std::span<const std::unique_ptr<Method>> methods_;
  const bool confined_;
  const Caps caps_;
  bool one_by_one_ = false;  ///< after a loss in a call about many pairs
  std::unique_ptr<Memory> memory_;
  std::unique_ptr<Process> process_;
};

}  // namespace cyl
