// SPDX-License-Identifier: MIT
// One method's failure on one pair, which can be explained and sent to the maintainers of the method.
#pragma once

#include <memory>
#include <optional>
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
  std::optional<Pair> worst{};  ///< of the same cause
};

/// Throws UsageError if the word is not a kind of finding.
FindingKind kind_of_word(const std::string& word);

/// The options of `explain` and `export` that name a failure.
struct FailureOptions {
  std::string target, method, kind;
  GuestOptions guests;
};
void add_failure_options(Command& command, FailureOptions& options);

/// Returns the failure that the command line names. Missing parts come from the stored finding, else from a
/// new answer. Throws UsageError if it does not name exactly one pair, or if the method is right on it.
OneFailure failure_of(const FailureOptions& options, std::span<const std::unique_ptr<Method>> methods);

/// Writes make_export() into the folder, and prints what it wrote. A program for a packaged library is built
/// and run first. Returns exit_undecided if it could not be built here. Throws std::runtime_error, and writes
/// nothing, if it does not show the failure.
int export_failure(const MethodSet& set, const OneFailure& failure, const std::string& folder);

}  // namespace cyl
