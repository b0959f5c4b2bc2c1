// SPDX-License-Identifier: MIT
// The methods and pairs of a campaign, and the pair of each index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

/// The methods and the pairs. Index i of a run is case i while there are cases. Then the families take turns,
/// and at the end of each round the corpus of a fuzzer.
struct Workload {
  std::span<const std::unique_ptr<Method>> methods;
  std::span<const Family> families;
  std::span<const Case> cases;
  std::span<const Pair> corpus = {};
  /// After all pairs of the corpus, further ones are changes of them by a seed. Not null if there is a
  /// corpus.
  Pair (*change)(const Pair& pair, std::uint64_t seed) = nullptr;
};

/// The family of an index of a run, and the index in it.
struct FamilyIndex {
  std::size_t family;   ///< 0 for the cases, f for families[f - 1], and then the corpus
  std::uint64_t index;  ///< of the case, or of the family's own pairs
};
FamilyIndex family_index_of(const Workload& workload, std::uint64_t index);
Pair pair_at(const Workload& workload, std::uint64_t seed, const FamilyIndex& at);
std::string family_name(const Workload& workload, std::size_t family);
/// Returns the pair at an index as a line of a file of cases.
std::string format_case_at(const Workload& workload, std::uint64_t seed, std::uint64_t index,
                           const FamilyIndex& at, const Pair& pair, const Truth& truth);
/// The number of families, those of the cases and of the corpus included.
std::size_t family_count(const Workload& workload);

/// Returns whether a method with a share of one in `share` is asked about an index. It is drawn from seed and
/// index, so that no family and no turn of the families is missed.
bool on_share(unsigned share, std::uint64_t seed, std::uint64_t index);

/// Returns whether a method is asked that is not ours.
bool any_foreign(const Workload& workload);

/// Indices of a batch, about a second of work for the packaged methods. Each batch costs two new workers (one
/// of them confirms the findings) and hands over its counts and the findings that the run may keep. In
/// smaller batches that takes longer than the answers of a fast library, or of our own methods. Programs
/// answer slowly, so their batches are short: the campaign shows progress, and a lost batch costs little.
inline constexpr std::uint64_t batch_size = 2048, own_batch_size = 131072, program_batch_size = 512;
std::uint64_t batch_size_for(const Workload& workload);

}  // namespace cyl
