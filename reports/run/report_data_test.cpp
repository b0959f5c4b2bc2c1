// SPDX-License-Identifier: MIT
#include "reports/run/report_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <vector>

#include "base/error_of_test.hpp"
#include "base/files.hpp"
#include "base/json.hpp"
#include "base/scratch_test.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/representatives.hpp"
#include "corpus/store/run_store.hpp"
#include "reports/run/page_template.hpp"
#include "reports/triage/triage_store.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

const std::string hostile = "</script></code></style><img src=x onerror=alert(1)>\"'&\x01<!--@@STYLE@@$&";

class ReportData : public testing::Test {
 protected:
  json data() const { return parse_ordered_json(report_json(read_run(folder))); }
  void put(const char* name, const std::string& text) const { std::ofstream(folder / name) << text; }
  const Scratch alone;  // without earlier runs
  const fs::path folder = alone.folder / "run";
};

FindingRecord finding(std::uint64_t index, const std::string& method, double margin) {
  FindingRecord f;
  f.index = f.family_index = index;
  f.family = "cases";
  f.method = method;
  f.kind = FindingKind::wrong_disjoint;
  f.severity = Severity::contract;
  f.margin = Enclosure{margin, margin};
  Pair pair;
  pair.a.radius = static_cast<double>(index) + 0.1;
  pair.b.center = {-0.0, 5e-324, 1.7976931348623157e308};
  f.pair = format_pair(pair);
  f.answers =
      R"([[{"verdict":"disjoint","direction":[1,0,0.1]},["fake"]],[{"verdict":"disjoint","direction":[1,0,0.2]},)"
      R"(["other"]],[{"verdict":"disjoint","direction":[1,0,0.3]},["third"]]])";
  f.truth = R"({"verdict":"undecided","stage":"wide"})";
  return f;
}

void commit(RunStore& store, const std::vector<FindingRecord>& findings) {
  BatchRecord batch;
  batch.first = store.progress().next;
  batch.next = batch.first + findings.size();
  Representatives kept;
  for (const FindingRecord& f : findings) {
    if (kept.admit(f)) batch.findings.push_back(f);
    batch.tallies.push_back({f.method, f.family, Counts{1, 0, 0, 1, 0, 0, 100}});
  }
  batch.groups = kept.groups();
  store.commit(batch, 1500);
}

TEST_F(ReportData, HasTheRunItsMethodsAndEveryNumber) {
  RunStore store = RunStore::create(
      folder, {{"seed", "42"}, {"started", "today"}, {"build", "b"}, {"status", "complete"}},
      {{"fake", "9.8", 1e-6, 0.001, "its manual", 3, "fake"}, {"intersect", "1", 0, 0, "d", 1}});
  BatchRecord batch;
  batch.next = 7;
  batch.tallies = {{"fake", "random", {1002, 11, 12, 13, 14, 15, 1002 * 16}},
                   {"referee", "random", {7, 0, 0, 0, 0, 2, 70}}};
  store.commit(batch, 1500);
  const json report = data();
  EXPECT_EQ(report["run"]["seed"], "42");
  EXPECT_EQ(report["run"]["pairs"], 7);
  EXPECT_EQ(report["run"]["seconds"], 1.5);
  EXPECT_EQ(report["run"]["id"], folder.filename().string());
  EXPECT_EQ(report["run"]["folder"], folder.string());
  EXPECT_EQ(report["methods"][0],
            parse_ordered_json(R"({"name":"fake","library":"fake","version":"9.8","claim":{"relative":1e-6,
    "absolute":0.001,"source":"its manual","stated":true},"own":false})"));
  EXPECT_EQ(report["methods"][1]["own"], true);
  EXPECT_EQ(report["families"][0]["name"], "random");
  EXPECT_NE(report["families"][0]["summary"], "");
  EXPECT_EQ(report["tallies"][0],
            parse_ordered_json(R"({"method":"fake","family":"random","asked":1002,"declined":11,
    "failed":12,"contract":13,"resolution":14,"undecided":15})"));
  for (const char* empty : {"causes", "findings", "maps", "speed", "paths"})
    EXPECT_EQ(report[empty], json::array()) << empty;
}

TEST_F(ReportData, AGuestIsALibraryOfItsOwn) {
  std::vector<MethodRecord> asked;
  for (const auto& [name, library] : {std::pair("decide", "decide"), std::pair("mujoco-tol1e-10", "mujoco"),
                                      std::pair("mujoco-js", "mujoco-js"), std::pair("mine-2", "mine")})
    asked.push_back({name, "1", 0, 0, "", 1, library});
  RunStore::create(folder / "guests", {{"seed", "1"}}, asked);
  std::vector<std::string> libraries;
  const auto report = parse_ordered_json(report_json(read_run(folder / "guests")));
  for (const auto& m : report["methods"]) libraries.push_back(m["library"]);
  EXPECT_EQ(libraries, (std::vector<std::string>{"ours", "mujoco", "mujoco-js", "mine"}));
}

