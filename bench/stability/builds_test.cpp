// SPDX-License-Identifier: MIT
#include "bench/stability/builds.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <stdexcept>

#include "base/json.hpp"
#include "base/scratch_test.hpp"
#include "bench/stability/build_pairs.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/fake_method_test.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Upright, side by side, at a margin relative to the size (6).
Pair beside(double margin) {
  return {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2 + 6 * margin, 0, 0}, {0, 0, 1}, 1, 2}};
}

std::unique_ptr<Method> named(std::string name, double relative, unsigned share) {
  const auto ask = [](const Pair&) -> MethodAnswer { std::abort(); };
  return fake_method(std::move(name), ask,
                     {.claim = {.relative = relative, .source = "the test"}, .share = share});
}

MethodAnswer said(Verdict verdict, std::optional<double> distance = {}) {
  MethodAnswer a;
  a.status = Status::answered;
  a.verdict = verdict;
  a.has_distance = distance.has_value();
  a.distance = distance.value_or(0);
  return a;
}

TEST(Builds, CountWhatChangesAndWhatIsWrongByIt) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(named("sure", 1e-13, 1));
  methods.push_back(named("coarse", 1e-2, 1));
  methods.push_back(named("costly", 1e-13, 2));
  const std::vector<Pair> pairs{beside(1e-3), beside(1e-3), beside(-1e-3), beside(1e-15)};
  std::vector<MethodAnswer> before(12), after(12);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t m = 0; m < 3; ++m)
      before[3 * i + m] = after[3 * i + m] =
          said(i == 2 ? Verdict::intersecting : Verdict::disjoint, i == 2 ? -6e-3 : 6e-3);
  BuildComparison comparison(methods, pairs);
  for (const BuildDifference& d : comparison.compare(before, after)) {
    EXPECT_EQ(d.pairs, d.method == "costly" ? 2u : 4u);
    EXPECT_EQ(d.verdicts_changed + d.beyond_claim + d.distances_changed, 0u);
    EXPECT_FALSE(d.largest_change);
  }
  for (std::size_t m = 0; m < 3; ++m) {
    after[m].verdict = Verdict::intersecting;      // wrong, by 1e-3
    after[3 + m].verdict = Verdict::undecided;     // changed, and nothing wrong
    after[6 + m].distance = -6e-3 - 6 * 0.25;      // by 0.25 sizes
    after[9 + m].verdict = Verdict::intersecting;  // wrong, by less than any of them claims
    after[9 + m].has_distance = false;             // changed by no number
  }
  before[5].verdict = Verdict::touching;  // of the costly one, at an index for which it is not asked
  const std::vector<BuildDifference> changed = comparison.compare(before, after);
  ASSERT_EQ(changed.size(), 3u);
  EXPECT_EQ(changed[0].verdicts_changed, 3u);
  EXPECT_EQ(changed[0].beyond_claim, 1u);
  EXPECT_EQ(changed[0].distances_changed, 2u);
  ASSERT_TRUE(changed[0].largest_change);
  EXPECT_NEAR(*changed[0].largest_change, 0.25, 1e-12);
  EXPECT_EQ(changed[1].verdicts_changed, 3u);
  EXPECT_EQ(changed[1].beyond_claim, 0u);
  EXPECT_EQ(changed[2].verdicts_changed, 1u);
  EXPECT_EQ(changed[2].beyond_claim, 1u);
  EXPECT_EQ(changed[2].distances_changed, 1u);
  after[0] = said(Verdict::disjoint, 6e-3);
  after[0].status = Status::failed;  // a failure is counted, and it is not a changed answer
  EXPECT_EQ(comparison.compare(before, after)[0].verdicts_changed, 3u);
  after.pop_back();
  EXPECT_THROW(comparison.compare(before, after), std::invalid_argument);
}

TEST(Builds, ThePairsAreReadAsTheyWereWritten) {
  for (const Pair& pair : build_pairs()) {
    double numbers[doubles_per_pair];
    numbers_of(pair, numbers);
    ASSERT_EQ(format_pair(pair_of(numbers, cylinder_number_count)), format_pair(pair));
  }
}

TEST(Builds, ThePairsHaveDenormalLengthsAndOrdinaryOnes) {
  std::set<int> exponents;
  for (const Pair& pair : build_pairs())
    if (pair.a.radius > 0) exponents.insert(std::ilogb(pair.a.radius));
  EXPECT_LT(*exponents.begin(), -1050);
  EXPECT_TRUE(exponents.contains(0));
  EXPECT_TRUE(exponents.contains(-500) && exponents.contains(-1010));
}

TEST(Builds, TheMethodsAreThoseThatNeedEigenAlone) {
  std::set<std::string_view> names;
  const auto methods = built_methods();
  for (const auto& method : methods) names.insert(method->name());
  EXPECT_TRUE(names.contains("intersect") && names.contains("decide") && names.contains("distance"));
  EXPECT_TRUE(names.contains("seed2008-polynomial-polish4") && names.contains("seed2017-cg-steps-64"));
  EXPECT_FALSE(names.contains("exact"));
}

TEST(Builds, AreReadBackLineByLine) {
  const Scratch scratch;
  const fs::path file = scratch.folder / "builds";
  EXPECT_EQ(builds_json(file), json::array());
  BuildDifference d;
  d.method = "m";
  d.build = "clang-O0";
  d.against = "gcc-O3";
  d.pairs = 9;
  std::ofstream(file) << R"({"command":"c"})" << '\n' << to_json(d) << '\n';
  EXPECT_EQ(builds_json(file), json::array({to_json(d)}));
  EXPECT_TRUE(builds_json(file)[0]["largest_change"].is_null());
  for (const char* bad : {"[]\n", "{}\n", "{\"command\":1}\n{\"method\":\"m\"}\n", "{\"command\":1}\nx\n"}) {
    std::ofstream(file) << bad;
    EXPECT_THROW(builds_json(file), std::runtime_error) << bad;
  }
}

TEST(Builds, TheCommittedOnesAreOfTheForm) {
  const json builds = builds_json(DAYLIGHT_SOURCE_DIR "/bench/stability/builds.jsonl");
  EXPECT_FALSE(builds.empty());
}

}  // namespace
}  // namespace cyl
