// SPDX-License-Identifier: MIT
// What a command line names to be run again: stored findings and kept cases.
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

/// Returns what `name` stands for. RUN: all its findings; RUN:ID: one; FILE: all its cases; FILE:LINE: one;
/// "-": the cases of standard input. Throws UsageError on a name that is none of these, InputError on a line
/// that is no case.
std::vector<Target> targets_of(const std::string& name);

}  // namespace cyl
