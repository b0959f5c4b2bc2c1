// SPDX-License-Identifier: MIT
// The interface between intersect_batch.cpp and its kernels, without a type that needs a header.
#pragma once

namespace cyl {

/// Pairs a kernel is given at most: its lists of open pairs stay on the stack and in the first cache.
inline constexpr unsigned batch_chunk = 1024;

/// A record is a Prepared: eight doubles, then flags (intersect_batch.cpp checks it).
inline constexpr unsigned long long record_bytes = 80;
inline constexpr unsigned long long record_ordinary = 65;  ///< the position of the flag `ordinary`

struct BatchJob {
  const unsigned char *a, *b;  ///< the sets' first records
  const unsigned* pairs;       ///< two indices each
  unsigned count;              ///< <= batch_chunk
  unsigned char* verdicts;     ///< 0 disjoint, 1 intersecting, or:
};
inline constexpr unsigned batch_undecided = 3;  ///< at the work cap

/// An Answer (intersect_batch.cpp checks it).
struct AnswerRecord {
  unsigned char verdict, proof;
  double direction[3], point_head[3], point_tail[3];
  unsigned char hull_a, hull_b;
  int iterations;
};
inline constexpr unsigned char proof_direction = 1, proof_point = 2;

struct DecideJob {
  const unsigned char *a, *b;  ///< as in BatchJob
  const unsigned* pairs;
  unsigned count;
  AnswerRecord* answers;
  double filter_error, point_error, least_det;  ///< of decide(), which shares no header with the kernels
};

/// Each answers what it can and returns how many it cannot (solids out of the ordinary), their places in
/// `rest`, which has room for all.
unsigned batch_baseline(const BatchJob& job, unsigned* rest);
#if defined(__x86_64__)
unsigned batch_v3(const BatchJob& job, unsigned* rest);
unsigned batch_v4(const BatchJob& job, unsigned* rest);
#endif

/// The same of certificates; what is left may be anything.
unsigned decide_baseline(const DecideJob& job, unsigned* rest);
#if defined(__x86_64__)
unsigned decide_v3(const DecideJob& job, unsigned* rest);
unsigned decide_v4(const DecideJob& job, unsigned* rest);
#endif

}  // namespace cyl
