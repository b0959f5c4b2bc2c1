// SPDX-License-Identifier: MIT
// Values of MPFR and intervals of MPFI as ordinary C++ values. New values take the thread's current
// precision: set it with WidePrecision for a scope.
#pragma once

#include <gmpxx.h>
#include <mpfi.h>
#include <mpfr.h>

#include <algorithm>
#include <iterator>

namespace cyl {

/// Precision in bits of the values made while it lives.
class WidePrecision {
 public:
  explicit WidePrecision(int bits) : before_(mpfr_get_default_prec()) { mpfr_set_default_prec(bits); }
  ~WidePrecision() { mpfr_set_default_prec(before_); }
  WidePrecision(const WidePrecision&) = delete;
  WidePrecision& operator=(const WidePrecision&) = delete;

 private:
  mpfr_prec_t before_;
};

/// Bits up to which a Wide allocates nothing: most pairs are settled at 128, nearly all others at 256.
inline constexpr mpfr_prec_t inline_bits_cap = 256;

/// A floating-point number of MPFR, rounded to nearest, its exponent as good as unbounded.
class Wide {
 public:
  Wide() { make_zero(mpfr_get_default_prec()); }
  Wide(double x) : Wide() {  // NOLINT: a double is a number
    mpfr_set_d(v_, x, MPFR_RNDN);
  }
  Wide(const Wide& o) {
    if (!o.is_inline()) make_zero(mpfr_get_prec(o.v_));
    copy_digits(o);
  }
  Wide& operator=(const Wide& o) {
    if (this == &o) return *this;
    if (mpfr_get_prec(v_) != mpfr_get_prec(o.v_)) {
      clear();
      make_zero(mpfr_get_prec(o.v_));
    }
    copy_digits(o);
    return *this;
  }
  Wide(Wide&& o) noexcept {
    if (o.is_inline()) {
      copy_digits(o);
      return;
    }
    *v_ = *o.v_;
    o.make_zero(inline_bits_cap);
  }
  Wide& operator=(Wide&& o) noexcept {
    if (is_inline() || o.is_inline()) return *this = o;
    mpfr_swap(v_, o.v_);
    return *this;
  }
  ~Wide() { clear(); }

  double to_double() const { return mpfr_get_d(v_, MPFR_RNDN); }
  /// The same number exactly. Throws nothing; the number is finite.
  mpq_class to_rational() const {
    mpq_class q;
    mpfr_get_q(q.get_mpq_t(), v_);
    return q;
  }

  friend Wide operator+(const Wide& a, const Wide& b) { return make(mpfr_add, a, b); }
  friend Wide operator-(const Wide& a, const Wide& b) { return make(mpfr_sub, a, b); }
  friend Wide operator*(const Wide& a, const Wide& b) { return make(mpfr_mul, a, b); }
  friend Wide operator/(const Wide& a, const Wide& b) { return make(mpfr_div, a, b); }
  Wide operator-() const {
    Wide r;
    mpfr_neg(r.v_, v_, MPFR_RNDN);
    return r;
  }
  friend Wide sqrt(const Wide& a) {
    Wide r;
    mpfr_sqrt(r.v_, a.v_, MPFR_RNDN);
    return r;
  }
  friend Wide abs(const Wide& a) {
    Wide r;
    mpfr_abs(r.v_, a.v_, MPFR_RNDN);
    return r;
  }
  friend bool operator<(const Wide& a, const Wide& b) { return mpfr_less_p(a.v_, b.v_) != 0; }
  friend bool operator>(const Wide& a, const Wide& b) { return mpfr_greater_p(a.v_, b.v_) != 0; }
  friend bool operator<=(const Wide& a, const Wide& b) { return mpfr_lessequal_p(a.v_, b.v_) != 0; }
  friend bool operator>=(const Wide& a, const Wide& b) { return mpfr_greaterequal_p(a.v_, b.v_) != 0; }
  friend bool operator==(const Wide& a, const Wide& b) { return mpfr_equal_p(a.v_, b.v_) != 0; }

