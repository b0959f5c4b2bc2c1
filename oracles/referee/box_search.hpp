// SPDX-License-Identifier: MIT
// The referee's own search for the nearest points of a box and another core, in numbers of any kind
// (Gilbert, Johnson, Keerthi 1988). The points b - a of two cores form a convex body. The search holds up to
// four of its points, and the point of their hull that is nearest to the origin. Each round adds a point of
// the body that is lowest along that nearest one, and keeps the points that hold the new nearest one.
//
// In exact numbers the search of two polytopes ends, because the distance falls and there are finitely many
// corners. In others its result is a guess.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/vec3.hpp"
#include "corpus/pairs/support.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// A point of b's core less one of a's, and the one of a's, relative to a's centre.
template <class R>
struct BodyCorner {
  Vec3<R> at{}, on_a{};
};

template <class R>
struct Simplex {
  std::array<BodyCorner<R>, 4> corners{};
  std::array<R, 4> weights{};  ///< of the corners in the nearest point; > 0 after reduce()
  std::size_t count = 0;
  Vec3<R> nearest{};  ///< points from a to b
  R square{};         ///< of its length

  Vec3<R> on_a() const {
    Vec3<R> x{R(0.0), R(0.0), R(0.0)};
    for (std::size_t i = 0; i < count; ++i) x = x + weights[i] * corners[i].on_a;
    return x;
  }
  /// Is on_a() and the nearest point, up to rounding errors that do not lead out of b's core.
  Vec3<R> on_b() const {
    Vec3<R> x = on_a();
    for (std::size_t i = 0; i < count; ++i) x = x + weights[i] * corners[i].at;
    return x;
  }

  /// Keeps the corners of the face that has the nearest point inside. `thin` is the square of a sine.
  /// Corners that are in a line or plane up to that do not count as a triangle or tetrahedron. If
  /// `with_last`, only faces with the last corner are tried.
  void reduce(const R& thin, bool with_last) {
    const R zero(0.0);
    Simplex best;
    for (unsigned face = 1; face < 1U << count; ++face) {
      if (with_last && (face >> (count - 1)) == 0) continue;
      Simplex s;
      for (std::size_t i = 0; i < count; ++i)
        if ((face >> i & 1U) != 0) s.corners[s.count++] = corners[i];
      if (s.find_nearest(thin, zero) && (best.count == 0 || s.square < best.square)) best = std::move(s);
    }
    *this = std::move(best);
  }

 private:
  /// Returns whether the nearest point of the flat through all corners is strictly between them.
  bool find_nearest(const R& thin, const R& zero) {
    const Vec3<R>&p = corners[0].at, &q = corners[1].at, &r = corners[2].at, &t = corners[3].at;
    if (count == 1) {
      weights[0] = R(1.0);
      nearest = p;
    } else if (count == 2) {
      const Vec3<R> e = q - p;
      const R total = dot(e, e), w = dot(q, e);
      if (!(w > zero && w < total)) return false;
      weights[0] = w / total;
      weights[1] = R(1.0) - weights[0];
      nearest = weights[0] * p + weights[1] * q;
    } else if (count == 3) {
      const Vec3<R> e = q - p, f = r - p, n = cross(e, f);
      const R total = dot(n, n);
      if (!(total > thin * dot(e, e) * dot(f, f))) return false;
      const R a = dot(n, cross(q, r)), b = dot(n, cross(r, p)), c = dot(n, cross(p, q));
      if (!(a > zero && b > zero && c > zero)) return false;
      const R height = dot(n, p) / total, sum = a + b + c;
      weights = {R(a / sum), R(b / sum), R(c / sum), zero};
      nearest = height * n;
    } else {
      const Vec3<R> e = q - p, f = r - p, g = t - p;
      const R volume = dot(cross(e, f), g), a = dot(cross(q, r), t), b = R(zero - dot(cross(p, r), t)),
              c = dot(cross(p, q), t), d = R(zero - dot(cross(p, q), r));
      if (!(volume * volume > thin * dot(e, e) * dot(f, f) * dot(g, g))) return false;
      const bool positive = a > zero && b > zero && c > zero && d > zero,
                 negative = a < zero && b < zero && c < zero && d < zero;
      if (!positive && !negative) return false;
      const R sum = a + b + c + d;
      weights = {R(a / sum), R(b / sum), R(c / sum), R(d / sum)};
      nearest = {zero, zero, zero};
    }
    square = dot(nearest, nearest);
    return true;
  }
};

