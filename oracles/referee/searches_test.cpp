// SPDX-License-Identifier: MIT
// Counts the steps of the referee's own search. A search that goes astray proves nothing wrong, so only the
// count shows it. The bounds are measured values.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "corpus/pairs/checks_test.hpp"
#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/exact_pairs.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// One in this many of the drawn pairs is searched in 128 bits.
constexpr std::size_t fine_share = 20;

/// The most effort for one kind of pairs.
struct Bounds {
  double slices, fine_slices;  // in the mean, in double and in 128 bits
  double beyond_double;        // a share
  double doublings;            // mean of log2(bits/53)
};
/// For families, strata and close contacts.
constexpr Bounds bounds[] = {{1.7008, 1.2946, 0.065005, 0.082627},
                             {4.2914, 3.1338, 0.095097, 0.120787},
                             {2.1795, 1.8113, 0.031668, 0.040283}};

/// Sums of the effort for one kind of pairs.
struct Effort {
  double pairs = 0, slices = 0, in_double = 0, bits = 0, undecided = 0;
  double fine_pairs = 0, fine_slices = 0;
};

void search_one(const Pair& pair, Effort& effort) {
  if (!is_legal(pair)) return;
  int exponent = 0;
  const SearchPair<double> p = double_pair(pair, exponent);
  const double most = std::max({std::fabs(p.delta.x), std::fabs(p.delta.y), std::fabs(p.delta.z), p.radius0,
                                2 * p.half0, p.radius1, 2 * p.half1});
  check_that(most == 0 || (most >= 0.5 && most < 2.5), "searches: a pair out of its unit", pair);
  const Found<double> found = search(p, 53);
  const Truth alone = judge_verdict(pair);
  ++effort.pairs;
  effort.slices += found.slices;
  effort.in_double += alone.bits <= 53;
  effort.bits += std::log2(std::max(alone.bits, 53) / 53.0);
  effort.undecided += alone.verdict == Verdict::undecided;
}

void search_finely(const Pair& pair, Effort& effort) {
  constexpr int bits = 128;
  const PrecisionScope precision(bits);
  int exponent = 0;
  const SearchPair<double> p = double_pair(pair, exponent);
  const auto lift = [](const Vec3<double>& v) {
    return Vec3<MpFloat>{MpFloat(v.x), MpFloat(v.y), MpFloat(v.z)};
  };
  const SearchPair<MpFloat> fine{lift(p.axis0),    lift(p.axis1),      lift(p.delta),   MpFloat(p.radius0),
                                 MpFloat(p.half0), MpFloat(p.radius1), MpFloat(p.half1)};
  ++effort.fine_pairs;
  effort.fine_slices += search(fine, bits).slices;
}

TEST(RefereeSearches, FindInAsManyStepsAsMeasured) {
  const std::vector<PairsOfKind> drawn = draw_pairs(counting_seed);
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const PairsOfKind& kind = drawn[k];
    const Bounds& most = bounds[k];
    Effort e;
    for (const Pair& pair : kind.pairs) search_one(pair, e);
    for (std::size_t i = 0; i < kind.pairs.size(); i += fine_share) search_finely(kind.pairs[i], e);
    const auto expect = [&](double is, double may_be, const char* what) {
      check_that(is <= may_be * step_tolerance, what, "of", kind.name, is, "that may be", may_be);
    };
    expect(e.slices / e.pairs, most.slices, "searches: mean slices");
    expect(e.fine_slices / e.fine_pairs, most.fine_slices, "searches: mean slices in 128 bits");
    expect(1 - e.in_double / e.pairs, most.beyond_double, "searches: share that double leaves open");
    expect(e.bits / e.pairs, most.doublings, "searches: mean doublings of 53 bits");
    expect(e.undecided, 0, "searches: undecided");
  }
}

}  // namespace
}  // namespace cyl
