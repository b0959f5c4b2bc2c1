// SPDX-License-Identifier: MIT
#include "bench/bench_summary.hpp"

#include <algorithm>
#include <cmath>
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

Rival rival_of(const BenchRow* row, double our_ns) {
  return row ? Rival{row->method, row->median_ns, row->median_ns / our_ns, row->max_error} : Rival{};
}

Contest contest_of(std::span<const BenchRow> rows, const BenchRow& ours) {
  Contest c;
  c.family = ours.family;
  c.method = ours.method;
  c.ns = ours.median_ns;
  c.p99_over_median = ours.p99_ns / ours.median_ns;
  c.max_error = ours.max_error;
  c.max_error_at_most = ours.max_error_at_most;
  c.wrong = ours.wrong_disjoint + ours.wrong_intersecting;
  c.wrong_at_margin = ours.wrong_at_margin;
  if (const BenchRow* verdict = own_row(rows, ours.family, "verdict"))
    c.over_verdict = c.ns / verdict->median_ns;
  if (const BenchRow* random = own_row(rows, "random", ours.query)) c.over_random = c.ns / random->median_ns;
  const bool by_verdict = ours.query == "certificate" || ours.query == "batch";
  const auto rival = [&](const BenchRow& row) {
    return row.foreign && row.pairs >= ours.pairs && row.family == ours.family &&
           row.query == (by_verdict ? "verdict" : ours.query);
  };
  c.right = rival_of(fastest_row(rows, [&](const BenchRow& r) { return rival(r) && is_right(r); }), c.ns);
  c.fastest = rival_of(fastest_row(rows, rival), c.ns);
  return c;
}

Ratios ratios_of(std::span<const Contest> contests, Rival Contest::*rival) {
  Ratios ratios;
  double sum = 0, count = 0;
  for (const Contest& contest : contests) {
    const double ratio = (contest.*rival).ratio;
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
  const std::size_t off = row.wrong_disjoint + row.wrong_intersecting + row.undecided + row.failed;
  return static_cast<double>(off) <= right_tol * static_cast<double>(row.pairs);
}

std::vector<Standing> summarise(std::span<const BenchRow> rows) {
  std::vector<std::string> families;
  for (const BenchRow& row : rows) {
    if (std::find(families.begin(), families.end(), row.family) == families.end())
      families.push_back(row.family);
  }
  std::vector<Standing> standings;
  for (const char* query : {"verdict", "raw", "certificate", "batch", "distance", "depth"}) {
    Standing s;
    s.query = query;
    for (const std::string& family : families) {
      if (const BenchRow* ours = own_row(rows, family, query)) s.contests.push_back(contest_of(rows, *ours));
    }
    if (s.contests.empty()) continue;
    s.right = ratios_of(s.contests, &Contest::right);
    s.fastest = ratios_of(s.contests, &Contest::fastest);
    for (const Contest& contest : s.contests) s.wrong_at_margin += contest.wrong_at_margin;
    standings.push_back(std::move(s));
  }
  return standings;
}

}  // namespace cyl
