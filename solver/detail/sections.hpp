// SPDX-License-Identifier: MIT
// The decision as arithmetic on numbers of any kind: one pair in doubles, or several in the lanes of a
// vector. The same operations in the same order, so the same verdicts. Derivations: derivation.md. Users call
// decide.hpp and intersect_batch.hpp; nothing here checks its arguments. No
// include, so that a translation unit compiled for another instruction set shares no code with the rest of
// the program.
//
// T is double, or a type with + - * /, comparisons that give a mask, and what is below for double. Lengths
// with a bar in derivation.md (times s) end in _s here.
#pragma once

namespace cyl {

inline double root(double x) noexcept { return __builtin_sqrt(x); }
inline double magnitude(double x) noexcept { return __builtin_fabs(x); }
inline double larger(double a, double b) noexcept { return a < b ? b : a; }
inline double smaller(double a, double b) noexcept { return b < a ? b : a; }
/// max(x, 0) exactly, and never a branch that the data decides.
inline double positive(double x) noexcept { return 0.5 * (x + magnitude(x)); }
inline double pick(bool mask, double a, double b) noexcept { return mask ? a : b; }
inline bool negate(bool mask) noexcept { return !mask; }

/// The error of F' as computed, relative to the radii's sum: five roundings, upwards.
inline constexpr double slope_error = 0x1p-50;
/// A smaller cosine counts as 0 to the edges: it moves their ends by less than a rounding of the radii.
inline constexpr double least_cosine = 0x1p-60;

/// Two solids: unit axes, Delta from the first centre to the second, radii and half heights.
template <class T>
struct Couple {
  T w0x, w0y, w0z, w1x, w1y, w1z;
  T dx, dy, dz;
  T r0, h0, r1, h1;
};

/// The parts of the slices parallel to both axes (derivation.md, section 1).
template <class T>
struct Sections {
  T r0, r1;
  T c, s, s2;    ///< cosine (>= 0), sine and its square of the angle between the axes
  T z_s;         ///< s times the distance of the axes' lines
  T k0, k1;      ///< |Delta.e_j| less the heights' reach, along w0 and w1
  T k2_s, k3_s;  ///< s times the same along m0 and m1
};

/// The largest cosine for which sections() is accurate: a sine of 1/8 or more.
inline constexpr double steep_cosine = 0.99215;
/// Axes of a smaller squared sine count as parallel: below an angle of 2^-49 their difference may be mostly a
/// rounding of their lengths. It moves no point of a solid by more than 2^-50 of its height.
inline constexpr double parallel_square = 0x1p-98;

/// The products behind sections().
template <class T>
struct Products {
  T cosine;      ///< of the axes, with its sign
  T nx, ny, nz;  ///< w0 x w1
  T d0, d1, dn;  ///< Delta along w0, w1 and w0 x w1
};

template <class T>
[[gnu::always_inline]] inline Products<T> products(const Couple<T>& p) noexcept {
  const T nx = p.w0y * p.w1z - p.w0z * p.w1y;
  const T ny = p.w0z * p.w1x - p.w0x * p.w1z;
  const T nz = p.w0x * p.w1y - p.w0y * p.w1x;
  return {p.w0x * p.w1x + p.w0y * p.w1y + p.w0z * p.w1z,
          nx,
          ny,
          nz,
          p.dx * p.w0x + p.dy * p.w0y + p.dz * p.w0z,
          p.dx * p.w1x + p.dy * p.w1y + p.dz * p.w1z,
          p.dx * nx + p.dy * ny + p.dz * nz};
}

/// For axes at an angle: c <= steep_cosine.
template <class T>
[[gnu::always_inline]] inline Sections<T> sections(const Couple<T>& p, const Products<T>& q) noexcept {
  Sections<T> f;
  f.r0 = p.r0;
  f.r1 = p.r1;
  f.c = magnitude(q.cosine);
  f.s2 = q.nx * q.nx + q.ny * q.ny + q.nz * q.nz;
  f.s = root(f.s2);
  f.z_s = magnitude(q.dn);
  f.k0 = magnitude(q.d0) - p.h0 - p.h1 * f.c;
  f.k1 = magnitude(q.d1) - p.h1 - p.h0 * f.c;
  f.k2_s = magnitude(q.cosine * q.d0 - q.d1) - p.h1 * f.s2;
  f.k3_s = magnitude(q.cosine * q.d1 - q.d0) - p.h0 * f.s2;
  return f;
}

template <class T>
[[gnu::always_inline]] inline Sections<T> sections(const Couple<T>& p) noexcept {
  return sections(p, products(p));
}

/// The same at any angle, for s2 >= parallel_square. With w1 reversed if the axes point apart, everything
/// comes from their difference (section 6).
template <class T>
Sections<T> shallow_sections(const Couple<T>& p) noexcept {
  const T cosine = p.w0x * p.w1x + p.w0y * p.w1y + p.w0z * p.w1z;
  const T turn = pick(cosine < T(0), T(-1), T(1));
  const T ax = turn * p.w1x, ay = turn * p.w1y, az = turn * p.w1z;
  const T ex = p.w0x - ax, ey = p.w0y - ay, ez = p.w0z - az;
  const T sx = p.w0x + ax, sy = p.w0y + ay, sz = p.w0z + az;
  const T nx = 0.5 * (ey * sz - ez * sy), ny = 0.5 * (ez * sx - ex * sz), nz = 0.5 * (ex * sy - ey * sx);
  // Delta along the axes, from its parts along their sum and their difference. Rounding of the first part
  // changes both equally, like a shift along the axes.
  const T de = p.dx * ex + p.dy * ey + p.dz * ez, middle = 0.5 * (p.dx * sx + p.dy * sy + p.dz * sz);
  const T d0 = middle + 0.5 * de, d1 = middle - 0.5 * de;
  const T e0 = ex * p.w0x + ey * p.w0y + ez * p.w0z, e1 = ex * ax + ey * ay + ez * az;
  Sections<T> f;
  f.r0 = p.r0;
  f.r1 = p.r1;
  f.c = magnitude(cosine);
  f.s2 = nx * nx + ny * ny + nz * nz;
  f.s = root(f.s2);
  f.z_s = magnitude(p.dx * nx + p.dy * ny + p.dz * nz);
  f.k0 = magnitude(d0) - p.h0 - p.h1 * f.c;
  f.k1 = magnitude(d1) - p.h1 - p.h0 * f.c;
  f.k2_s = magnitude(de - e0 * d0) - p.h1 * f.s2;
  f.k3_s = magnitude(de - e1 * d1) - p.h0 * f.s2;
  return f;
}

/// Axes parallel, as parallel_square has it: the solids are apart along their direction or across it. The
/// axes' sum is 2 long but for rounding.
template <class T>
auto apart_in_parallel(const Couple<T>& p) noexcept {
  const T turn = pick(p.w0x * p.w1x + p.w0y * p.w1y + p.w0z * p.w1z < T(0), T(-1), T(1));
  const T sx = p.w0x + turn * p.w1x, sy = p.w0y + turn * p.w1y, sz = p.w0z + turn * p.w1z;
  const T along = p.dx * sx + p.dy * sy + p.dz * sz, reach = 2.0 * (p.r0 + p.r1);
  const T ax = p.dy * sz - p.dz * sy, ay = p.dz * sx - p.dx * sz, az = p.dx * sy - p.dy * sx;
  return (magnitude(along) > 2.0 * (p.h0 + p.h1)) | (ax * ax + ay * ay + az * az > reach * reach);
}

/// The roles in an order of their own, which scaling by 2^k, reversing an axis and swapping the roles do
/// not change. The code after separating_axis_filter is not symmetric. If all of it is equal, so are the
/// roles.
template <class T>
Sections<T> in_order(const Sections<T>& f) noexcept {
  const auto swapped =
      (f.r0 > f.r1) | ((f.r0 == f.r1) & ((f.k0 > f.k1) | ((f.k0 == f.k1) & (f.k2_s > f.k3_s))));
  return {pick(swapped, f.r1, f.r0),
          pick(swapped, f.r0, f.r1),
          f.c,
          f.s,
          f.s2,
          f.z_s,
          pick(swapped, f.k1, f.k0),
          pick(swapped, f.k0, f.k1),
          pick(swapped, f.k3_s, f.k2_s),
          pick(swapped, f.k2_s, f.k3_s)};
}

template <class Mask>
struct FilterResult {
  Mask apart, overlaps;
};

/// x^2 with the sign of x.
template <class T>
T signed_square(T x) noexcept {
  return x * magnitude(x);
}

/// Five rejections and one slice, in squares, without a division or a root. They decide most pairs (section
/// 2). Symmetric in the roles bit for bit. If both are true, apart counts.
template <class T>
[[gnu::always_inline]] inline auto separating_axis_filter(const Sections<T>& f) noexcept {
  const T radii = f.r0 + f.r1, most2 = f.r0 + f.c * f.r1, most3 = f.c * f.r0 + f.r1;
  const T square = radii * radii, rest = f.s2 * square - f.z_s * f.z_s;  // (s (r0 + r1) q)^2
  const T k0 = signed_square(f.k0), k1 = signed_square(f.k1);
  const T k2 = signed_square(f.k2_s), k3 = signed_square(f.k3_s);
  const T rr0 = f.r0 * f.r0, rr1 = f.r1 * f.r1, mm2 = most2 * most2, mm3 = most3 * most3;
  const auto apart =
      (rest < T(0)) | (k0 > f.s2 * rr1) | (k1 > f.s2 * rr0) | (k2 > f.s2 * mm2) | (k3 > f.s2 * mm3);
  const auto overlaps = (k0 * square <= rest * rr1) & (k1 * square <= rest * rr0) &
                        (k2 * square <= rest * mm2) & (k3 * square <= rest * mm3);
  return FilterResult<decltype(apart | overlaps)>{apart, overlaps};
}

/// Relative, of the square of a radius: more than the roundings of the two squares compared with it.
inline constexpr double square_error = 0x1p-48;

/// Whether a solid of radius r has at no width from `least` on half the length `half`.
template <class T>
auto too_long(T r, T least, T half) noexcept {
  return least * least + half * half > r * r * T(1 + square_error);
}

/// The corner of the widths (x, y) that the normals demand, nearest to the maximum of H, and the direction in
/// which H still rises from it (section 3).
template <class T, class Mask>
struct Corner {
  T r0, r1, c, z;
  T x0, y0, k2, k3;  ///< demands: x >= x0, y >= y0, x + c y >= k2, c x + y >= k3
  T x, y;
  T u, v;               ///< half lengths along n that solid 0 has at width x, solid 1 at y
  Mask on2, on3;        ///< the corner lies on x + c y = k2, on c x + y = k3
  Mask rises2, rises3;  ///< H rises along that line
  Mask overlaps;        ///< H >= 0 at the corner
  Mask cannot_improve;  ///< H rises, but not to 0 (section 4)
};

/// Not for pairs that are apart by the separating-axis filter.
template <class T>
auto corner(const Sections<T>& f) noexcept {
  const T inverse = T(1) / f.s;
  const T c = pick(f.c < T(least_cosine), T(0), f.c);
  const T z = f.z_s * inverse, k2 = f.k2_s * inverse, k3 = f.k3_s * inverse;
  const T x0 = positive(f.k1 * inverse), y0 = positive(f.k0 * inverse);
  const T crossing = (k2 - c * k3) / f.s2;
  // Left of x0 the crossing leaves the first line no part in the boundary, below y0 the second.
  const auto beyond = crossing > x0;
  const T upper = pick(beyond, crossing, x0);
  const T level = k3 - c * upper;
  const auto on3 = level > y0;
  const T y = pick(on3, level, y0);
  const T foot = k2 - c * y0;
  const T x = pick(on3, upper, larger(x0, foot));
  const auto on2 = beyond & (on3 | (foot > x0));
  const T u = root(positive((f.r0 - x) * (f.r0 + x))), v = root(positive((f.r1 - y) * (f.r1 + y)));
  // H falls with x at the rate x/u and with y at y/v.
  const T fall0 = x * v, fall1 = y * u;
  const auto rises2 = on2 & (fall1 < c * fall0);
  const auto rises3 = on3 & negate(rises2) & (c * fall1 > fall0);
  const auto overlaps = (x <= f.r0) & (y <= f.r1) & (u + v >= z);
  // Up the first line y grows to r1 at most and u has to make up for what v lacks of z. The same holds down
  // the second.
  const auto vain2 = too_long(f.r0, positive(x - c * positive(f.r1 - y)), positive(z - v));
  const auto vain3 = too_long(f.r1, positive(y - c * positive(f.r0 - x)), positive(z - u));
  const auto cannot_improve = (rises2 & vain2) | (rises3 & vain3);
  return Corner<T, decltype(overlaps & on2)>{
      f.r0, f.r1, c, z, x0, y0, k2, k3, x, y, u, v, on2, on3, rises2, rises3, overlaps, cannot_improve};
}

/// One line a + c b = k of the two, from the corner up to the least a: solid `a` has weight 1 in it, solid
/// `b` weight c.
template <class T>
struct Edge {
  T ra, rb, c, z, k;
  T least_width;  ///< of a
};

template <class T, class Mask>
Edge<T> edge(const Corner<T, Mask>& at) noexcept {
  const auto& first = at.rises2;
  return {pick(first, at.r0, at.r1), pick(first, at.r1, at.r0), at.c, at.z,
          pick(first, at.k2, at.k3), pick(first, at.x0, at.y0)};
}

template <class T, class Mask>
struct Top {
  T cb, u, cv;          ///< c times the width of b, u of a, c times v of b
  Mask here, overlaps;  ///< H is greatest at the edge's far end; and is >= 0 there
};

/// The far end, at which a's width is least.
template <class T>
auto top(const Edge<T>& e) noexcept {
  const T cb = e.k - e.least_width;
  const T u = root(positive((e.ra - e.least_width) * (e.ra + e.least_width)));
  const T cr = e.c * e.rb, cv = root(positive((cr - cb) * (cr + cb)));
  const auto here = (cb <= cr) & (cb * u <= e.c * (e.least_width * cv));
  return Top<T, decltype(here & here)>{cb, u, cv, here, here & (e.c * u + cv >= e.c * e.z)};
}

/// Inside the edge: F(t) = ra sqrt(1 + t^2) + rb sqrt(c^2 + t^2) - k - z t, the support gap of the direction
/// e + t n, is convex. The solids meet iff its least value is not negative (section 5).
template <class T, class Mask>
struct Step {
  T t;                   ///< where to look next
  T min_gap;             ///< min F, about
  Mask apart, overlaps;  ///< min F < 0; min F >= 0
  Mask found;            ///< it is known to the last place
};

template <class T>
struct Start {
  T low;  ///< a t not above that of the minimum
  T t;    ///< a better one, not below `low`
};

/// The start of the search (section 5): bounds of the minimum's t from either side, the first of them exact
/// for small t, the second for large. Neither is above 64. F(t) is known up to a rounding of sqrt(1 + t^2),
/// and only at small t can F be below 0 by more than that.
template <class T>
Start<T> start(const Edge<T>& e) noexcept {
  const T radii = e.ra + e.rb, q = root(positive((radii - e.z) * (radii + e.z)));
  const T tilt = e.z / larger(q, e.z * 0x1p-60), share = e.z / radii;
  const T below = smaller(T(64), tilt * (e.c * radii / (e.c * e.ra + e.rb)));
  const T above = smaller(T(64), tilt * root((e.ra + e.c * e.c * e.rb) / radii));
  return {below, below + share * share * (above - below)};
}

/// F looked at in t, and the next t.
template <class T>
auto step(const Edge<T>& e, T low, T t) noexcept {
  const T c2 = e.c * e.c, t2 = t * t;
  const T s1 = root(1.0 + t2), s2 = root(c2 + t2);
  const T i1 = 1.0 / s1, i2 = 1.0 / s2;
  const T p1 = e.ra * i1, p2 = e.rb * i2;
  const T bend1 = p1 * i1 * i1, bend2 = c2 * p2 * i2 * i2;
  const T value = (e.ra * s1 - e.k) + (e.rb * s2 - e.z * t);
  const T slope = t * (p1 + p2) - e.z;
  const T bend = bend1 + bend2;                                  // F'' > 0, falling
  const T turn = 3.0 * t * (bend1 * i1 * i1 + bend2 * i2 * i2);  // -F'''
  const T newton = -slope / bend;
  const T share = newton * i2;  // of the length over which F'' can change
  const T model = value + 0.5 * slope * newton;
  const T rest = positive(1.0 - 2.0 * share);
  const T sag = s2 * (1.0 - root(rest));
  const T other = value - 0.5 * bend * sag * sag;
  const auto far = share >= 0.25;
  // Known: what the bounds leave open, or all that a slope this small can still bring, is rounding.
  const T radii = e.ra + e.rb, gain = magnitude(slope * newton * share);
  const auto close = negate(far) & (gain <= 0x1p-56 * radii * s1);
  const auto found = close | (magnitude(slope) <= slope_error * radii);
  const T tried = t + pick(far | (slope > 0.0), newton, newton * bend / (bend - 0.5 * turn * newton));
  const T next = pick(tried > low, tried, root(low * t));
  const auto apart = (model < 0.0) & (found | (share >= 0.0) | (other < 0.0));
  const auto overlaps = (model >= 0.0) & (found | ((share < 0.5) & (other >= 0.0)));
  return Step<T, decltype(overlaps & apart)>{next, model, apart, overlaps, found};
}

}  // namespace cyl
