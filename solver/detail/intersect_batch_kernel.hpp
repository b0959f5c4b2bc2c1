// SPDX-License-Identifier: MIT
// The batch kernel, in lanes. One translation unit for each instruction set includes it, and defines
// CYL_KERNEL (its entry) and CYL_LANES. Everything else has internal linkage and no header but the
// intrinsics' comes in, so that no code for one instruction set can be linked in for another.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "solver/detail/intersect_batch_job.hpp"
#include "solver/detail/iteration_cap.hpp"
#include "solver/detail/sections.hpp"

namespace cyl {
namespace {

constexpr int lanes = CYL_LANES;
typedef double Vector __attribute__((vector_size(8 * CYL_LANES)));
typedef long long Bits __attribute__((vector_size(8 * CYL_LANES)));
typedef double Two __attribute__((vector_size(16), aligned(8)));

struct Mask {
  Bits v;
  friend Mask operator&(Mask a, Mask b) { return {a.v & b.v}; }
  friend Mask operator|(Mask a, Mask b) { return {a.v | b.v}; }
};

struct Lanes {
  Vector v;
  Lanes() = default;
  Lanes(Vector x) : v(x) {}
  Lanes(double x) : v(x - Vector{}) {}
  friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  friend Lanes operator-(Lanes a) { return -a.v; }
  friend Mask operator<(Lanes a, Lanes b) { return {a.v < b.v}; }
  friend Mask operator>(Lanes a, Lanes b) { return {a.v > b.v}; }
  friend Mask operator<=(Lanes a, Lanes b) { return {a.v <= b.v}; }
  friend Mask operator>=(Lanes a, Lanes b) { return {a.v >= b.v}; }
  friend Mask operator==(Lanes a, Lanes b) { return {a.v == b.v}; }
};

Lanes root(Lanes x) {
#if CYL_LANES == 8 && defined(__AVX512F__)
  return Vector(_mm512_maskz_sqrt_pd(0xff, __m512d(x.v)));
#elif CYL_LANES == 4 && defined(__AVX__)
  return Vector(_mm256_sqrt_pd(__m256d(x.v)));
#elif CYL_LANES == 2 && defined(__SSE2__)
  return Vector(_mm_sqrt_pd(__m128d(x.v)));
#else
  Vector y;
  for (int i = 0; i < lanes; ++i) y[i] = __builtin_sqrt(x.v[i]);
  return y;
#endif
}

Lanes magnitude(Lanes x) {
  constexpr long long all_but_sign = 0x7fffffffffffffff;
  return Vector(Bits(x.v) & all_but_sign);
}
Lanes pick(Mask mask, Lanes a, Lanes b) { return Vector((mask.v & Bits(a.v)) | (~mask.v & Bits(b.v))); }
Lanes larger(Lanes a, Lanes b) { return pick(a < b, b, a); }
Lanes smaller(Lanes a, Lanes b) { return pick(b < a, b, a); }
Lanes positive(Lanes x) { return 0.5 * (x + magnitude(x)); }
Mask negate(Mask mask) { return {~mask.v}; }

/// Bit i is lane i.
unsigned bits(Mask mask) {
#if CYL_LANES == 8 && defined(__AVX512DQ__)
  return _mm512_movepi64_mask(__m512i(mask.v));
#elif CYL_LANES == 4 && defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(__m256d(mask.v)));
#elif CYL_LANES == 2 && defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(__m128d(mask.v)));
#else
  unsigned all = 0;
  for (int i = 0; i < lanes; ++i) all |= (mask.v[i] != 0 ? 1u : 0u) << i;
  return all;
#endif
}

/// Numbers k and k + 1 of each record, in lanes.
[[gnu::always_inline]] inline void load(const double* const* records, int k, Lanes& first, Lanes& second) {
  auto two = [&](int i) { return *reinterpret_cast<const Two*>(records[i] + k); };
#if CYL_LANES == 2
  const Vector x = two(0), y = two(1);
  first.v = __builtin_shufflevector(x, y, 0, 2);
  second.v = __builtin_shufflevector(x, y, 1, 3);
#elif CYL_LANES == 4
  const Vector x = __builtin_shufflevector(two(0), two(2), 0, 1, 2, 3);
  const Vector y = __builtin_shufflevector(two(1), two(3), 0, 1, 2, 3);
  first.v = __builtin_shufflevector(x, y, 0, 4, 2, 6);
  second.v = __builtin_shufflevector(x, y, 1, 5, 3, 7);
#else
  auto four = [&](int i, int j) { return __builtin_shufflevector(two(i), two(j), 0, 1, 2, 3); };
  const Vector x = __builtin_shufflevector(four(0, 2), four(4, 6), 0, 1, 2, 3, 4, 5, 6, 7);
  const Vector y = __builtin_shufflevector(four(1, 3), four(5, 7), 0, 1, 2, 3, 4, 5, 6, 7);
  first.v = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
  second.v = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
#endif
}

/// A record: centre, unit axis, radius, height.
[[gnu::always_inline]] inline Couple<Lanes> load(const double* const* first, const double* const* second) {
  Lanes ax, ay, az, bx, by, bz, ha, hb;
  Couple<Lanes> p;
  load(first, 0, ax, ay);
  load(first, 2, az, p.w0x);
  load(first, 4, p.w0y, p.w0z);
  load(first, 6, p.r0, ha);
  load(second, 0, bx, by);
  load(second, 2, bz, p.w1x);
  load(second, 4, p.w1y, p.w1z);
  load(second, 6, p.r1, hb);
  p.dx = bx - ax;
  p.dy = by - ay;
  p.dz = bz - az;
  p.h0 = ha * 0.5;
  p.h1 = hb * 0.5;
  return p;
}

/// The work of `settle` of intersect.cpp, for lanes that the separating-axis filter does not decide. `open`
/// keeps the lanes that reach the cap.
Mask resolve_at_edge(const Sections<Lanes>& f, Mask& open) {
  const auto at = corner(in_order(f));
  Mask overlaps = at.overlaps;
  open = open & negate(at.overlaps | at.cannot_improve) & (at.rises2 | at.rises3);
  if (bits(open) == 0) return overlaps;
  const Edge<Lanes> e = edge(at);
  const auto end = top(e);
  overlaps = overlaps | (open & end.here & end.overlaps);
  open = open & negate(end.here);
  if (bits(open) == 0) return overlaps;
  const auto first = start(e);
  Lanes t = first.t;
  // not covered: no pair that was ever seen comes to the cap
  for (int i = 0; i < iteration_cap && bits(open) != 0; ++i) {
    const auto now = step(e, first.low, t);
    overlaps = overlaps | (open & now.overlaps);
    open = open & negate(now.apart | now.overlaps);
    t = now.t;
  }
  return overlaps;
}

const double* record(const unsigned char* set, unsigned index) {
  return reinterpret_cast<const double*>(set + index * record_bytes);
}

unsigned is_ordinary(const double* record) {
  return reinterpret_cast<const unsigned char*>(record)[record_traits] & 1u;
}

struct Records {
  const double *first[lanes], *second[lanes];
};

/// Pairs at indices[0 .. count), the last one repeated in lanes that are left over.
Records find(const BatchJob& job, const unsigned* indices, unsigned count) {
  Records r;
  for (unsigned i = 0; i < static_cast<unsigned>(lanes); ++i) {
    const unsigned k = indices[i < count ? i : count - 1];
    r.first[i] = record(job.a, job.pairs[2 * k]);
    r.second[i] = record(job.b, job.pairs[2 * k + 1]);
  }
  return r;
}

/// Axes nearly parallel; `open` gets those that reach the cap.
Mask meet_shallow(const Couple<Lanes>& p, Mask& open) {
  const Sections<Lanes> f = shallow_sections(p);
  const auto filter = separating_axis_filter(f);
  const Mask parallel = f.s2 < parallel_square;
  Mask overlaps =
      (filter.overlaps & negate(filter.apart) & negate(parallel)) | (parallel & negate(apart_in_parallel(p)));
  open = negate(parallel | filter.apart | filter.overlaps);
  if (bits(open) != 0) {
    const Mask asked = open;
    overlaps = overlaps | (resolve_at_edge(f, open) & asked);
  }
  return overlaps;
}

/// Pairs at indices[0 .. count): axes at an angle, which the separating-axis filter has left open, or nearly
/// parallel ones.
template <bool steep>
void finish(const BatchJob& job, const unsigned* indices, unsigned count) {
  for (unsigned start = 0; start < count; start += static_cast<unsigned>(lanes)) {
    // not covered: the gate asks batches of one pair, and batches_test asks all sizes
    const unsigned n =
        count - start < static_cast<unsigned>(lanes) ? count - start : static_cast<unsigned>(lanes);
    const Records r = find(job, indices + start, n);
    const Couple<Lanes> p = load(r.first, r.second);
    Mask overlaps, open;
    if constexpr (steep) {
      open = p.r0 >= Lanes(0.0);  // all
      overlaps = resolve_at_edge(sections(p), open);
    } else {
      overlaps = meet_shallow(p, open);
    }
    const unsigned overlap_bits = bits(overlaps), open_bits = bits(open);
    for (unsigned i = 0; i < n; ++i)
      job.verdicts[indices[start + i]] =
          static_cast<unsigned char>((open_bits >> i & 1) != 0 ? batch_undecided : overlap_bits >> i & 1);
  }
}

}  // namespace

unsigned CYL_KERNEL(const BatchJob& job, unsigned* rest) {
  constexpr unsigned width = lanes, all = (1u << width) - 1;
  unsigned steep[batch_chunk] = {}, flat[batch_chunk] = {}, steep_count = 0, flat_count = 0, left = 0;
  for (unsigned start = 0; start < job.count; start += width) {
    // not covered: the same
    const unsigned n = job.count - start < width ? job.count - start : width;
    Records r;
    unsigned ordinary = 0;
    for (unsigned i = 0; i < width; ++i) {
      const unsigned k = start + (i < n ? i : n - 1);
      r.first[i] = record(job.a, job.pairs[2 * k]);
      r.second[i] = record(job.b, job.pairs[2 * k + 1]);
      ordinary |= (is_ordinary(r.first[i]) & is_ordinary(r.second[i])) << i;
    }
    const Couple<Lanes> p = load(r.first, r.second);
    const Products<Lanes> q = products(p);
    const unsigned at_angle = bits(magnitude(q.cosine) <= steep_cosine);
    unsigned overlaps, seen;
    if (at_angle == 0) {  // in batches of parallel pairs all are
      const Mask one_axis = (p.w0x == p.w1x) & (p.w0y == p.w1y) & (p.w0z == p.w1z);
      Mask open{};
      overlaps = bits(bits(one_axis) == all ? negate(apart_in_parallel(p)) : meet_shallow(p, open));
      seen = all & ~bits(open);
    } else {
      const auto filter = separating_axis_filter(sections(p, q));
      overlaps = all & ~bits(filter.apart);
      seen = at_angle & (~overlaps | bits(filter.overlaps));
    }
    const unsigned decided = ordinary & seen;
    for (unsigned i = 0; i < n; ++i) job.verdicts[start + i] = static_cast<unsigned char>(overlaps >> i & 1);
    if (decided == all) continue;  // not covered: the same
    for (unsigned i = 0; i < n; ++i) {
      if (decided >> i & 1) continue;
      if (!(ordinary >> i & 1))
        rest[left++] = start + i;
      else if (at_angle >> i & 1)
        steep[steep_count++] = start + i;
      else
        flat[flat_count++] = start + i;
    }
  }
  finish<true>(job, steep, steep_count);
  finish<false>(job, flat, flat_count);
  return left;
}

}  // namespace cyl
