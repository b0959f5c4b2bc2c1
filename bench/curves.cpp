// SPDX-License-Identifier: MIT
#include "bench/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/number_text.hpp"

namespace cyl {
namespace {

constexpr std::array<std::string_view, 4> queries{"verdict", "batch", "certificate", "distance"};

bool all_right(const BenchRow& row) {
  return row.pairs > 0 && row.wrong_disjoint + row.wrong_intersecting + row.undecided + row.failed == 0;
}

/// Puts the rows of one method and query together, by first appearance.
std::vector<std::vector<BenchRow>> by_question(std::span<const BenchRow> rows) {
  std::vector<std::vector<BenchRow>> groups;
  for (const BenchRow& row : rows) {
    if (std::find(queries.begin(), queries.end(), row.query) == queries.end()) continue;
    const auto same = [&](const auto& g) { return g[0].method == row.method && g[0].query == row.query; };
    const auto group = std::find_if(groups.begin(), groups.end(), same);
    (group == groups.end() ? groups.emplace_back() : *group).push_back(row);
  }
  return groups;
}

/// Returns the point of one method and query over all margins.
SpeedPoint point_of(std::span<const BenchRow> rows) {
  const MethodName& name = rows[0].name;
  SpeedPoint all;
  all.method = rows[0].method;
  all.curve = name.library + (name.algorithm.empty() ? "" : '-' + name.algorithm);
  all.setting = name.setting.empty() ? "default" : name.setting;
  all.query = rows[0].query;
  all.digits = digits_of(rows);
  double sum = 0, timed = 0;
  for (const BenchRow& row : rows) {
    if (!margin_of_family(row.family)) continue;
    all.asked += row.pairs;
    all.wrong_disjoint += row.wrong_disjoint;
    all.wrong_intersecting += row.wrong_intersecting;
    all.p99_ns = std::fmax(all.p99_ns, row.p99_ns);
    all.max_ns = std::fmax(all.max_ns, row.max_ns);
    if (!std::isfinite(row.median_ns)) continue;
    sum += row.median_ns;
    ++timed;
  }
  if (timed > 0) all.ns = sum / timed;
  return all;
}

std::string text_of(const std::optional<int>& digits) { return digits ? std::to_string(*digits) : "-"; }

std::string number(double x) { return std::isfinite(x) ? fmt::format("{:.0f}", x) : "-"; }

}  // namespace

std::optional<int> margin_of_family(std::string_view family) {
  constexpr std::string_view start = "margin_1e-";
  if (!family.starts_with(start)) return {};
  return number_in<int>(family.substr(start.size()));
}

Digits digits_of(std::span<const BenchRow> rows) {
  std::map<int, const BenchRow*> by_margin;
  for (const BenchRow& row : rows)
    if (const auto decade = margin_of_family(row.family)) by_margin[*decade] = &row;
  Digits digits;
  if (by_margin.contains(1)) digits.right = 0;
  for (int d = 1; by_margin.contains(d) && all_right(*by_margin[d]); ++d) digits.right = d;
  if (!digits.right) return digits;
  const double needed = std::log(1 - low_confidence) / std::log1p(-low_share_tol);
  double right = 0;
  for (int d = *digits.right; d >= 1 && !digits.low; --d) {
    right += static_cast<double>(by_margin[d]->pairs);
    if (right >= needed) digits.low = d;
  }
  return digits;
}

std::vector<SpeedPoint> speed_points(std::span<const BenchRow> rows) {
  std::vector<SpeedPoint> points;
  for (const std::vector<BenchRow>& group : by_question(rows)) points.push_back(point_of(group));
  std::erase_if(points, [](const SpeedPoint& p) { return !std::isfinite(p.ns); });
  return points;
}

std::string format_curves(std::vector<SpeedPoint> points) {
  std::ranges::stable_sort(points, {}, [](const SpeedPoint& p) { return std::pair(p.query, p.curve); });
  std::string text =
      fmt::format("{:<32}{:<11}{:<13}{:>10}{:>10}{:>11}{:>7}{:>9}{:>9}{:>8}{:>6}\n", "curve", "setting",
                  "query", "ns/pair", "p99 ns", "max ns", "pairs", "disj(!)", "inter(!)", "digits", "low");
  for (const SpeedPoint& p : points) {
    text += fmt::format("{:<32}{:<11}{:<13}{:>10}{:>10}{:>11}{:>7}{:>9}{:>9}{:>8}{:>6}\n", p.curve, p.setting,
                        p.query, number(p.ns), number(p.p99_ns), number(p.max_ns), p.asked, p.wrong_disjoint,
                        p.wrong_intersecting, text_of(p.digits.right), text_of(p.digits.low));
  }
  return text +
         "\ndigits: right on every pair at margins of 1e-1 to 1e-digits of the size, and not at the next; "
         "low: at most 0.1 % not\nright, at 95 %. disj(!), inter(!): wrong answers disjoint, intersecting, "
         "over margins 1e-1 to 1e-15.\n";
}

}  // namespace cyl
