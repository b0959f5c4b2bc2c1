// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "base/enum_words.hpp"
#include "corpus/pairs/checks_test.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "solver/detail/frame.hpp"
#include "solver/detail/intersect_batch_job.hpp"
#include "solver/intersect_batch.hpp"

namespace cyl {
namespace {

/// About the widths of the kernels and the number of pairs that they are given at once.
constexpr std::size_t sizes[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 40, 1023, 1024, 1025, 3000};
constexpr std::size_t times_of_a_size = 12;

/// Solids, and pairs of them whose verdicts are known; those drawn together, or any two.
struct Batch {
  std::vector<Prepared> a, b;
  std::vector<IndexPair> pairs;
  std::vector<Verdict> single;
};

Batch draw_batch(const std::vector<Pair>& drawn, std::size_t size, RandomStream& stream) {
  Batch batch;
  // Out of the ordinary all, none or some of them.
  const std::size_t odd = stream.below(3);
  const std::size_t solids = std::max<std::size_t>(1, size * 2 / 3);
  for (std::size_t i = 0; i < solids; ++i) {
    Pair pair = drawn[stream.below(drawn.size())];
    if (stream.below(8) < odd * odd) pair = scaled(pair, stream.coin() ? 300 : -300);
    if (stream.below(64) < odd) pair.a.radius = -1;
    batch.a.push_back(prepare(pair.a));
    batch.b.push_back(prepare(pair.b));
  }
  const bool alike = stream.coin();
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = stream.below(solids), other = stream.below(8) == 0 ? stream.below(solids) : at;
    const std::size_t first = alike ? i % solids : at, second = alike ? i % solids : other;
    batch.pairs.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second)});
    batch.single.push_back(intersect(batch.a[first], batch.b[second]));
  }
  return batch;
}

/// All that is drawn, each pair once.
Batch whole_batch(const std::vector<Pair>& drawn) {
  Batch batch;
  for (const Pair& pair : drawn) {
    const auto at = static_cast<std::uint32_t>(batch.pairs.size());
    batch.a.push_back(prepare(pair.a));
    batch.b.push_back(prepare(pair.b));
    batch.pairs.push_back({at, at});
    batch.single.push_back(intersect(batch.a[at], batch.b[at]));
  }
  return batch;
}

/// The memory behind the last verdict does not change.
constexpr std::size_t room = 64;
constexpr Verdict untouched{0xaa};

void ask_in_batch(const Batch& batch, Instructions wanted) {
  const std::size_t size = batch.pairs.size();
  std::vector<Verdict> verdicts(size + 2 * room, untouched);
  intersect_batch(batch.a, batch.b, batch.pairs, verdicts.data() + room, wanted);
  const auto start = verdicts.begin() + room, end = start + static_cast<std::ptrdiff_t>(size);
  check_that(std::equal(start, end, batch.single.begin()), "batches: a verdict of another pair, of", size,
             "on instructions", static_cast<int>(wanted));
  const auto is_untouched = [](Verdict v) { return v == untouched; };
  check_that(
      std::all_of(verdicts.begin(), start, is_untouched) && std::all_of(end, verdicts.end(), is_untouched),
      "batches: written beside, of", size);
}

/// A kernel leaves to intersect() what is out of the ordinary, and nothing else.
void count_left(const Batch& batch, Instructions wanted) {
  const unsigned count = static_cast<unsigned>(std::min<std::size_t>(batch.pairs.size(), batch_chunk));
  std::vector<Verdict> verdicts(count + 1);
  unsigned rest[batch_chunk], odd = 0;
  for (const IndexPair& pair : std::span(batch.pairs).first(count))
    odd += !both_are(Prepared::ordinary, batch.a[pair.a], batch.b[pair.b]);
  const BatchJob job{reinterpret_cast<const unsigned char*>(batch.a.data()),
                     reinterpret_cast<const unsigned char*>(batch.b.data()),
                     reinterpret_cast<const unsigned*>(batch.pairs.data()), count,
                     reinterpret_cast<unsigned char*>(verdicts.data())};
  unsigned left = 0;
#if defined(__x86_64__)
  if (wanted == Instructions::v4) left = batch_v4(job, rest);
  if (wanted == Instructions::v3) left = batch_v3(job, rest);
#endif
  if (wanted == Instructions::baseline) left = batch_baseline(job, rest);
  check_that(left == odd, "batches: left to single questions:", left, "that should be", odd, "of", count);
}

TEST(SolverBatches, AnswerAsSinglePairs) {
  std::vector<Pair> drawn;
  for (const PairsOfKind& kind : draw_pairs(drawing_seed))
    drawn.insert(drawn.end(), kind.pairs.begin(), kind.pairs.end());
  const Batch whole = whole_batch(drawn);
  for (const Instructions wanted : enum_values<Instructions>)
    if (wanted <= best_instructions()) ask_in_batch(whole, wanted);
  for (std::uint64_t i = 0; i < std::size(sizes) * times_of_a_size; ++i) {
    RandomStream stream("batches", drawing_seed, i);
    const std::size_t size = sizes[i % std::size(sizes)];
    const Batch batch = draw_batch(drawn, size, stream);
    for (const Instructions wanted : enum_values<Instructions>) {
      if (wanted > best_instructions()) continue;
      ask_in_batch(batch, wanted);
      count_left(batch, wanted);
    }
  }
}

}  // namespace
}  // namespace cyl
