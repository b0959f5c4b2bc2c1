// SPDX-License-Identifier: MIT
// The pairs that a command line names for another run: stored findings and cases.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/store/run_store.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// One thing to run again: a stored finding, or a case on which anything may be wrong.
struct Target {
  std::string label;
  Pair pair;
  std::optional<FindingRecord> finding;
  std::optional<Verdict> stated;  ///< the truth that the case or the run stores
};

/// Returns the folder that a link like runs/latest leads to, which is named the same tomorrow; any other as
/// it is.
std::string lasting_name(const std::string& folder);

/// Returns the pairs of `name`. It is one of five forms.
/// * RUN: all findings of the run.
/// * RUN:ID: one finding.
/// * FILE: all cases of the file.
/// * FILE:LINE: one case.
/// * "-": the cases of standard input.
/// Throws UsageError for any other name, and InputError if a line is not a case.
std::vector<Target> targets_of(const std::string& name);

}  // namespace cyl
