// SPDX-License-Identifier: MIT
// Holds methods to the laws, many pairs at a time, so that foreign code is contained at the price of two
// forks for all of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "oracles/methods/contained.hpp"
#include "oracles/methods/method.hpp"
#include "props/laws/laws.hpp"

namespace cyl {

/// Indices into what was given to examine().
struct LawViolation {
  std::size_t method, pair;
  const Law* law;
  Violation violation;
  std::vector<LawQuery> asked;        ///< what the law had asked beside the pair,
  std::vector<MethodAnswer> answers;  ///< the method's answers to these pairs
};

/// Counts of a method's answers to the pairs themselves.
struct AnswerCounts {
  std::uint64_t asked = 0, declined = 0, failed = 0;
  std::uint64_t hangs = 0, crashes = 0;  ///< changed pairs included
  double hung_seconds = 0;               ///< that these took in all
  std::array<std::uint64_t, 5> said{};   ///< by Verdict
  AnswerCounts& operator+=(const AnswerCounts& other);
};

struct Examined {
  std::vector<LawViolation> violations;        ///< by pair, then method, then law
  std::vector<AnswerCounts> counts;            ///< by method
  std::vector<std::optional<Verdict>> truths;  ///< by pair; empty if no law asked for it
  std::vector<MethodAnswer> answers;           ///< to the pairs themselves: pair by pair, of every method
};

/// Returns whether a method is held to a law.
using LawFilter = std::function<bool(std::size_t method, const Law& law)>;

/// Asks the methods, contained: each pair that a method supports once, then all queries of the laws that
/// `wanted` selects for it. A pair that is not sent is declined and not counted: an unsupported one, or one
/// after too many hangs. Deterministic except for hangs.
Examined examine(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                 const LawFilter& wanted, Asker& asker);

/// Does the same, in new workers.
Examined examine(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                 const LawFilter& wanted, const Caps& caps = {});

}  // namespace cyl
