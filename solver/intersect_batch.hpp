// SPDX-License-Identifier: MIT
// Many pairs at once, in the vector lanes of the processor. The verdicts equal those of intersect(), pair by
// pair, on every instruction set, because the arithmetic is the same (sections.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "solver/decide.hpp"

namespace cyl {

/// One solid of each set, by index.
struct IndexPair {
  std::uint32_t a, b;
};

/// The target of a kernel. Other processors than x86-64 have only `baseline`.
enum class Instructions : unsigned char {
  baseline,  ///< two lanes of the processor's own vectors: SSE2, NEON
  v3,        ///< x86-64-v3: AVX2, four lanes
  v4         ///< x86-64-v4: AVX-512, eight lanes
};
constexpr auto words_of(Instructions) noexcept { return std::array{"baseline", "v3", "v4"}; }

/// The best that this processor runs.
Instructions best_instructions() noexcept;

/// verdicts[i] = intersect(a[pairs[i].a], b[pairs[i].b]). The two sets may be the same. A solid is one
/// record, because pairs come from a broad phase in any order, and one record is two cache lines but eight
/// arrays would be eight. `verdicts` has room for all pairs and shares no memory with the sets. Indices are
/// not checked. Allocates nothing. If the processor lacks an instruction set, the best available one is used.
/// Cost: with AVX-512 less than half of intersect() a pair of plain cylinders. Codes with thousands of pairs
/// at once gain, of particles or plans. Pairs of other solids are passed to intersect() one by one.
void intersect_batch(std::span<const Prepared> a, std::span<const Prepared> b,
                     std::span<const IndexPair> pairs, Verdict* verdicts,
                     Instructions instructions = best_instructions()) noexcept;

}  // namespace cyl
