// SPDX-License-Identifier: MIT
#include "oracles/referee/surd.hpp"

#include "oracles/referee/proofs.hpp"

namespace cyl {
namespace {
void take_denominator(mpz_class& unit, const mpq_class& x) {
  mpz_lcm(unit.get_mpz_t(), unit.get_mpz_t(), x.get_den_mpz_t());
}
}  // namespace

void take_denominators(mpz_class& unit, const Surd3& v) {
  for (const Surd* x : {&v.x, &v.y, &v.z}) {
    take_denominator(unit, x->rational_part());
    take_denominator(unit, x->factor());
  }
}

Vec3<mpq_class> in_integers(const Vec3<mpq_class>& v) {
  mpz_class unit = 1;
  take_denominators(unit, lift(v));
  return mpq_class(unit) * v;
}

Vec3<mpq_class> rounded(const Surd3& v, const mpq_class& square, const mpq_class& size, int bits) {
  const auto one = [&](const Surd& x) {
    if (x.is_rational()) return x.rational_part();
    // x = a +- sqrt(f f s): the root of the scaled square, rounded down.
    const mpq_class term = x.factor() * x.factor() * square;
    const auto digits = [](const mpz_class& n) { return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
    const int places = bits + 2 + digits(size.get_den()) - digits(size.get_num());
    const mpq_class scaled = times_power(term, 2 * places);
    const mpq_class root =
        times_power(mpq_class(sqrt(mpz_class(scaled.get_num() / scaled.get_den()))), -places);
    return mpq_class(x.rational_part() + sgn(x.factor()) * root);
  };
  return {one(v.x), one(v.y), one(v.z)};
}

}  // namespace cyl
