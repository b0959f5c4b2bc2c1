// SPDX-License-Identifier: MIT
#include "props/laws.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "props/law_groups.hpp"

namespace cyl {

std::span<const Law> all_laws() {
  static const std::vector<Law> laws = [] {
    std::vector<Law> all;
    for (const auto& part : {exact_laws(), one_sided_laws(), approximate_laws(), answer_laws()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return laws;
}

const Law& law_numbered(int number) {
  const auto laws = all_laws();
  const auto found =
      std::find_if(laws.begin(), laws.end(), [&](const Law& law) { return law.number == number; });
  if (found == laws.end()) throw std::invalid_argument("there is no law " + std::to_string(number));
  return *found;
}

const char* to_string(LawKind kind) noexcept {
  switch (kind) {
    case LawKind::exact:
      return "exact";
    case LawKind::one_sided:
      return "one-sided";
    case LawKind::approximate:
      return "approximate";
    case LawKind::answer:
      return "answer";
  }
  return "answer";
}

Severity severity_of(const LawCase& c) {
  const Claim claim = c.method.claim();
  if (!beyond_claim(c.proofs.of(c.pair), claim)) return Severity::resolution;
  for (const Asked& asked : c.asked)
    if (!beyond_claim(c.proofs.of(asked.pair), claim)) return Severity::resolution;
  return Severity::contract;
}

}  // namespace cyl
