// SPDX-License-Identifier: MIT
#include "oracles/trial/algorithm_groups.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "corpus/pairs/strata.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t group_seed = 7, pairs_per_cell = 4;
/// Methods with this share() or more, those of NLopt, would take nine tenths of the time. They are asked
/// about one pair of each cell, which gives the same groups.
constexpr unsigned costly_share = 64;

/// One of two methods is wrong on fewer pairs. This is the part of them on which the other is wrong in the
/// same way. Among all_methods(), methods with one algorithm share 0.97 and more, others 0.92 at most.
constexpr double shared_part_margin = 0.95;
/// The part of the pairs on which both are wrong, among the pairs on which either is. Across libraries, it is
/// 0.67 or more for methods with one algorithm, at most 0.53 for others. Within one, a setting may make the
/// difference. Below the smaller margin, one is wrong so often that it includes the other's pairs by chance.
constexpr double alike_part_margin = 0.3, alike_part_across_margin = 0.6;
/// The number of pairs on which both must be wrong to exclude luck: within a library, and across libraries.
constexpr std::size_t least_wrong = 5, least_wrong_across = 20;

enum class Outcome : unsigned char { nothing, right, wrong_disjoint, wrong_intersecting, failed };

Outcome classify(const MethodAnswer& answer, Verdict truth) {
  if (answer.status == Status::failed) return Outcome::failed;
  if (answer.status == Status::declined || answer.verdict == Verdict::undecided) return Outcome::nothing;
  if ((answer.verdict == Verdict::disjoint) == (truth == Verdict::disjoint)) return Outcome::right;
  return answer.verdict == Verdict::disjoint ? Outcome::wrong_disjoint : Outcome::wrong_intersecting;
}

bool err_alike(std::span<const Outcome> x, std::span<const Outcome> y, bool one_library) {
  std::size_t x_wrong = 0, y_wrong = 0, both = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (x[p] == Outcome::nothing || y[p] == Outcome::nothing) continue;
    x_wrong += x[p] != Outcome::right;
    y_wrong += y[p] != Outcome::right;
    both += x[p] != Outcome::right && x[p] == y[p];
  }
  const auto part = [&](std::size_t of) { return static_cast<double>(both) / static_cast<double>(of); };
  const std::size_t rarer = std::min(x_wrong, y_wrong);
  if (rarer < (one_library ? least_wrong : least_wrong_across) || part(rarer) < shared_part_margin)
    return false;
  return part(x_wrong + y_wrong - both) >= (one_library ? alike_part_margin : alike_part_across_margin);
}

}  // namespace

bool differ_in_setting(const Method& x, const Method& y) {
  const MethodName &first = x.name_parts(), &second = y.name_parts();
  return x.guest() == y.guest() && first.library == second.library && first.algorithm == second.algorithm &&
         first.setting != second.setting;
}

std::vector<std::size_t> algorithm_groups(std::span<const std::unique_ptr<Method>> methods,
                                          const std::function<bool(const Method&)>& asked) {
  const std::vector<Pair> pairs = draw_in_all_strata(pairs_per_cell, group_seed);
  std::vector<Question> questions;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m]->guest() || !asked(*methods[m])) continue;
    const std::size_t step = methods[m]->share() >= costly_share ? pairs_per_cell : 1;
    for (std::size_t p = 0; p < pairs.size(); p += step) questions.push_back({m, p});
  }
  Caps caps;
  caps.hangs = 4;
  const std::vector<ContainedAnswer> answers = ask_contained(methods, pairs, questions, caps);
  std::vector<Verdict> truths;
  for (const Pair& pair : pairs)
    if (!questions.empty()) truths.push_back(judge(pair).verdict);
  std::vector<Outcome> said(methods.size() * pairs.size(), Outcome::nothing);
  for (std::size_t q = 0; q < questions.size(); ++q) {
    const auto& [m, p, way, run] = questions[q];
    if (truths[p] != Verdict::undecided) said[m * pairs.size() + p] = classify(answers[q].answer, truths[p]);
  }

  std::vector<std::size_t> first(methods.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  const auto of = [&](std::size_t m) { return std::span(said).subspan(m * pairs.size(), pairs.size()); };
  for (std::size_t m = 0; m < methods.size(); ++m)
    for (std::size_t n = 0; n < m; ++n) {
      if (first[m] == first[n]) continue;
      const Method &x = *methods[m], &y = *methods[n];
      if (!differ_in_setting(x, y) && !err_alike(of(m), of(n), x.library() == y.library())) continue;
      const std::size_t kept = std::min(first[m], first[n]), joined = std::max(first[m], first[n]);
      std::replace(first.begin(), first.end(), joined, kept);
    }
  return first;
}

}  // namespace cyl
