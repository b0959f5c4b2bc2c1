// SPDX-License-Identifier: MIT
#include "corpus/store/run_store.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "base/error_of_test.hpp"
#include "base/scratch_test.hpp"
#include "base/usage_error.hpp"
#include "corpus/store/representatives.hpp"
#include "corpus/store/run_facts.hpp"
#include "corpus/store/sqlite_file.hpp"
#include "corpus/store/stored_answers.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

class Store : public testing::Test, protected Scratch {};

FindingRecord finding_at(std::uint64_t index, double margin) {
  FindingRecord f;
  static_cast<FindingGroup&>(f) = {"fake", FindingKind::wrong_disjoint, Severity::contract, "scene"};
  f.index = f.family_index = index;
  f.margin = Enclosure{margin, margin * 2};
  f.pair = R"({"a":{},"b":{}})";
  f.answers = "[]";
  f.truth = "{}";
  return f;
}

/// Scatters small numbers over 24 bits (Knuth's multiplicative hash), for cuts and margins without a
/// pattern.
std::uint64_t scatter(std::uint64_t i) { return (i + 1) * 2654435761u % 4294967296u >> 8; }

/// A margin of one of 60 binades.
double scattered_margin(std::uint64_t i) { return std::ldexp(1.0, -static_cast<int>(scatter(i) % 60)); }

/// Returns the findings i in [first, next) as a batch would send them. `margin(i)` is the margin of each.
template <class Margin>
BatchRecord batch_of(std::uint64_t first, std::uint64_t next, Margin margin) {
  BatchRecord batch;
  batch.first = first;
  batch.next = next;
  Representatives kept;
  for (std::uint64_t i = first; i < next; ++i) {
    const FindingRecord f = finding_at(i, margin(i));
    if (kept.admit(f)) batch.findings.push_back(f);
  }
  batch.groups = kept.groups();
  batch.tallies = {{"fake", "scene", Counts{next - first, 0, 0, next - first, 0, 0, 10}}};
  return batch;
}

std::vector<std::uint64_t> indices(const RunStore& store) {
  std::vector<std::uint64_t> all;
  for (const FindingRecord& f : store.findings()) all.push_back(f.index);
  return all;
}

TEST_F(Store, GivesBackWhatWasCommitted) {
  {
    RunStore store = RunStore::create(folder, {{"seed", "18446744073709551615"}});
    BatchRecord batch;
    batch.next = 7;
    FindingRecord f = finding_at(3, 0.25);
    f.pair = "{\"a\":{\"radius\":-0}} '); DROP TABLE finding; --";
    f.reason = "</script>";
    f.margin = Enclosure{5e-324, std::numeric_limits<double>::infinity()};
    batch.findings = {f, finding_at(5, 0.5)};
    batch.findings[1].margin.reset();
    batch.groups = {{{"fake", FindingKind::wrong_disjoint, Severity::contract, "scene"}, 2, -1}};
    batch.tallies = {{"fake", "scene", Counts{1, 2, 3, 4, 5, 6, 7}}};
    store.commit(batch, 12);
  }
  const RunStore store = RunStore::open(folder);
  EXPECT_EQ(store.config().at("seed"), "18446744073709551615");
  EXPECT_EQ(store.progress().next, 7u);
  EXPECT_EQ(store.progress().milliseconds, 12u);
  const auto findings = store.findings();
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].id, 1);
  EXPECT_EQ(findings[0].pair, "{\"a\":{\"radius\":-0}} '); DROP TABLE finding; --");
  EXPECT_EQ(findings[0].reason, "</script>");
  EXPECT_EQ(findings[0].margin->lo, 5e-324);
  EXPECT_EQ(findings[0].margin->hi, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(findings[1].margin);
  EXPECT_EQ(store.finding(2)->index, 5u);
  EXPECT_FALSE(store.finding(3));
  ASSERT_EQ(store.tallies().size(), 1u);
  EXPECT_EQ(store.tallies()[0].counts.nanoseconds, 7u);
  ASSERT_EQ(store.groups().size(), 1u);
  EXPECT_EQ(store.groups()[0].count, 2u);
}

TEST_F(Store, AWordThatNoVersionWroteIsRefusedWithTheFile) {
  RunStore store = RunStore::create(folder, {});
  BatchRecord batch;
  batch.next = 7;
  batch.groups = {{{"fake", FindingKind::wrong_disjoint, Severity::contract, "scene"}, 2, -1}};
  store.commit(batch, 0);
  SQLite::Database(folder / "run.sqlite", SQLite::OPEN_READWRITE)
      .exec("UPDATE finding_group SET kind = 'odd'");
  const std::string error = error_of([&] { store.groups(); });
  for (const char* part : {"run.sqlite", "'odd'"}) EXPECT_NE(error.find(part), std::string::npos) << error;
}

