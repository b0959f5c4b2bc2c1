// SPDX-License-Identifier: MIT
// The answers whose witnesses the referee may use. They do not depend on the methods of the run.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

class WitnessSet {
 public:
  /// `methods` are those that the run asks.
  explicit WitnessSet(std::span<const std::unique_ptr<Method>> methods);

  /// Returns the answers to a pair. Adds the answer of our certifying method unless the run asks that method.
  /// The span is valid until the next call.
  std::span<const MethodAnswer> with_own_witness(const Pair& pair, std::span<const MethodAnswer> said);

 private:
  std::unique_ptr<Method> ours_;  ///< null if the run asks it
  std::vector<MethodAnswer> all_;
};

}  // namespace cyl
