// SPDX-License-Identifier: MIT
// Values of MPFR and intervals of MPFI as ordinary C++ values. New values take the thread's current
// precision: set it with PrecisionScope for a scope.
#pragma once

#include <gmpxx.h>
#include <mpfi.h>
#include <mpfr.h>

#include <algorithm>
#include <iterator>

namespace cyl {

/// Precision in bits of the values made while it lives.
class PrecisionScope {
 public:
  explicit PrecisionScope(int bits) : before_(mpfr_get_default_prec()) { mpfr_set_default_prec(bits); }
  ~PrecisionScope() { mpfr_set_default_prec(before_); }
  PrecisionScope(const PrecisionScope&) = delete;
  PrecisionScope& operator=(const PrecisionScope&) = delete;

 private:
  mpfr_prec_t before_;
};

/// Bits up to which a MpFloat allocates nothing: most pairs are settled at 128, nearly all others at 256.
inline constexpr mpfr_prec_t inline_bits_cap = 256;

namespace multiprecision_detail {
using Limbs = mp_limb_t[inline_bits_cap / GMP_NUMB_BITS];  // used if is_inline()
inline bool is_inline(mpfr_srcptr v) { return mpfr_get_prec(v) <= inline_bits_cap; }
inline void make_zero(mpfr_ptr v, Limbs& limbs, mpfr_prec_t bits) {
  if (bits > inline_bits_cap) {
    mpfr_init2(v, bits);
    mpfr_set_zero(v, 1);
  } else {
    mpfr_custom_init_set(v, MPFR_ZERO_KIND, 0, bits, limbs);
  }
}
}  // namespace multiprecision_detail

/// A floating-point number of MPFR, rounded to nearest, its exponent as good as unbounded.
class MpFloat {
 public:
  MpFloat() { make_zero(mpfr_get_default_prec()); }
  MpFloat(double x) : MpFloat() {  // NOLINT: a double is a number
    mpfr_set_d(v_, x, MPFR_RNDN);
  }
  MpFloat(const MpFloat& o) {
    if (!o.is_inline()) make_zero(mpfr_get_prec(o.v_));
    copy_digits(o);
  }
  MpFloat& operator=(const MpFloat& o) {
    if (this == &o) return *this;  // not covered: the search assigns no number to itself
    // not covered: the numbers of one search have one precision
    if (mpfr_get_prec(v_) != mpfr_get_prec(o.v_)) {
      clear();
      make_zero(mpfr_get_prec(o.v_));
    }
    copy_digits(o);
    return *this;
  }
  MpFloat(MpFloat&& o) noexcept {
    if (o.is_inline()) {
      copy_digits(o);
      return;
    }
    *v_ = *o.v_;
    o.make_zero(inline_bits_cap);
  }
  MpFloat& operator=(MpFloat&& o) noexcept {
    if (is_inline() || o.is_inline()) return *this = o;  // not covered: they have one precision
    mpfr_swap(v_, o.v_);
    return *this;
  }
  ~MpFloat() { clear(); }

  double to_double() const { return mpfr_get_d(v_, MPFR_RNDN); }  // not covered: for tests
  /// The same number exactly. Throws nothing; the number is finite.
  mpq_class to_rational() const {
    mpq_class q;
    mpfr_get_q(q.get_mpq_t(), v_);
    return q;
  }

  friend MpFloat operator+(const MpFloat& a, const MpFloat& b) { return make(mpfr_add, a, b); }
  friend MpFloat operator-(const MpFloat& a, const MpFloat& b) { return make(mpfr_sub, a, b); }
  friend MpFloat operator*(const MpFloat& a, const MpFloat& b) { return make(mpfr_mul, a, b); }
  friend MpFloat operator/(const MpFloat& a, const MpFloat& b) { return make(mpfr_div, a, b); }
  MpFloat operator-() const {
    MpFloat r;
    mpfr_neg(r.v_, v_, MPFR_RNDN);
    return r;
  }
  friend MpFloat sqrt(const MpFloat& a) {
    MpFloat r;
    mpfr_sqrt(r.v_, a.v_, MPFR_RNDN);
    return r;
  }
  friend MpFloat abs(const MpFloat& a) {
    MpFloat r;
    mpfr_abs(r.v_, a.v_, MPFR_RNDN);
    return r;
  }
  friend bool operator<(const MpFloat& a, const MpFloat& b) { return mpfr_less_p(a.v_, b.v_) != 0; }
  friend bool operator>(const MpFloat& a, const MpFloat& b) { return mpfr_greater_p(a.v_, b.v_) != 0; }
  friend bool operator<=(const MpFloat& a, const MpFloat& b) { return mpfr_lessequal_p(a.v_, b.v_) != 0; }
  friend bool operator>=(const MpFloat& a, const MpFloat& b) { return mpfr_greaterequal_p(a.v_, b.v_) != 0; }
  friend bool operator==(const MpFloat& a, const MpFloat& b) { return mpfr_equal_p(a.v_, b.v_) != 0; }

