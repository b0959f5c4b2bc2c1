// SPDX-License-Identifier: MIT
#include "bench/bench_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace cyl {
namespace {

/// The row of least time that `fits`, or nullptr.
template <class Fits>
const BenchRow* fastest_row(std::span<const BenchRow> rows, Fits fits) {
  const BenchRow* best = nullptr;
  for (const BenchRow& row : rows) {
    if (std::isfinite(row.median_ns) && fits(row) && (!best || row.median_ns < best->median_ns)) best = &row;
  }
  return best;
}

const BenchRow* own_row(std::span<const BenchRow> rows, std::string_view family, std::string_view query) {
  const bool yes_no = query == "verdict" || query == "raw";
  return fastest_row(rows, [&](const BenchRow& row) {
    return !row.foreign && row.family == family && row.query == query &&
           (!yes_no || row.method == "intersect");
  });
}

std::size_t off(const BenchRow& row) {
  return row.wrong_disjoint + row.wrong_intersecting + row.undecided + row.failed;
}

/// A pair that is declined takes no time.
bool answers(const BenchRow& row) {
  return static_cast<double>(row.undecided + row.failed) <= right_tol * static_cast<double>(row.pairs);
}

Competitor competitor_of(const BenchRow* row, double our_ns) {
  if (!row) return {};
  return {row->method, row->median_ns, row->median_ns / our_ns,
          1 - static_cast<double>(off(*row)) / static_cast<double>(row->pairs), row->max_error};
}

Comparison comparison_of(std::span<const BenchRow> rows, const BenchRow& ours) {
  Comparison c;
  c.family = ours.family;
  c.method = ours.method;
  c.ns = ours.median_ns;
  c.p99_over_median = ours.p99_ns / ours.median_ns;
  c.max_error = ours.max_error;
  c.wrong_at_margin = ours.wrong_at_margin;
  if (const BenchRow* verdict = own_row(rows, ours.family, "verdict"))
    c.over_verdict = c.ns / verdict->median_ns;
  if (const BenchRow* random = own_row(rows, "random", ours.query)) c.over_random = c.ns / random->median_ns;
  const bool by_verdict = ours.query == "certificate" || ours.query == "batch";
  const auto competitor = [&](const BenchRow& row) {
    return row.foreign && row.pairs >= ours.pairs && row.family == ours.family &&
           row.query == (by_verdict ? "verdict" : ours.query);
  };
  c.right =
      competitor_of(fastest_row(rows, [&](const BenchRow& r) { return competitor(r) && is_right(r); }), c.ns);
  c.fastest =
      competitor_of(fastest_row(rows, [&](const BenchRow& r) { return competitor(r) && answers(r); }), c.ns);
  return c;
}

Ratios ratios_of(std::span<const Comparison> comparisons, Competitor Comparison::*competitor) {
  Ratios ratios;
  double sum = 0, count = 0;
  for (const Comparison& comparison : comparisons) {
    const double ratio = (comparison.*competitor).ratio;
    if (std::isnan(ratio)) continue;
    ratios.least = std::fmin(ratios.least, ratio);
    sum += std::log(ratio);
    ++count;
  }
  if (count > 0) ratios.geometric_mean = std::exp(sum / count);
  return ratios;
}

}  // namespace

bool is_right(const BenchRow& row) {
  return static_cast<double>(off(row)) <= right_tol * static_cast<double>(row.pairs);
}

std::vector<QueryComparisons> summarise(std::span<const BenchRow> rows) {
  std::vector<std::string> families;
  for (const BenchRow& row : rows) {
    if (std::ranges::count(families, row.family) == 0) families.push_back(row.family);
  }
  std::vector<QueryComparisons> queries;
  for (const char* query : {"verdict", "raw", "certificate", "batch", "distance", "depth"}) {
    QueryComparisons s;
    s.query = query;
    for (const std::string& family : families) {
      if (const BenchRow* ours = own_row(rows, family, query))
        s.comparisons.push_back(comparison_of(rows, *ours));
    }
    if (s.comparisons.empty()) continue;
    s.right = ratios_of(s.comparisons, &Comparison::right);
    s.fastest = ratios_of(s.comparisons, &Comparison::fastest);
    for (const Comparison& comparison : s.comparisons) s.wrong_at_margin += comparison.wrong_at_margin;
    queries.push_back(std::move(s));
  }
  return queries;
}

std::string format_shapes(std::span<const QueryComparisons> queries) {
  std::string text, table;
  for (const QueryComparisons& s : queries) {
    text += fmt::format("\n{:<50}{:>11}  {:<30}{:>9}{:>9}{:>8}\n", s.query, "ours ns", "right", "ns",
                        "right %", "ratio");
    std::map<std::string, std::vector<Comparison>> by_shapes;
    for (const Comparison& c : s.comparisons) {
      const std::string shapes = c.family.substr(0, c.family.find(' '));
      by_shapes[shapes].push_back(c);
      text += fmt::format("{:<50}{:>11.1f}  {:<30}{:>9.1f}{:>9.1f}{:>8.1f}\n", c.family, c.ns,
                          c.right.method.empty() ? "-" : c.right.method, c.right.ns,
                          100 * c.right.right_share, c.right.ratio);
    }
    table += fmt::format(
        "\n| shapes | `{}` ns | families | with a right method | ratio | least ratio | to |\n"
        "|---|---:|---:|---:|---:|---:|---|\n",
        s.comparisons[0].method);
    std::vector<std::string> without;
    const auto line = [&](const std::string& shapes, std::span<const Comparison> all) {
      double sum = 0;
      std::size_t right = 0;
      const Comparison* least = nullptr;
      for (const Comparison& c : all) {
        sum += std::log(c.ns);
        if (c.right.method.empty()) continue;
        ++right;
        if (!least || c.right.ratio < least->right.ratio) least = &c;
      }
      if (!least) return without.push_back(shapes);
      table += fmt::format("| {} | {:.0f} | {} | {} | {:.1f} | {:.1f} | `{}`, {} |\n", shapes,
                           std::exp(sum / static_cast<double>(all.size())), all.size(), right,
                           ratios_of(all, &Comparison::right).geometric_mean, least->right.ratio,
                           least->right.method, least->family.substr(least->family.find(' ') + 1));
    };
    for (const auto& [shapes, all] : by_shapes) line(shapes, all);
    line("all", s.comparisons);
    if (!without.empty()) table += fmt::format("\nno method is right on: {}\n", fmt::join(without, ", "));
  }
  return text + table;
}

}  // namespace cyl
