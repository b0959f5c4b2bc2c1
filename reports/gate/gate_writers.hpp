// SPDX-License-Identifier: MIT
// The gate's result as others read it. gate_json.hpp has the one that a later gate reads back.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "props/gate/gate_report.hpp"

namespace cyl {

/// Further buckets of one law and kind of failure that gate_text() shows; then how many more.
inline constexpr std::size_t also_cap = 5;
/// Breaks in one line each (within claims, or known), of all methods together; then how many more.
inline constexpr std::size_t brief_cap = 20;

/// Returns the report for people: what was not asked, the counts of each method, each failure with a command
/// that replays it, and last what was proved of each method. No line is wider than 120 columns, except for
/// pairs and quotations of methods.
std::string gate_text(const GateReport& report);

/// Returns the last lines of one method: what its independent random pairs prove, one fact a line. Cases and
/// laws do not count.
std::string proved_in_words(const GateMethod& method);

/// Returns JUnit XML, the form that build servers read: one testsuite a method; in it one testcase a law
/// ("law 10 growth"), and one for each kept case on which it failed. What does not fail the gate (within the
/// claim, or known) is in the suite's system-out. What was not asked is a suite of its own, with a test in
/// error a line. The time is that of the whole gate: methods are asked side by side.
std::string gate_junit(const GateReport& report);

/// Returns SARIF 2.1.0, the form in which code hosts take findings: a rule a law, a result a failure.
/// `version` is that of daylight; `compared`: there was a base (--against), so each result is new or
/// unchanged. Failures beyond a claim have the level error, all others note. An invocation that did not ask
/// all has a notification a line of it, and is no success. A result of a method of no build is at the place
/// that it was said to be built from, else at none.
std::string gate_sarif(const GateReport& report, std::string_view version, bool compared);

/// Annotations of one kind that gate_github() writes; the service itself drops those of a step beyond ten.
inline constexpr std::size_t annotations_cap = 10;

/// Returns workflow commands of GitHub Actions, lines of standard output that become annotations of the case
/// or the law, of a method of no build of what it was built from: one ::error for each method, law and kind
/// of failure that fails the gate, in the order of the report; then a ::notice saying how many more there
/// are, and a ::warning for each line of what was not asked. Empty where nothing fails the gate and all was
/// asked.
std::string gate_github(const GateReport& report);

}  // namespace cyl