template <class R>
struct SimplexLimits {
  R fine{};                ///< a length below which rounding has the word; 0 in exact numbers
  R thin{};                ///< as in reduce()
  R contact{};             ///< the search compares the distance with this length, >= 0
  bool sign_only = false;  ///< ends as soon as the comparison is certain
  int rounds_cap = 0;
};

/// Goes on from the simplex, which is reduced, until its nearest point is that of the body. `lowest(d)`
/// returns a corner at which d.at is least.
template <class R, class Lowest>
void approach(Simplex<R>& s, const SimplexLimits<R>& limits, Lowest&& lowest) {
  const R zero(0.0), fine = limits.fine * limits.fine, over = limits.contact + limits.fine,
                     under = limits.contact - limits.fine, farther = over * over, nearer = under * under;
  for (int round = 0; round < limits.rounds_cap; ++round) {
    if (!(s.square > fine)) return;
    if (limits.sign_only && under > zero && s.square < nearer) return;
    const BodyCorner<R> corner = lowest(s.nearest);
    const R least = dot(s.nearest, corner.at), slack = s.square - least;
    if (limits.sign_only && least > zero && least * least > farther * s.square) return;
    if (!(slack > zero) || slack * slack < fine * s.square) return;
    Simplex<R> next = s;
    next.corners[next.count++] = corner;
    next.reduce(limits.thin, true);
    if (next.count == 0 || !(next.square < s.square)) return;
    s = std::move(next);
  }
}

/// A pair in numbers of one kind; b's centre is relative to a's.
template <class R>
struct TermsPair {
  Terms<R> a, b;
  Vec3<R> delta;
};

/// A legal pair of bounded solids in double or Twin, with all lengths times 2^-exponent so that the largest
/// is near 1. Numbers that become subnormal are rounded, which moves no point by more than 2^-1070.
template <class R>
TermsPair<R> terms_in_unit(const Pair& pair, int& exponent);

template <class R>
TermsPair<R> terms_of_pair(const Pair& pair) {
  return {terms_of<R>(pair.a), terms_of<R>(pair.b), lifted<R>(pair.b.center) - lifted<R>(pair.a.center)};
}

/// A length that bounds all points b - a of the cores.
template <class R>
R reach_of(const TermsPair<R>& p) {
  R reach = norm(p.delta);
  for (const Terms<R>* s : {&p.a, &p.b})
    reach = s->box ? R(reach + s->halves[0] + s->halves[1] + s->halves[2]) : R(reach + s->radius + s->half);
  return reach;
}

/// x 2^-bits.
template <class R>
R with_fewer_bits(R x, int bits) {
  for (; bits > 0; bits -= 1000) x = x * R(std::ldexp(1.0, -(bits < 1000 ? bits : 1000)));
  return x;
}

template <class R>
BodyCorner<R> lowest_corner(const TermsPair<R>& p, const Vec3<R>& d) {
  const Vec3<R> on_a = farthest(p.a, d);
  return {p.delta + farthest(p.b, R(-1.0) * d) - on_a, on_a};
}

/// Searches from a corner of the body for the nearest points of the cores.
template <class R>
Simplex<R> search_box(const TermsPair<R>& p, const SimplexLimits<R>& limits) {
  const auto lowest = [&](const Vec3<R>& d) { return lowest_corner(p, d); };
  Simplex<R> s;
  s.corners[s.count++] = lowest(p.delta);
  s.reduce(limits.thin, false);
  approach(s, limits, lowest);
  return s;
}

/// Searches with `bits` of precision for the nearest points of the cores, or until their distance is
/// certainly above or below the sum of both roundings. If the cores meet, both points are a common one. A
/// flat or touched side costs most of the digits of a common point's distance from it. Cost in double: 1 us
/// if `sign_only`, else 2 to 10 us.
template <class R>
Simplex<R> search_box(const TermsPair<R>& p, int bits, bool sign_only) {
  SimplexLimits<R> limits;
  limits.fine = with_fewer_bits(reach_of(p), bits - 4);
  limits.thin = with_fewer_bits(R(1.0), bits - 8);
  limits.contact = p.a.rounding + p.b.rounding;
  limits.sign_only = sign_only;
  limits.rounds_cap = 3 * bits;
  return search_box(p, limits);
}

}  // namespace cyl
