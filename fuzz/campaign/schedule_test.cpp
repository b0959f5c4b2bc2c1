// SPDX-License-Identifier: MIT
#include "fuzz/campaign/schedule.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "corpus/store/run_store.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

TEST(Schedule, EqualWeightsAreTheOrderOfTheFamilies) {
  const Schedule schedule({1, 1, 1});
  for (std::uint64_t i = 0; i < 100; ++i) {
    EXPECT_EQ(schedule.at(i).family, i % 3);
    EXPECT_EQ(schedule.at(i).index, i / 3);
  }
}

TEST(Schedule, EveryFamilyDrawsItsPairsInOrderAsOftenAsItsWeight) {
  const std::vector<unsigned> weights{5, 1, 3};
  const Schedule schedule(weights);
  std::vector<std::uint64_t> next(3);
  for (std::uint64_t i = 0; i < 900; ++i) {
    const auto [family, index] = schedule.at(i);
    EXPECT_EQ(index, next[family]++);
    if (i % 9 != 8) continue;
    for (std::size_t f = 0; f < 3; ++f) EXPECT_EQ(next[f], weights[f] * (i / 9 + 1));
  }
}

TEST(Weights, GrowWithWhatWasFoundAndLeaveNobodyOut) {
  const fs::path folder = fs::temp_directory_path() / ("daylight_weights_" + std::to_string(getpid()));
  fs::remove_all(folder);
  const Family families[] = {{"poor", "", nullptr}, {"rich", "", nullptr}, {"middling", "", nullptr}};
  const auto commit = [&](const char* run, std::vector<GroupRecord> groups) {
    RunStore store = RunStore::create(folder / run, {});
    BatchRecord batch;
    batch.next = 1;
    for (const GroupRecord& g : groups) {
      FindingRecord found;
      static_cast<FindingGroup&>(found) = g;
      batch.findings.insert(batch.findings.end(), std::min(g.count, representatives_cap), found);
    }
    batch.groups = std::move(groups);
    store.commit(batch, 1);
  };
  commit("1", {{"x", FindingKind::wrong_disjoint, Severity::contract, "rich", 1000, 0},
               {"x", FindingKind::crash, Severity::contract, "rich", 1, 0},
               {"x", FindingKind::wrong_disjoint, Severity::contract, "middling", 1, 0},
               {"x", FindingKind::wrong_disjoint, Severity::resolution, "poor", 1000, 0}});
  commit("2", {{"x", FindingKind::wrong_disjoint, Severity::contract, "rich", 5, 0},
               {"y", FindingKind::crash, Severity::contract, "rich", 1, 0},
               {"y", FindingKind::hang, Severity::contract, "rich", 1, 0}});
  EXPECT_EQ(weights_from(folder, families), (std::vector<unsigned>{1, weight_cap, 3}));
  EXPECT_EQ(weights_from(folder / "1", families), (std::vector<unsigned>{1, weight_cap, 5}));
  EXPECT_THROW(weights_from(folder / "none", families), std::invalid_argument);
  fs::remove_all(folder);
}

TEST(Weights, AreReadBack) {
  EXPECT_EQ(format_weights(std::vector<unsigned>{1, 1}), "");
  EXPECT_EQ(format_weights(std::vector<unsigned>{1, 8}), "1 8");
  EXPECT_EQ(parse_weights("1 8"), (std::vector<unsigned>{1, 8}));
  EXPECT_TRUE(parse_weights("").empty());
  EXPECT_THROW(parse_weights("1 x"), std::runtime_error);
  EXPECT_THROW(parse_weights("1 0"), std::runtime_error);
}

}  // namespace
}  // namespace cyl
