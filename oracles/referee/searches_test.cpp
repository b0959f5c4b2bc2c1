// SPDX-License-Identifier: MIT
// Tests the reach of the referee's own search and enclosure, and counts their steps. A search that goes
// astray proves nothing wrong, so only the count shows it. The bounds are measured values.
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
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/referee/search.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// One in this many of the drawn pairs is searched in 128 bits, and one in this many is enclosed.
constexpr std::size_t fine_share = 20, enclosing_share = 10;
constexpr double enclosing_widths[] = {1e-3, 1e-6, 1e-9};

/// The most effort for one kind of pairs.
struct Bounds {
  double slices, fine_slices;  // in the mean, in double and in 128 bits
  double beyond_double;        // a share
  double doublings;            // mean of log2(bits/53)
  double cells;                // in the mean
  double no_guess, capped;     // shares
};
/// For families, strata and close contacts.
constexpr Bounds bounds[] = {{1.7008, 1.2946, 0.065005, 0.082627, 15.9546, 0.166748, 0.000000},
                             {4.2914, 3.1338, 0.095097, 0.120787, 1.7366, 0.357213, 0.000000},
                             {2.1795, 1.8113, 0.031668, 0.040283, 31.3269, 0.168520, 0.000000}};

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

/// Sums of the effort of enclosures for one kind of pairs.
struct EnclosingEffort {
  double pairs = 0, cells = 0, near = 0, capped = 0;
};

/// Returns an enclosure of the distance by the solver's two bounds. If the solids are apart, these are the
/// nearest points and the plane between them. If they overlap, they come from the separation that is shown.
Enclosure bounds_of(const Distance& d) { return {d.value - d.error, d.value + d.error}; }

void enclose_one(const Pair& pair, double width, EnclosingEffort& effort) {
  const double size = size_of(pair), reach = size + (pair.b.center - pair.a.center).lpNorm<1>();
  if (!(reach > 0x1p-200 && reach < 0x1p200)) return;
  const Truth truth = judge_verdict(pair);
  const AttainedDistance attained = attain_distance(pair, truth, width);
  const Enclosure& e = attained.distance;
  const auto expect = [&](bool right, const char* what) { check_that(right, what, pair, width); };
  const double rounding = 256 * 0x1p-53 * reach;  // twice the slack that the enclosure adds on either side
  const std::array<double, 3>& u = attained.direction;
  expect(std::fabs(std::hypot(u[0], u[1], u[2]) - 1) <= 0x1p-50, "enclosures: a direction of another length");
  ++effort.pairs;
  effort.cells += static_cast<double>(attained.cells);
  const bool capped = attained.cells >= cell_cap;
  effort.capped += capped;
  expect(e.lo <= e.hi && (e.hi - e.lo <= width * size + rounding || capped), "enclosures: too wide");
  const double f =
      support_gap(terms_of<double>(pair.a), terms_of<double>(pair.b),
                  lifted<double>(pair.b.center) - lifted<double>(pair.a.center), {u[0], u[1], u[2]});
  expect(std::fabs(f + e.lo) <= 16 * rounding, "enclosures: attained nowhere");
  if (truth.verdict == Verdict::touching) {
    expect(e.hi == 0, "enclosures: of touching solids");
    return;
  }
  const Distance measured = distance(pair.a, pair.b);
  const Enclosure real = bounds_of(measured);
  expect(real.hi >= e.lo - rounding && real.lo <= e.hi + rounding, "enclosures: beside the distance");
  const Enclosure quick = enclose_distance(pair, truth, width);
  expect(quick.lo <= real.hi && quick.hi >= real.lo && quick.lo <= quick.hi, "enclosures: a guess beside");
  expect(quick.hi - quick.lo <= width * size + rounding || capped, "enclosures: a guess too wide");
  const bool is_near = std::fabs(measured.value) < width / 16 * size;
  if (is_near)
    effort.near += quick.lo == 0 || quick.hi == 0;
  else
    ++effort.near;
}

TEST(RefereeSearches, FindInAsManyStepsAsMeasured) {
  const std::vector<PairsOfKind> drawn = draw_pairs(counting_seed);
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const PairsOfKind& kind = drawn[k];
    const Bounds& most = bounds[k];
    Effort e;
    for (const Pair& pair : kind.pairs) search_one(pair, e);
    for (std::size_t i = 0; i < kind.pairs.size(); i += fine_share) search_finely(kind.pairs[i], e);
    EnclosingEffort n;
    for (std::size_t i = 0; i < kind.pairs.size(); i += enclosing_share)
      enclose_one(kind.pairs[i], enclosing_widths[i / enclosing_share % std::size(enclosing_widths)], n);
    const auto expect = [&](double is, double may_be, const char* what) {
      check_that(is <= may_be * step_tolerance, what, "of", kind.name, is, "that may be", may_be);
    };
    expect(e.slices / e.pairs, most.slices, "searches: mean slices");
    expect(e.fine_slices / e.fine_pairs, most.fine_slices, "searches: mean slices in 128 bits");
    expect(1 - e.in_double / e.pairs, most.beyond_double, "searches: share that double leaves open");
    expect(e.bits / e.pairs, most.doublings, "searches: mean doublings of 53 bits");
    expect(e.undecided, 0, "searches: undecided");
    expect(n.cells / n.pairs, most.cells, "enclosures: mean cells");
    expect(1 - n.near / n.pairs, most.no_guess, "enclosures: share near touching that no guess encloses");
    expect(n.capped / n.pairs, most.capped, "enclosures: share at the cap on cells");
  }
}

}  // namespace
}  // namespace cyl
