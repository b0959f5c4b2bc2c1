// SPDX-License-Identifier: MIT
// A process in which foreign methods are asked, block after block, until it is lost; then the next block
// starts another. Questions and answers lie in memory that both sides map: the questions cannot be written
// there, and nothing that is read of the answers is believed unseen.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "oracles/methods/contained.hpp"

namespace cyl {

/// Questions that go to a worker at once: many, so that waking it costs little beside them; few enough that
/// both sides of the block stay in the cache.
inline constexpr std::size_t block_cap = 256;

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
  Watched watch();
  ContainedAnswer describe_loss(const Watched& watched);

  std::span<const std::unique_ptr<Method>> methods_;
  const bool confined_;
  const Caps caps_;
  bool one_by_one_ = false;  ///< after a loss in a call about many pairs
  std::unique_ptr<Memory> memory_;
  std::unique_ptr<Process> process_;
};

/// Asks in this process, and turns what a method throws, and numbers that are none, into failures.
MethodAnswer ask_caught(Method& method, const Pair& pair, CallMode mode);

/// Returns the answer, as a failure where it is not one of a method's: of no known kind, or not finite.
MethodAnswer checked(MethodAnswer answer);

}  // namespace cyl
