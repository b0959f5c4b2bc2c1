// SPDX-License-Identifier: MIT
#include "reports/triage/worst_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string_view>

#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// A method that answers intersecting for pairs with a gap of at most `wrong_up_to`, in sizes.
using Methods = std::vector<std::unique_ptr<Method>>;

Methods planted(std::function<double(const Pair&)> wrong_up_to) {
  Methods methods;
  methods.push_back(fake_method("planted", [wrong_up_to = std::move(wrong_up_to)](const Pair& pair) {
    const double margin = approximate_distance(pair).value / size_of(pair);
    return answered(margin > wrong_up_to(pair) ? Verdict::disjoint : Verdict::intersecting);
  }));
  return methods;
}

/// Two equal cans side by side with axes at a right angle, `gap` sizes apart.
Pair apart(double gap, double size = 1) {
  const double h = size / 4, r = size / 4;
  return {{{0, 0, 0}, {0, 0, 1}, r, h}, {{2 * r + gap * size, 0, 0}, {0, 1, 0}, r, h}};
}

/// The margin is at most `most`, for solids whose radii differ by a factor of ten.
constexpr double most = 2e-3;
double reach_of_unequal(const Pair& p) {
  return most * std::pow(10, -std::abs(std::log10(p.a.radius / p.b.radius) - 1));
}

WorstOptions shapes(std::size_t cap) {
  WorstOptions options;
  options.evaluation_cap = cap;
  return options;
}

std::optional<WrongPair> search(const Methods& methods, const CauseSought& cause, std::size_t cap = 300) {
  const std::vector<std::size_t> groups{0};
  return worst_of_cause({methods, groups}, cause, shapes(cap), {});
}

TEST(WorstOfCause, NineTenthsOfAKnownMarginAreFoundAndAgainTheSame) {
  const Methods methods = planted(reach_of_unequal);
  const CauseSought cause{"planted/wrong_intersecting",
                          Mechanism::unclassified,
                          0,
                          FindingKind::wrong_intersecting,
                          {apart(1e-5)}};
  const auto found = search(methods, cause);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->finding.severity, Severity::contract);
  EXPECT_GE(found->finding.margin->lo, 0.9 * most);
  EXPECT_LE(found->finding.margin->lo, most);
  EXPECT_EQ(format_pair(found->pair), format_pair(search(methods, cause)->pair));
}

// The method has two causes: rounding up to 1e-13, and unequal solids, which no probe reveals.
TEST(WorstOfCause, AnotherCauseDoesNotCount) {
  const Methods methods = planted([](const Pair& p) { return p.a.radius > 1.1 * p.b.radius ? most : 1e-13; });
  const CauseSought rounding{
      "planted/rounding", Mechanism::rounding, 0, FindingKind::wrong_intersecting, {apart(5e-14)}};
  const auto found = search(methods, rounding, 1000);
  ASSERT_TRUE(found);
  EXPECT_GE(found->finding.margin->lo, 0.9e-13);
  EXPECT_LE(found->finding.margin->lo, rounding_margin);
}

// With a fixed length of 1e-3, smaller solids are worse without end. The starts set the range of sizes.
TEST(WorstOfCause, AFixedLengthIsNotFollowedToWhereItSwallowsAll) {
  const Methods methods = planted([](const Pair& p) { return 1e-3 / size_of(p); });
  const std::vector<Pair> starts{apart(1e-5, 10), apart(1e-6, 1000)};
  const CauseSought cause{"planted/absolute-length", Mechanism::absolute_length, 0,
                          FindingKind::wrong_intersecting, starts};
  const auto found = search(methods, cause);
  ASSERT_TRUE(found);
  EXPECT_GE(size_of(found->pair), 4.9);
  EXPECT_GE(found->finding.margin->lo, 1e-4);
  EXPECT_LE(found->finding.margin->lo, 2.1e-4);
}

TEST(DomainOf, KeepsToTheSizesAndPlacesOfTheStartsWhereTheCauseIsAboutThem) {
  Pair far = apart(0.1, 1);
  far.a.center[2] += 1e8;
  far.b.center[2] += 1e8;
  const std::vector<Pair> starts{apart(0.1, 1e-150), apart(0.1, 1e-140), far};
  const Domain ordinary = domain_of(Mechanism::unclassified, starts);
  EXPECT_EQ(ordinary.least_size, Domain{}.least_size);
  EXPECT_EQ(ordinary.most_offset, Domain{}.most_offset);
  const Domain small = domain_of(Mechanism::underflow, std::span(starts).first(2));
  EXPECT_LE(small.least_size, 1e-150);
  EXPECT_GE(small.least_size, 1e-151);
  EXPECT_LE(small.most_size, 1e-138);
  EXPECT_GE(domain_of(Mechanism::offset, starts).most_offset, 1e7);
}

}  // namespace
}  // namespace cyl
