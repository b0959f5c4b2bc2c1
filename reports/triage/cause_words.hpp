// SPDX-License-Identifier: MIT
// The description and the labels of a cause, in words.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "oracles/trial/mechanism.hpp"
#include "reports/triage/causes.hpp"
#include "reports/triage/group_findings.hpp"
#include "reports/triage/shown_pair.hpp"

namespace cyl {

/// Returns the cause. `reasons` has the kinds of its findings, each with the method's own words on a failure,
/// which may be empty.
std::string cause_in_words(const std::string& key, Mechanism mechanism,
                           const std::map<FindingKind, std::string>& reasons);

/// Returns the description and the labels of a cause: what applies to how many of its findings, and which
/// other methods are wrong. `simplest_now` holds the answers to its simplest pair.
std::vector<std::string> labels_of(const Cause& cause, const CauseFindings& findings,
                                   const ShownPair& simplest_now, const GroupedMethods& methods);

}  // namespace cyl
