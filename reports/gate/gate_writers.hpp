// SPDX-License-Identifier: MIT
// The gate's result as others read it. gate_json.hpp has the one that a later gate reads back.
#pragma once

#include <cstddef>
#include <string>

#include "reports/gate/judged_gate.hpp"

namespace cyl {

/// Further causes of one law and kind of failure that gate_text() shows; then how many more.
inline constexpr std::size_t also_cap = 5;
/// Breaks in one line each (within claims, or known), of all methods together; then how many more.
inline constexpr std::size_t brief_cap = 20;

/// Returns the report as text. It lists the questions that were not asked, the counts of each method, and
/// each failure with a command that replays it. The proved facts about each method come last. No line is
/// wider than 120 columns, except for pairs and quotations of methods.
std::string gate_text(const JudgedGate& gate);

/// Returns the last lines of one method: what its independent random pairs prove, one fact a line. Cases and
/// laws do not count.
std::string proved_in_words(const GateMethod& method);

/// Returns JUnit XML for build servers: one testsuite for each method, with one testcase for each law ("law
/// 10 growth") and for each case on which it failed. Failures that do not fail the gate (within the claim, or
/// known) are in the suite's system-out. Each line of what was not asked is a test in error, in a suite of
/// its own. The time is that of the whole gate, because methods are asked side by side.
std::string gate_junit(const JudgedGate& gate);

}  // namespace cyl
