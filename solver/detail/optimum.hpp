// SPDX-License-Identifier: MIT
// Certificates at the height at which H is greatest. The deepest slice is there. The multipliers of the
// demands that hold it there are the weights of a direction (derivation.md, section 7). For decide() alone.
//
// F is a frame in numbers of one kind, F::Scalar: its sections `f`, its slices(), a point at(x, y, u) of
// them, and direction(i, a, j, b, c), which is a e_i + b e_j + c n.
#pragma once

#include <utility>

#include "solver/detail/iteration_cap.hpp"
#include "solver/detail/slice_point.hpp"

namespace cyl {

// The five directions and the slice that decide most pairs. True if nothing is left to search.
template <class F>
bool prove_by_filter(ProofTask& q, const Scaled& p, const F& frame) noexcept {
  using T = typename F::Scalar;
  const Sections<T>& f = frame.f;
  const auto filter = separating_axis_filter(f);
  if (filter.apart) {
    const T most[] = {f.s * f.r1, f.s * f.r0, f.s * (f.r0 + f.c * f.r1), f.s * (f.c * f.r0 + f.r1)};
    const T k[] = {f.k0, f.k1, f.k2_s, f.k3_s};
    const auto attempt = [&](int j, double weight, double along_n) {
      return try_direction(q, frame.direction(j, T(weight), 0, T(0), T(along_n)));
    };
    if (f.z_s > f.s * (f.r0 + f.r1) && attempt(0, 0, 1)) return true;
    for (int j = 0; j < 4; ++j)
      if (k[j] > most[j] && attempt(j, 1, 0)) return true;
    return false;
  }
  const double radii = p.r0 + p.r1;
  return filter.overlaps &&
         try_slice(q, p, frame, radii > 0 ? frame.slices().z * T(p.r0 / radii) : T(0), false);
}

// The middle of the slices in which both widths suffice: at most u from C0 and v from C1.
template <class F, class T>
bool try_middle(ProofTask& q, const Scaled& p, const F& frame, T u, T v) noexcept {
  return try_slice(q, p, frame, middle_of_both(u, frame.slices().z, v), true);
}

// Widths x, y and half lengths u, v of two disks.
template <class T>
struct Widths {
  T x, u, y, v;
};

// Half lengths u and v at the demanded widths that leave a gap, u + v < z. Near a tip (u or v is 0) the
// multipliers, x/u and y/v, are unbounded. A quarter of the gap more for either, and the widths that go with
// it, demand less. With u' + v' < z still, their direction has f <= u' + v' - z, because r^2 - x' x <= u'^2
// for x' <= x.
template <class T>
Widths<T> beside_tips(T r0, T u, T r1, T v, T z) noexcept {
  const T spare = (z - (u + v)) * T(0.25);
  u = larger(u, smaller(r0, spare));
  v = larger(v, smaller(r1, spare));
  return {root(positive((r0 - u) * (r0 + u))), u, root(positive((r1 - v) * (r1 + v))), v};
}

// The direction whose weights are the multipliers of the demands that hold the corner, which has no slice.
template <class F, class At>
void separate_at_corner(ProofTask& q, const F& frame, const At& at) noexcept {
  using T = typename F::Scalar;
  const Sections<T>& f = frame.f;
  const auto try_widths = [&](T x, T u, T y, T v) {
    if (!(x > T(0) || u > T(0))) u = 1;  // a segment: only x/u and y/v count
    if (!(y > T(0) || v > T(0))) v = 1;
    const T fall0 = x * v, fall1 = y * u, uv = u * v;
    return try_direction(
        q, at.on2 & at.on3 ? frame.direction(2, positive(fall0 - f.c * fall1), 3,
                                             positive(fall1 - f.c * fall0), f.s2 * uv)
           : at.on2        ? frame.direction(2, f.s * fall0, 0, positive(fall1 - f.c * fall0), f.s * uv)
           : at.on3        ? frame.direction(3, f.s * fall1, 1, positive(fall0 - f.c * fall1), f.s * uv)
                           : frame.direction(1, fall0, 0, fall1, f.s * uv));
  };
  const auto [x, u, y, v] = beside_tips(f.r0, at.u, f.r1, at.v, at.z);
  if (try_widths(x, u, y, v)) return;
  // If a demand is more than a radius, or the multipliers leave the cone of the demands, then smaller demands
  // leave room for all directions.
  for (const double share : {1.0, 0.5, 0.25}) {
    const T less0 = T(share) * at.x, less1 = T(share) * at.y;
    if (try_widths(less0, root(positive((f.r0 - less0) * (f.r0 + less0))), less1,
                   root(positive((f.r1 - less1) * (f.r1 + less1)))))
      return;
  }
}

// At the far end of the edge.
template <class F, class T>
void separate_at_top(ProofTask& q, const F& frame, int line, const Edge<T>& e, T u, T cv) noexcept {
  const auto [x, u_now, y, v] = beside_tips(e.ra, u, e.rb, cv / e.c, e.z);
  // not covered: x is 0 if the radius is, and u with it. A tip, of width 0, cannot be a top, since k > 0.
  const T slope = x > T(0) || u_now > T(0) ? u_now : T(1), cb = e.c * y, c_v = e.c * v;
  try_direction(q, frame.direction(line, frame.f.s * (cb * slope), line == 2 ? 1 : 0,
                                   positive(e.c * (x * c_v) - cb * slope), e.c * frame.f.s * (slope * c_v)));
}

// Up the line along which H rises from the corner, of the pair `p`.
template <class F, class At>
void prove_on_edge(ProofTask& q, const Scaled& p, const F& frame, const At& at) noexcept {
  using T = typename F::Scalar;
  constexpr int miss_cap = 12;        // verdicts whose certificate does not hold: at most so many are usual
  constexpr double far_tol = 0x1p60;  // a tilt beyond which e + t n is n
  const int line = at.rises2 ? 2 : 3;
  const Edge<T> e = edge(at);
  // u and v as the edge has them: of solid a, of solid b.
  const auto try_edge_point = [&](T u, T v) {
    if (!at.rises2) std::swap(u, v);
    return try_middle(q, p, frame, u, v);
  };
  const auto end = top(e);
  if (end.here) {
    if (end.overlaps)
      try_edge_point(end.u, end.cv / e.c);
    else
      separate_at_top(q, frame, line, e, end.u, end.cv);
    return;
  }
  const auto [low, first] = start(e);
  T t = first;
  int misses = 0;
  // not covered: no pair that was ever seen comes to the first of the caps
  for (int i = 0; i < iteration_cap && misses < miss_cap && t <= T(far_tol); ++i) {
    ++q.answer.iterations;
    const auto now = step(e, low, t);
    if (now.apart) {
      // Far out F hardly falls any more; a smaller t weighs its depth against a shorter direction.
      const T tilt = smaller(t, (e.ra + e.rb) / -now.min_gap);
      if (try_direction(q, frame.direction(line, T(1), 0, T(0), tilt))) return;
    }
    if (now.overlaps) {
      const T next = now.t;  // F is flat at its minimum, the slice is not: one step more
      const T u = e.ra * next / root(T(1) + next * next), v = e.rb * next / root(e.c * e.c + next * next);
      if (try_edge_point(u, v)) return;
    }
    misses += now.found | now.apart;
    if (now.found) {  // what is left is rounding: how near are both?
      if (!q.no_slack()) try_direction(q, frame.direction(line, T(1), 0, T(0), now.t));
      if (!q.no_gap()) try_edge_point(e.ra * t / root(T(1) + t * t), e.rb * t / root(e.c * e.c + t * t));
      if (q.no_gap() & q.no_slack()) return;
    }
    t = now.t;
  }
}

// The search runs on `p`: the pair itself, or one a little larger or smaller.
template <class F>
void prove_at_optimum(ProofTask& q, const Scaled& p, const F& frame) noexcept {
  const auto at = corner(frame.f);
  if (at.overlaps && try_middle(q, p, frame, at.u, at.v)) return;
  if (at.rises2 | at.rises3) prove_on_edge(q, p, frame, at);
  // Also if the edge gave no proof. With axes almost perpendicular its first steps are shorter than a
  // rounding of the widths, and H at the corner is as great as anywhere.
  if (q.answer.proof == Proof::none && !at.overlaps) separate_at_corner(q, frame, at);
  if (q.answer.proof != Proof::none) return;
  // So that q knows how near both are.
  if (at.overlaps)
    separate_at_corner(q, frame, at);
  else
    try_middle(q, p, frame, at.u, at.v);
}

}  // namespace cyl
