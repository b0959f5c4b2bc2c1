// SPDX-License-Identifier: MIT
// The shrinker finds a simple pair that still fails in the same way. It moves, turns, scales and
// exchanges solids, and changes their shape at a constant distance. It does not know why a pair fails:
// it asks about every pair that it takes. The caller defines "the same way". To keep the contact
// feature, the caller must ask for it (oracles/trial/contact.hpp). Otherwise most pairs end as disks and
// points.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "props/shrink/complexity.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Returns which of these pairs still fail. It gets many pairs at a time, because each call of foreign code
/// costs a fork. It must be a pure function of each pair. The pairs are valid.
using StillFails = std::function<std::vector<bool>(std::span<const Pair>)>;

struct Simplified {
  Pair pair;              ///< confirmed failing, or the pair given
  std::size_t questions;  ///< pairs asked about
  bool at_cap;            ///< ended by the cap: what more might have been found is not known
};

/// Pairs asked about before the simplest so far is returned. Near-touching pairs of every feature took 300,
/// at most 600, in 20 to 60 calls.
inline constexpr std::size_t question_cap_default = 4000;

/// Returns the simplest pair found. It has no radius, height or edge of 0 that the given pair has not. The
/// given pair is assumed to fail and is not asked. An invalid pair is returned unchanged. Deterministic, and
/// never worse than the given pair. If it did not reach the limit, a second call changes nothing.
Simplified simplify(const Pair& pair, const StillFails& still_fails,
                    std::size_t question_cap = question_cap_default);

}  // namespace cyl
