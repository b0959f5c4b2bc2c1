// SPDX-License-Identifier: MIT
// The pairs that a command line names for another run: stored findings and cases.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/store/run_store.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// One thing to run again: a stored finding, or a case on which anything may be wrong.
struct Target {
  std::string label;
  Pair pair;
  std::optional<FindingRecord> finding;
};

/// Returns the folder that a link like runs/latest leads to, which is named the same tomorrow; any other as
/// it is.
std::string lasting_name(const std::string& folder);

/// Returns the pairs of `name`. RUN: all its findings; RUN:ID: one. FILE: all its cases; FILE:LINE: one. "-":
/// the cases of standard input. Throws UsageError if the name is none of these, and InputError if a line is
/// not a case.
std::vector<Target> targets_of(const std::string& name);

}  // namespace cyl
