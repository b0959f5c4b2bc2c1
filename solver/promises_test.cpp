// SPDX-License-Identifier: MIT
// Tests the data that come with the solver's verdicts. A shortcut that is never taken and a bad start give
// right answers, so only the count of steps shows them. The bounds are measured values.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "corpus/pairs/checks_test.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "solver/detail/frame.hpp"
#include "solver/detail/sections.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// Sums over one kind of pairs.
struct Work {
  double pairs = 0, decide_steps = 0, undecided = 0, distance_steps = 0;
  double apart = 0, error = 0, outside = 0;  // mean error of gaps, in units of the rounding
  double unresolved = 0, iterated = 0, intersect_steps = 0, hit_cap = 0;  // of intersect()
};

/// The most that the mean of Work may be for one kind of pairs.
struct Bounds {
  double decide_steps, undecided, distance_steps, error, outside, unresolved, iterated, intersect_steps;
};
/// Families, strata, close contacts, pairs within rounding.
constexpr Bounds bounds[] = {{0.118620, 0.053939, 4.9978, 1.007987, 0.001168, 0.156260, 0.038568, 1.771999},
                             {0.371180, 0.069430, 3.8567, 1.008235, 0.000090, 0.392330, 0.131690, 1.839740},
                             {0.206590, 0.022502, 8.8639, 1.017220, 0.015755, 0.279552, 0.054911, 2.183100},
                             {5.566700, 0.993704, 16.8891, 1.035702, 0.018839, 0.518850, 0.161322, 5.458600}};

bool is_ordinary_range(double reach) { return reach > 0x1p-200 && reach < 0x1p200; }

double reach_of(const Pair& pair) {
  return pair.a.radius + pair.a.height / 2 + pair.b.radius + pair.b.height / 2 +
         (pair.b.center - pair.a.center).norm();
}

/// How far the point, which counts from the solid's centre, is outside the solid.
double outside(const Solid& c, const Vector3& x) {
  const Vector3 w = c.axis.stableNormalized();
  const double along = x.dot(w);
  return std::max(std::fabs(along) - c.height / 2, (x - along * w).norm() - c.radius);
}

double gap_along(const Pair& pair, const Vector3& d) {
  double f = -std::fabs(d.dot(pair.b.center - pair.a.center));
  for (const Solid* c : {&pair.a, &pair.b}) {
    const Vector3 w = c->axis.stableNormalized();
    f += c->radius * d.cross(w).norm() + c->height / 2 * std::fabs(d.dot(w));
  }
  return f;
}

/// Checks all that solver/distance.hpp promises of value, error, direction and points.
void measure(const Pair& pair, Work& work) {
  const Distance d = distance(pair.a, pair.b);
  const auto expect = [&](bool right, const char* what) { check_that(right, what, pair); };
  work.distance_steps += d.iterations;
  const double reach = reach_of(pair), rounding = distance_error * reach, slack = d.error + rounding;
  if (!is_ordinary_range(reach)) return;
  const Vector3 delta = pair.b.center - pair.a.center;
  expect((d.value > 0) == (d.verdict == Verdict::disjoint), "distances: the sign is not the verdict");
  expect(d.error >= rounding * (1 - 0x1p-40), "distances: an error below rounding");
  expect(d.error <= (d.value > 0 ? 1e-13 * (size_of(pair) + delta.norm()) : 1.01 * rounding),
         "distances: a great error");
  expect(std::fabs(d.direction.norm() - 1) <= 0x1p-50, "distances: a direction of another length");
  expect(d.direction.dot(delta) >= -rounding, "distances: a direction from b to a");
  expect(d.value == 0 || std::fabs(gap_along(pair, d.direction) + d.value) <= 2 * rounding,
         "distances: not along the direction");
  const bool inside = outside(pair.a, d.on_a) <= slack && outside(pair.b, d.on_b) <= slack;
  const Vector3 way = delta + d.on_b - d.on_a;
  if (d.value > 0) {
    expect(inside, "distances: a nearest point outside its solid");
    expect(std::fabs(way.norm() - d.value) <= slack, "distances: points at another distance");
    ++work.apart;
    work.error += d.error / rounding;
  } else {
    work.outside += !inside;
    const bool near = outside(pair.a, d.on_a) <= 1e-9 * reach && outside(pair.b, d.on_b) <= 1e-9 * reach;
    expect(near, "distances: a deepest point outside its solid");
    expect((way - d.value * d.direction).norm() <= 2 * slack, "distances: points not along the direction");
    // Each deepest in the other: at the end of its solid along the direction.
    const auto lacks = [&](const Solid& c, const Vector3& x, const Vector3& u) {
      const Vector3 w = c.axis.stableNormalized();
      return c.radius * u.cross(w).norm() + c.height / 2 * std::fabs(u.dot(w)) - u.dot(x);
    };
    const double both = lacks(pair.a, d.on_a, d.direction) + lacks(pair.b, d.on_b, -d.direction);
    expect(both <= 4 * slack, "distances: points that are not deepest");
  }
}

