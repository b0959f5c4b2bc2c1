// SPDX-License-Identifier: MIT
// One batch of a campaign: a stretch of indices, asked, judged and compared. A pure function of its
// arguments, times and kind `hang` excepted; where a campaign is cut into batches does not show in what it
// finds.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

#include "corpus/store/run_store.hpp"
#include "fuzz/campaign/workload.hpp"

namespace cyl {

/// Rows of the tally and the findings that are no method's: the cases' own statements of truth, the judge.
inline constexpr const char* corpus_row = "corpus";
inline constexpr const char* referee_row = "referee";
/// How often each arithmetic had the last word, decided or not, and all the time of those pairs; in the order
/// of Stage.
inline constexpr std::array<const char*, 3> stage_rows{"referee-filter", "referee-wide", "referee-exact"};
/// Returns whether a row is a method's own and none of those above.
bool is_method_row(std::string_view name);
/// Our methods are asked twice on every index divisible by this: often enough to catch a method that keeps
/// state, at 2 % of the cost.
inline constexpr std::uint64_t repeat_share = 64;

/// A pair is counted in the cells of the failure maps (oracles/trial/cells.hpp) with a chance of one in this
/// many, drawn from seed and index: finding the place of a pair takes longer than asking about it. Beside
/// foreign methods every pair is, up to an index, for such runs are short.
inline constexpr std::size_t own_cell_share = 256, cell_share = 16;
inline constexpr std::uint64_t every_cell_until = 65536;

/// Indices of a batch: about a second's work of the packaged methods. Each batch costs two new workers, one
/// of them to confirm its findings, and hands over its counts and the findings that the run may keep. In
/// smaller batches that takes longer than the answers of a fast library, or of our methods. Programs answer
/// slowly: a batch that shows no progress, or is lost, should be short.
inline constexpr std::uint64_t batch_size = 2048, own_batch_size = 131072, program_batch_size = 512;
std::uint64_t batch_size_for(const Workload& workload);

/// Own methods are asked in this process, foreign ones contained. A costly method (share() > 1) is asked on
/// its share of the indices (on_share()) and wherever another's verdict is wrong beyond its claim or the
/// truth is undecided. (Within their claims tolerant methods differ on every near-touching pair: a quarter of
/// all, no news, and the costly ones would take nearly all of the time.) In the cells of the failure maps
/// they are counted on their share alone: disputes are where somebody is wrong, and no sample.
BatchRecord run_batch(const Workload& workload, std::uint64_t seed, std::uint64_t first, std::uint64_t next);

/// Returns what makes one batch after the other, [first, next) each, with the workers of foreign methods
/// alive between them.
std::function<BatchRecord(std::uint64_t first, std::uint64_t next)> batch_maker(const Workload& workload,
                                                                                std::uint64_t seed);

}  // namespace cyl
