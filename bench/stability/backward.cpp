// SPDX-License-Identifier: MIT
#include "bench/stability/backward.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/json.hpp"
#include "base/statistics.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/strata.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

using nlohmann::json;

constexpr std::uint64_t sample_seed = 1;
/// Pairs drawn of each stratum, gaps and penetrations alike: 416 pairs.
constexpr std::uint64_t pairs_per_stratum = 4;

bool meets(Verdict v) { return v == Verdict::intersecting || v == Verdict::touching; }

/// Returns the verdict that a finding of this kind is about, or undecided if it is about none.
Verdict wrong_verdict(FindingKind kind) {
  switch (kind) {
    case FindingKind::wrong_disjoint:
      return Verdict::disjoint;
    case FindingKind::wrong_intersecting:
      return Verdict::intersecting;
    case FindingKind::wrong_touching:
      return Verdict::touching;
    default:
      return Verdict::undecided;
  }
}

/// Returns how far a solid must move until the verdict changes, relative to the size. Verdicts are proved.
double movement(Trial& p) {
  p.distance_at(1e-6);
  p.narrow_distance();
  const double moved = std::max(std::abs(p.distance.lo), std::abs(p.distance.hi)) / size_of(p.pair);
  return std::min(moved, std::numeric_limits<double>::max());
}

}  // namespace

std::optional<double> backward_error(const Pair& pair, Verdict wrong) {
  Trial p(pair);
  if (!p.decided()) return {};
  const bool right = wrong == p.truth.verdict || (wrong == Verdict::intersecting && meets(p.truth.verdict));
  if (right) return {};
  if (p.truth.verdict == Verdict::touching) return 0;
  return movement(p);
}

std::vector<WrongVerdict> wrong_verdicts(const std::vector<FindingRecord>& findings) {
  std::vector<WrongVerdict> all;
  std::map<std::pair<std::string, Verdict>, std::optional<double>> known;  // many methods err on one pair
  for (const FindingRecord& f : findings) {
    const Verdict said = wrong_verdict(f.kind);
    if (said == Verdict::undecided) continue;
    const auto [at, is_new] = known.try_emplace({f.pair, said});
    const CaseLine line = parse_case(f.pair, 1);
    if (is_new && line.value) at->second = backward_error(line.value->pair, said);
    if (at->second) all.push_back({f.method, *at->second});
  }
  return all;
}

std::vector<WrongVerdict> wrong_verdicts(std::span<const std::unique_ptr<Method>> methods) {
  const std::vector<Pair> pairs = draw_in_all_strata(pairs_per_stratum, sample_seed);
  std::vector<WrongVerdict> all;
  for (const auto& method : methods) {
    for (const Trial& p : try_method(method, pairs)) {
      if (!p.finding() || wrong_verdict(p.finding()->kind) == Verdict::undecided) continue;
      if (const auto backward = backward_error(p.pair, wrong_verdict(p.finding()->kind)))
        all.push_back({std::string(method->name()), *backward});
    }
  }
  return all;
}

std::vector<BackwardError> backward_errors(std::span<const WrongVerdict> wrong) {
  std::vector<std::pair<std::string, std::vector<double>>> by_method;
  for (const WrongVerdict& w : wrong) {
    auto at =
        std::find_if(by_method.begin(), by_method.end(), [&](const auto& m) { return m.first == w.method; });
    if (at == by_method.end()) at = by_method.insert(at, {w.method, {}});
    at->second.push_back(w.backward);
  }
  std::vector<BackwardError> errors;
  for (auto& [method, moves] : by_method) {
    std::sort(moves.begin(), moves.end());
    errors.push_back({method, moves.size(), least_above(moves, 0.5), least_above(moves, 0.99), moves.back()});
  }
  return errors;
}

json backward_json(std::span<const BackwardError> errors) {
  json all = json::array();
  for (const BackwardError& e : errors)
    all.push_back({{"method", e.method}, {"wrong", e.wrong}, {"p50", e.p50}, {"p99", e.p99}, {"max", e.max}});
  return all;
}

}  // namespace cyl
