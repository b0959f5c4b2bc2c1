// SPDX-License-Identifier: MIT
// Laws 30 and on: what one answer owes by itself. The judge of them is the referee's proof, where one is
// needed.
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "corpus/pair_io.hpp"
#include "props/law_groups.hpp"

namespace cyl {
namespace {

/// What compare() finds wrong, if it is of one of these kinds.
std::optional<Broken> refuted(const LawCase& c, std::initializer_list<FindingKind> kinds) {
  if (c.first.status == Status::declined) return {};
  Proved& proved = c.proofs.of(c.pair);
  const auto finding = compare(c.pair, proved.truth, proved.distance, c.method.claim(), c.first);
  if (!finding || std::find(kinds.begin(), kinds.end(), finding->kind) == kinds.end()) return {};
  std::string what = to_string(finding->kind);
  if (finding->margin) what += fmt::format(", margin {:.3g}", finding->margin->lo);
  return Broken{std::move(what), finding->severity};
}

std::optional<Broken> break_answers(const LawCase& c) {
  if (c.first.status != Status::failed) return {};
  auto broken = refuted(c, {FindingKind::exception, FindingKind::crash, FindingKind::hang,
                            FindingKind::non_finite, FindingKind::malformed});
  if (broken) broken->what = fmt::format("{}: {}", broken->what, c.first.reason);
  return broken;
}

std::optional<Broken> break_verdict(const LawCase& c) {
  return refuted(c, {FindingKind::wrong_disjoint, FindingKind::wrong_intersecting,
                     FindingKind::wrong_touching, FindingKind::wrong_invalid});
}

}  // namespace

std::vector<Law> answer_laws() {
  return {
      {30, LawKind::answer, "answers", "it answers: no crash, exception, hang, NaN or value without meaning",
       "everywhere", needs_none, break_answers},
      {31, LawKind::answer, "verdict", "no certificate refutes the verdict", "where the truth is proved",
       needs_none, break_verdict},
  };
}

}  // namespace cyl
