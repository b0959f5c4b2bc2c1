// SPDX-License-Identifier: MIT
// The interface between intersect_batch.cpp and its kernels, without a type that needs a header.
#pragma once

namespace cyl {

/// Pairs a kernel is given at most: its lists of open pairs stay on the stack and in the first cache.
inline constexpr unsigned batch_chunk = 1024;

/// A record is a Prepared: eight doubles, flags, and more (intersect_batch.cpp checks it).
inline constexpr unsigned long long record_bytes = 128;
inline constexpr unsigned long long record_traits = 65;  ///< their position; bit 0 is `ordinary`

struct BatchJob {
  const unsigned char *a, *b;  ///< the sets' first records
  const unsigned* pairs;       ///< two indices each
  unsigned count;              ///< <= batch_chunk
  unsigned char* verdicts;     ///< 0 disjoint, 1 intersecting, or:
};
inline constexpr unsigned batch_undecided = 3;  ///< at the work cap

/// Each answers what it can and returns how many it cannot (solids out of the ordinary), their places in
/// `rest`, which has room for all.
unsigned batch_baseline(const BatchJob& job, unsigned* rest);
#if defined(__x86_64__)
unsigned batch_v3(const BatchJob& job, unsigned* rest);
unsigned batch_v4(const BatchJob& job, unsigned* rest);
#endif

}  // namespace cyl
