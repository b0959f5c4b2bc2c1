// SPDX-License-Identifier: MIT
#include "solver/intersect_batch.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "solver/detail/intersect_batch_job.hpp"

namespace cyl {
namespace {

static_assert(std::is_standard_layout_v<Prepared> && sizeof(Prepared) == record_bytes);
static_assert(offsetof(Prepared, center) == 0 && offsetof(Prepared, unit_axis) == 24);
static_assert(offsetof(Prepared, radius) == 48 && offsetof(Prepared, height) == 56);
static_assert(offsetof(Prepared, ordinary) == record_ordinary);  // what is rounded is left to the rest
static_assert(sizeof(IndexPair) == 2 * sizeof(unsigned) && sizeof(Verdict) == 1);
static_assert(static_cast<unsigned>(Verdict::undecided) == batch_undecided);

static_assert(std::is_standard_layout_v<Answer> && sizeof(Answer) == sizeof(AnswerRecord));
static_assert(offsetof(Answer, verdict) == offsetof(AnswerRecord, verdict) &&
              offsetof(Answer, proof) == offsetof(AnswerRecord, proof) &&
              offsetof(Answer, direction) == offsetof(AnswerRecord, direction) &&
              offsetof(Answer, point_head) == offsetof(AnswerRecord, point_head) &&
              offsetof(Answer, point_tail) == offsetof(AnswerRecord, point_tail) &&
              offsetof(Answer, hull_a) == offsetof(AnswerRecord, hull_a) &&
              offsetof(Answer, hull_b) == offsetof(AnswerRecord, hull_b) &&
              offsetof(Answer, iterations) == offsetof(AnswerRecord, iterations));
static_assert(static_cast<int>(Proof::direction) == proof_direction &&
              static_cast<int>(Proof::point) == proof_point && static_cast<int>(Hull::space) == 0);

struct Kernels {
  unsigned (*intersect)(const BatchJob&, unsigned*);
  unsigned (*decide)(const DecideJob&, unsigned*);
};

// not covered within: each machine takes the branch of its processor
Kernels kernels_of(Instructions wanted) noexcept {
#if defined(__x86_64__)
  switch (std::min(wanted, best_instructions())) {
    case Instructions::v4:
      return {batch_v4, decide_v4};
    case Instructions::v3:
      return {batch_v3, decide_v3};
    case Instructions::baseline:
      break;
  }
#endif
  static_cast<void>(wanted);
  return {batch_baseline, decide_baseline};
}

void run(const Kernels& kernels, std::span<const Prepared> a, std::span<const Prepared> b,
         std::span<const IndexPair> pairs, Verdict* verdicts) noexcept {
  const BatchJob job{reinterpret_cast<const unsigned char*>(a.data()),
                     reinterpret_cast<const unsigned char*>(b.data()),
                     reinterpret_cast<const unsigned*>(pairs.data()), static_cast<unsigned>(pairs.size()),
                     reinterpret_cast<unsigned char*>(verdicts)};
  unsigned rest[batch_chunk];
  const unsigned left = kernels.intersect(job, rest);
  for (unsigned i = 0; i < left; ++i) verdicts[rest[i]] = intersect(a[pairs[rest[i]].a], b[pairs[rest[i]].b]);
}

}  // namespace

// not covered within: each machine takes the branch of its processor
Instructions best_instructions() noexcept {
#if defined(__x86_64__)
  static const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                         __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  static const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                         __builtin_cpu_supports("avx512vl");
  return v4 ? Instructions::v4 : v3 ? Instructions::v3 : Instructions::baseline;
#else
  return Instructions::baseline;
#endif
}

void intersect_batch(std::span<const Prepared> a, std::span<const Prepared> b,
                     std::span<const IndexPair> pairs, Verdict* verdicts,
                     Instructions instructions) noexcept {
  const Kernels kernels = kernels_of(instructions);
  for (std::size_t start = 0; start < pairs.size(); start += batch_chunk)
    run(kernels, a, b, pairs.subspan(start, std::min<std::size_t>(batch_chunk, pairs.size() - start)),
        verdicts + start);
}

// not covered within: the gate asks decide() for certificates, and intersect_batch_test asks here
void decide_batch(std::span<const Prepared> a, std::span<const Prepared> b, std::span<const IndexPair> pairs,
                  Answer* answers, Instructions instructions) noexcept {
  const Kernels kernels = kernels_of(instructions);
  for (std::size_t start = 0; start < pairs.size(); start += batch_chunk) {
    const auto chunk = pairs.subspan(start, std::min<std::size_t>(batch_chunk, pairs.size() - start));
    const DecideJob job{reinterpret_cast<const unsigned char*>(a.data()),
                        reinterpret_cast<const unsigned char*>(b.data()),
                        reinterpret_cast<const unsigned*>(chunk.data()),
                        static_cast<unsigned>(chunk.size()),
                        reinterpret_cast<AnswerRecord*>(answers + start),
                        filter_error,
                        point_error,
                        least_det};
    unsigned rest[batch_chunk];
    const unsigned left = kernels.decide(job, rest);
    for (unsigned i = 0; i < left; ++i)
      answers[start + rest[i]] = decide(a[chunk[rest[i]].a], b[chunk[rest[i]].b]);
  }
}

// not covered within: the gate asks for pairs, not for all of two sets, and intersect_batch_test does
void intersect_all(std::span<const Prepared> a, std::span<const Prepared> b, Verdict* verdicts,
                   Instructions instructions) noexcept {
  const Kernels kernels = kernels_of(instructions);
  IndexPair pairs[batch_chunk];
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      pairs[count++] = {i, j};
      if (count < batch_chunk) continue;
      run(kernels, a, b, pairs, verdicts);
      verdicts += count;
      count = 0;
    }
  }
  if (count > 0) run(kernels, a, b, {pairs, count}, verdicts);
}

}  // namespace cyl
