// SPDX-License-Identifier: MIT
#include "oracles/trial/decidable_margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// The radii of balls that are tried: 8 per decade, from 1e-16 to 1 times the size.
constexpr int per_decade = 8, decades = 16;

}  // namespace

std::optional<Solid> core(Solid c, double least) {
  if (c.rounding >= least) {
    c.rounding -= least;
    return c;
  }
  least -= c.rounding;
  c.rounding = 0;
  if (is_box(c)) {
    for (double& edge : c.edges) edge = edge <= least ? 0 : edge - 2 * least;
    const auto [shortest, longest] = std::ranges::minmax(c.edges);
    if (shortest < 0 || longest == 0) return {};
    return c;
  }
  c.radius = 2 * c.radius <= least ? 0 : c.radius - least;
  c.height = c.height <= least ? 0 : c.height - 2 * least;
  if (c.radius < 0 || c.height < 0 || (c.radius == 0 && c.height == 0)) return {};
  return c;
}

std::optional<Pair> cores(const Pair& pair, double least) {
  const auto flat = [&](const Solid& solid) {
    const double thickness =
        is_box(solid) ? std::ranges::min(solid.edges) : std::min(2 * solid.radius, solid.height);
    return solid.rounding + thickness / 2 <= least / 2;
  };
  const auto a = core(pair.a, least), b = core(pair.b, least);
  if (!a || !b || (flat(pair.a) && flat(pair.b)) || !(size_of(pair) < std::numeric_limits<double>::max()))
    return {};
  return Pair{*a, *b};
}

bool must_decide(DecisionScope promised, Trial& proved) {
  if (promised == DecisionScope::not_promised || !proved.decided()) return false;
  if (promised == DecisionScope::all) return true;
  if (has_box(proved.pair) || (has_half_space(proved.pair) && is_rounded(proved.pair))) return false;
  // Subnormal lengths have fewer digits than the margin needs.
  if (size_of(proved.pair) < std::numeric_limits<double>::min()) return false;
  const double least = reach({.relative = resolved_margin, .source = {}}, size_of(proved.pair));
  if (!proved.meets()) return magnitude_against(least, proved).lo >= least;
  const auto inner = cores(proved.pair, least);
  if (!inner) return false;
  const Verdict truth = judge_verdict(*inner).verdict;
  return truth == Verdict::intersecting || truth == Verdict::touching;
}

double estimated_margin(const Pair& pair) {
  const double gap = approximate_distance(pair).value;
  if (gap > 0) return gap / size_of(pair);
  int least = -1, most = per_decade * decades;  // steps at whose radius the cores meet, and do not
  const auto radius = [](int step) { return std::pow(10, static_cast<double>(step) / per_decade - decades); };
  while (most - least > 1) {
    const int middle = (least + most) / 2;
    const auto inner = cores(pair, radius(middle) * size_of(pair));
    (inner && approximate_distance(*inner).value <= 0 ? least : most) = middle;
  }
  return least < 0 ? 0 : radius(least);
}

}  // namespace cyl
