// SPDX-License-Identifier: MIT
#include "props/gate/law_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "props/laws/laws_test.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

const Wanted everything = [](std::size_t, const Law&) { return true; };
const IsNews anything = [](const Catch&) { return true; };
constexpr std::uint64_t seed = 20261121;

/// What RapidCheck shrank and named.
const Catch& named(const HuntRound& round) {
  const auto found = std::find_if(round.caught.begin(), round.caught.end(),
                                  [](const Catch& c) { return !c.reproduce.empty(); });
  if (found == round.caught.end()) throw std::runtime_error("nothing was named");
  return *found;
}

std::vector<std::unique_ptr<Method>> one(const Planted::Ask& ask) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Planted>(ask));
  return methods;
}

/// Takes wide solids a for flat ones.
MethodAnswer favours_narrow(const Pair& pair) {
  MethodAnswer answer = ask_ours("intersect", pair);
  if (pair.a.radius > 3) answer.verdict = Verdict::disjoint;
  return answer;
}

TEST(LawHunt, FindsNothingWhereNothingIsBroken) {
  const auto methods = own_methods();
  const HuntRound round = hunt(methods, everything, anything, seed, 20, {});
  for (const Catch& c : round.caught) EXPECT_NE(c.broken.severity, Severity::contract) << c.law->name;
  std::uint64_t drawn = 0;
  for (const auto& [kind, pairs] : round.drawn) drawn += pairs;
  EXPECT_GT(drawn, 200u);
  EXPECT_GT(round.drawn.size(), 10u) << "kinds take turns";
  EXPECT_EQ(round.counts.at(0).asked, drawn);
}

TEST(LawHunt, ShrinksWhatItFindsOnTheGridAndNamesIt) {
  const auto methods = one(favours_narrow);
  // Only swaps on the grid, so that it is RapidCheck that shrinks.
  const Wanted swap = [](std::size_t, const Law& law) { return law.number == 1; };
  const IsNews on_the_grid = [](const Catch& c) { return c.from == "grid"; };
  const HuntRound round = hunt(methods, swap, on_the_grid, seed, 400, {});
  const Catch& first = named(round);
  EXPECT_EQ(first.from, "grid");
  EXPECT_EQ(first.law->number, 1);
  ASSERT_TRUE(first.shrunk);
  const double wide = std::max(first.shrunk->a.radius, first.shrunk->b.radius);
  EXPECT_GT(wide, 3);
  EXPECT_LT(wide, 3.25) << "as near to the least of the grid as the cap lets it come";
  ASSERT_TRUE(first.reproduce.starts_with("reproduce=")) << first.reproduce;

  const HuntRound again = hunt_again(methods, swap, first.reproduce, {});
  ASSERT_FALSE(again.caught.empty());
  ASSERT_TRUE(again.caught.back().shrunk);
  EXPECT_EQ(again.caught.back().shrunk->a.radius, first.shrunk->a.radius);
  EXPECT_EQ(again.caught.back().shrunk->b.center, first.shrunk->b.center);
}

TEST(LawHunt, DrawsTheSamePairsWhateverItFinds) {
  const HuntRound broken = hunt(one(favours_narrow), everything, anything, seed, 20, {});
  const HuntRound whole =
      hunt(one([](const Pair& p) { return ask_ours("intersect", p); }), everything, anything, seed, 20, {});
  EXPECT_FALSE(named(broken).reproduce.empty());
  EXPECT_EQ(broken.drawn, whole.drawn);
  ASSERT_EQ(broken.pairs.size(), whole.pairs.size());
  for (std::size_t i = 0; i < whole.pairs.size(); ++i) {
    EXPECT_EQ(broken.pairs[i].a.radius, whole.pairs[i].a.radius);
    EXPECT_EQ(broken.pairs[i].b.center, whole.pairs[i].b.center);
  }
}

TEST(LawHunt, SameSeedSameCatch) {
  const auto methods = one(favours_narrow);
  const HuntRound first = hunt(methods, everything, anything, seed, 20, {});
  const HuntRound second = hunt(methods, everything, anything, seed, 20, {});
  EXPECT_EQ(named(first).reproduce, named(second).reproduce);
  EXPECT_EQ(named(first).broken, named(second).broken);
}

TEST(LawHunt, RefusesANameOfNothing) {
  const auto methods = own_methods();
  EXPECT_THROW(hunt_again(methods, everything, "reproduce=nonsense", {}), std::invalid_argument);
  EXPECT_THROW(hunt_again(methods, everything, "", {}), std::invalid_argument);
}

}  // namespace
}  // namespace cyl
