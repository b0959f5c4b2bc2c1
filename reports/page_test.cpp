// SPDX-License-Identifier: MIT
#include "reports/page.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <vector>

#include "corpus/pair_io.hpp"
#include "corpus/store.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

const std::string hostile = "</script></code></style><img src=x onerror=alert(1)>\"'&\x01<!--";

class Page : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("daylight_page_" + std::to_string(getpid()) + "_" +
                                          testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string written() const {
    write_page(folder);
    std::ifstream in(folder / "report.html");
    return {std::istreambuf_iterator<char>(in), {}};
  }
  fs::path folder;
};

FindingRecord finding(std::uint64_t index, const std::string& method, double margin) {
  FindingRecord f;
  f.index = index;
  f.family = "cases";
  f.family_index = index;
  f.method = method;
  f.kind = "wrong_disjoint";
  f.severity = "contract";
  f.margin = MarginRecord{margin, margin};
  Case c;
  c.pair.a.radius = static_cast<double>(index) + 0.125;
  f.pair = format_case(c);
  f.answers = R"({"fake":{"verdict":"disjoint","distance":0.5}})";
  f.truth = R"({"verdict":"intersecting","point":[0,0,[1,1e-30]],"stage":"wide"})";
  f.stage = "wide";
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
  store.commit(batch, 1000);
}

bool contains(const std::string& page, const std::string& text) {
  return page.find(text) != std::string::npos;
}

std::size_t occurrences(const std::string& page, const std::string& text) {
  std::size_t n = 0;
  for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++n;
  return n;
}

/// The first thing wrong with the nesting of tags, or nothing. Every '<' must begin a tag this page may have.
std::string nesting_error(const std::string& page) {
  const std::set<std::string> known{"html", "head", "meta", "title", "style",   "body",    "h1",      "h2",
                                    "h3",   "p",    "ul",   "li",    "b",       "span",    "div",     "table",
                                    "tr",   "th",   "td",   "br",    "details", "summary", "article", "code"};
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return "a tag without end";
    const std::string tag = page.substr(at + 1, end - at - 1);
    if (tag == "!DOCTYPE html") continue;
    const bool closing = tag.starts_with('/');
    const std::string name = tag.substr(closing, tag.find_first_of(" /", closing) - closing);
    if (!known.contains(name)) return "a tag <" + tag + ">";
    if (name == "br" || name == "meta") continue;
    if (!closing) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back() + " stays open";
}

TEST_F(Page, HoldsEveryFindingWithAllThatIsNeeded) {
  RunStore store =
      RunStore::create(folder, {{"seed", "42"}}, {{"fake", "9.8", 1e-6, 0.001, "its manual", 1}});
  std::vector<FindingRecord> findings{finding(0, "fake", 1e-3), finding(1, "fake", 0.25),
                                      finding(2, "other", 1e-9)};
  findings[2].kind = "crash";
  findings[2].margin.reset();
  findings[2].reason = "SIGABRT";
  commit(store, findings);
  const std::string page = written();
  EXPECT_EQ(nesting_error(page), "");
  for (const FindingRecord& f : store.findings()) {
    EXPECT_TRUE(contains(page, "id=\"f" + std::to_string(f.id) + "\""));
    EXPECT_TRUE(contains(page, escape_html(format_pair(parse_case(f.pair, 1).value->pair))));
    EXPECT_TRUE(contains(page, "replay " + folder.string() + ":" + std::to_string(f.id)));
  }
  EXPECT_TRUE(contains(page, "The point (0, 0, 1 + 1e-30) lies in both."));
  EXPECT_TRUE(contains(page, "Off by 0.25 to 0.25"));
  EXPECT_TRUE(contains(page, "SIGABRT"));
  EXPECT_TRUE(contains(page, "seed 42"));
  EXPECT_TRUE(contains(page, "at least 1e-06 of the size plus a length of 0.001"));
  EXPECT_TRUE(contains(page, "disjoint, distance 0.5"));
  EXPECT_LT(page.find("id=\"f2\""), page.find("id=\"f1\"")) << "the worst first";
  EXPECT_TRUE(
      contains(page, "<b>fake</b> <b class=\"bad\">2 times</b> in 2 answers (100 %): 2 wrong_disjoint"));
}

