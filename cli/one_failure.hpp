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

/// Throws UsageError where the word is no kind of finding.
FindingKind kind_of_word(const std::string& word);

/// The options of `explain` and `export` that name a failure.
struct FailureOptions {
  std::string target, method, kind;
  GuestOptions guests;
};
void add_failure_options(Command& command, FailureOptions& options);

/// Returns what the command line names; what it leaves out is taken from the stored finding, else found by
/// asking. Throws UsageError where that is no one pair, or the method is not wrong on it.
OneFailure failure_of(const FailureOptions& options, std::span<const std::unique_ptr<Method>> methods);

/// What is sent with a failure: the sources of a guest, and a test in this framework, if any.
struct SendOptions {
  std::vector<std::string> sources;
  std::string framework;
};
void add_send_options(Command& command, SendOptions& options);

/// Builds and runs what make_export() gives, writes it into the folder, and says on standard output what it
/// wrote. Returns the exit code: exit_undecided if the program could not be built or asked here. Throws
/// std::runtime_error, and writes nothing, if it does not show the failure.
int export_failure(const MethodSet& set, const OneFailure& failure, const SendOptions& options,
                   const std::string& folder);

}  // namespace cyl
