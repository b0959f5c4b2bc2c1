// SPDX-License-Identifier: MIT
// Findings for the tests of triage.
#pragma once

#include <string>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {

inline FindingRecord finding(const std::string& method, const std::string& family, const Pair& pair,
                             FindingKind kind = FindingKind::wrong_disjoint) {
  FindingRecord f;
  static_cast<FindingGroup&>(f) = {method, kind, Severity::contract, family};
  Trial trial(pair);
  const Verdict said = kind == FindingKind::wrong_intersecting ? Verdict::intersecting : Verdict::disjoint;
  const auto wrong = compare_statement(trial, said);
  f.margin = wrong ? wrong->margin : std::nullopt;
  f.pair = format_pair(pair);
  f.answers = std::string("[[{\"verdict\":\"") + to_string(said) + "\"},[" + quote_json(method) + "]]]";
  f.truth = "{}";
  return f;
}

/// Two cylinders of that radius and height that overlap.
inline Pair huge(double size) {
  return {{{0, 0, 0}, {0, 0, 1}, size, size}, {{size / 2, 0, 0}, {0, 1, 0}, size, size}};
}

/// The page of the book, as printed, answers intersecting for this pair.
inline Pair apart() { return {{{0, 0, 0}, {0, 0, 1}, 3, 2}, {{3, 3, 3}, {0, 1, 2}, 1, 4}}; }

}  // namespace cyl
