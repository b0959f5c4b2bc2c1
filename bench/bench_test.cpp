// SPDX-License-Identifier: MIT
#include "bench/bench.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "bench/bench_summary.hpp"
#include "oracles/referee/referee.hpp"
#include "reports/run/bench_table.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

/// Answers by functions; an empty one stands for a way that it does not have.
struct Fake : Method {
  Claim claim_;
  bool foreign_ = true;
  unsigned share_ = 1;
  std::function<Verdict(const Pair&)> say = right;
  std::function<Verdict(const Pair&)> say_prepared;
  std::function<double(const Pair&)> say_distance;
  std::function<void(std::span<const Pair>, std::span<Verdict>)> say_all;

  static Verdict right(const Pair& pair) { return judge(pair).verdict; }

  explicit Fake(std::string name = "fake") : Method({std::move(name)}) {}
  std::string_view version() const override { return ""; }
  Claim claim() const override { return claim_; }
  bool foreign() const override { return foreign_; }
  unsigned share() const override { return share_; }
  MethodAnswer answer(const Pair& pair) override {
    MethodAnswer answer;
    answer.status = Status::answered;
    answer.verdict = say(pair);
    return answer;
  }
  Call prepare_all(std::span<const Pair> pairs) override {
    if (!say_prepared) return {};
    return [say = say_prepared, pairs = copy(pairs)](std::size_t i) { return say(pairs[i]); };
  }
  DistanceCall prepare_distances(std::span<const Pair> pairs) override {
    if (!say_distance) return {};
    return [say = say_distance, pairs = copy(pairs)](std::size_t i) { return say(pairs[i]); };
  }
  BatchCall prepare_batch(std::span<const Pair> pairs) override {
    if (!say_all) return {};
    return [say = say_all, pairs = copy(pairs)](std::span<Verdict> verdicts) { say(pairs, verdicts); };
  }

 private:
  static std::vector<Pair> copy(std::span<const Pair> pairs) { return {pairs.begin(), pairs.end()}; }
};

constexpr BenchOptions quick{.seed = 3, .pairs = 60, .min_time = 0, .passes = 3};

std::vector<BenchRow> run(std::unique_ptr<Method> method, const char* family = "random",
                          const BenchOptions& options = quick) {
  const std::unique_ptr<Method> methods[] = {std::move(method)};
  return bench(methods, {find_family(family), 1}, options, [](std::string_view) {});
}

std::vector<BenchRow> run(Fake fake, const char* family = "random") {
  return run(std::make_unique<Fake>(std::move(fake)), family);
}

Pair pair_at(std::size_t index, const char* family = "random") {
  return find_family(family)->generate(quick.seed, index);
}

bool is_pair(const Pair& pair, std::size_t index) { return pair.a.center == pair_at(index).a.center; }

std::size_t count_disjoint(const char* family = "random") {
  std::size_t n = 0;
  for (std::size_t i = 0; i < quick.pairs; ++i) n += judge(pair_at(i, family)).verdict == Verdict::disjoint;
  return n;
}

TEST(Bench, WhatIsRightHasNoFaults) {
  Fake fake;
  const auto rows = run(fake);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].method, "fake");
  EXPECT_EQ(rows[0].family, "random");
  EXPECT_EQ(rows[0].query, "verdict");
  EXPECT_EQ(rows[0].pairs, quick.pairs);
  EXPECT_TRUE(rows[0].foreign);
  EXPECT_TRUE(is_right(rows[0]));
  EXPECT_EQ(rows[0].wrong_disjoint + rows[0].wrong_intersecting + rows[0].undecided + rows[0].failed, 0u);
  EXPECT_TRUE(std::isfinite(rows[0].median_ns) && std::isfinite(rows[0].p99_ns));
  EXPECT_TRUE(std::isnan(rows[0].max_error));
}

TEST(Bench, CountsWhatIsWrong) {
  const std::size_t disjoint = count_disjoint();
  ASSERT_TRUE(disjoint > 0 && disjoint < quick.pairs);
  Fake fake;
  fake.say = [](const Pair&) { return Verdict::disjoint; };
  BenchRow row = run(fake)[0];
  EXPECT_EQ(row.wrong_disjoint, quick.pairs - disjoint);
  EXPECT_EQ(row.wrong_intersecting, 0u);
  EXPECT_EQ(row.wrong_below_claim, 0u);
  EXPECT_EQ(row.wrong_at_margin, row.wrong_disjoint);
  EXPECT_FALSE(is_right(row));

  fake.say = [](const Pair&) { return Verdict::intersecting; };
  fake.claim_.relative = 1;
  row = run(fake)[0];
  EXPECT_EQ(row.wrong_intersecting, disjoint);
  EXPECT_EQ(row.wrong_disjoint, 0u);
  EXPECT_EQ(row.wrong_below_claim, disjoint);

  fake.say = [](const Pair& pair) { return is_pair(pair, 7) ? Verdict::undecided : Fake::right(pair); };
  EXPECT_EQ(run(fake)[0].undecided, 1u);
  fake.say = [](const Pair& pair) { return is_pair(pair, 7) ? Verdict::invalid : Fake::right(pair); };
  EXPECT_EQ(run(fake)[0].undecided, 1u);
}

