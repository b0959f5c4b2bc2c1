// SPDX-License-Identifier: MIT
#include "oracles/referee/root_sum.hpp"

#include "oracles/referee/multiprecision.hpp"

namespace cyl {
namespace {

// Returns whether q has a rational square root, and sets `root` to it.
bool rational_root(const mpq_class& q, mpq_class& root) {
  if (!mpz_perfect_square_p(q.get_num_mpz_t()) || !mpz_perfect_square_p(q.get_den_mpz_t())) return false;
  root = mpq_class(sqrt(q.get_num()), sqrt(q.get_den()));
  return true;
}

}  // namespace

// sqrt(q) = sqrt(q r)/r sqrt(r). So if q r is a square, the term joins that of sqrt(r). If no product of two
// of the rationals is a square, their square roots are linearly independent over the rationals (Besicovitch
// 1940). So the sum is 0 if and only if no term is left.
void RootSum::add(const mpq_class& c, const mpq_class& q) {
  if (c == 0 || q == 0) return;
  mpq_class root;
  for (auto t = terms_.begin(); t != terms_.end(); ++t)
    if (rational_root(q * t->q, root)) {
      t->c += c * root / t->q;
      if (t->c == 0) terms_.erase(t);
      return;
    }
  if (rational_root(q, root))
    terms_.push_back({c * root, 1});
  else
    terms_.push_back({c, q});
}

RootSum operator+(const RootSum& a, const RootSum& b) {
  RootSum r = a;
  r.terms_.insert(r.terms_.end(), b.terms_.begin(), b.terms_.end());
  return r;
}

RootSum operator-(const RootSum& a, const RootSum& b) {
  RootSum r = a;
  for (const auto& t : b.terms_) r.terms_.push_back({-t.c, t.q});
  return r;
}

RootSum operator*(const RootSum& a, const RootSum& b) {
  RootSum r;
  for (const auto& s : a.terms_)
    for (const auto& t : b.terms_) r.add(s.c * t.c, s.q * t.q);
  return r;
}

int RootSum::sign_within(int bits) const {
  const PrecisionScope precision(bits);
  MpInterval sum;
  for (const Term& t : terms_) sum = sum + MpInterval(t.c) * sqrt(MpInterval(t.q));
  return sum.positive() ? 1 : sum.negative() ? -1 : 0;
}

RootSum RootSum::joined() const {
  RootSum r;
  for (const Term& t : terms_) r.add(t.c, t.q);
  return r;
}

std::optional<mpq_class> RootSum::rational() const {
  const RootSum r = joined();
  if (r.terms_.empty()) return mpq_class(0);
  if (r.terms_.size() == 1 && r.terms_[0].q == 1) return r.terms_[0].c;
  return std::nullopt;
}

int RootSum::sign() const {
  constexpr int first_bits = 128;
  if (const int sign = sign_within(first_bits)) return sign;
  const RootSum sum = joined();
  if (sum.terms_.empty()) return 0;
  // The sum is not 0, so some precision shows its sign.
  for (int bits = first_bits;; bits *= 2)
    if (const int sign = sum.sign_within(bits)) return sign;
}

}  // namespace cyl
