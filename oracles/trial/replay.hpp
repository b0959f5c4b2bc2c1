// SPDX-License-Identifier: MIT
// Runs pairs again on today's build: what is true of each, what every method says, what is wrong with that.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "oracles/methods/contained.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

/// One pair, asked of every method. `answers` and `findings` run parallel to the methods.
struct Replayed {
  Truth truth;
  Enclosure distance;  ///< meaningful where the truth is decided
  std::vector<MethodAnswer> answers;
  std::vector<std::optional<Finding>> findings;
};

/// Every method is asked contained and twice: two answers that differ are a finding where nothing else is.
std::vector<Replayed> replay(std::span<const std::unique_ptr<Method>> methods, std::span<const Pair> pairs,
                             const Caps& caps = {});

}  // namespace cyl
