// SPDX-License-Identifier: MIT
// The gate's result as JUnit XML, the form that build servers read.
#pragma once

#include <string>

#include "props/gate/gate.hpp"

namespace cyl {

/// One testsuite a method; in it one testcase a law ("law 10 growth"), and one for each kept case on which it
/// failed. What does not fail the gate (within the claim, or known) is told in the suite's system-out. What
/// was not asked is a suite of its own, with a test in error a line. The
/// time is that of the whole gate: methods are asked side by side.
std::string gate_junit(const GateReport& report);

}  // namespace cyl
