// SPDX-License-Identifier: MIT
#include "reports/gate/judged_gate.hpp"

#include <algorithm>
#include <utility>

namespace cyl {

JudgedGate judged(GateReport report) {
  JudgedGate gate{.report = std::move(report), .failures = {}, .not_asked = {}};
  for (const GateFailure& failure : gate.report.failures) gate.failures.push_back({failure});
  gate.not_asked = gate.report.not_asked;
  for (std::string& doubt : doubts(gate.report)) gate.remarks.push_back({std::move(doubt), exit_undecided});
  return gate;
}

bool fails_gate(const JudgedFailure& failure) { return is_error(failure) && !failure.known; }

int exit_code(const JudgedGate& gate) {
  const auto leads_to = [&](int code) {
    return std::ranges::any_of(gate.remarks, [code](const GateRemark& r) { return r.exit_code == code; });
  };
  if (std::any_of(gate.failures.begin(), gate.failures.end(), fails_gate) || leads_to(exit_findings))
    return exit_findings;
  return leads_to(exit_undecided) || !gate.not_asked.empty() ? exit_undecided : exit_pass;
}

}  // namespace cyl
