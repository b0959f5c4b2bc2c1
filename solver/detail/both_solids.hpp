// SPDX-License-Identifier: MIT
// The first slice and the five directions of one pair, for both solids at a time. One operation on two
// numbers here does the work of sections.hpp for both solids. The roundings and their order are the same, so
// the verdicts are the same.
#pragma once

#include "solver/detail/frame.hpp"

namespace cyl {

/// A number of either solid, of the first in lane 0.
typedef double Both __attribute__((vector_size(16)));
typedef long long BothBits __attribute__((vector_size(16)));

inline Both both(double x) noexcept { return Both{x, x}; }
inline Both crosswise(Both x) noexcept { return __builtin_shufflevector(x, x, 1, 0); }
inline Both magnitude(Both x) noexcept {
  constexpr long long all_but_sign = 0x7fffffffffffffff;
  return Both(BothBits(x) & all_but_sign);
}

/// Bit i is lane i.
inline unsigned bits(BothBits mask) noexcept {
#if defined(__SSE2__)
  return static_cast<unsigned>(__builtin_ia32_movmskpd(Both(mask)));
#else
  return (mask[0] != 0 ? 1u : 0u) | (mask[1] != 0 ? 2u : 0u);
#endif
}

/// Products and Sections of sections.hpp, by their names there: d holds d0 and d1, k holds k0 and k1, k_s
/// holds k2_s and k3_s. For ordinary solids.
struct SectionsOfBoth {
  Both r, h, d, k, k_s;
  double dx, dy, dz, cosine, nx, ny, nz, dn;
  double c, s2, z_s;

  Both other_r() const noexcept { return crosswise(r); }
  Both most() const noexcept { return r + c * other_r(); }  ///< most2, most3
  double radii() const noexcept { return r[0] + r[1]; }
  Sections<double> of_each() const noexcept {
    return {r[0], r[1], c, root(s2), s2, z_s, k[0], k[1], k_s[0], k_s[1]};
  }
};

/// separating_axis_filter(), both solids at a time.
[[gnu::always_inline]] inline FilterResult<bool> separating_axis_filter(const SectionsOfBoth& f) noexcept {
  const double radii = f.radii(), square = radii * radii, rest = f.s2 * square - f.z_s * f.z_s;
  const Both rr = f.r * f.r, other_rr = crosswise(rr), most = f.most(), mm = most * most;
  const Both kk = f.k * magnitude(f.k), kk_s = f.k_s * magnitude(f.k_s);
  const unsigned apart = (rest < 0 ? 1u : 0u) | bits(kk > f.s2 * other_rr) | bits(kk_s > f.s2 * mm);
  const unsigned overlaps = bits(kk * square <= rest * other_rr) & bits(kk_s * square <= rest * mm);
  return {apart != 0, overlaps == 3};
}

[[gnu::always_inline]] inline double cosine_of(const Prepared& a, const Prepared& b) noexcept {
  return dot(a.unit_axis, b.unit_axis);
}

/// For a pair of axes with that cosine, at most steep_cosine.
[[gnu::always_inline]] inline SectionsOfBoth sections_of_both(const Prepared& a, const Prepared& b,
                                                              double cosine) noexcept {
  const Vector3 &v = a.unit_axis, &w = b.unit_axis;
  SectionsOfBoth f;
  f.cosine = cosine;
  f.dx = b.center.x() - a.center.x();
  f.dy = b.center.y() - a.center.y();
  f.dz = b.center.z() - a.center.z();
  f.r = Both{a.radius, b.radius};
  f.h = Both{a.height, b.height} * 0.5;
  f.d = f.dx * Both{v.x(), w.x()} + f.dy * Both{v.y(), w.y()} + f.dz * Both{v.z(), w.z()};
  f.nx = v.y() * w.z() - v.z() * w.y();
  f.ny = v.z() * w.x() - v.x() * w.z();
  f.nz = v.x() * w.y() - v.y() * w.x();
  f.dn = f.dx * f.nx + f.dy * f.ny + f.dz * f.nz;
  f.s2 = f.nx * f.nx + f.ny * f.ny + f.nz * f.nz;
  f.c = magnitude(cosine);
  f.z_s = magnitude(f.dn);
  const Both other_h = crosswise(f.h);
  f.k = magnitude(f.d) - f.h - other_h * f.c;
  f.k_s = magnitude(cosine * f.d - crosswise(f.d)) - other_h * f.s2;
  return f;
}

}  // namespace cyl
