// SPDX-License-Identifier: MIT
// A pair prepared for the computation in doubles: brought to a unit in which nothing overflows, with its
// common normal and its slices. Only for files of solver/. Symbols as in derivation.md: half heights, Delta
// from the first centre to the second.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/decide.hpp"
#include "solver/detail/sections.hpp"

namespace cyl {

// A solid is `moderate` if its lengths are 0 or within 2^-200 to 2^200, and its coordinates 0 or within
// 2^-250 to 2^250.
inline constexpr int moderate_exponent = 200, center_exponent = 50;
// Sets the traits of a solid without a defect.
void mark_traits(Prepared& p) noexcept;
inline bool both_are(Prepared::Trait t, const Prepared& a, const Prepared& b) noexcept {
  return (a.traits & b.traits & t) != 0;
}

// 2^exponent for -1022 <= exponent <= 1023.
constexpr double power_of_two(int exponent) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// floor(log2 x) of a normal positive x; of a subnormal one -1023.
inline int exponent_of(double x) noexcept {
  return static_cast<int>((std::bit_cast<std::uint64_t>(x) >> 52) & 0x7ff) - 1023;
}

// 2^-exponent, or the least normal power of two.
inline double unit_of(int exponent) noexcept { return exponent > 1022 ? 0x1p-1022 : power_of_two(-exponent); }

// Without a branch: which of the two it is cannot be predicted.
inline Verdict verdict_of(bool meets) noexcept {
  static_assert(static_cast<int>(Verdict::disjoint) == 0 && static_cast<int>(Verdict::intersecting) == 1);
  return static_cast<Verdict>(meets);
}

inline double max_abs(const Vector3& x) noexcept {
  return larger(std::fabs(x.x()), larger(std::fabs(x.y()), std::fabs(x.z())));
}

inline double dot(const Vector3& a, const Vector3& b) noexcept {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

inline double length(const Vector3& a) noexcept { return std::sqrt(dot(a, a)); }

// The middle of what [-reach0, reach0] and [center1 - reach1, center1 + reach1] have in common.
template <class T>
T middle_of_both(T reach0, T center1, T reach1) noexcept {
  return (larger(-reach0, center1 - reach1) + smaller(reach0, center1 + reach1)) * T(0.5);
}

// The fixed order of the roles, which makes the swap law hold bit for bit. It does not depend on anything
// that scaling by 2^k or reversing an axis changes. True if b comes first.
inline bool out_of_order(const Prepared& a, const Prepared& b) noexcept {
  if (a.radius != b.radius) return a.radius > b.radius;
  if (a.height != b.height) return a.height > b.height;
  for (int i = 0; i < 3; ++i)
    if (a.unit_axis[i] != b.unit_axis[i]) return a.unit_axis[i] > b.unit_axis[i];
  for (int i = 0; i < 3; ++i)
    if (a.center[i] != b.center[i]) return a.center[i] > b.center[i];
  return false;
}

// The pair in a unit of 2^exponent in which nothing below overflows or loses digits to underflow. If both
// solids are ordinary (prepare), it is the scene's unit. Else the largest of radii, heights and |Delta| is in
// [1, 2). Powers of two change no digit, so answers do not show which of the two it is.
struct Scaled {
  const Vector3 &w0, &w1;
  Vector3 delta;
  double r0, h0, r1, h1;  // h0, h1: half heights
  int exponent;

  Couple<double> couple() const noexcept {
    return {w0.x(), w0.y(), w0.z(), w1.x(), w1.y(), w1.z(), delta.x(), delta.y(), delta.z(), r0, h0, r1, h1};
  }
};

// Both ordinary.
inline Scaled as_it_is(const Prepared& a, const Prepared& b) noexcept {
  return {a.unit_axis,    b.unit_axis, b.center - a.center, a.radius,
          a.height * 0.5, b.radius,    b.height * 0.5,      0};
}

// `room`: a length that must not overflow in the unit either.
inline Scaled scale(const Prepared& a, const Prepared& b, double room = 0) noexcept {
  if (both_are(Prepared::ordinary, a, b)) return as_it_is(a, b);
  const double widest = larger(larger(larger(a.radius, b.radius), larger(a.height, b.height)), room);
  Vector3 delta = b.center - a.center;
  double most = larger(widest, max_abs(delta));
  // `before` restores a Delta that overflowed (smaller terms do not matter then). It brings the largest
  // lengths into the range in which a normal factor takes them to 1, and lifts subnormal pairs in the same
  // way.
  int shift = 0;
  if (!(most < 0x1p1023))
    shift = -100;
  else if (most < 0x1p-1000)
    shift = 200;
  double radius0 = a.radius, height0 = a.height, radius1 = b.radius, height1 = b.height;
  if (shift != 0) {
    const double before = power_of_two(shift);
    delta = shift < 0 ? Vector3(b.center * before - a.center * before) : Vector3(delta * before);
    radius0 *= before;
    height0 *= before;
    radius1 *= before;
    height1 *= before;
    most = larger(widest * before, max_abs(delta));
  }
  const int exponent = most > 0 ? exponent_of(most) : 0;
  const double unit = power_of_two(-exponent), half = unit * 0.5;
  return {a.unit_axis,    b.unit_axis,    delta * unit,   radius0 * unit,
          height0 * half, radius1 * unit, height1 * half, exponent - shift};
}

// f(d), or f(-d) if that is smaller.
inline double support_gap(const Scaled& p, const Vector3& d) noexcept {
  return p.r0 * length(d.cross(p.w0)) + p.h0 * std::fabs(dot(d, p.w0)) + p.r1 * length(d.cross(p.w1)) +
         p.h1 * std::fabs(dot(d, p.w1)) - std::fabs(dot(d, p.delta));
}

// w0 x w1 from the sum and the difference of the axes (with one reversed if they are opposite). Up to the
// rounding of their lengths these two are perpendicular, so their cross product is accurate relative to its
// own length at any angle. Swapping the roles changes at most the sign of `cross`.
struct Axes {
  Axes(const Vector3& w0, const Vector3& w1) noexcept : cosine(dot(w0, w1)) {
    const Vector3 aligned = w1 * std::copysign(1.0, cosine);
    sum = w0 + aligned;
    difference = w0 - aligned;
    cross = difference.cross(sum) * 0.5;
    square = dot(cross, cross);
  }
  bool parallel() const noexcept { return square < parallel_square; }

  // x along w0 and along w1, from its parts along sum and difference. Rounding then changes both almost
  // equally, like a shift along the axes, and their difference stays as accurate as it is small.
  std::array<double, 2> along(const Vector3& x) const noexcept {
    const double middle = 0.5 * dot(x, sum), half = 0.5 * dot(x, difference);
    return {middle + half, std::copysign(1.0, cosine) * (middle - half)};
  }

  double cosine;
  Vector3 sum, difference, cross;  // cross = w0 x w1 up to sign
  double square;                   // |cross|^2
};

// The slices parallel to both axes, in the first solid's coordinates: along w0, along m0, and along n, by
// which a slice is named.
template <class T>
struct Slices {
  T along, beside, z;  // Delta
  T cosine, sine;      // w1, along w0 and along m0
};

// A pair at work: its vectors, the common normal n with n.Delta >= 0, m_i = w_i x n, and what the slices
// need. The axes are not parallel.
struct Frame {
  Frame(const Scaled& p, const Axes& axes) noexcept : w0(p.w0), w1(p.w1), delta(p.delta) {
    const double s = std::sqrt(axes.square), beside = dot(delta, axes.cross), c = std::fabs(axes.cosine);
    n = axes.cross * std::copysign(1 / s, beside);
    m0 = w0.cross(n);
    m1 = w1.cross(n);
    const auto [d0, d1] = axes.along(delta);
    d[0] = d0;
    d[1] = d1;
    d[2] = dot(delta, m0);
    d[3] = dot(delta, m1);
    z = std::fabs(beside) / s;
    f = {p.r0,
         p.r1,
         c,
         s,
         axes.square,
         std::fabs(beside),
         std::fabs(d[0]) - p.h0 - p.h1 * c,
         std::fabs(d[1]) - p.h1 - p.h0 * c,
         s * (std::fabs(d[2]) - p.h1 * s),
         s * (std::fabs(d[3]) - p.h0 * s)};
  }
  // From what is known already, of axes at an angle: Delta along w0 and w1, w0 x w1, and the sections.
  Frame(const Scaled& p, double d0, double d1, const Vector3& cross,
        const Sections<double>& sections) noexcept
      : w0(p.w0), w1(p.w1), delta(p.delta), f(sections) {
    const double inverse = 1 / f.s;
    n = cross * std::copysign(inverse, dot(delta, cross));
    m0 = w0.cross(n);
    m1 = w1.cross(n);
    d[0] = d0;
    d[1] = d1;
    d[2] = dot(delta, m0);
    d[3] = dot(delta, m1);
    z = f.z_s * inverse;
  }
  // e_j, pointing from a to b.
  Vector3 e(int j) const noexcept {
    const Vector3& axis = j == 0 ? w0 : j == 1 ? w1 : j == 2 ? m0 : m1;
    return d[j] < 0 ? Vector3(-axis) : axis;
  }
  using Scalar = double;
  // a e_i + b e_j + c n.
  Vector3 direction(int i, double a, int j, double b, double c) const noexcept {
    return a * e(i) + b * e(j) + c * n;
  }
  Slices<double> slices() const noexcept { return {d[0], d[2], z, dot(w1, w0), dot(w1, m0)}; }
  // From C0: what has these coordinates.
  Vector3 at(double along, double beside, double u) const noexcept {
    return along * w0 + beside * m0 + u * n;
  }

  Vector3 w0, w1, delta, n, m0, m1;
  double d[4];  // Delta along w0, w1, m0, m1
  double z;     // and along n, >= 0
  Sections<double> f;
};

// Axes parallel, as parallel_square has it: two numbers decide, the distance along the axis and the one
// across it.
struct Parallel {
  // Delta, the sums of the half heights and of the radii, the sum of the axes.
  Parallel(const Vector3& between, double heights, double radii, const Vector3& sum) noexcept
      : w(sum / length(sum)),
        delta(between),
        along(dot(delta, w)),
        distance(length(delta.cross(w))),
        stacked(std::fabs(along) > heights),
        beside(distance > radii) {}
  // Perpendicular to w even if nearly all of Delta is along it.
  Vector3 across() const noexcept {
    const Vector3 off = delta - along * w;
    return (off - dot(off, w) * w) / distance;
  }

  Vector3 w, delta;
  double along, distance;
  bool stacked, beside;
};

}  // namespace cyl