TEST(Bench, WrongAtAMarginIsReportedFromWrongBelowIt) {
  Fake fake;
  fake.say = [](const Pair&) { return Verdict::disjoint; };
  for (const auto& [family, at_margin] :
       {std::pair("margin_1e-12", true), std::pair("margin_1e-14", false)}) {
    const BenchRow row = run(fake, family)[0];
    EXPECT_EQ(row.wrong_disjoint, quick.pairs / 2) << family;
    EXPECT_EQ(row.wrong_at_margin, at_margin ? quick.pairs / 2 : 0) << family;
  }
}

TEST(Bench, ContainsWhatBreaks) {
  Fake fake;
  fake.say = [](const Pair& pair) {
    if (is_pair(pair, 4)) throw std::runtime_error("thrown");
    if (is_pair(pair, 5)) std::abort();
    if (is_pair(pair, 6))
      for (volatile bool forever = true; forever;) continue;
    return Fake::right(pair);
  };
  fake.say_prepared = fake.say;
  for (const BenchRow& row : run(fake)) {
    EXPECT_EQ(row.failed, 3u) << row.query;
    EXPECT_EQ(row.wrong_disjoint + row.wrong_intersecting + row.undecided, 0u) << row.query;
    EXPECT_TRUE(std::isfinite(row.median_ns) && std::isfinite(row.p99_ns)) << row.query;
  }
  Fake hopeless;
  hopeless.say = [](const Pair&) -> Verdict { throw std::runtime_error("thrown"); };
  const BenchRow row = run(hopeless)[0];
  EXPECT_EQ(row.failed, quick.pairs);
  EXPECT_TRUE(std::isnan(row.median_ns) && std::isnan(row.p99_ns) && std::isnan(row.spread_percent));
}

TEST(Bench, AsksEachWayThatThereIs) {
  Fake fake;
  fake.say_prepared = Fake::right;
  fake.say_distance = [](const Pair& pair) { return judge(pair).verdict == Verdict::disjoint ? 1 : -1; };
  fake.say_all = [](std::span<const Pair> pairs, std::span<Verdict> verdicts) {
    std::transform(pairs.begin(), pairs.end(), verdicts.begin(), Fake::right);
  };
  std::vector<std::string> queries;
  for (const BenchRow& row : run(fake)) queries.push_back(row.query);
  EXPECT_EQ(queries, (std::vector<std::string>{"verdict", "raw", "distance", "depth", "batch"}));

  const auto rows = run(std::move(select_methods(own_methods(), "decide")[0]));
  ASSERT_GE(rows.size(), 2u);
  EXPECT_EQ(rows[0].query, "certificate");
  EXPECT_EQ(rows[1].query, "raw");
}

TEST(Bench, AsksCostlyMethodsTheirShare) {
  Fake fake;
  fake.share_ = 16;
  EXPECT_EQ(run(fake)[0].pairs, quick.pairs / 16);
}

TEST(Bench, SplitsAFamilyByShapes) {
  BenchOptions options = quick;
  options.shapes = true;
  std::size_t pairs = 0;
  const auto rows = run(std::move(select_methods(own_methods(), "intersect")[0]), "box_edges", options);
  for (const BenchRow& row : rows) {
    EXPECT_TRUE(row.family.ends_with("box box_edges")) << row.family;
    EXPECT_EQ(row.query, "verdict");
    pairs += row.pairs;
  }
  EXPECT_GE(rows.size(), 2u);
  EXPECT_EQ(pairs, quick.pairs);
  Fake costly;
  costly.share_ = 16;
  EXPECT_TRUE(run(std::make_unique<Fake>(costly), "random", options).empty());
}

