// SPDX-License-Identifier: MIT
#include "reports/run/bench_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

std::string number(double x, int digits = 1) {
  return std::isfinite(x) ? fmt::format("{:.{}f}", x, digits) : "-";
}
std::string power(double x) { return std::isfinite(x) ? fmt::format("{:.0e}", x) : "-"; }
std::string number_text(double x) { return std::isfinite(x) ? format_double(x) : "null"; }

std::string join(const std::vector<std::string>& texts) { return fmt::format("{}", fmt::join(texts, ",")); }

std::string competitor_json(const Competitor& competitor) {
  if (competitor.method.empty()) return "null";
  return fmt::format(R"({{"method":{},"median_ns":{},"ratio":{},"max_error":{}}})",
                     quote_json(competitor.method), number_text(competitor.ns), number_text(competitor.ratio),
                     number_text(competitor.max_error));
}

std::string ratios_json(const Ratios& ratios) {
  return fmt::format(R"({{"least":{},"geometric_mean":{}}})", number_text(ratios.least),
                     number_text(ratios.geometric_mean));
}

std::string row_json(const BenchRow& row) {
  return fmt::format(R"({{"method":{},"library":{},"algorithm":{},"setting":{},"family":{},"query":{},)"
                     R"("foreign":{},"n":{},"median_ns":{},)"
                     R"("spread":{},"p50_ns":{},"p99_ns":{},"max_ns":{},)"
                     R"("instructions":{},"wrong_disjoint":{},"wrong_intersecting":{},)"
                     R"("wrong_below_claim":{},"wrong_at_margin":{},)"
                     R"("undecided":{},"failed":{},"max_error":{},"max_error_at_most":{}}})",
                     quote_json(row.method), quote_json(row.name.library), quote_json(row.name.algorithm),
                     quote_json(row.name.setting), quote_json(row.family), quote_json(row.query), row.foreign,
                     row.pairs, number_text(row.median_ns), number_text(row.spread_percent),
                     number_text(row.p50_ns), number_text(row.p99_ns), number_text(row.max_ns),
                     number_text(row.instructions), row.wrong_disjoint, row.wrong_intersecting,
                     row.wrong_below_claim, row.wrong_at_margin, row.undecided, row.failed,
                     number_text(row.max_error), number_text(row.max_error_at_most));
}

std::string comparisons_json(std::span<const QueryComparisons> queries) {
  std::vector<std::string> objects;
  for (const QueryComparisons& s : queries) {
    std::vector<std::string> comparisons;
    for (const Comparison& c : s.comparisons) {
      comparisons.push_back(fmt::format(
          R"({{"family":{},"method":{},"median_ns":{},"p99_over_median":{},"over_verdict":{},"over_random":{},)"
          R"("max_error":{},"max_error_at_most":{},"wrong":{},"wrong_at_margin":{},"right":{},"fastest":{}}})",
          quote_json(c.family), quote_json(c.method), number_text(c.ns), number_text(c.p99_over_median),
          number_text(c.over_verdict), number_text(c.over_random), number_text(c.max_error),
          number_text(c.max_error_at_most), c.wrong, c.wrong_at_margin, competitor_json(c.right),
          competitor_json(c.fastest)));
    }
    objects.push_back(fmt::format(
        "\n{}:{{\"right\":{},\"fastest\":{},\"wrong_at_margin\":{},\"families\":[{}]}}", quote_json(s.query),
        ratios_json(s.right), ratios_json(s.fastest), s.wrong_at_margin, join(comparisons)));
  }
  return fmt::format("{{{}}}", join(objects));
}

}  // namespace