TEST_F(ReportData, ShowsAPairOfManyFindingsOnceAndToTheLastBit) {
  RunStore store = RunStore::create(folder, {{"seed", "1"}});
  std::vector<FindingRecord> findings{finding(0, "fake", 0.25), finding(0, "other", 0.25),
                                      finding(1, "fake", 0.1)};
  findings[1].reason = "SIGABRT";
  findings[1].margin.reset();
  commit(store, findings);
  const json report = data();
  ASSERT_EQ(report["findings"].size(), 3u);
  ASSERT_EQ(report["cases"].size(), 2u);
  EXPECT_EQ(report["findings_total"], 3);
  EXPECT_EQ(report["findings"][0], parse_ordered_json(R"({"id":1,"method":"fake","kind":"wrong_disjoint",
    "severity":"contract","family":"cases","cause":null,"margin":[0.25,0.25],"case":0})"));
  EXPECT_EQ(report["findings"][1]["case"], 1) << "the largest margin first";
  EXPECT_EQ(report["findings"][2]["case"], 0);
  EXPECT_EQ(report["findings"][2]["reason"], "SIGABRT");
  const json& reported = report["cases"][0];
  EXPECT_EQ(reported["margin"], json({0.25, 0.25}));
  EXPECT_EQ(reported["pair"]["a"]["radius"].get<double>(), 0.1);
  EXPECT_TRUE(std::signbit(reported["pair"]["b"]["center"][0].get<double>()));
  EXPECT_EQ(reported["pair"]["b"]["center"][1].get<double>(), 5e-324);
  EXPECT_EQ(reported["pair"]["b"]["center"][2].get<double>(), 1.7976931348623157e308);
  // The witness of "third" is left out, because it has no finding here. The other answers stay as they are.
  ASSERT_EQ(reported["said"].size(), 3u);
  EXPECT_EQ(reported["said"][0][0]["direction"][2], 0.1);
  EXPECT_EQ(reported["said"][2], parse_ordered_json(R"([{"verdict":"disjoint"},["third"]])"));
}

TEST_F(ReportData, EachFindingHasItsOwnMargin) {
  RunStore store = RunStore::create(folder, {});
  std::vector<FindingRecord> findings{finding(0, "far_off", 0.25), finding(0, "fake", 1e-7),
                                      finding(0, "other", 1e-7)};
  findings[0].kind = FindingKind::distance_outside;
  findings[2].margin.reset();
  commit(store, findings);
  const json report = data();
  ASSERT_EQ(report["cases"].size(), 1u);
  EXPECT_EQ(report["findings"][0]["margin"], json({1e-7, 1e-7}));
  EXPECT_EQ(report["findings"][1]["margin"], nullptr);
  EXPECT_EQ(report["findings"][2]["margin"], json({0.25, 0.25})) << "the error of a distance";
  EXPECT_EQ(report["cases"][0]["margin"], json({1e-7, 1e-7})) << "the pair's is no error";
}

TEST_F(ReportData, EnclosesTheDistanceAndShowsWhere) {
  RunStore store = RunStore::create(folder, {});
  FindingRecord f = finding(0, "fake", 0.5);
  f.pair = format_pair({{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2.5, 0, 0}, {0, 1, 0}, 1, 2}});
  f.truth = R"({"verdict":"disjoint","direction":[1,0,0]})";
  f.margin.reset();
  commit(store, {f});
  const json reported = data()["cases"][0];
  EXPECT_LE(reported["truth"]["distance"][0].get<double>(), 0.5);
  EXPECT_GE(reported["truth"]["distance"][1].get<double>(), 0.5);
  EXPECT_NEAR(reported["margin"][0].get<double>(), 0.5 / 6, 1e-10);
  EXPECT_NEAR(reported["direction"][0].get<double>(), 1, 1e-6);
  EXPECT_NEAR(reported["nearest"]["a"][0].get<double>(), 1, 1e-9);
  EXPECT_NEAR(reported["nearest"]["b"][0].get<double>(), 1.5, 1e-9);
}