TEST_F(Page, HasEveryNumberOfEveryMethodAndFamily) {
  RunStore store = RunStore::create(folder, {});
  BatchRecord batch;
  batch.next = 1;
  batch.tallies = {{"fake", "flat", {1002, 11, 12, 13, 14, 15, 1002 * 16}},
                   {"fake", "tall", {2003, 21, 0, 23, 24, 25, 2003 * 26}},
                   {"referee-wide", "tall", {7, 0, 0, 0, 0, 0, 7 * 1234}}};
  store.commit(batch, 1);
  const std::string page = written();
  EXPECT_EQ(nesting_error(page), "");
  const std::size_t table = page.find("<details><summary>fake</summary>");
  ASSERT_NE(table, std::string::npos);
  const auto row = [&](const std::string& family, std::vector<std::string> numbers) {
    std::string text = "<tr><td>" + family + "</td>";
    for (const std::string& n : numbers) text += "<td>" + n + "</td>";
    return page.find(text + "</tr>", table);
  };
  const std::size_t all = row("<b>all</b>", {"3,005", "32", "12", "36", "38", "40", "22"});
  const std::size_t flat = row("flat", {"1,002", "11", "12", "13", "14", "15", "16"});
  const std::size_t tall = row("tall", {"2,003", "21", "", "23", "24", "25", "26"});
  const std::size_t stage = page.find("<details><summary>referee-wide</summary>");
  EXPECT_LT(all, flat);
  EXPECT_LT(flat, tall);
  EXPECT_LT(tall, stage);
  EXPECT_LT(stage, row("tall", {"7", "", "", "", "", "", "1,234"}));
  EXPECT_NE(row("tall", {"7", "", "", "", "", "", "1,234"}), std::string::npos);
}

TEST_F(Page, TellsMethodsFromTheOtherRows) {
  RunStore store = RunStore::create(folder, {});
  BatchRecord batch;
  batch.next = 1;
  for (const char* row : {"corpus", "referee", "referee-filter", "referee-wide", "referee-exact", "fine"})
    batch.tallies.push_back({row, "flat", {1, 0, 0, 0, 0, 0, 1}});
  for (const char* method : {"referee2", "referee-mine"})
    batch.tallies.push_back({method, "flat", {1, 0, 0, 1, 0, 0, 1}});
  store.commit(batch, 1);
  const std::string page = written();
  EXPECT_TRUE(contains(page, "<p>1 more was not.</p>"));
  EXPECT_TRUE(contains(page, "<li><b>referee2</b>"));
  EXPECT_TRUE(contains(page, "<th>referee-mine</th>"));
  EXPECT_FALSE(contains(page, "<th>referee</th>"));
  EXPECT_LT(page.find("<details><summary>referee2<"), page.find("<details><summary>corpus<"));
  EXPECT_LT(page.find("<details><summary>fine<"), page.find("<details><summary>corpus<"));
}

