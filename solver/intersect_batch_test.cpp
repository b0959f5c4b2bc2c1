// SPDX-License-Identifier: MIT
#include "solver/intersect_batch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/enum_words.hpp"
#include "solver/solver_test.hpp"

namespace cyl {
namespace {

std::vector<Instructions> runnable() {
  std::vector<Instructions> sets;
  for (const Instructions i : enum_values<Instructions>)
    if (i <= best_instructions()) sets.push_back(i);
  return sets;
}

// Solids in a small room, of all the kinds that take another way through the kernel. They have steep, nearly
// parallel and parallel axes. They are needles, coins, segments, points, far beyond the ordinary, or
// invalid.
std::vector<Prepared> crowd(int count) {
  Numbers numbers(20261121);
  auto unit = [&] { return numbers.unit(); };
  std::vector<Prepared> solids;
  for (int i = 0; i < count; ++i) {
    Solid c{Vector3(4 * unit(), 4 * unit(), 4 * unit()), Vector3(unit() - 0.5, unit() - 0.5, unit() - 0.5),
            unit(), 2 * unit()};
    if (i % 5 == 1) c.axis = Vector3(1, 1, 1) + Vector3(unit(), unit(), unit()) * std::pow(10, -i % 18);
    if (i % 7 == 1) c.axis = Vector3(0, 0, i % 2 ? 1 : -1);
    if (i % 11 == 1) c.radius *= 1e-4;
    if (i % 13 == 1) c.height *= 1e-4;
    if (i % 17 == 1) c.radius = 0;
    if (i % 19 == 1) c.height = 0;
    if (i % 23 == 1) c.center = Vector3(std::floor(c.center.x()), 2, 2);
    if (i % 53 == 1) c.radius = 1e-290;
    if (i % 97 == 1) c.radius = std::numeric_limits<double>::quiet_NaN();
    solids.push_back(prepare(c));
  }
  return solids;
}

/// Every solid of `a` with each one of `b`.
std::vector<Verdict> ask_all(const std::vector<Prepared>& a, const std::vector<Prepared>& b,
                             Instructions instructions) {
  std::vector<IndexPair> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j) pairs.push_back({i, j});
  std::vector<Verdict> verdicts(pairs.size());
  intersect_batch(a, b, pairs, verdicts.data(), instructions);
  return verdicts;
}

TEST(Batch, GivesWhatIntersectGivesOnEveryInstructionSet) {
  const std::vector<Prepared> a = crowd(211), b = crowd(97);
  for (const Instructions instructions : runnable()) {
    const std::vector<Verdict> all = ask_all(a, b, instructions);
    int seen[5] = {};
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        const Verdict said = all[i * b.size() + j];
        ASSERT_EQ(said, intersect(a[i], b[j])) << i << " " << j << " " << static_cast<int>(instructions);
        ++seen[static_cast<int>(said)];
      }
    }
    EXPECT_GT(seen[static_cast<int>(Verdict::disjoint)], 1000);
    EXPECT_GT(seen[static_cast<int>(Verdict::intersecting)], 500);
    EXPECT_GT(seen[static_cast<int>(Verdict::invalid)], 100);
  }
}

// The square axes of intersect_test, in every lane.
TEST(Batch, SquareAxesAndARimInLineWithAnEndAreNoTouch) {
  const Solid a{Vector3(0, 3, 2), Vector3(2, 1, 0), 1, 2};
  const Solid b{Vector3(2, 3, 0), Vector3(8.937938184587448e-17, -4.484781043539769e-17, 1), 1, 2};
  const std::vector<Prepared> first(16, prepare(a)), second(16, prepare(b));
  for (const Instructions instructions : runnable())
    for (const Verdict said : ask_all(first, second, instructions))
      EXPECT_EQ(said, Verdict::disjoint) << static_cast<int>(instructions);
}

}  // namespace
}  // namespace cyl
