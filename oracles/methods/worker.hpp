// SPDX-License-Identifier: MIT
// A process that asks foreign methods, block after block. When it is lost, the next block starts another
// one.
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
  /// `confined`: it may not start processes or signal others, if the kernel can enforce that.
  Worker(std::span<const std::unique_ptr<Method>> methods, bool confined, const Caps& caps);
  ~Worker();

  /// Asks at most block_cap questions in order, and returns their answers. If the worker is lost, the last
  /// answer is that of the question that it did not survive, with how it ended. A worker may also return
  /// fewer answers.
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
  bool one_by_one_ = false;                          ///< after a loss in a call about many pairs
  std::optional<ContainedAnswer> lost_in_one_call_;  ///< that loss, if no single call has it
  std::unique_ptr<Memory> memory_;
  std::unique_ptr<Process> process_;
};

}  // namespace cyl
