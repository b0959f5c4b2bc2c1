// SPDX-License-Identifier: MIT
// Witnesses that the referee is offered, whoever is asked.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

class Offers {
 public:
  /// `methods`: those that are asked.
  explicit Offers(std::span<const std::unique_ptr<Method>> methods);

  /// Returns what they said of a pair, and what our certifying method says of it where it is none of them;
  /// valid until the next call.
  std::span<const MethodAnswer> with_ours(const Pair& pair, std::span<const MethodAnswer> said);

 private:
  std::unique_ptr<Method> ours_;  ///< nothing where it is asked anyway
  std::vector<MethodAnswer> all_;
};

}  // namespace cyl