/// Takes the steps of intersect() one by one, because intersect() does not report them.
void count_steps(const Pair& pair, Work& work) {
  const Prepared a = prepare(pair.a), b = prepare(pair.b);
  if (!both_are(Prepared::ordinary, a, b)) return;
  const Couple<double> couple = as_it_is(a, b).couple();
  const Sections<double> f = shallow_sections(couple);
  if (f.s2 < parallel_square) return;
  const auto filter = separating_axis_filter(f);
  if (filter.apart || filter.overlaps) return;
  ++work.unresolved;
  const auto at = corner(in_order(f));
  if (at.overlaps || at.cannot_improve || !(at.rises2 || at.rises3)) return;
  const Edge<double> e = edge(at);
  if (top(e).here) return;
  ++work.iterated;
  const auto [low, first] = start(e);
  double t = first;
  for (int i = 0; i < iteration_cap; ++i) {
    ++work.intersect_steps;
    const auto now = step(e, low, t);
    if (now.apart || now.overlaps) return;
    t = now.t;
  }
  ++work.hit_cap;
}

void work_on(const Pair& pair, Work& work) {
  if (!is_legal(pair)) return;
  ++work.pairs;
  const Answer decided = decide(pair.a, pair.b);
  work.decide_steps += decided.iterations;
  work.undecided += decided.verdict == Verdict::undecided;
  measure(pair, work);
  count_steps(pair, work);
}

/// Solids of parallel axes along a coordinate, whose numbers are small integers: nothing is rounded, and
/// touching is meeting.
void touch_exactly(std::uint64_t index) {
  RandomStream stream("touching solids", drawing_seed, index);
  Pair pair;
  pair.a.axis = stream.coordinate_axis();
  pair.b.axis = stream.sign() * pair.a.axis;
  for (Solid* c : {&pair.a, &pair.b}) {
    for (double& x : c->center) x = stream.integer(-5, 5);
    c->radius = stream.integer(0, 4);
    c->height = 2 * stream.integer(0, 3);
  }
  const Vector3 delta = pair.b.center - pair.a.center;
  const double along = std::fabs(delta.dot(pair.a.axis)), radii = pair.a.radius + pair.b.radius;
  const double square = delta.squaredNorm() - along * along;
  const bool meet = 2 * along <= pair.a.height + pair.b.height && square <= radii * radii;
  check_that((intersect(pair.a, pair.b) == Verdict::intersecting) == meet, "verdicts: of parallel solids",
             pair);
}

/// The pair with b moved along the direction of its distance until hardly anything is between them.
Pair brought_together(Pair pair) {
  const Distance d = distance(pair.a, pair.b);
  pair.b.center -= d.value * (1 - 0x1p-50) * d.direction;
  return pair;
}

/// One in so many of the strata and of the close contacts is brought together: decide() takes its time there.
constexpr std::size_t within_rounding_share = 3;
constexpr std::uint64_t touching_count = 4000;

TEST(SolverPromises, HoldInAsManyStepsAsMeasured) {
  std::vector<PairsOfKind> drawn = draw_pairs(counting_seed);
  drawn.push_back({"pairs within rounding", {}});
  for (std::size_t k = 1; k < 3; ++k)
    for (std::size_t i = 0; i < drawn[k].pairs.size(); i += within_rounding_share)
      drawn.back().pairs.push_back(brought_together(drawn[k].pairs[i]));
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const PairsOfKind& kind = drawn[k];
    Work w;
    for (const Pair& pair : kind.pairs) work_on(pair, w);
    const Bounds& most = bounds[k];
    const auto expect = [&](double is, double may_be, const char* what) {
      check_that(is <= may_be * step_tolerance, what, "of", kind.name, is, "that may be", may_be);
    };
    expect(w.decide_steps / w.pairs, most.decide_steps, "decide: mean steps");
    expect(w.undecided / w.pairs, most.undecided, "decide: share undecided");
    expect(w.distance_steps / w.pairs, most.distance_steps, "distance: mean steps");
    expect(w.error / w.apart, most.error, "distance: mean error of gaps in units of the rounding");
    expect(w.outside / (w.pairs - w.apart), most.outside,
           "distance: share of overlaps with a point outside its solid");
    expect(w.unresolved / w.pairs, most.unresolved, "intersect: share that the filter leaves open");
    expect(w.iterated / w.pairs, most.iterated, "intersect: share that the corner leaves open");
    expect(w.intersect_steps / w.iterated, most.intersect_steps, "intersect: mean steps of these");
    expect(w.hit_cap, 0, "intersect: undecided");
  }
  for (std::uint64_t i = 0; i < touching_count; ++i) touch_exactly(i);
}

}  // namespace
}  // namespace cyl
