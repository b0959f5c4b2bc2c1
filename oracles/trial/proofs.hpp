// SPDX-License-Identifier: MIT
// What is proved of the pairs of one question: found when first asked for, and kept.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

struct Proved {
  Pair pair;
  Truth truth;
  LazyDistance distance;  ///< not to be asked where the truth is undecided or invalid
};

class Proofs {
 public:
  /// `offered`: answers to `pair`, whose witnesses are tried before the referee searches. Not copied.
  Proofs(const Pair& pair, std::span<const MethodAnswer> offered) : pair_(pair), offered_(offered) {}
  Proofs(const Proofs&) = delete;
  Proofs& operator=(const Proofs&) = delete;

  /// Of the pair itself or of any other. Valid as long as this is.
  Proved& of(const Pair& pair);
  /// What was found of it so far, or nullptr.
  const Proved* known(const Pair& pair) const;

 private:
  const Pair& pair_;
  std::span<const MethodAnswer> offered_;
  std::deque<Proved> proved_;  // few
};

/// Whether |signed distance| of the pair certainly reaches what `claim` promises: from there on the method's
/// verdict is its contract. False where the truth is undecided.
bool beyond_claim(Proved& proved, const Claim& claim);

}  // namespace cyl