TEST_F(Store, StoresTheAnswersOfAPairOnce) {
  RunStore store = RunStore::create(folder, {});
  BatchRecord batch;
  batch.next = 7;
  batch.findings.assign(50, finding_at(3, 0.25));
  for (std::size_t i = 0; i < batch.findings.size(); ++i) {
    batch.findings[i].method = std::to_string(i);
    batch.findings[i].answers = std::string(100'000, 'x');
  }
  store.commit(batch, 0);
  ASSERT_EQ(store.findings().size(), 50u);
  EXPECT_EQ(store.findings().back().answers, batch.findings[0].answers);
  EXPECT_LT(fs::file_size(folder / "run.sqlite-wal"), 250'000u);
}

TEST_F(Store, AddsTheCellsOfBatches) {
  RunStore store = RunStore::create(folder, {});
  BatchRecord batch;
  batch.next = 1;
  batch.cells = {{"a", 3, 4, {{1}, {1, 1}}}, {"b", 3, 4, {{5}}}};
  store.commit(batch, 0);
  batch.first = 1;
  batch.next = 2;
  batch.cells = {{"a", 3, 4, {{2, 0, 1, 0, 0}, {}, {1, 0, 0, 0, 1}}}, {"a", 0, 9, {{1, 0, 0, 1, 0}}}};
  store.commit(batch, 0);
  const std::vector<CellRecord> wanted{{"a", 0, 9, {{1, 0, 0, 1, 0}}},
                                       {"a", 3, 4, {{3, 0, 1, 0, 0}, {1, 1}, {1, 0, 0, 0, 1}}},
                                       {"b", 3, 4, {{5}}}};
  EXPECT_EQ(RunStore::open(folder).cells(), wanted);
}

TEST_F(Store, OfAnotherVersionIsRefused) {
  RunStore::create(folder, {});
  for (const std::string version : {"1", "1000"}) {
    SQLite::Database((folder / "run.sqlite").string(), SQLite::OPEN_READWRITE)
        .exec("PRAGMA user_version=" + version);
    const std::string error = error_of([&] { RunStore::open(folder); });
    EXPECT_NE(error.find(" was written in store version " + version + ';'), std::string::npos) << error;
  }
}

/// Returns why a run is refused after a stranger ran this script in it.
std::string refused_after(const fs::path& folder, const std::string& script) {
  fs::remove_all(folder);
  RunStore::create(folder, {}).commit(batch_of(0, 50, [](auto) { return 1.0; }), 0);
  SQLite::Database(folder / "run.sqlite", SQLite::OPEN_READWRITE).exec(script);
  return error_of<InputError>([&] { RunStore::open(folder).findings(); });
}

TEST_F(Store, OnlyTheTablesThatThisBuildWritesAreRead) {
  const fs::path run = folder / "run";
  for (const auto& [script, what] : std::initializer_list<std::pair<const char*, const char*>>{
           {"CREATE TRIGGER evil AFTER UPDATE ON progress BEGIN DELETE FROM wrong_answer; END",
            "trigger 'evil'"},
           {"DROP TABLE cell; CREATE VIEW cell AS WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x FROM "
            "r) "
            "SELECT x AS plane, x AS x, x AS y, x AS methods FROM r",
            "view 'cell'"},
           {"DROP VIEW finding; CREATE VIEW finding AS SELECT 1", "view 'finding'"},
           {"DROP TABLE cell", "table 'cell' is missing"},
           {"CREATE TABLE more(x)", "table 'more'"},
           {"CREATE INDEX evil ON wrong_answer(hex(reason))", "index 'evil'"},
           {"ALTER TABLE progress ADD COLUMN x", "table 'progress'"}})
    EXPECT_NE(refused_after(run, script).find(what), std::string::npos) << refused_after(run, script);
  EXPECT_EQ(refused_after(run, "UPDATE progress SET next = 5"), "nothing thrown");
}

TEST_F(Store, FindingsThatARunDoesNotCountAreRefused) {
  const std::string copies =
      "WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM r WHERE x < 3000) INSERT INTO "
      "wrong_answer SELECT 1000 + x, pair_index, family, family_index, method, kind, severity, margin_lo, "
      "margin_hi, "
      "reason FROM r, wrong_answer WHERE id = 1";
  const std::string of = "findings of fake (wrong_disjoint, beyond its claim, scene)";
  for (const auto& [script, what] : std::initializer_list<std::pair<std::string, std::string>>{
           {"UPDATE judged_pair SET pair_index = pair_index + 1000",
            "it counts 50 " + of + ", has rows of 10, and pairs of 0"},
           {"DELETE FROM wrong_answer WHERE id = 1",
            "it counts 50 " + of + ", has rows of 9, and pairs of 9"},
           {"DELETE FROM finding_group", "it counts 0 " + of + ", has rows of 10"},
           {copies, "it counts 50 " + of + ", has rows of 3010"},
           {"UPDATE finding_group SET count = 1000000; " + copies, "it counts 1000000 " + of},
           {"UPDATE judged_pair SET truth = '" + std::string(101, '[') + "'", "nested more than 100 deep"},
           {"UPDATE wrong_answer SET kind = 'odd'", "'odd' is not a word"}})
    EXPECT_NE(refused_after(folder / "run", script).find(what), std::string::npos)
        << refused_after(folder / "run", script);
}

TEST_F(Store, NoQueryIsLongerThanTheFileExplains) {
  SqliteFile file(folder / "any.sqlite", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  const std::string endless = "WITH RECURSIVE r(x) AS (SELECT 1 UNION ALL SELECT x FROM r) ";
  for (const char* rest : {"SELECT count(*) FROM r", "SELECT 'a text of some bytes' FROM r"}) {
    const std::string error = error_of<InputError>([&] { file.rows<std::string>(endless + rest); });
    EXPECT_TRUE(error.ends_with("any.sqlite: it holds more than its size explains: it is damaged or forged"))
        << error;
  }
  EXPECT_THROW(file.rows<std::string>("SELECT hex(zeroblob(40000000))"), std::runtime_error);
  EXPECT_THROW(file.script("ATTACH ':memory:' AS other"), std::runtime_error);
  file.script("CREATE TABLE t(x); CREATE VIEW v AS SELECT 1");
  EXPECT_THROW(file.rows<int>("SELECT * FROM v"), std::runtime_error);
}

TEST_F(Store, TextSteersNoTerminalAndLegalTextStays) {
  const std::string legal = "cache-\u0041 caf\u00e9 \u65e5\u672c <b>&'\"`$(x)`\\n";
  const std::string config = "line\n\ta tab\n" + legal;
  RunStore store = RunStore::create(folder, {{"plain", config}, {"evil", "\x1b[2J\n\a\u202e"}});
  BatchRecord batch;
  batch.next = 7;
  batch.findings = {finding_at(3, 0.25), finding_at(4, 0.25)};
  batch.findings[0].method = batch.findings[0].reason = legal;
  batch.findings[1].method = "\x1b[2J\aevil\nline\u202e";
  batch.findings[1].answers = "[[{},[\"\u202e\"]]]";
  store.commit(batch, 0);
  EXPECT_EQ(store.config(), (Config{{"plain", config}, {"evil", "\\u001b[2J\n\\u0007\\u202e"}}));
  const std::vector<FindingRecord> found = store.findings();
  EXPECT_EQ(found[0].method, legal);
  EXPECT_EQ(found[0].reason, legal);
  EXPECT_EQ(found[1].method, "\\u001b[2J\\u0007evil\\nline\\u202e");
  EXPECT_EQ(nlohmann::json::parse(found[1].answers), nlohmann::json::parse(batch.findings[1].answers));
  std::vector<std::string> names;
  for_each_answer(nlohmann::json::parse(found[1].answers),
                  [&](const auto&, const auto& methods) { names = methods; });
  EXPECT_EQ(names, std::vector<std::string>{"\\u202e"}) << "JSON has its own escapes";
}

TEST(RunFacts, ABadNumberIsNamed) {
  EXPECT_EQ(number_of({{"seed", "18446744073709551615"}}, "seed"), std::numeric_limits<std::uint64_t>::max());
  for (const std::string bad : {"", "x", "-1", "1.5", "7 ", "18446744073709551616"})
    EXPECT_EQ(error_of<InputError>([&] {
                number_of({{"seed", bad}}, "seed");
              }),
              "the seed of the run is '" + bad + "', no whole number");
  EXPECT_THROW(number_of({}, "seed"), InputError);
  EXPECT_THROW(shard_of({{"shard", "3/2 of batches of 1"}}), InputError);
}

TEST_F(Store, RefusesAFolderThatHoldsARunAndOneThatHoldsNone) {
  EXPECT_THROW(RunStore::open(folder), std::invalid_argument);
  RunStore::create(folder, {});
  EXPECT_THROW(RunStore::create(folder, {}), UsageError);
}

TEST_F(Store, NamesTheFileThatCannotBeRead) {
  fs::create_directories(folder);
  std::ofstream(folder / "run.sqlite")
      << "not a database, and longer than the header of one would be: " << folder;
  const std::string error = error_of([&] { RunStore::open(folder); });
  EXPECT_NE(error.find((folder / "run.sqlite").string()), std::string::npos) << error;
}

TEST_F(Store, RunsInAFolderAreFoundByTheirStores) {
  EXPECT_TRUE(runs_in(folder).empty());
  RunStore::create(folder / "b", {});
  RunStore::create(folder / "a", {{"status", "running"}}).set("status", "complete");
  fs::create_directories(folder / "empty");
  fs::create_directory_symlink("b", folder / "latest");
  EXPECT_EQ(runs_in(folder), (std::vector<std::string>{folder / "a", folder / "b"}));
  EXPECT_EQ(RunStore::open(folder / "a").config(), (Config{{"status", "complete"}}));
}

TEST_F(Store, RefusesABatchOutOfOrder) {
  RunStore store = RunStore::create(folder, {});
  store.commit(batch_of(0, 10, [](auto) { return 1.0; }), 0);
  EXPECT_THROW(store.commit(batch_of(20, 30, [](auto) { return 1.0; }), 0), std::runtime_error);
  EXPECT_THROW(store.commit(batch_of(0, 10, [](auto) { return 1.0; }), 0), std::runtime_error);
  EXPECT_EQ(store.progress().next, 10u);
  EXPECT_EQ(store.tallies()[0].counts.asked, 10u);
}

TEST_F(Store, KeepsTheFirstAndEveryNewBinadeAndCountsAll) {
  RunStore store = RunStore::create(folder, {});
  // All margins are 1e-9, except for one of 1e-3 and, later, a smaller one of 1e-6.
  const auto margin = [](std::uint64_t i) { return i == 70 ? 1e-3 : i == 80 ? 1e-6 : 1e-9; };
  store.commit(batch_of(0, 50, margin), 0);
  store.commit(batch_of(50, 100, margin), 0);
  std::vector<std::uint64_t> expected(representatives_cap);
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = i;
  expected.push_back(70);
  EXPECT_EQ(indices(store), expected);
  EXPECT_EQ(store.groups()[0].count, 100u);
  EXPECT_EQ(store.tallies()[0].counts.contract, 100u);
}

TEST_F(Store, WhatIsKeptDoesNotDependOnWhereBatchesAreCut) {
  RunStore whole = RunStore::create(folder / "whole", {});
  whole.commit(batch_of(0, 2000, scattered_margin), 0);
  RunStore cut = RunStore::create(folder / "cut", {});
  for (std::uint64_t first = 0; first < 2000;) {
    const std::uint64_t next = std::min<std::uint64_t>(2000, first + 1 + scatter(first) % 200);
    cut.commit(batch_of(first, next, scattered_margin), 0);
    first = next;
  }
  EXPECT_EQ(indices(cut), indices(whole));
  EXPECT_EQ(cut.groups()[0].count, whole.groups()[0].count);
  EXPECT_EQ(cut.groups()[0].binade, whole.groups()[0].binade);
}

TEST_F(Store, AKilledWriterLeavesAConsistentPrefix) {
  RunStore::create(folder, {});
  std::uint64_t before = 0;
  for (std::uint64_t round = 0; round < 5; ++round) {
    int stored[2];
    ASSERT_EQ(pipe(stored), 0);
    const pid_t child = fork();
    if (child == 0) {
      RunStore store = RunStore::open(folder);
      for (std::uint64_t first = store.progress().next;; first += 10) {
        store.commit(batch_of(first, first + 10, [](auto i) { return 1.0 / double(i + 1); }), 1);
        if (::write(stored[1], "", 1) != 1) _exit(1);
      }
    }
    close(stored[1]);
    char byte;
    ASSERT_EQ(read(stored[0], &byte, 1), 1);
    usleep(static_cast<useconds_t>(scatter(round) % 20000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(stored[0]);
    const RunStore store = RunStore::open(folder);
    const std::uint64_t next = store.progress().next;
    ASSERT_EQ(next % 10, 0u);
    ASSERT_GT(next, before);
    before = next;
    EXPECT_EQ(store.tallies()[0].counts.asked, next);
    EXPECT_EQ(store.groups()[0].count, next);
    EXPECT_EQ(store.findings().size(), std::min<std::uint64_t>(next, representatives_cap));
  }
}

}  // namespace
}  // namespace cyl