 private:
  template <class Operation>
  static MpFloat make(Operation operation, const MpFloat& a, const MpFloat& b) {
    MpFloat r;
    operation(r.v_, a.v_, b.v_, MPFR_RNDN);
    return r;
  }
  bool is_inline() const { return multiprecision_detail::is_inline(v_); }
  void make_zero(mpfr_prec_t bits) { multiprecision_detail::make_zero(v_, limbs_, bits); }
  void clear() {
    if (!is_inline()) mpfr_clear(v_);
  }
  // Takes numbers of the same precision, if the digits are not inline.
  void copy_digits(const MpFloat& o) {
    if (!o.is_inline()) {
      mpfr_set(v_, o.v_, MPFR_RNDN);
      return;
    }
    *v_ = *o.v_;
    std::copy(std::begin(o.limbs_), std::end(o.limbs_), limbs_);
    mpfr_custom_move(v_, limbs_);
  }
  mpfr_t v_;
  multiprecision_detail::Limbs limbs_ = {};
};

/// A closed interval of MPFI.
class MpInterval {
 public:
  MpInterval() {
    multiprecision_detail::make_zero(&v_->left, limbs_[0], mpfr_get_default_prec());
    multiprecision_detail::make_zero(&v_->right, limbs_[1], mpfr_get_default_prec());
  }
  MpInterval(double x) : MpInterval() {  // NOLINT: a double is an interval
    mpfi_set_d(v_, x);
  }
  explicit MpInterval(const mpq_class& x) : MpInterval() { mpfi_set_q(v_, x.get_mpq_t()); }
  // not covered: results are built in place, but the language requires it
  MpInterval(MpInterval&& o) noexcept : MpInterval() { mpfi_set(v_, o.v_); }
  MpInterval& operator=(MpInterval&& o) noexcept {
    mpfi_set(v_, o.v_);
    return *this;
  }
  ~MpInterval() {
    for (mpfr_ptr end : {&v_->left, &v_->right})
      if (!multiprecision_detail::is_inline(end)) mpfr_clear(end);
  }

  friend MpInterval operator+(const MpInterval& a, const MpInterval& b) { return make(mpfi_add, a, b); }
  friend MpInterval operator-(const MpInterval& a, const MpInterval& b) { return make(mpfi_sub, a, b); }
  friend MpInterval operator*(const MpInterval& a, const MpInterval& b) { return make(mpfi_mul, a, b); }
  friend MpInterval operator/(const MpInterval& a, const MpInterval& b) { return make(mpfi_div, a, b); }
  friend MpInterval sqrt(const MpInterval& a) {
    MpInterval r;
    mpfi_sqrt(r.v_, a.v_);
    return r;
  }
  friend MpInterval abs(const MpInterval& a) {
    MpInterval r;
    mpfi_abs(r.v_, a.v_);
    return r;
  }
  friend MpInterval square(const MpInterval& a) {
    MpInterval r;
    mpfi_sqr(r.v_, a.v_);
    return r;
  }
  double lower() const { return mpfr_get_d(&v_->left, MPFR_RNDD); }
  double upper() const { return mpfr_get_d(&v_->right, MPFR_RNDU); }
  bool negative() const { return mpfi_is_strictly_neg(v_) != 0; }
  bool positive() const { return mpfi_is_strictly_pos(v_) != 0; }

 private:
  template <class Operation>
  static MpInterval make(Operation operation, const MpInterval& a, const MpInterval& b) {
    MpInterval r;
    operation(r.v_, a.v_, b.v_);
    return r;
  }
  mpfi_t v_;
  multiprecision_detail::Limbs limbs_[2];
};

}  // namespace cyl
