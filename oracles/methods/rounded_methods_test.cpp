// SPDX-License-Identifier: MIT
// Asks each packaged library about the spheres, capsules, rounded cylinders and half-spaces for which it has
// shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

using Kinds = std::set<SolidKind>;
using enum SolidKind;
const Kinds cylinders_alone{cylinder}, boxes_alone{box}, sharp{cylinder, box},
    without_rounded{sphere, capsule, cylinder, box},
    with_half_space{sphere, capsule, cylinder, half_space, box},
    of_the_solver{sphere, capsule, cylinder, rounded},
    bounded{sphere, capsule, cylinder, rounded, box, rounded_box},
    all{sphere, capsule, cylinder, rounded, half_space, box, rounded_box};

Kinds kinds_of(const Method& method) {
  Kinds kinds;
  for (const SolidKind kind : enum_values<SolidKind>)
    if (method.supports(kind)) kinds.insert(kind);
  return kinds;
}

TEST(RoundedMethods, HaveTheShapesOfTheirLibraries) {
  std::map<std::string, Kinds> expected{{"intersect", all},
                                        {"exact", all},
                                        {"distance", of_the_solver},
                                        {"fcl-libccd", with_half_space},
                                        {"fcl-distance-libccd", without_rounded},
                                        {"bullet-cylinder", all},
                                        {"bullet-gjkepa2", sharp},
                                        {"bullet-hull-16", sharp},
                                        {"bullet-box", boxes_alone},
                                        {"libccd-gjk", bounded},
                                        {"nlopt-direct-600", bounded},
                                        {"ode", with_half_space},
                                        {"mujoco", with_half_space},
                                        {"seedbook", cylinders_alone}};
  for (const auto& method : all_methods()) {
    const auto found = expected.find(std::string(method->name()));
    if (found == expected.end()) continue;
    EXPECT_EQ(kinds_of(*method), found->second) << method->name();
    expected.erase(found);
  }
  EXPECT_TRUE(expected.empty()) << expected.begin()->first << " is no method";
}

/// Returns pairs of solids that lie anywhere, either clearly apart or deep in each other.
std::vector<Pair> clear_pairs(const Family& family, std::size_t count) {
  std::vector<Pair> pairs;
  for (std::uint64_t i = 0; pairs.size() < count; i += 4) {
    const Pair pair = family.generate(20261123, i);
    if (std::fabs(approximate_distance(pair).value) > 0.02 * size_of(pair)) pairs.push_back(pair);
  }
  return pairs;
}

TEST(RoundedMethods, AreRightWhereThatIsEasy) {
  const auto methods = all_methods();
  std::map<std::string, std::size_t> answers;
  std::vector<Family> families(rounded_families().begin(), rounded_families().begin() + 9);  // two kinds each
  families.insert(families.end(), half_space_families().begin(), half_space_families().begin() + 4);
  for (const Family& family : families) {
    for (const Pair& pair : clear_pairs(family, 100)) {
      const bool meet = approximate_distance(pair).value < 0;
      for (const auto& method : methods) {
        if (method->share() > 1) continue;
        const MethodAnswer answer = method->ask(pair);
        if (!method->supports(pair)) {
          ASSERT_EQ(answer.status, Status::declined) << method->name();
          ASSERT_TRUE(std::string(answer.reason).starts_with("it has no ")) << answer.reason;
          continue;
        }
        ASSERT_EQ(answer.status, Status::answered) << method->name() << ' ' << format_pair(pair);
        ASSERT_EQ(answer.verdict != Verdict::disjoint, meet) << method->name() << ' ' << format_pair(pair);
        ++answers[std::string(method->name())];
      }
    }
  }
  EXPECT_EQ(answers["libccd-gjk"], 900u);
  EXPECT_EQ(answers["mujoco"], 800u);  // no pair with a rounded cylinder
  EXPECT_EQ(answers["ode"], 800u);
  EXPECT_EQ(answers["fcl-libccd"], 800u);
  EXPECT_EQ(answers["bullet-cylinder-margin0"], 1300u);
}

// Bullet's constructor makes another solid of a cylinder, and the method reports it.
TEST(RoundedMethods, ThatRoundEdgesNameTheirModel) {
  const Pair pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{3, 0, 0}, {0, 0, 1}, 1, 2}};
  for (const auto& method : all_methods()) {
    const Pair model = method->modelled(pair);
    EXPECT_EQ(is_rounded(model), method->name() == "bullet-cylinder") << method->name();
    EXPECT_EQ(model.a.radius + model.a.rounding, 1) << method->name();
    EXPECT_EQ(model.a.height + 2 * model.a.rounding, 2) << method->name();
  }
}

}  // namespace
}  // namespace cyl
