// SPDX-License-Identifier: MIT
// Sums c1 sqrt(q1) + ... + cn sqrt(qn) of rationals c and square roots of positive rationals q, with exact
// signs.
#pragma once

#include <gmpxx.h>

#include <vector>

namespace cyl {

/// A number of that form. + - * stay exact; sign() is exact: whether it is 0 is decided by algebra, which
/// side of 0 it lies on by intervals.
class RootSum {
 public:
  RootSum() = default;
  RootSum(const mpq_class& c) { add(c, 1); }  // NOLINT: a rational is such a sum
  RootSum(int c) : RootSum(mpq_class(c)) {}   // NOLINT
  /// c sqrt(q), q >= 0.
  static RootSum root(const mpq_class& c, const mpq_class& q) {
    RootSum r;
    r.add(c, q);
    return r;
  }

  friend RootSum operator+(const RootSum& a, const RootSum& b);
  friend RootSum operator-(const RootSum& a, const RootSum& b);
  friend RootSum operator*(const RootSum& a, const RootSum& b);

  /// -1, 0 or 1.
  int sign() const;

 private:
  struct Term {
    mpq_class c, q;
  };
  void add(const mpq_class& c, const mpq_class& q);
  std::vector<Term> terms_;  // c != 0; no two q whose product is a rational square
};

}  // namespace cyl
