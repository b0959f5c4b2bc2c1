// SPDX-License-Identifier: MIT
// Sums c1 sqrt(q1) + ... + cn sqrt(qn) of rationals c and square roots of positive rationals q, with exact
// signs.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

namespace cyl {

/// A number of that form. + - * stay exact, and so does sign(). Algebra decides whether the number is 0,
/// intervals decide its sign. The intervals are tried first.
class RootSum {
 public:
  RootSum() = default;
  RootSum(const mpq_class& c) : RootSum(root(c, 1)) {}  // NOLINT: a rational is such a sum
  RootSum(int c) : RootSum(mpq_class(c)) {}             // NOLINT
  /// c sqrt(q), q >= 0.
  static RootSum root(const mpq_class& c, const mpq_class& q) {
    RootSum r;
    if (c != 0 && q != 0) r.terms_.push_back({c, q});
    return r;
  }

  friend RootSum operator+(const RootSum& a, const RootSum& b);
  friend RootSum operator-(const RootSum& a, const RootSum& b);
  friend RootSum operator*(const RootSum& a, const RootSum& b);

  /// -1, 0 or 1.
  int sign() const;
  /// The sum itself, if it is rational.
  std::optional<mpq_class> rational() const;

 private:
  struct Term {
    mpq_class c, q;
  };
  // Joins the term with one whose q makes a rational square with its own. The joined ones stay so.
  void add(const mpq_class& c, const mpq_class& q);
  RootSum joined() const;
  int sign_within(int bits) const;  // 0 if intervals of that many bits contain 0
  std::vector<Term> terms_;         // q >= 0
};

}  // namespace cyl