 private:
  template <class Operation>
  static Wide make(Operation operation, const Wide& a, const Wide& b) {
    Wide r;
    operation(r.v_, a.v_, b.v_, MPFR_RNDN);
    return r;
  }
  bool is_inline() const { return mpfr_get_prec(v_) <= inline_bits_cap; }
  void make_zero(mpfr_prec_t bits) {
    if (bits > inline_bits_cap) {
      mpfr_init2(v_, bits);
      mpfr_set_zero(v_, 1);
    } else {
      mpfr_custom_init_set(v_, MPFR_ZERO_KIND, 0, bits, limbs_);
    }
  }
  void clear() {
    if (!is_inline()) mpfr_clear(v_);
  }
  // Of the same precision, where the digits are not inline.
  void copy_digits(const Wide& o) {
    if (!o.is_inline()) {
      mpfr_set(v_, o.v_, MPFR_RNDN);
      return;
    }
    *v_ = *o.v_;
    std::copy(std::begin(o.limbs_), std::end(o.limbs_), limbs_);
    mpfr_custom_move(v_, limbs_);
  }
  mpfr_t v_;
  mp_limb_t limbs_[inline_bits_cap / GMP_NUMB_BITS] = {};  // where is_inline()
};

/// A closed interval of MPFI.
class WideInterval {
 public:
  WideInterval() : WideInterval(0.0) {}
  WideInterval(double x) {  // NOLINT: a double is an interval
    mpfi_init(v_);
    mpfi_set_d(v_, x);
  }
  explicit WideInterval(const mpq_class& x) {
    mpfi_init(v_);
    mpfi_set_q(v_, x.get_mpq_t());
  }
  WideInterval(const WideInterval& o) {
    mpfi_init2(v_, mpfi_get_prec(o.v_));
    mpfi_set(v_, o.v_);
  }
  WideInterval& operator=(const WideInterval& o) {
    if (this != &o) {
      mpfi_set_prec(v_, mpfi_get_prec(o.v_));
      mpfi_set(v_, o.v_);
    }
    return *this;
  }
  WideInterval(WideInterval&& o) noexcept : WideInterval() { mpfi_swap(v_, o.v_); }
  WideInterval& operator=(WideInterval&& o) noexcept {
    mpfi_swap(v_, o.v_);
    return *this;
  }
  ~WideInterval() { mpfi_clear(v_); }

  friend WideInterval operator+(const WideInterval& a, const WideInterval& b) { return make(mpfi_add, a, b); }
  friend WideInterval operator-(const WideInterval& a, const WideInterval& b) { return make(mpfi_sub, a, b); }
  friend WideInterval operator*(const WideInterval& a, const WideInterval& b) { return make(mpfi_mul, a, b); }
  friend WideInterval operator/(const WideInterval& a, const WideInterval& b) { return make(mpfi_div, a, b); }
  friend WideInterval sqrt(const WideInterval& a) {
    WideInterval r;
    mpfi_sqrt(r.v_, a.v_);
    return r;
  }
  friend WideInterval abs(const WideInterval& a) {
    WideInterval r;
    mpfi_abs(r.v_, a.v_);
    return r;
  }
  friend WideInterval square(const WideInterval& a) {
    WideInterval r;
    mpfi_sqr(r.v_, a.v_);
    return r;
  }
  bool negative() const { return mpfi_is_strictly_neg(v_) != 0; }
  bool positive() const { return mpfi_is_strictly_pos(v_) != 0; }
  /// Doubles outside, rounded away from the interval.
  double lower_double() const {
    mpfr_t x;
    mpfr_init(x);
    mpfi_get_left(x, v_);
    const double d = mpfr_get_d(x, MPFR_RNDD);
    mpfr_clear(x);
    return d;
  }
  double upper_double() const {
    mpfr_t x;
    mpfr_init(x);
    mpfi_get_right(x, v_);
    const double d = mpfr_get_d(x, MPFR_RNDU);
    mpfr_clear(x);
    return d;
  }

 private:
  template <class Operation>
  static WideInterval make(Operation operation, const WideInterval& a, const WideInterval& b) {
    WideInterval r;
    operation(r.v_, a.v_, b.v_);
    return r;
  }
  mpfi_t v_;
};

inline double lower(const WideInterval& a) { return a.lower_double(); }
inline double upper(const WideInterval& a) { return a.upper_double(); }

}  // namespace cyl
