// SPDX-License-Identifier: MIT
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "corpus/pairs/checks_test.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/interval.hpp"
#include "oracles/referee/root_sum.hpp"
#include "oracles/referee/twin_interval.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t interval_count = 6000, sum_count = 150;

mpq_class exactly(double x) { return mpq_class(x); }

/// The unit in the last place of 1.
constexpr double last_place = 0x1p-52;

/// Returns a number of either sign, or 0, near 1 or some decades away. It has all digits or is an integer.
double draw_number(RandomStream& stream) {
  const std::size_t kind = stream.below(8);
  if (kind == 0) return 0;
  const double small = stream.integer(-3, 3);
  if (kind == 1) return small;
  const double sign = stream.sign(), unit = stream.between(0.5, 2), rest = stream.unit();
  const int exponent = kind == 2 ? stream.integer(-200, 200) : stream.integer(-2, 2);
  return std::ldexp(sign * (unit + rest * last_place), exponent);
}

Interval draw_interval(RandomStream& stream) {
  double lo = draw_number(stream), hi = draw_number(stream);
  if (stream.below(3) == 0) hi = lo + std::fabs(lo) * static_cast<double>(stream.below(5)) * last_place;
  if (hi < lo) std::swap(lo, hi);
  return {lo, hi};
}

/// Returns whether the end is at the exact value or outside of it, by at most two units in the last place.
bool is_outward(double end, const mpq_class& exact, int side) {
  const mpq_class beyond = side * (exactly(end) - exact), unit = abs(exact) * exactly(last_place);
  return beyond >= 0 && beyond <= 2 * unit + exactly(std::numeric_limits<double>::denorm_min());
}

bool holds(const Interval& x, const mpq_class& lo, const mpq_class& hi) {
  return std::isfinite(x.lo) && std::isfinite(x.hi) && is_outward(x.lo, lo, -1) && is_outward(x.hi, hi, 1);
}

/// The same for the square root. It compares squares, which are rational.
bool holds_root(const Interval& x, const mpq_class& lo, const mpq_class& hi) {
  const auto square = [](double end) { return mpq_class(exactly(end) * exactly(end)); };
  const mpq_class slack = 1 + 6 * exactly(last_place),
                  least = 4 * exactly(std::numeric_limits<double>::denorm_min());
  return x.lo >= 0 && square(x.lo) <= lo && square(x.lo) * slack + least >= lo && square(x.hi) >= hi &&
         square(x.hi) <= hi * slack + least;
}

struct Ends {
  mpq_class lo, hi;
};
Ends ends_of(const mpq_class& p, const mpq_class& q, const mpq_class& r, const mpq_class& s) {
  return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}

void check_intervals(RandomStream& stream) {
  using I = Interval;
  const I a = draw_interval(stream), b = draw_interval(stream);
  const mpq_class al = exactly(a.lo), ah = exactly(a.hi), bl = exactly(b.lo), bh = exactly(b.hi);
  const auto expect = [&](bool right, const char* operation) {
    check_that(right, operation, a.lo, a.hi, b.lo, b.hi);
  };
  expect(holds(a + b, al + bl, ah + bh), "intervals: sum");
  expect(holds(a - b, al - bh, ah - bl), "intervals: difference");
  const Ends product = ends_of(al * bl, al * bh, ah * bl, ah * bh);
  expect(holds(a * b, product.lo, product.hi), "intervals: product");
  const I minus = -a, quotient = a / b, magnitude = abs(a);
  expect(minus.lo == -a.hi && minus.hi == -a.lo, "intervals: negative");
  if (bl <= 0 && bh >= 0) {
    expect(std::isinf(quotient.lo) && std::isinf(quotient.hi) && quotient.lo < 0 && quotient.hi > 0,
           "intervals: quotient by 0");
  } else {
    const Ends q = ends_of(al / bl, al / bh, ah / bl, ah / bh);
    expect(holds(quotient, q.lo, q.hi), "intervals: quotient");
  }
  const mpq_class least =
      sgn(al) * sgn(ah) <= 0 ? mpq_class(0) : std::min(mpq_class(abs(al)), mpq_class(abs(ah)));
  const mpq_class most = std::max(mpq_class(abs(al)), mpq_class(abs(ah)));
  expect(exactly(magnitude.lo) == least && exactly(magnitude.hi) == most, "intervals: magnitude");
  expect(holds(square(a), least * least, most * most) && square(a).lo >= 0, "intervals: square");
  if (a.hi >= 0) expect(holds_root(sqrt(a), std::max(mpq_class(0), al), ah), "intervals: root");
}

/// An operation without a number as its result proves nothing.
void check_overflow() {
  using I = Interval;
  const double most = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const auto is_everything = [&](const I& x) { return x.lo == -infinity && x.hi == infinity; };
  const I far(most, infinity), zero(0), all = I::everything();
  check_that((I(most) + I(most)).hi == infinity && (I(-most) + I(-most)).lo == -infinity,
             "intervals: overflow");
  check_that(is_everything(far * zero) && is_everything(zero * far), "intervals: 0 times infinity");
  check_that(is_everything(I(infinity) / I(infinity)), "intervals: infinity by infinity");
  check_that(is_everything(all + far - far) && is_everything(all), "intervals: everything");
}

