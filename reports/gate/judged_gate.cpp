// SPDX-License-Identifier: MIT
#include "reports/gate/judged_gate.hpp"

#include <algorithm>
#include <utility>

#include "base/exit_code.hpp"

namespace cyl {

JudgedGate judged(GateReport report) {
  JudgedGate gate{std::move(report), {}, {}};
  for (const GateFailure& failure : gate.report.failures)
    gate.failures.push_back({failure, false, 0, {}, {}});
  gate.not_asked = gate.report.not_asked;
  return gate;
}

bool fails_gate(const JudgedFailure& failure) { return is_error(failure) && !failure.known; }

int exit_code(const JudgedGate& gate) {
  if (std::any_of(gate.failures.begin(), gate.failures.end(), fails_gate)) return exit_findings;
  if (std::ranges::any_of(gate.remarks, &SuppressionRemark::fails)) return exit_findings;
  return leaves_doubt(gate.report) || !gate.not_asked.empty() ? exit_undecided : exit_pass;
}

}  // namespace cyl
