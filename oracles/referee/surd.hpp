// SPDX-License-Identifier: MIT
// Numbers a + b sqrt(s) with rational a and b and one rational s >= 0 for a whole computation. They are a
// field, so unlike RootSum they can be divided, and their signs need no intervals.
#pragma once

#include <gmpxx.h>

#include <utility>

#include "base/vec3.hpp"

namespace cyl {

class Surd {
 public:
  Surd() = default;
  Surd(double x) : a_(x) {}  // NOLINT: a number is such a sum
  explicit Surd(mpq_class a) : a_(std::move(a)) {}
  /// b sqrt(s). `s` is not the square of a rational, and outlives all numbers that are made from it.
  Surd(mpq_class b, const mpq_class& s) : b_(std::move(b)), s_(&s) {}

  const mpq_class& rational_part() const { return a_; }
  const mpq_class& factor() const { return b_; }  ///< of the root
  bool is_rational() const { return b_ == 0; }

  friend Surd operator+(const Surd& x, const Surd& y) { return {x.a_ + y.a_, x.b_ + y.b_, x.root(y)}; }
  friend Surd operator-(const Surd& x, const Surd& y) { return {x.a_ - y.a_, x.b_ - y.b_, x.root(y)}; }
  Surd operator-() const { return {-a_, -b_, s_}; }
  friend Surd operator*(const Surd& x, const Surd& y) {
    if (x.b_ == 0 && y.b_ == 0) return Surd(mpq_class(x.a_ * y.a_));
    const mpq_class* s = x.root(y);
    return {x.a_ * y.a_ + x.b_ * y.b_ * *s, x.a_ * y.b_ + x.b_ * y.a_, s};
  }
  /// y is not 0.
  friend Surd operator/(const Surd& x, const Surd& y) {
    if (y.b_ == 0) return {x.a_ / y.a_, x.b_ / y.a_, x.s_};
    const mpq_class length = y.a_ * y.a_ - y.b_ * y.b_ * *y.s_;
    return x * Surd{y.a_ / length, -y.b_ / length, y.s_};
  }

  /// -1, 0 or 1.
  int sign() const {
    const int a = sgn(a_), b = sgn(b_);
    if (b == 0 || a == b) return a;
    if (a == 0) return b;
    return mpq_class(a_ * a_) > mpq_class(b_ * b_ * *s_) ? a : b;
  }
  friend bool operator<(const Surd& x, const Surd& y) { return (x - y).sign() < 0; }
  friend bool operator>(const Surd& x, const Surd& y) { return (x - y).sign() > 0; }
  friend Surd abs(const Surd& x) { return x.sign() < 0 ? -x : x; }

 private:
  Surd(const mpq_class& a, const mpq_class& b, const mpq_class* s) : a_(a), b_(b), s_(s) {}
  const mpq_class* root(const Surd& other) const { return s_ ? s_ : other.s_; }
  mpq_class a_, b_;
  const mpq_class* s_ = nullptr;
};

using Surd3 = Vec3<Surd>;

inline Surd3 lift(const Vec3<mpq_class>& v) { return {Surd(v.x), Surd(v.y), Surd(v.z)}; }
inline Vec3<mpq_class> rational_part(const Surd3& v) {
  return {v.x.rational_part(), v.y.rational_part(), v.z.rational_part()};
}

/// Makes the unit a multiple of all denominators. Numbers that are multiplied by it are computed with faster,
/// because integers need no common divisors.
void take_denominators(mpz_class& unit, const Surd3& v);

/// Returns a multiple of the vector that has integers.
Vec3<mpq_class> in_integers(const Vec3<mpq_class>& v);

/// Returns rationals that differ by less than size 2^-bits from each coordinate; the coordinate if that is
/// rational. `square` is the number under the root.
Vec3<mpq_class> rounded(const Surd3& v, const mpq_class& square, const mpq_class& size, int bits);

}  // namespace cyl
