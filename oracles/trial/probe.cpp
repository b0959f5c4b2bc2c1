// SPDX-License-Identifier: MIT
#include "oracles/trial/probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/usage_error.hpp"

namespace cyl {
namespace {

/// Relative widths of a distance that is only shown, and how much of itself it may be unsure of.
constexpr double widths[] = {1e-6, 1e-9, 1e-12, 1e-15};
constexpr double shown_share = 1e-3;

}  // namespace

std::vector<Probe> probe(const std::unique_ptr<Method>& method, std::span<const Pair> pairs,
                         const Caps& caps) {
  std::vector<Question> questions;
  for (std::size_t i = 0; i < pairs.size(); ++i) questions.push_back({0, i});
  const std::vector<ContainedAnswer> said =
      ask_contained(std::span<const std::unique_ptr<Method>>(&method, 1), pairs, questions, caps);
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Probe& p = probes.emplace_back();
    p.pair = pairs[i];
    p.answer = said[i].answer;
    p.truth = judge(p.pair, std::span(&p.answer, 1));
    LazyDistance distance([&](double width) { return enclose_distance(p.pair, p.truth, width); });
    p.finding = compare(p.pair, p.truth, distance, method->claim(), p.answer);
    if (p.decided()) p.distance = distance.known() ? *distance.known() : distance.at(widths[0]);
  }
  return probes;
}

Probe probe_one(const std::unique_ptr<Method>& method, const Pair& pair) {
  Probe p = probe(method, std::span(&pair, 1), Caps{}).front();
  narrow_distance(p);
  return p;
}

void narrow_distance(Probe& p) {
  if (!p.decided() || p.truth.verdict == Verdict::touching) return;
  for (const double width : widths) {
    const double least = std::min(std::abs(p.distance.lo), std::abs(p.distance.hi));
    const bool one_sign = (p.distance.lo > 0) == (p.distance.hi > 0);
    if (one_sign && p.distance.hi - p.distance.lo <= shown_share * least) return;
    p.distance = enclose_distance(p.pair, p.truth, width);
  }
}

const std::unique_ptr<Method>& find_method(std::span<const std::unique_ptr<Method>> methods,
                                           std::string_view name) {
  for (const auto& method : methods)
    if (method->name() == name) return method;
  throw UsageError(fmt::format("no method is named '{}'", name));
}

std::string distance_in_words(const Probe& p) {
  if (!p.decided()) return "of unproved distance";
  if (p.truth.verdict == Verdict::touching) return "touching";
  if (p.truth.verdict == Verdict::disjoint) return fmt::format("{:.3g} apart", p.distance.lo);
  return fmt::format("overlapping by {:.3g}", -p.distance.hi);
}

}  // namespace cyl
