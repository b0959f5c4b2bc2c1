// SPDX-License-Identifier: MIT
#include "props/gate/gate_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/exit_code.hpp"
#include "base/safe_text.hpp"

namespace cyl {
namespace {

/// From this many pairs on, one answer to all of them deserves a remark.
constexpr std::uint64_t enough_to_remark = 100;

}  // namespace

bool abstains(const AnswerCounts& counts) {
  const auto silent = counts.declined + counts.said[static_cast<std::size_t>(Verdict::undecided)];
  return counts.asked == 0 || 2 * silent > counts.asked;
}

std::string remark_on(const AnswerCounts& counts) {
  if (counts.asked < enough_to_remark) return {};
  const auto said = [&](Verdict v) { return counts.said[static_cast<std::size_t>(v)]; };
  if (counts.failed == counts.asked) return "fails on every pair";
  const std::uint64_t silent = counts.declined + said(Verdict::undecided);
  if (silent == counts.asked) return "abstains on every pair";
  if (abstains(counts)) return fmt::format("abstains on {} of {} pairs", silent, counts.asked);
  for (const Verdict v : {Verdict::disjoint, Verdict::intersecting, Verdict::touching, Verdict::invalid})
    if (said(v) + counts.declined + counts.failed == counts.asked)
      return fmt::format("answers {} to every pair", to_string(v));
  return {};
}

VerdictCount close_contacts_of(const GateMethod& method) {
  VerdictCount all;
  for (const CloseGateCell& c : method.close_cells) {
    all.pairs += c.gaps + c.overlaps;
    all.wrong += c.wrong_gaps + c.wrong_overlaps;
    all.undecided += c.undecided;
  }
  return all;
}

bool shows_in_answer(const Law& law) { return law.number == answer_law || law.number == verdict_law; }

bool is_error(const GateFailure& failure) { return failure.severity == Severity::contract; }

std::vector<std::string> doubts(const GateReport& report) {
  std::vector<std::string> lines;
  if (report.undecided_truths > 0)
    lines.push_back("the referee could not decide " + counted(report.undecided_truths, "pair"));
  for (const GatePhaseReport& p : report.phases)
    if ((p.phase == GatePhase::sample || p.phase == GatePhase::rounded_sample) && p.pairs == 0)
      lines.push_back(fmt::format("no pair was asked in the phase '{}'", to_string(p.phase)));
  for (const GateMethod& m : report.methods)
    if (abstains(m.counts)) lines.push_back(m.name + ' ' + m.remark);
  return lines;
}

int exit_code(const GateReport& report) {
  if (std::any_of(report.failures.begin(), report.failures.end(), is_error)) return exit_findings;
  return doubts(report).empty() && report.not_asked.empty() ? exit_pass : exit_undecided;
}

}  // namespace cyl
