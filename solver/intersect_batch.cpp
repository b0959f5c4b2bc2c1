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
static_assert(offsetof(Prepared, traits) == record_traits && Prepared::ordinary == 1);
static_assert(sizeof(IndexPair) == 2 * sizeof(unsigned) && sizeof(Verdict) == 1);
static_assert(static_cast<unsigned>(Verdict::undecided) == batch_undecided);

using Kernel = unsigned (*)(const BatchJob&, unsigned*);

// not covered within: each machine takes the branch of its processor
Kernel kernel_of(Instructions wanted) noexcept {
#if defined(__x86_64__)
  switch (std::min(wanted, best_instructions())) {
    case Instructions::v4:
      return batch_v4;
    case Instructions::v3:
      return batch_v3;
    case Instructions::baseline:
      break;
  }
#endif
  static_cast<void>(wanted);
  return batch_baseline;
}

void run(Kernel kernel, std::span<const Prepared> a, std::span<const Prepared> b,
         std::span<const IndexPair> pairs, Verdict* verdicts) noexcept {
  const BatchJob job{reinterpret_cast<const unsigned char*>(a.data()),
                     reinterpret_cast<const unsigned char*>(b.data()),
                     reinterpret_cast<const unsigned*>(pairs.data()), static_cast<unsigned>(pairs.size()),
                     reinterpret_cast<unsigned char*>(verdicts)};
  unsigned rest[batch_chunk];
  const unsigned left = kernel(job, rest);
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
  const Kernel kernel = kernel_of(instructions);
  for (std::size_t start = 0; start < pairs.size(); start += batch_chunk)
    run(kernel, a, b, pairs.subspan(start, std::min<std::size_t>(batch_chunk, pairs.size() - start)),
        verdicts + start);
}

}  // namespace cyl
