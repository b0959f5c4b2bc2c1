// SPDX-License-Identifier: MIT
#include "reports/run/history.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "reports/run/run_data.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

// Kinds, named by what becomes of them in the runs below.
constexpr auto held = FindingKind::hang, lost = FindingKind::crash, old = FindingKind::exception,
               late = FindingKind::malformed, first = FindingKind::wrong_disjoint,
               seldom = FindingKind::nondeterminism, other = FindingKind::reported;

class HistoryTest : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("daylight_history_" + std::to_string(getpid()));
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  /// A run that asked `methods` about one family and found these kinds of each.
  void run(const std::string& name, const std::string& began,
           const std::map<std::string, std::set<FindingKind>>& methods) const {
    RunStore store = RunStore::create(folder / name, {{"started", began}});
    BatchRecord batch;
    batch.next = 1;
    for (const auto& [method, kinds] : methods) {
      batch.tallies.push_back({method, "flat", Counts{100, 0, 0, 0, 0, 0, 0}});
      for (const FindingKind kind : kinds) {
        FindingRecord found;
        static_cast<FindingGroup&>(found) = {method, kind, Severity::contract, "flat"};
        batch.groups.push_back({found, kind == seldom ? 2u : 30u, 0});
        batch.findings.insert(batch.findings.end(), std::min(batch.groups.back().count, representatives_cap),
                              found);
      }
    }
    store.commit(batch, 1);
  }
  History of(const std::string& name) const { return compare_with_earlier(read_run(folder / name, {})); }
  std::string recurrence(const std::string& name, const std::string& method, FindingKind kind) const {
    for (const auto& [group, recurrence] : of(name).groups) {
      if (group.method == method && group.kind == kind) return to_string(recurrence);
    }
    return "";
  }

  fs::path folder;
};

TEST_F(HistoryTest, ShowsNewKnownBackAndGone) {
  run("c", "2026-11-01", {{"x", {lost, held, old}}});
  run("b", "2026-11-02", {{"x", {held, late}}});
  run("a", "2026-11-03", {{"x", {held, lost, first, seldom}}, {"y", {other}}});
  run("later", "2026-11-04", {{"x", {first}}});
  EXPECT_EQ(recurrence("a", "x", first), "new");
  EXPECT_EQ(recurrence("a", "y", other), "new");
  EXPECT_EQ(recurrence("a", "x", seldom), "rare") << "two may be chance";
  EXPECT_EQ(recurrence("a", "x", held), "known");
  EXPECT_EQ(recurrence("a", "x", lost), "back");
  EXPECT_EQ(recurrence("a", "x", late), "gone");
  EXPECT_EQ(recurrence("a", "x", old), "") << "gone before";
  EXPECT_EQ(format_history(of("a")),
            "compared with 2 earlier runs in the same folder, groups by method, kind and family: 2 new, 1 "
            "back, 1 gone, 1 known, 1 rare");
  EXPECT_EQ(format_history(of("c")),
            "compared with 0 earlier runs in the same folder, groups by method, kind and family: 3 new, 0 "
            "back, 0 gone, 0 known, 0 rare");
}

TEST_F(HistoryTest, ARunThatDidNotAskDoesNotCount) {
  run("1", "2026-11-01", {{"x", {held}}});
  run("2", "2026-11-02", {{"y", {}}});
  run("3", "2026-11-03", {{"x", {held}}});
  run("4", "2026-11-04", {{"y", {}}});
  EXPECT_EQ(recurrence("3", "x", held), "known");
  EXPECT_EQ(recurrence("4", "x", held), "");
}

TEST_F(HistoryTest, ShardsHaveNoHistoryOfTheirOwn) {
  run("0", "2026-11-01", {{"x", {held}}});
  run("1", "2026-11-02", {{"x", {held}}});
  run("2", "2026-11-03", {{"x", {held}}});
  RunStore::open(folder / "1").set("shard", "1/3 of batches of 512");
  EXPECT_EQ(of("1").runs, 0u);
  EXPECT_EQ(of("2").runs, 1u);
}

TEST_F(HistoryTest, PassesOverWhatCannotBeRead) {
  run("1", "2026-11-01", {{"x", {held}}});
  run("2", "2026-11-02", {{"x", {held}}});
  fs::create_directories(folder / "broken");
  std::ofstream(folder / "broken" / "run.sqlite") << std::string(4096, '?');
  EXPECT_EQ(format_history(of("2")),
            "compared with 1 earlier run in the same folder, groups by method, kind and family: 0 new, 0 "
            "back, 0 gone, 1 known, 0 rare\n"
            "  skipped because they cannot be read: 1 run");
}

}  // namespace
}  // namespace cyl
