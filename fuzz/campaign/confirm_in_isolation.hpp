// SPDX-License-Identifier: MIT
// A worker lives longer than a batch. A finding may therefore come from state that a library kept from
// earlier questions. Then the pair alone does not show it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "oracles/methods/method.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// A finding that the pair alone may not show.
struct Suspect {
  std::size_t method, pair;
  FindingKind kind;
};

/// Asks each question once more, in new workers. Returns the suspects that did not fail again in the same
/// way.
std::vector<Suspect> confirm_in_isolation(std::span<const std::unique_ptr<Method>> methods,
                                          std::span<Trial> trials, std::span<const Suspect> suspects);

}  // namespace cyl
