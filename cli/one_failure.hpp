// SPDX-License-Identifier: MIT
// One method's failure on one pair, as the command line of `explain` and `export` names it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cli/guests.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

struct OneFailure {
  std::string method;
  FindingKind kind;
  Pair pair;
};

/// The options of `explain` and `export` that name a failure: a pair, or a cause of a triaged run.
struct FailureOptions {
  std::string target, key, method, kind;
  GuestOptions guests;
};
void add_failure_options(Command& command, FailureOptions& options);

/// Returns the failure that the command line names. A cause stands for the failure of its shown method on
/// pair_to_send(), or for one of --method. If export refuses that pair, it stands for the first stored
/// failure that export takes. Missing parts come from the stored finding, else from a new answer. Throws
/// UsageError if the command line names neither exactly one pair nor a cause, or if the method is right on
/// the pair.
OneFailure failure_of(const FailureOptions& options, std::span<const std::unique_ptr<Method>> methods);

}  // namespace cyl