TEST_F(Page, IsSafeAgainstHostileText) {
  RunStore store = RunStore::create(folder, {{"seed", hostile}, {"started", hostile}, {"build", hostile}},
                                    {{hostile, hostile, 1, 1, hostile, 1}});
  FindingRecord f = finding(0, hostile, 0.5);
  Case c;
  c.id = hostile;
  c.source = hostile;
  c.note = hostile + std::string(5000, 'x');
  f.pair = format_case(c);
  f.kind = f.reason = f.stage = hostile;
  f.answers = "{" + quote_json(hostile) + R"(:{"failed":)" + quote_json(hostile) + R"(,"reason":)" +
              quote_json(hostile) + "}}";
  f.truth = R"({"verdict":)" + quote_json(hostile) + R"(,"point":["1/3",)" + quote_json(hostile) + ",0]}";
  FindingRecord broken = f;
  broken.family = hostile;
  broken.pair = broken.answers = broken.truth = hostile;
  commit(store, {f, broken});
  const std::string page = written();
  EXPECT_EQ(nesting_error(page), "");
  EXPECT_FALSE(contains(page, "<img"));
  EXPECT_FALSE(contains(page, "<script"));
  EXPECT_FALSE(contains(page, "\x01"));
  EXPECT_TRUE(contains(page, "&lt;img src=x onerror=alert(1)&gt;"));
}

TEST_F(Page, QuotesTheFolderInTheCommandToReplay) {
  folder += " $(id)  it's";
  RunStore store = RunStore::create(folder, {});
  commit(store, {finding(0, "fake", 1)});
  const std::string path = folder.string(), until_quote = path.substr(0, path.find('\''));
  EXPECT_TRUE(
      contains(written(), "./daylight replay " + escape_html("'" + until_quote + "'\\''s:1'") + "</code>"));
}

TEST(EscapeHtml, ShowsWhatReordersText) {
  EXPECT_EQ(escape_html("a\u202eb\u2066c\u2069\u202ad"), "a\\u202eb\\u2066c\\u2069\\u202ad");
  EXPECT_EQ(escape_html("\u2026 \u20ac\xe2\x80"), "\u2026 \u20ac\xe2\x80");
}

TEST_F(Page, NeedsNoNetwork) {
  RunStore store = RunStore::create(folder, {});
  commit(store, {finding(0, "fake", 1)});
  const std::string page = written();
  for (const char* word : {"http://", "https://", "src=", "url(", "@import", "<link"})
    EXPECT_FALSE(contains(page, word)) << word;
}

TEST_F(Page, StaysBoundedHoweverMuchWasFound) {
  RunStore store = RunStore::create(folder, {});
  std::vector<FindingRecord> findings;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    findings.push_back(finding(i, "fake" + std::to_string(i % 100), 0.5));
    findings.back().family = "family" + std::to_string(i / 100 % 40);
  }
  commit(store, findings);
  const std::string page = written();
  EXPECT_EQ(nesting_error(page), "");
  EXPECT_EQ(occurrences(page, "<article"), shown_cap);
  EXPECT_LT(page.size(), 3u << 20);
}

TEST_F(Page, ShowsTheWorstOfAGroup) {
  RunStore store = RunStore::create(folder, {});
  std::vector<FindingRecord> findings;
  for (std::uint64_t i = 0; i < representatives_cap; ++i)
    findings.push_back(finding(i, "fake", 0.01 * double(i + 1)));
  commit(store, findings);
  const std::string page = written();
  EXPECT_EQ(occurrences(page, "<article"), shown_per_group_cap);
  EXPECT_TRUE(contains(page, "id=\"f" + std::to_string(representatives_cap) + "\""));
  EXPECT_FALSE(contains(page, "id=\"f1\""));
}

TEST_F(Page, SaysWhereNothingWasFound) {
  RunStore::create(folder, {{"seed", "1"}});
  const std::string page = written();
  EXPECT_EQ(nesting_error(page), "");
  EXPECT_TRUE(contains(page, "No method was wrong beyond its own claim"));
}

TEST_F(Page, IsReplacedAsAWhole) {
  RunStore store = RunStore::create(folder, {});
  written();
  commit(store, {finding(0, "fake", 1)});
  EXPECT_TRUE(contains(written(), "fake"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}),
            static_cast<std::ptrdiff_t>(2 + fs::exists(folder / "run.sqlite-wal") +
                                        fs::exists(folder / "run.sqlite-shm")));
}

}  // namespace
}  // namespace cyl