TEST(Bench, MeasuresTheErrorOfDistances) {
  std::size_t first_disjoint = 0;
  while (judge(pair_at(first_disjoint)).verdict != Verdict::disjoint) ++first_disjoint;
  Fake fake;
  fake.say_distance = [=](const Pair& pair) {
    const Truth truth = judge(pair);
    if (truth.verdict != Verdict::disjoint) return not_measured;
    const Enclosure real = enclose_distance(pair, truth);
    return (real.lo + real.hi) / 2 + (is_pair(pair, first_disjoint) ? 1e-6 : 1e-9) * size_of(pair);
  };
  auto rows = run(fake);
  ASSERT_EQ(rows.size(), 2u) << "no depth is given, so there is no row of depths";
  EXPECT_EQ(rows[1].query, "distance");
  EXPECT_EQ(rows[1].pairs, count_disjoint());
  EXPECT_NEAR(rows[1].max_error, 1e-6, 1e-11);
  EXPECT_GE(rows[1].max_error_at_most, rows[1].max_error);
  EXPECT_NEAR(rows[1].max_error_at_most, 1e-6, 1e-11);
  EXPECT_EQ(rows[1].wrong_intersecting, 0u);

  fake.say_distance = [](const Pair& pair) { return is_pair(pair, 3) ? not_measured : -1.0; };
  rows = run(fake);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].wrong_intersecting + rows[1].undecided, count_disjoint());
  EXPECT_EQ(rows[1].undecided + rows[2].undecided, 1u);
  EXPECT_EQ(rows[2].query, "depth");
  EXPECT_EQ(rows[2].pairs, quick.pairs - count_disjoint());
  EXPECT_EQ(rows[2].wrong_disjoint, 0u);
}

TEST(Bench, ChecksEveryVerdictOfABatch) {
  Fake fake;
  fake.say_all = [](std::span<const Pair> pairs, std::span<Verdict> verdicts) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool disjoint = (judge(pairs[i]).verdict == Verdict::disjoint) != is_pair(pairs[i], 11);
      verdicts[i] = disjoint ? Verdict::disjoint : Verdict::intersecting;
    }
  };
  BenchRow row = run(fake)[1];
  EXPECT_EQ(row.query, "batch");
  EXPECT_EQ(row.wrong_disjoint + row.wrong_intersecting, 1u);
  EXPECT_TRUE(std::isfinite(row.median_ns) && std::isnan(row.p99_ns));

  fake.say_all = [](std::span<const Pair>, std::span<Verdict>) { std::abort(); };
  row = run(fake)[1];
  EXPECT_EQ(row.failed, quick.pairs);
  EXPECT_TRUE(std::isnan(row.median_ns));
}

BenchRow row_of(const char* method, const char* family, const char* query, double ns, std::size_t wrong = 0) {
  BenchRow row;
  row.method = method;
  row.family = family;
  row.query = query;
  row.foreign = row.method != "intersect" && row.method != "decide" && row.method != "exact";
  row.pairs = 2000;
  row.median_ns = ns;
  row.p99_ns = 2 * ns;
  row.wrong_disjoint = row.wrong_at_margin = wrong;
  return row;
}

TEST(Summary, TakesTheFastestThatIsRight) {
  BenchRow share = row_of("costly", "y", "verdict", 15);
  share.pairs = 31;
  BenchRow declining = row_of("declining", "random", "verdict", 1);
  declining.undecided = 400;
  const BenchRow rows[] = {row_of("intersect", "random", "verdict", 10),
                           row_of("exact", "random", "verdict", 5),
                           row_of("decide", "random", "certificate", 14),
                           row_of("intersect", "random", "batch", 2),
                           row_of("hasty", "random", "verdict", 50, 3),
                           row_of("good", "random", "verdict", 90, 2),
                           row_of("slow", "random", "verdict", 900),
                           row_of("broken", "random", "verdict", not_measured),
                           declining,
                           row_of("raw", "random", "raw", 1),
                           row_of("intersect", "x", "verdict", 30, 1),
                           row_of("good", "x", "verdict", 120),
                           row_of("intersect", "y", "verdict", 10),
                           row_of("hasty", "y", "verdict", 20, 4),
                           share};
  const auto queries = summarise(rows);
  ASSERT_EQ(queries.size(), 3u);
  const QueryComparisons &verdict = queries[0], &certificate = queries[1], &batch = queries[2];
  EXPECT_EQ(verdict.query, "verdict");
  ASSERT_EQ(verdict.comparisons.size(), 3u);
  EXPECT_EQ(verdict.comparisons[0].method, "intersect");
  EXPECT_EQ(verdict.comparisons[0].right.method, "good");
  EXPECT_DOUBLE_EQ(verdict.comparisons[0].right.ratio, 9);
  EXPECT_EQ(verdict.comparisons[0].fastest.method, "hasty");
  EXPECT_DOUBLE_EQ(verdict.comparisons[0].fastest.ratio, 5);
  EXPECT_DOUBLE_EQ(verdict.comparisons[0].p99_over_median, 2);
  EXPECT_DOUBLE_EQ(verdict.comparisons[1].over_random, 3);
  EXPECT_EQ(verdict.comparisons[2].right.method, "") << "nobody is right on y";
  EXPECT_DOUBLE_EQ(verdict.right.least, 4);
  EXPECT_DOUBLE_EQ(verdict.right.geometric_mean, 6);
  EXPECT_DOUBLE_EQ(verdict.fastest.least, 2);
  EXPECT_NEAR(verdict.fastest.geometric_mean, std::cbrt(5. * 4 * 2), 1e-12);
  EXPECT_EQ(verdict.wrong_at_margin, 1u);
  EXPECT_EQ(certificate.query, "certificate");
  EXPECT_DOUBLE_EQ(certificate.comparisons[0].over_verdict, 1.4);
  EXPECT_EQ(batch.query, "batch");
  EXPECT_EQ(batch.comparisons[0].right.method, "good") << "a batch is held against verdicts";
  EXPECT_DOUBLE_EQ(batch.right.least, 45);
  EXPECT_DOUBLE_EQ(batch.fastest.least, 25);
}