std::string format_bench_table(std::span<const BenchRow> rows) {
  std::map<std::pair<std::string, std::string>, double> unit;  // by family and query
  for (const BenchRow& row : rows) {
    if (row.method != "intersect") continue;
    unit[{row.family, row.query}] = row.median_ns;
    if (row.query == "verdict") unit[{row.family, "certificate"}] = row.median_ns;
  }
  std::string text;
  std::string family;
  for (const BenchRow& row : rows) {
    if (row.family != family) {
      family = row.family;
      text += fmt::format(
          "{}{}\n{:<30}{:<12}{:>7}{:>11}{:>8}{:>11}{:>8}{:>8}{:>9}{:>9}{:>9}{:>7}{:>7}{:>9}\n",
          text.empty() ? "" : "\n", family, "method", "query", "pairs", "ns/pair", "spread", "p99 ns",
          "ratio", "instr", "disj(!)", "inter(!)", "claimed", "undec", "failed", "error");
    }
    const auto base = unit.find({row.family, row.query});
    const double ratio = base == unit.end() ? not_measured : row.median_ns / base->second;
    text += fmt::format("{:<30}{:<12}{:>7}{:>11}{:>7}%{:>11}{:>8}{:>8}{:>9}{:>9}{:>9}{:>7}{:>7}{:>9}\n",
                        row.method, row.query, row.pairs, number(row.median_ns), number(row.spread_percent),
                        number(row.p99_ns), number(ratio), number(row.instructions, 0), row.wrong_disjoint,
                        row.wrong_intersecting, row.wrong_below_claim, row.undecided, row.failed,
                        power(row.max_error));
  }
  return text +
         "\nns/pair: median of the turns; spread: the middle half of these, in % of it. p99: over pairs.\n"
         "ratio: times the ns of `intersect`, same query (certificate: its verdict). instr: instructions per "
         "pair.\n"
         "verdict, certificate, batch, distance, depth: on prepared solids; raw: prepared inside the call, "
         "as an\n"
         "adapter of a foreign method prepares them. distance is asked of disjoint pairs, depth of the "
         "others.\n"
         "disj(!), inter(!): wrong answers disjoint, intersecting; claimed: of these, within the "
         "claim.\n"
         "error: a lower bound of the greatest error of a distance, in units of the pair's size.\n";
}

std::string format_comparisons(std::span<const QueryComparisons> queries) {
  std::string text;
  for (const QueryComparisons& s : queries) {
    text += fmt::format(
        "\n{}: ours against the fastest packaged method that is right on 99.9 % of the pairs, and the "
        "fastest of those that answer as many\n{:<25}{:<10}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}  {:<25}{:>9}{:>8}  "
        "{:<25}{:>9}{:>8}\n",
        s.query, "family", "ours", "ns", "p99/ns", "/verdict", "/random", "wrong(!)", "error", "right", "ns",
        "ratio", "fastest", "ns", "ratio");
    for (const Comparison& c : s.comparisons) {
      text += fmt::format(
          "{:<25}{:<10}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}  {:<25}{:>9}{:>8}  {:<25}{:>9}{:>8}\n", c.family,
          c.method, number(c.ns), number(c.p99_over_median), number(c.over_verdict, 2),
          number(c.over_random, 2), c.wrong_at_margin, power(c.max_error),
          c.right.method.empty() ? "-" : c.right.method, number(c.right.ns), number(c.right.ratio),
          c.fastest.method.empty() ? "-" : c.fastest.method, number(c.fastest.ns), number(c.fastest.ratio));
    }
    text += fmt::format(
        "least ratio {}, geometric mean {} (of the fastest: {}, {}); wrong at margins from 1e-13 on "
        "(random: 1e-14): {}\n",
        number(s.right.least, 2), number(s.right.geometric_mean, 2), number(s.fastest.least, 2),
        number(s.fastest.geometric_mean, 2), s.wrong_at_margin);
  }
  return text;
}

std::string bench_json(std::span<const BenchRow> rows, std::span<const QueryComparisons> queries) {
  std::vector<std::string> results;
  for (const BenchRow& row : rows) results.push_back('\n' + row_json(row));
  return fmt::format("\"results\":[{}\n],\n\"summary\":{}", join(results), comparisons_json(queries));
}

}  // namespace cyl
