// SPDX-License-Identifier: MIT
// One batch of a campaign: a range of indices, asked, judged and compared. It is a pure function of its
// arguments, except for times and hangs. The findings do not depend on how a campaign is divided into
// batches.
#pragma once

#include <cstdint>
#include <functional>

#include "corpus/store/run_facts.hpp"
#include "fuzz/campaign/workload.hpp"

namespace cyl {

/// Our methods are asked twice on every index divisible by this: often enough to catch a method that keeps
/// state, at 2 % of the cost.
inline constexpr std::uint64_t repeat_share = 64;

/// The cells of the failure maps (oracles/trial/cells.hpp) count one pair in this many, drawn from seed and
/// index. The search for the cell of a pair takes longer than the questions about it. With foreign methods
/// every pair up to an index counts, because such runs are short.
inline constexpr std::size_t own_cell_share = 256, cell_share = 16;
inline constexpr std::uint64_t every_cell_until = 65536;

/// Returns what makes one batch after the other, [first, next) each, with the workers of foreign methods
/// alive between them. Own methods are asked in this process, foreign ones in a contained one. A costly
/// method (share() > 1) is asked on its share of the indices (on_share()), and if another verdict is wrong
/// beyond its claim or the truth is undecided. Within their claims tolerant methods differ on a quarter of
/// all pairs. Asking costly methods there would take nearly all of the time. The cells of the failure maps
/// count costly methods on their share only, because disputed pairs are not a random sample.
std::function<BatchRecord(std::uint64_t first, std::uint64_t next)> batch_maker(const Workload& workload,
                                                                                std::uint64_t seed);

}  // namespace cyl
