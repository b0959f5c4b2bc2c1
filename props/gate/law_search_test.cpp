// SPDX-License-Identifier: MIT
#include "props/gate/law_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "corpus/pairs/pair_io.hpp"
#include "props/laws/laws_test.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

const LawFilter everything = [](std::size_t, const Law&) { return true; };
const WorthShrinking anything = [](const LawFailure&) { return true; };
constexpr std::uint64_t seed = 20261121;

/// Returns the failure that RapidCheck shrank.
const LawFailure& shrunk(const SearchRound& round) {
  const auto found = std::find_if(round.failures.begin(), round.failures.end(),
                                  [](const LawFailure& c) { return c.shrunk.has_value(); });
  if (found == round.failures.end()) throw std::runtime_error("nothing was shrunk");
  return *found;
}

std::vector<std::unique_ptr<Method>> one(const Planted::Ask& ask) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Planted>(ask));
  return methods;
}

/// Misses an intersection if the radius of a is above 3.
MethodAnswer favours_narrow(const Pair& pair) {
  MethodAnswer answer = ask_ours("intersect", pair);
  if (pair.a.radius > 3) answer.verdict = Verdict::disjoint;
  return answer;
}

TEST(LawSearch, FindsNothingWhereNothingIsBroken) {
  const auto methods = own_methods();
  const SearchRound round = find_violations(methods, everything, anything, PairSource::kinds, seed, 20, {});
  for (const LawFailure& c : round.failures)
    EXPECT_NE(c.violation.severity, Severity::contract) << c.law->name;
  std::uint64_t drawn = 0;
  for (const auto& [kind, pairs] : round.drawn) drawn += pairs;
  EXPECT_GT(drawn, 200u);
  EXPECT_GT(round.drawn.size(), 10u) << "kinds take turns";
  EXPECT_EQ(round.counts.at(0).asked, drawn);
}

TEST(LawSearch, ShrinksWhatItFindsOnTheGrid) {
  const auto methods = one(favours_narrow);
  // Asks for swaps on the grid only, because RapidCheck shrinks no other pairs.
  const LawFilter swap = [](std::size_t, const Law& law) { return law.number == 1; };
  const WorthShrinking on_the_grid = [](const LawFailure& c) { return c.from == "grid"; };
  const SearchRound round = find_violations(methods, swap, on_the_grid, PairSource::kinds, seed, 400, {});
  const LawFailure& first = shrunk(round);
  EXPECT_EQ(first.from, "grid");
  EXPECT_EQ(first.law->number, 1);
  ASSERT_TRUE(first.shrunk);
  const double wide = std::max(first.shrunk->a.radius, first.shrunk->b.radius);
  EXPECT_GT(wide, 3);
  EXPECT_LT(wide, 3.25) << "as near to the least of the grid as the cap lets it come";
}

TEST(LawSearch, DrawsTheSamePairsWhateverItFinds) {
  const SearchRound stopped =
      find_violations(one(favours_narrow), everything, anything, PairSource::kinds, seed, 20, {});
  const SearchRound whole = find_violations(one([](const Pair& p) { return ask_ours("intersect", p); }),
                                            everything, anything, PairSource::kinds, seed, 20, {});
  EXPECT_TRUE(shrunk(stopped).shrunk);
  EXPECT_EQ(stopped.drawn, whole.drawn);
  ASSERT_EQ(stopped.pairs.size(), whole.pairs.size());
  for (std::size_t i = 0; i < whole.pairs.size(); ++i) {
    EXPECT_EQ(stopped.pairs[i].a.radius, whole.pairs[i].a.radius);
    EXPECT_EQ(stopped.pairs[i].b.center, whole.pairs[i].b.center);
  }
}

TEST(LawSearch, SameSeedSameFailure) {
  const auto methods = one(favours_narrow);
  const SearchRound first = find_violations(methods, everything, anything, PairSource::kinds, seed, 20, {});
  const SearchRound second = find_violations(methods, everything, anything, PairSource::kinds, seed, 20, {});
  EXPECT_EQ(format_pair(*shrunk(first).shrunk), format_pair(*shrunk(second).shrunk));
  EXPECT_EQ(shrunk(first).violation, shrunk(second).violation);
}

TEST(LawSearch, KeepsWhatASeedDrawsForTheBasesOfGates) {
  const auto methods = one(favours_narrow);
  std::string drawn;
  for (std::uint64_t i = 1; i <= 3; ++i)
    for (const auto& [kind, pairs] :
         find_violations(methods, everything, anything, PairSource::kinds, i, 4, {}).drawn)
      drawn += kind + "; ";
  EXPECT_EQ(
      drawn,
      "family touching_cap_cap; stratum cap-side 1e-01; stratum cap-side 1e-08; stratum side-side 1e-01; "
      "family touching_cap_side; family touching_side_rim; stratum rim-rim 1e-07; stratum side-side 1e-01; "
      "family flat_disks; family random; family touching_rim_rim; stratum cap-side 1e-05; ");
}

TEST(LawSearch, ShrinksWhatItFindsOnCloseContacts) {
  // Wrong for flat solids only, so that some pairs pass.
  const auto methods = one([](const Pair& pair) {
    MethodAnswer answer = ask_ours("intersect", pair);
    if (pair.a.height == 0 || pair.a.radius == 0) answer.verdict = Verdict::disjoint;
    return answer;
  });
  const SearchRound round =
      find_violations(methods, everything, anything, PairSource::close_contacts, seed, 20, {});
  for (const auto& [kind, pairs] : round.drawn)
    EXPECT_TRUE(kind.starts_with("close ") || kind.starts_with("family close_") ||
                kind == "family range_ends" || kind == "family whiskers")
        << kind;
  std::string all;
  for (const auto& [kind, pairs] : round.drawn) all += kind + "; ";
  EXPECT_GT(round.drawn.size(), 10u) << all;
  EXPECT_TRUE(round.drawn.contains(shrunk(round).from)) << shrunk(round).from;
}

}  // namespace
}  // namespace cyl
