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
  ASSERT_FALSE(round.caught.empty());
  const Catch& last = round.caught.back();
  EXPECT_EQ(last.from, "grid");
  EXPECT_EQ(last.law->number, 1);
  const double wide = std::max(last.pair.a.radius, last.pair.b.radius);
  EXPECT_GT(wide, 3);
  EXPECT_LT(wide, 3.25) << "as near to the least of the grid as the cap lets it come";
  ASSERT_TRUE(last.reproduce.starts_with("reproduce=")) << last.reproduce;

  const HuntRound again = hunt_again(methods, swap, last.reproduce, {});
  ASSERT_FALSE(again.caught.empty());
  EXPECT_EQ(again.caught.back().pair.a.radius, last.pair.a.radius);
  EXPECT_EQ(again.caught.back().pair.b.center, last.pair.b.center);
}

TEST(LawHunt, SameSeedSameCatch) {
  const auto methods = one(favours_narrow);
  const HuntRound first = hunt(methods, everything, anything, seed, 100, {});
  const HuntRound second = hunt(methods, everything, anything, seed, 100, {});
  ASSERT_FALSE(first.caught.empty());
  EXPECT_EQ(first.caught.back().reproduce, second.caught.back().reproduce);
  EXPECT_EQ(first.caught.back().broken, second.caught.back().broken);
}

TEST(LawHunt, RefusesANameOfNothing) {
  const auto methods = own_methods();
  EXPECT_THROW(hunt_again(methods, everything, "reproduce=nonsense", {}), std::invalid_argument);
  EXPECT_THROW(hunt_again(methods, everything, "", {}), std::invalid_argument);
}

}  // namespace
}  // namespace cyl