TEST(Summary, ByShapesTakesTheMeanAndTheLeast) {
  const BenchRow rows[] = {
      row_of("intersect", "sphere/box x", "verdict", 10), row_of("good", "sphere/box x", "verdict", 40, 1),
      row_of("intersect", "sphere/box y", "verdict", 40), row_of("good", "sphere/box y", "verdict", 360),
      row_of("intersect", "box/box x", "verdict", 10),    row_of("good", "box/box x", "verdict", 40, 3)};
  const std::string text = format_shapes(summarise(rows));
  EXPECT_NE(text.find("| sphere/box | 20 | 2 | 2 | 6.0 | 4.0 | `good`, x |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("no method is right on: box/box\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" good "), std::string::npos);
  EXPECT_NE(text.find(" 100.0 "), std::string::npos) << text;
}

TEST(Summary, UndecidedAndFailedAreNotRight) {
  BenchRow row = row_of("good", "random", "verdict", 1, 1);
  row.undecided = 1;
  EXPECT_TRUE(is_right(row));
  row.failed = 1;
  EXPECT_FALSE(is_right(row));
}

TEST(Summary, JsonHasEveryField) {
  std::vector<BenchRow> rows{row_of("intersect", "random", "verdict", 10),
                             row_of("good \"x\"", "random", "verdict", 90)};
  rows[0].max_error = 1e-14;
  const auto json = bench_json(rows);
  ASSERT_EQ(json.size(), 2u);
  const auto& row = json[0];
  for (const char* field :
       {"method", "family", "query", "foreign", "n", "median_ns", "spread", "p50_ns", "p99_ns", "max_ns",
        "instructions", "wrong_disjoint", "wrong_intersecting", "wrong_below_claim", "wrong_at_margin",
        "undecided", "failed", "max_error", "max_error_at_most"}) {
    EXPECT_TRUE(row.contains(field)) << field;
  }
  EXPECT_EQ(row["n"], 2000);
  EXPECT_EQ(row["foreign"], false);
  EXPECT_EQ(row["median_ns"], 10);
  EXPECT_EQ(row["max_error"], 1e-14);
  EXPECT_TRUE(row["instructions"].is_null());
  EXPECT_EQ(json[1]["method"], "good \"x\"");
}

TEST(Families, AMarginIsWhatItsNameSays) {
  ASSERT_EQ(margin_families().size(), 15u);
  for (const Family& family : margin_families()) {
    const double margin = std::stod(std::string(family.name.substr(family.name.find('_') + 1)));
    for (std::size_t i = 0; i < 48; ++i) {
      const Pair pair = family.generate(1, i);
      const Truth truth = judge(pair);
      const bool gap = i % 2 == 0 || margin > 0.05;
      ASSERT_EQ(truth.verdict, gap ? Verdict::disjoint : Verdict::intersecting) << family.name << ' ' << i;
      const Enclosure real = enclose_distance(pair, truth, 1e-15);
      // Construction rounds by up to 5e-16 of the size; the enclosure is up to 5e-14 wide.
      const double said = (gap ? 1 : -1) * margin * size_of(pair), rounding = 5e-16 * size_of(pair);
      EXPECT_LE(real.lo, said + rounding) << family.name << ' ' << i;
      EXPECT_GE(real.hi, said - rounding) << family.name << ' ' << i;
      EXPECT_LE(real.hi - real.lo, 5e-14 * size_of(pair)) << family.name << ' ' << i;
    }
  }
}

TEST(Families, AreChosenByName) {
  EXPECT_EQ(select_families("all").size(), campaign_families().size() + margin_families().size());
  EXPECT_EQ(select_families("margin_1e").size(), margin_families().size());
  const auto two = select_families("margin_1e-06,random");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].name, "random");
  EXPECT_EQ(two[1].name, "margin_1e-06");
  EXPECT_THROW(select_families("nothing"), std::invalid_argument);
}

}  // namespace
}  // namespace cyl
