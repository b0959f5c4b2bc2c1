// SPDX-License-Identifier: MIT
// What a cause shows of a pair: everybody's answer today. Who is blamed is asked in a worker of its own, so
// that nothing that was asked before has a say; the others share workers, and one that hangs again and again
// is left out.
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

/// As the triage has them; what hangs once on a pair would again.
inline constexpr Caps shown_caps{
    .call_cpu = std::chrono::milliseconds(500), .call_wall = std::chrono::milliseconds(2000), .hangs = 1};

struct ShownPair {
  Trial trial;              ///< an answer a method; who was not asked has none that means anything
  std::vector<bool> asked;  ///< by method
};

/// A method and the way in which it is said to fail.
struct FailingMethod {
  std::size_t method;
  FindingKind kind;

  bool operator==(const FailingMethod&) const = default;
};

/// Returns whether the method, asked alone in a worker of its own, fails on the pair in that way. What comes
/// and goes does not.
bool fails_alone(std::span<const std::unique_ptr<Method>> methods, const FailingMethod& blamed,
                 const Pair& pair);

class PairShower {
 public:
  /// Once `out_of_time()`, only who is blamed is asked.
  PairShower(std::span<const std::unique_ptr<Method>> methods, std::function<bool()> out_of_time);

  ShownPair show(const Pair& pair, std::span<const FailingMethod> blamed);

 private:
  std::span<const std::unique_ptr<Method>> methods_;
  std::function<bool()> out_of_time_;
  Asker asker_;
  std::vector<unsigned> hangs_;
};

}  // namespace cyl
