// SPDX-License-Identifier: MIT
// The shrinker: from a failing pair to the simplest one found that still fails the same way. It knows what
// pairs are made of (solids may be moved, turned, scaled, exchanged, kept at their distance while their shape
// changes) and nothing of why a pair fails: every pair it takes was asked about and failed. What "the same
// way" means is the caller's to say: a caller who wants the contact feature kept asks for it
// (oracles/trial/contact.hpp), or most pairs end as disks and points.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "props/shrink/complexity.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// Says which of these pairs still fail, one bool each; asked many at a time, because each call about foreign
/// code costs a fork. Must be a pure function of each pair. The pairs are legal.
using StillFails = std::function<std::vector<bool>(std::span<const Pair>)>;

struct Simplified {
  Pair pair;              ///< confirmed failing, or the pair given
  std::size_t questions;  ///< pairs asked about
  bool at_cap;            ///< ended by the cap: what more might have been found is not known
};

/// Pairs asked about before the simplest so far is returned. Near-touching pairs of every feature took 300,
/// at most 600, in 20 to 60 calls.
inline constexpr std::size_t question_cap_default = 4000;

/// Returns the simplest pair found. The pair given is taken to fail and is not asked about; an illegal one
/// comes back as it is. Deterministic; never worse than what was given; where it did not end at the cap,
/// simplifying again changes nothing.
Simplified simplify(const Pair& pair, const StillFails& still_fails,
                    std::size_t question_cap = question_cap_default);

}  // namespace cyl
