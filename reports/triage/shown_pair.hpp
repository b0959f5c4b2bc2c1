// SPDX-License-Identifier: MIT
// The answers of all methods to a pair of a cause now. The blamed method is asked in a worker of its own, so
// that earlier pairs cannot affect it. The others share workers, and a method that hangs repeatedly is left
// out.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "oracles/methods/contained.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// A method and its kind of failure.
struct FailingMethod {
  std::size_t method;
  FindingKind kind;
};

struct ShownPair {
  Trial trial;              ///< an answer a method; who was not asked has none that means anything
  std::vector<bool> asked;  ///< by method

  bool fails(const FailingMethod& blamed) const;
};

/// Returns whether the method, asked alone in a worker of its own, fails on the pair in that way. A failure
/// that is not deterministic does not count.
bool fails_alone(std::span<const std::unique_ptr<Method>> methods, const FailingMethod& blamed,
                 const Pair& pair);

class PairShower {
 public:
  /// Once `out_of_time()`, only who is blamed is asked, unless it hangs.
  PairShower(std::span<const std::unique_ptr<Method>> methods, std::function<bool()> out_of_time);

  ShownPair show(const Pair& pair, const std::optional<FailingMethod>& blamed);

 private:
  std::span<const std::unique_ptr<Method>> methods_;
  std::function<bool()> out_of_time_;
  Asker asker_;
  std::vector<unsigned> hangs_;
};

}  // namespace cyl
