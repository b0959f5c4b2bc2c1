// SPDX-License-Identifier: MIT
#include "reports/triage/recurrence.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cyl {
namespace {

constexpr std::size_t compared = 40;

std::optional<Recurrence> status(const Observation& here, const std::vector<Observation>& earlier) {
  return recurrence_of(here, earlier, compared).status;
}

TEST(Recurrence, IsSaidOnlyWhereItIsNoChance) {
  const Observation none{0, 20000}, few{4, 20000}, many{40, 20000};
  EXPECT_EQ(status(many, {none}), Recurrence::fresh);
  EXPECT_EQ(status(few, {none}), Recurrence::rare);
  EXPECT_EQ(status(none, {many}), Recurrence::gone);
  EXPECT_EQ(status(none, {few}), Recurrence::rare);
  EXPECT_EQ(status(few, {many}), Recurrence::known);
  EXPECT_EQ(status(many, {many, none}), Recurrence::back);
  EXPECT_EQ(status(few, {few, none}), Recurrence::known) << "missed by chance";
  EXPECT_EQ(status(none, {many, none}), std::nullopt) << "gone before";
  EXPECT_EQ(status(none, {}), std::nullopt);
}

TEST(Recurrence, GrowsSureWithTheNightsWithout) {
  const Observation none{0, 20000}, few{4, 20000};
  std::vector<Observation> history;
  for (int night = 0; night < 10; ++night) history.push_back(none);
  EXPECT_EQ(status(few, history), Recurrence::fresh);
  EXPECT_NEAR(*recurrence_of(few, history, compared).chance, 40.0 / (11 * 11 * 11 * 11), 1e-12);
}

TEST(Recurrence, ARunThatDidNotAskSaysNothing) {
  const Observation many{40, 20000}, unasked{};
  EXPECT_EQ(status(unasked, {many}), std::nullopt);
  EXPECT_EQ(status(many, {many, unasked}), Recurrence::known);
  EXPECT_EQ(status(many, {unasked}), Recurrence::fresh) << "looked for the first time";
}

}  // namespace
}  // namespace cyl
