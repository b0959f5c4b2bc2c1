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
  if (std::ranges::any_of(gate.failures, fails_gate)) return exit_findings;
  const bool in_doubt = std::ranges::count(gate.remarks, exit_undecided, &GateRemark::exit_code) > 0;
  return in_doubt || !gate.not_asked.empty() ? exit_undecided : exit_pass;
}

}  // namespace cyl
