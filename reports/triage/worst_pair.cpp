// SPDX-License-Identifier: MIT
#include "reports/triage/worst_pair.hpp"

#include <algorithm>

#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// How far the sizes may leave the range of the starts, as a factor: a search needs some room.
constexpr double size_room = 2;

double offset_of(const Pair& p) {
  const double size = size_of(p);
  const double farthest = std::max(p.a.center.cwiseAbs().maxCoeff(), p.b.center.cwiseAbs().maxCoeff());
  return size > 0 ? farthest / size : 0;
}

}  // namespace

Domain domain_of(Mechanism mechanism, std::span<const Pair> starts) {
  Domain domain;
  const bool about_size = mechanism == Mechanism::absolute_length || mechanism == Mechanism::underflow ||
                          mechanism == Mechanism::overflow;
  bool first = true;
  for (const Pair& start : starts) {
    const double size = size_of(start);
    if (!(size > 0)) continue;
    if (about_size) {
      domain.least_size = std::min(first ? size : domain.least_size, size / size_room);
      domain.most_size = std::max(first ? size : domain.most_size, size * size_room);
    }
    if (mechanism == Mechanism::offset) domain.most_offset = std::max(domain.most_offset, offset_of(start));
    first = false;
  }
  return domain;
}

// The sign of the distance is checked first, since it shows whether the verdict can be wrong in this way.
std::optional<WrongPair> worst_of_cause(const GroupedMethods& methods, const CauseSought& cause,
                                        WorstOptions options, const Caps& caps) {
  options.domain = domain_of(cause.mechanism, cause.starts);
  Asker asker(methods.methods, caps);
  const auto of_the_cause = [&](const Pair& pair) {
    if ((cause.kind == FindingKind::wrong_intersecting) != (approximate_distance(pair).value > 0))
      return false;
    return find_cause(methods, {cause.method, cause.kind, pair}, Severity::contract, {}, asker) == cause.key;
  };
  const Worst worst = worst_of(methods.methods[cause.method], cause.starts,
                               {.also = of_the_cause, .kind = cause.kind}, options);
  if (!worst.wrong || worst.wrong->finding.severity != Severity::contract) return {};
  return worst.wrong;
}

}  // namespace cyl
