// SPDX-License-Identifier: MIT
// Compares suppressions (corpus/store/suppressions.hpp) with what is stored and with a gate's failures.
#pragma once

#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/store/case_files.hpp"
#include "corpus/store/suppressions.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/mechanism.hpp"
#include "reports/gate/judged_gate.hpp"

namespace cyl {

/// Returns the causes, by cause_key(), of what methods get wrong on the cases; contained. Asks only methods
/// of libraries that a suppression names, because the causes of others do not matter. Cost: up to some
/// seconds for each of these.
std::set<std::string> causes_of(const GroupedMethods& of, std::span<const Case> cases,
                                const std::vector<Suppression>& suppressions);

/// Marks a failure of a gate as known if its bucket is suppressed, or the cause of each answer beyond the
/// claim that its law compares. Such answers explain no failure of a law that repeats a question. Cost: up to
/// some tenths of a second for a law of several answers. Adds the remarks on suppressions. `methods` holds
/// the methods of this build and the guests, because a key does not depend on which of them the gate tests.
void judge_suppressions(JudgedGate& gate, std::span<const std::unique_ptr<Method>> methods,
                        std::span<const Case> cases, const std::vector<Suppression>& suppressions,
                        std::string_view today);

/// Returns a remark for each suppression that has expired. Returns one that fails the gate for each
/// suppression whose cause is not in `causes`, those of the stored cases.
std::vector<GateRemark> suppression_remarks(const std::vector<Suppression>& suppressions,
                                            std::string_view today, const std::set<std::string>& causes);

}  // namespace cyl
