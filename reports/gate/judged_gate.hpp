// SPDX-License-Identifier: MIT
// A result of the gate, judged: which failures are known, what is missing against an earlier gate, and how to
// show the failures of a guest. The report itself does not change.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/exit_code.hpp"
#include "props/gate/gate_report.hpp"

namespace cyl {

/// A failure of the report, with what is known about it.
struct JudgedFailure : GateFailure {
  bool known = false;         ///< excused: the base has it on as many pairs
  std::uint64_t in_base = 0;  ///< pairs of the base that failed like this
  std::string options = {};   ///< options that add a guest, else empty
};

/// A line about the gate as a whole, such as a doubt, and the exit code that it leads to.
struct GateRemark {
  std::string text;
  int exit_code = exit_pass;
};

struct JudgedGate {
  GateReport report;
  std::vector<JudgedFailure> failures;   ///< those of the report, in its order
  std::vector<std::string> not_asked;    ///< lines of the report, and what later steps add
  std::vector<GateRemark> remarks = {};  ///< the doubts of the report, and what later steps add
};

/// Returns a judged report without known failures.
JudgedGate judged(GateReport report);

/// Returns whether a failure is an error that is not known.
bool fails_gate(const JudgedFailure& failure);

/// Returns 2 if a failure fails the gate. Else returns 3 if a remark leaves doubt or something
/// was not asked, or 0.
int exit_code(const JudgedGate& gate);

}  // namespace cyl
