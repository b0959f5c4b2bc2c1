// SPDX-License-Identifier: MIT
// decide() in lanes, if the first sight proves it (decide.cpp): the same operations in the same order, so the
// same certificates. Included by one translation unit for each instruction set, like
// intersect_batch_kernel.hpp. CYL_DECIDE_KERNEL is the name of its entry.
#pragma once

#include "solver/detail/intersect_batch_kernel.hpp"

namespace cyl {
namespace {

/// The order of the roles, as out_of_order() has it.
[[gnu::always_inline]] inline bool swapped(const double* a, const double* b) {
  constexpr int places[] = {6, 7, 3, 4, 5, 0, 1, 2};  // radius, height, axis, centre
  for (const int i : places)
    if (a[i] != b[i]) return a[i] > b[i];
  return false;
}

/// 2^-k of a positive number in [2^k, 2^(k+1)).
Lanes unit_of(Lanes x) {
  constexpr long long exponent = 0x7ff0000000000000, turned = 2046ll << 52;
  return Vector(turned - (Bits(x.v) & exponent));
}

struct LaneProofs {
  Mask apart, overlaps;  ///< which are proved
  Lanes direction[3], tail[3];
};

struct Pieces {
  const Couple<Lanes>& p;
  const Products<Lanes>& q;
  const Sections<Lanes>& f;
};

/// shown_apart() and direction_of().
[[gnu::always_inline]] inline Mask prove_apart(const Pieces& of, Lanes error, Lanes turn,
                                               Lanes (&direction)[3]) {
  const auto& [p, q, f] = of;
  const Lanes most2 = p.r0 + f.c * p.r1, most3 = p.r1 + f.c * p.r0, radii = p.r0 + p.r1;
  const Lanes s2 = f.s2;
  const auto beyond = [&](Lanes k, Lanes square) { return signed_square(k - error) > s2 * square; };
  const Mask in0 = beyond(f.k0, p.r1 * p.r1), in1 = beyond(f.k1, p.r0 * p.r0),
             in2 = beyond(f.k2_s, most2 * most2), in3 = beyond(f.k3_s, most3 * most3),
             in_n = beyond(f.z_s, radii * radii);
  // The first that shows it.
  const auto first = [&](Lanes x0, Lanes x1, Lanes x2, Lanes x3, Lanes xn) {
    return pick(in0, x0, pick(in1, x1, pick(in2, x2, pick(in3, x3, xn))));
  };
  Lanes a = first(1.0, 0.0, q.cosine, -1.0, 0.0), b = first(0.0, 1.0, -1.0, q.cosine, 0.0),
        n = first(0.0, 0.0, 0.0, 0.0, 1.0);
  const Lanes towards = a * q.d0 + b * q.d1 + n * q.dn, sign = pick(towards < Lanes(0.0), -1.0, 1.0);
  a = sign * a;
  b = sign * b;
  n = sign * n;
  direction[0] = turn * (a * p.w0x + b * p.w1x + n * q.nx);
  direction[1] = turn * (a * p.w0y + b * p.w1y + n * q.ny);
  direction[2] = turn * (a * p.w0z + b * p.w1z + n * q.nz);
  return in0 | in1 | in2 | in3 | in_n;
}

/// FirstSlice.
struct SumOfSquares {
  Lanes unit, sum, square, h0, h1, r0, r1, rr0, rr1, d0, d1, dn, s2;
  Lanes along0, along1, across0, across1;         ///< the weights
  Lanes at0, at1, axial1, beside0, beside1, det;  ///< axial0 is at0
};

[[gnu::always_inline]] inline SumOfSquares sum_of_squares(const Pieces& of) {
  const auto& [p, q, f] = of;
  const Lanes radii = p.r0 + p.r1;
  SumOfSquares s;
  s.unit = unit_of(radii);
  s.sum = radii * s.unit;
  s.square = s.sum * s.sum;
  s.h0 = p.h0 * s.unit;
  s.h1 = p.h1 * s.unit;
  s.r0 = p.r0 * s.unit;
  s.r1 = p.r1 * s.unit;
  s.rr0 = s.r0 * s.r0;
  s.rr1 = s.r1 * s.r1;
  s.d0 = q.d0 * s.unit;
  s.d1 = q.d1 * s.unit;
  s.dn = q.dn * s.unit;
  s.s2 = f.s2 * s.square;
  const Lanes hh0 = s.h0 * s.h0, hh1 = s.h1 * s.h1, hh = hh0 * hh1 * s.square;
  const Lanes g = s.rr0 * s.rr1 * (s.s2 - s.dn * s.dn);
  s.along0 = hh1 * g;
  s.along1 = hh0 * g;
  s.across0 = hh * s.rr1;
  s.across1 = hh * s.rr0;
  return s;
}

/// find_least() and hand_out().
[[gnu::always_inline]] inline Mask find_least(const Pieces& of, Lanes error, Lanes least_det, SumOfSquares& s,
                                              Lanes (&tail)[3]) {
  const auto& [p, q, f] = of;
  const Lanes c2 = q.cosine * q.cosine;
  const Lanes m0 = s.along0 + s.across1 + c2 * s.across0, m1 = s.along1 + s.across0 + c2 * s.across1;
  const Lanes turned = q.cosine * (s.across0 + s.across1);
  const Lanes g0 = s.across1 * (s.d0 - q.cosine * s.d1), g1 = s.along1 * s.d1 - q.cosine * g0;
  s.det = m0 * m1 - turned * turned;
  s.at0 = m1 * g0 + turned * g1;
  s.at1 = m0 * g1 + turned * g0;
  const Lanes inverse = Lanes(1.0) / (s.det * (f.s2 * s.sum)), room = error * s.unit;
  const Lanes from0 = s.at0 - s.d0 * s.det, depth = s.det * s.dn, across_square = s.s2 * (s.det * s.det);
  s.axial1 = s.at1 - s.d1 * s.det;
  s.beside0 = s.at1 - q.cosine * s.at0;
  s.beside1 = from0 - q.cosine * s.axial1;
  const auto is_across = [&](Lanes beside, Lanes rr, Lanes r) {
    return beside * beside * s.square + depth * depth * rr < signed_square(r - room) * across_square;
  };
  const Mask overlaps = (s.det > least_det) & (magnitude(s.at0) < (s.h0 - room) * s.det) &
                        (magnitude(s.axial1) < (s.h1 - room) * s.det) & is_across(s.beside0, s.rr0, s.r0) &
                        is_across(s.beside1, s.rr1, s.r1);
  const Lanes scale = inverse * (p.r0 + p.r1), scaled0 = s.at0 * scale, scaled1 = s.at1 * scale;
  const Lanes a = scaled0 - q.cosine * scaled1, b = scaled1 - q.cosine * scaled0,
              c = q.dn * s.r0 * (inverse * s.det);
  tail[0] = a * p.w0x + b * p.w1x + c * q.nx;
  tail[1] = a * p.w0y + b * p.w1y + c * q.ny;
  tail[2] = a * p.w0z + b * p.w1z + c * q.nz;
  return overlaps;
}

/// find_point(), and find_point_again() for lanes of `asked` in which that fails but the filter has an
/// overlap.
[[gnu::always_inline]] inline Mask prove_overlap(const Pieces& of, Mask asked, Lanes error, Lanes least_det,
                                                 Lanes (&tail)[3]) {
  SumOfSquares s = sum_of_squares(of);
  const Mask overlaps = asked & find_least(of, error, least_det, s, tail);
  const Mask open = asked & negate(overlaps);
  if (bits(open) == 0) return overlaps;
  const auto filter = separating_axis_filter(of.f);
  const Mask hopeful = open & filter.overlaps & negate(filter.apart);
  if (bits(hopeful) == 0) return overlaps;
  const Lanes inverse = Lanes(1.0) / s.det, width = root(s.s2 - s.dn * s.dn) / s.sum;
  s.along0 = s.along0 * (magnitude(s.at0) * inverse / s.h0);
  s.along1 = s.along1 * (magnitude(s.axial1) * inverse / s.h1);
  s.across0 = s.across0 * (magnitude(s.beside0) * inverse / (s.r0 * width));
  s.across1 = s.across1 * (magnitude(s.beside1) * inverse / (s.r1 * width));
  Lanes again[3];
  const Mask overlap_again = hopeful & find_least(of, error, least_det, s, again);
  for (int i = 0; i < 3; ++i) tail[i] = pick(overlap_again, again[i], tail[i]);
  return overlaps | overlap_again;
}

[[gnu::always_inline]] inline LaneProofs prove(const Couple<Lanes>& p, Lanes turn, const DecideJob& job) {
  const Products<Lanes> q = products(p);
  LaneProofs found;
  found.apart = found.overlaps = Mask{};
  if (bits(magnitude(q.cosine) <= Lanes(steep_cosine)) == 0) return found;
  const Sections<Lanes> f = sections(p, q);
  const Lanes reach = p.r0 + p.r1 + p.h0 + p.h1 + magnitude(p.dx) + magnitude(p.dy) + magnitude(p.dz);
  const Mask steep = f.c <= Lanes(steep_cosine);
  const Pieces of{p, q, f};
  found.apart = steep & prove_apart(of, job.filter_error * reach, turn, found.direction);
  found.overlaps =
      prove_overlap(of, steep & negate(found.apart), job.point_error * reach, job.least_det, found.tail);
  return found;
}

}  // namespace

unsigned CYL_DECIDE_KERNEL(const DecideJob& job, unsigned* rest) {
  constexpr unsigned width = lanes;
  unsigned left = 0;
  for (unsigned start = 0; start < job.count; start += width) {
    const unsigned n = job.count - start < width ? job.count - start : width;
    Records r;
    unsigned ordinary = 0;
    Vector turn{};
    for (unsigned i = 0; i < width; ++i) {
      const unsigned k = start + (i < n ? i : n - 1);
      const double *a = record(job.a, job.pairs[2 * k]), *b = record(job.b, job.pairs[2 * k + 1]);
      const bool turned = swapped(a, b);
      const double* const roles[] = {a, b};
      r.first[i] = roles[turned];
      r.second[i] = roles[!turned];
      turn[i] = turned ? -1.0 : 1.0;
      ordinary |= (is_ordinary(a) & is_ordinary(b)) << i;
    }
    const LaneProofs found = prove(load(r.first, r.second), Lanes(turn), job);
    const unsigned apart = ordinary & bits(found.apart), overlaps = ordinary & bits(found.overlaps);
    for (unsigned i = 0; i < n; ++i) {
      AnswerRecord& answer = job.answers[start + i];
      if ((apart >> i & 1) != 0) {
        const Lanes* d = found.direction;
        answer = {0, proof_direction, {d[0].v[i], d[1].v[i], d[2].v[i]}, {0, 0, 0}, {0, 0, 0}, 0, 0, 0};
      } else if ((overlaps >> i & 1) != 0) {
        const double* c = r.first[i];
        const Lanes* t = found.tail;
        answer = {1, proof_point, {0, 0, 0}, {c[0], c[1], c[2]}, {t[0].v[i], t[1].v[i], t[2].v[i]}, 0, 0, 0};
      } else {
        rest[left++] = start + i;
      }
    }
  }
  return left;
}

}  // namespace cyl
