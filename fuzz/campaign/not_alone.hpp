// SPDX-License-Identifier: MIT
// A worker outlives a batch, and what a library keeps of earlier questions may be what is wrong: then the
// pair alone shows nothing.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "oracles/methods/method.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

/// A finding that may be none of the pair: whose, on which, of what kind.
struct Doubt {
  std::size_t method, pair;
  FindingKind kind;
};

/// Asks about each once more, in workers that were started for it. Returns those that were not found again.
std::vector<Doubt> not_alone(std::span<const std::unique_ptr<Method>> methods, std::span<Trial> trials,
                             std::span<const Doubt> doubts);

}  // namespace cyl