/// Two crossed cylinders that overlap by 2.55e308.
TEST_F(ReportData, KeepsAnEndBeyondTheDoubles) {
  RunStore store = RunStore::create(folder, {});
  FindingRecord f = finding(0, "fake", 0.5);
  f.pair = format_pair({{{0, 0, 0}, {0, 0, 1}, 1.7e308, 1.7e308}, {{0, 0, 0}, {1, 0, 0}, 1.7e308, 1.7e308}});
  f.truth = R"({"verdict":"intersecting","point":[0,0,0]})";
  f.margin = Enclosure{0.5, std::numeric_limits<double>::infinity()};
  commit(store, {f});
  const json report = data();
  EXPECT_EQ(report["cases"][0]["truth"]["distance"][0], "-inf");
  EXPECT_LE(report["cases"][0]["truth"]["distance"][1].get<double>(), -1.79e308);
  EXPECT_EQ(report["findings"][0]["margin"], json({0.5, "inf"}));
}

TEST_F(ReportData, TakesWhatStandsBesideTheStore) {
  RunStore store = RunStore::create(folder, {});
  commit(store, {finding(0, "fake", 0.5), finding(1, "fake", 0.5)});
  TriageStore(folder, "a build").set_summary(R"([{"key":"fake/wrong","findings":[2]}])", 1);
  put("charts.json", R"({"speed":[{"method":"fake"}],"other":1})");
  const json report = data();
  EXPECT_EQ(report["findings"][0]["cause"], nullptr);
  EXPECT_EQ(report["findings"][1]["cause"], "fake/wrong");
  EXPECT_EQ(report["causes"].size(), 1u);
  EXPECT_EQ(report["speed"][0]["method"], "fake");
  EXPECT_FALSE(report.contains("other"));

  const auto refused = [&](const char* name, const char* text) {
    put(name, text);
    return error_of([&] { report_json(read_run(folder)); }).find(name) != std::string::npos;
  };
  EXPECT_TRUE(refused("charts.json", "{"));
  EXPECT_TRUE(refused("charts.json", R"({"speed":1})"));
}

TEST_F(ReportData, KeepsHostileTextAsText) {
  RunStore store = RunStore::create(folder, {{"seed", hostile}, {"started", hostile}, {"build", hostile}},
                                    {{hostile, hostile, 1, 1, hostile, 1}});
  FindingRecord f = finding(0, hostile, 0.5);
  Case c;
  c.id = c.source = c.note = hostile;
  f.pair = format_case(c);
  f.reason = hostile;
  f.answers = R"([[{"failed":)" + quote_json(hostile) + "},[" + quote_json(hostile) + "]]]";
  f.truth = R"({"verdict":)" + quote_json(hostile) + R"(,"point":["1/3",)" + quote_json(hostile) + ",0]}";
  FindingRecord broken = f;
  broken.index = 2;
  broken.pair = broken.answers = broken.truth = hostile;
  FindingRecord half = finding(1, "half", 0.5);
  half.answers = half.truth = "[1]";
  commit(store, {f, broken, half});
  write_page(read_run(folder));
  const std::string page = read_file(folder / "report.html");
  EXPECT_EQ(page.find("<img"), page.npos);
  EXPECT_EQ(page.find('\x01', page.find("report-data")), page.npos);

  const json report = data();
  EXPECT_EQ(report["unreadable"], 1);
  const json& findings = report["findings"];
  std::string safe = hostile;
  safe.replace(safe.find('\x1'), 1, "\\u0001");  // the store reads no control characters
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0]["method"], safe);
  EXPECT_EQ(findings[0]["reason"], safe);
  EXPECT_EQ(report["methods"][0]["claim"]["source"], safe);
  EXPECT_EQ(report["run"]["seed"], safe);
  EXPECT_EQ(report["cases"][0]["note"], hostile + "; " + hostile + "; " + hostile);
  EXPECT_EQ(report["cases"][1]["truth"]["verdict"], "undecided");
  EXPECT_EQ(report["cases"][1]["said"], json::array());
}

TEST_F(ReportData, NeedsNoNetworkAndStaysOneFile) {
  RunStore store = RunStore::create(folder, {});
  commit(store, {finding(0, "fake", 1)});
  write_page(read_run(folder));
  write_page(read_run(folder));
  const std::string page = fill_template("{}");
  for (const char* word : {"src=\"", "@import", "<link", "url(http"})
    EXPECT_EQ(page.find(word), page.npos) << word;
  EXPECT_NE(page.find("default-src 'none'"), page.npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}),
            static_cast<std::ptrdiff_t>(2 + fs::exists(folder / "run.sqlite-wal") +
                                        fs::exists(folder / "run.sqlite-shm")));
}

}  // namespace
}  // namespace cyl
