// SPDX-License-Identifier: MIT
#include "reports/run/bench_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

namespace cyl {
namespace {

std::string number(double x, int digits = 1) {
  return std::isfinite(x) ? fmt::format("{:.{}f}", x, digits) : "-";
}
std::string power(double x) { return std::isfinite(x) ? fmt::format("{:.0e}", x) : "-"; }

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

nlohmann::ordered_json bench_json(std::span<const BenchRow> rows) {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const BenchRow& row : rows)
    all.push_back({{"method", row.method},
                   {"library", row.name.library},
                   {"algorithm", row.name.algorithm},
                   {"setting", row.name.setting},
                   {"family", row.family},
                   {"query", row.query},
                   {"foreign", row.foreign},
                   {"n", row.pairs},
                   {"median_ns", number_or_null<Json>(row.median_ns)},
                   {"spread", number_or_null<Json>(row.spread_percent)},
                   {"p50_ns", number_or_null<Json>(row.p50_ns)},
                   {"p99_ns", number_or_null<Json>(row.p99_ns)},
                   {"max_ns", number_or_null<Json>(row.max_ns)},
                   {"instructions", number_or_null<Json>(row.instructions)},
                   {"wrong_disjoint", row.wrong_disjoint},
                   {"wrong_intersecting", row.wrong_intersecting},
                   {"wrong_below_claim", row.wrong_below_claim},
                   {"wrong_at_margin", row.wrong_at_margin},
                   {"undecided", row.undecided},
                   {"failed", row.failed},
                   {"max_error", number_or_null<Json>(row.max_error)},
                   {"max_error_at_most", number_or_null<Json>(row.max_error_at_most)}});
  return all;
}

}  // namespace cyl