/// A number known to some digits, and its exact value.
struct Known {
  TwinInterval twin;
  mpq_class exact;
};
Known draw_known(RandomStream& stream) {
  const double x = draw_number(stream), y = draw_number(stream) * 0x1p-60;
  return {TwinInterval(x) + TwinInterval(y), exactly(x) + exactly(y)};
}

/// `terms` is the sum of the lengths that the operation adds, or its result. The error is at most 2^-98
/// times that.
void check_twins(RandomStream& stream) {
  const Known a = draw_known(stream), b = draw_known(stream);
  const auto expect = [&](const TwinInterval& x, const mpq_class& exact, const mpq_class& terms,
                          const char* what) {
    const Twin& m = x.middle;
    check_that(abs(exactly(m.hi) + exactly(m.lo) - exact) <= exactly(x.error) &&
                   exactly(x.error) <= terms * exactly(0x1p-98) + exactly(0x1p-500) &&
                   std::fabs(m.lo) <= 0x1p-53 * std::fabs(m.hi),
               what, a.twin.middle.hi, b.twin.middle.hi);
  };
  const mpq_class lengths = abs(a.exact) + abs(b.exact), exact_product = a.exact * b.exact;
  const TwinInterval sum = a.twin + b.twin, product = a.twin * b.twin;
  expect(sum, a.exact + b.exact, lengths, "twins: sum");
  expect(a.twin - b.twin, a.exact - b.exact, lengths, "twins: difference");
  expect(product, exact_product, abs(exact_product), "twins: product");
  // The operands have errors.
  expect(product - sum, exact_product - a.exact - b.exact, abs(exact_product) + lengths, "twins: both");
  expect(product * sum, exact_product * (a.exact + b.exact), abs(exact_product) * lengths, "twins: three");
  if (b.exact == 0)
    check_that(std::isinf((a.twin / b.twin).error), "twins: quotient by 0");
  else
    expect(product / b.twin, a.exact, abs(a.exact), "twins: quotient");
  expect(sqrt(product * product), abs(exact_product), abs(exact_product), "twins: root");
  expect(abs(a.twin), abs(a.exact), abs(a.exact), "twins: magnitude");
  check_that(surely_less(a.twin, b.twin) == (a.exact < b.exact) ||
                 abs(a.exact - b.exact) <= lengths * exactly(0x1p-98),
             "twins: less", a.twin.middle.hi, b.twin.middle.hi);
  check_that(!surely_less(a.twin, a.twin) && surely_at_most(TwinInterval(1.0), TwinInterval(1.0)),
             "twins: equal");
  const TwinInterval huge = 0x1p1000, zero = 0.0;
  check_that(!surely_less(huge * huge, zero) && !surely_less(zero, huge * huge) &&
                 !surely_at_most(zero, huge * huge - huge) && sqrt(zero).error < 0x1p-500,
             "twins: overflow");
}

/// Checks (x + y)^2 = x^2 + 2 x y + y^2 for sums of three square roots, and the sign of a small difference.
void check_root_sums(RandomStream& stream) {
  const auto draw = [&] {
    RootSum sum;
    for (int i = 0; i < 3; ++i) {
      const mpq_class c(stream.integer(-6, 6), stream.integer(1, 4)),
          q(stream.integer(1, 12), stream.integer(1, 3));
      mpq_class simple = c, root = q;
      simple.canonicalize();
      root.canonicalize();
      sum = sum + RootSum::root(simple, root);
    }
    return sum;
  };
  const RootSum x = draw(), y = draw(), both = x + y;
  check_that((both * both - x * x - RootSum(2) * x * y - y * y).sign() == 0, "sums of roots: binomial");
  check_that((x - x).sign() == 0 && (x + y - y - x).sign() == 0, "sums of roots: nothing is left");
  check_that((x * x).sign() == (x.sign() != 0 ? 1 : 0) && (x - y).sign() == -(y - x).sign(),
             "sums of roots: sign of a square");
  // sqrt(n + 1) - sqrt(n) = 1/(sqrt(n + 1) + sqrt(n)) lies between 1/(2 sqrt(n + 1)) and 1/(2 sqrt(n)).
  const mpq_class n(stream.integer(1, 1 << 30));
  const RootSum step = RootSum::root(1, n + 1) - RootSum::root(1, n);
  check_that((step - RootSum::root(mpq_class(1, 2), 1 / (n + 1))).sign() == 1 &&
                 (step - RootSum::root(mpq_class(1, 2), 1 / n)).sign() == -1,
             "sums of roots: sign of a difference");
}

TEST(RefereeArithmetic, HoldsTheExactResult) {
  check_overflow();
  for (std::uint64_t i = 0; i < interval_count; ++i) {
    RandomStream stream("intervals", drawing_seed, i);
    check_intervals(stream);
    check_twins(stream);
  }
  for (std::uint64_t i = 0; i < sum_count; ++i) {
    RandomStream stream("sums of roots", drawing_seed, i);
    check_root_sums(stream);
  }
}

}  // namespace
}  // namespace cyl
