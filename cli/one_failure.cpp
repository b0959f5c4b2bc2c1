// SPDX-License-Identifier: MIT
#include "cli/one_failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <vector>

#include "base/own_command.hpp"
#include "base/process/child.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/targets.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/export/export.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// The time limit for a build and for a program that does not end.
constexpr std::chrono::minutes build_cap{5};

/// The output of a folder's build.sh, and how it ends.
struct Ran {
  std::string printed;
  int status = 0;
};

Ran run_build(const fs::path& folder) {
  const auto deadline = std::chrono::steady_clock::now() + build_cap;
  Child child({"sh", "-c", "exec sh \"$0\" 2>&1", (folder / "build.sh").string()}, {.own_group = true});
  while (!child.advance()) {
    if (std::chrono::steady_clock::now() > deadline) child.kill_now();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {child.bytes(), child.status()};
}

/// Returns whether the program, built and run in its own folder, shows the failure. False if it could not be
/// built. Throws std::runtime_error if it ran without a failure.
bool shows_failure(const Export& files) {
  std::string name = (fs::temp_directory_path() / "daylight-export-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + " cannot be made");
  const std::shared_ptr<void> removed(nullptr, [&](void*) {
    std::error_code none;
    fs::remove_all(name, none);
  });
  write_export(files, name);
  const Ran ran = run_build(name);
  if (!fs::exists(fs::path(name) / "reproduce")) return false;
  if (!WIFEXITED(ran.status) || WEXITSTATUS(ran.status) != 0) return true;
  throw std::runtime_error(
      "the program that would be sent does not show the failure, so nothing is written. It printed:\n" +
      ran.printed);
}

}  // namespace

FindingKind kind_of_word(const std::string& word) {
  if (const auto kind = from_word<FindingKind>(word)) return *kind;
  throw UsageError(fmt::format("'{}' is not a kind of finding", word));
}

void add_failure_options(Command& command, FailureOptions& options) {
  command.option("CASE", options.target, "RUN:ID, FILE:LINE, or a file of one case").required();
  command.section("Methods");
  command.option("--method NAME", options.method, "the method that is wrong")
      .default_text("the method of the finding");
  command.option("--kind KIND", options.kind, "kind of failure, such as wrong_disjoint")
      .default_text("the kind of the finding, or of the answer now");
  add_guest_options(command, options.guests);
  add_run_guests_option(command, options.guests);
}

OneFailure failure_of(const FailureOptions& options, std::span<const std::unique_ptr<Method>> methods) {
  const std::vector<Target> targets = targets_of(options.target);
  if (targets.size() != 1)
    throw UsageError(fmt::format("'{}' has {} pairs: give one pair, as FILE:LINE or RUN:ID", options.target,
                                 targets.size()));
  const Target& target = targets.front();
  const bool stored = target.finding && (options.method.empty() || options.method == target.finding->method);
  const std::string name = stored ? target.finding->method : options.method;
  if (name.empty()) throw UsageError("give the method with --method NAME");
  if (!options.kind.empty()) return {name, kind_of_word(options.kind), target.pair};
  if (stored) return {name, target.finding->kind, target.pair};
  const Trial now = try_method(find_method(methods, name), target.pair);
  if (!now.finding())
    throw UsageError(fmt::format("{} is right on {}: it answers {}, and the solids are {}", name,
                                 target.label, format_method_answer(now.answer()), distance_in_words(now)));
  return {name, now.finding()->kind, target.pair};
}

int export_failure(const MethodSet& set, const OneFailure& failure, const std::string& folder) {
  const auto guest = std::ranges::find(set.guests, failure.method, &Guest::name);
  const bool is_guest = guest != set.guests.end();
  const Export files = make_export(set.methods, failure.method, failure.kind, failure.pair,
                                   is_guest ? &*guest : nullptr, failure.worst);
  const bool shown = is_guest || shows_failure(files);
  write_export(files, folder);
  std::vector<std::string_view> names;
  for (const auto& [name, text] : files) names.push_back(name);
  fmt::print("{}, {}: {}/{}\n", failure.method, to_string(failure.kind), folder, fmt::join(names, ", "));
  if (is_guest)
    fmt::print("ask it again: {}\n", command_for(own_command(), folder + "/case.jsonl", *guest));
  else
    fmt::print("{}\n", shown ? "tested: it was built and run here, and shows the failure"
                             : "not tested: it could not be built here; sh build.sh in that folder shows the "
                               "reason");
  return shown ? exit_pass : exit_undecided;
}

}  // namespace cyl
