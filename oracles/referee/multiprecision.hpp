// SPDX-License-Identifier: MIT
// Values of MPFR and intervals of MPFI as ordinary C++ values. New values take the thread's current
// precision: set it with PrecisionScope for a scope.
#pragma once

#include <gmpxx.h>
#include <mpfi.h>
#include <mpfr.h>

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

/// A floating-point number of MPFR, rounded to nearest, its exponent as good as unbounded.
class MpFloat {
 public:
  MpFloat(double x = 0) {  // NOLINT: a double is a number
    mpfr_init(v_);
    mpfr_set_d(v_, x, MPFR_RNDN);
  }
  MpFloat(const MpFloat& o) {
    mpfr_init2(v_, mpfr_get_prec(o.v_));
    mpfr_set(v_, o.v_, MPFR_RNDN);
  }
  MpFloat(MpFloat&& o) noexcept {
    *v_ = *o.v_;
    o.v_->_mpfr_d = nullptr;
  }
  MpFloat& operator=(MpFloat o) noexcept {
    mpfr_swap(v_, o.v_);
    return *this;
  }
  ~MpFloat() {
    if (v_->_mpfr_d) mpfr_clear(v_);
  }

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
  mpfr_t v_;  ///< without digits if it was moved from
};

/// A closed interval of MPFI.
class MpInterval {
 public:
  MpInterval(double x = 0) {  // NOLINT: a double is an interval
    mpfi_init(v_);
    mpfi_set_d(v_, x);
  }
  explicit MpInterval(const mpq_class& x) : MpInterval() { mpfi_set_q(v_, x.get_mpq_t()); }
  MpInterval(const MpInterval& o) : MpInterval() { mpfi_set(v_, o.v_); }
  MpInterval& operator=(const MpInterval& o) {
    mpfi_set(v_, o.v_);
    return *this;
  }
  ~MpInterval() { mpfi_clear(v_); }

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
};

}  // namespace cyl
