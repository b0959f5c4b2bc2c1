// SPDX-License-Identifier: MIT
#include "cli/one_failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <vector>

#include "base/json.hpp"
#include "base/own_command.hpp"
#include "base/process/child.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/targets.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/export/export.hpp"
#include "reports/triage/triage.hpp"

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

FindingKind kind_of_word(const std::string& word) {
  if (const auto kind = from_word<FindingKind>(word)) return *kind;
  throw UsageError(fmt::format("'{}' is not a kind of finding", word));
}

/// Returns the cause that has that key in the last triage.
nlohmann::json find_cause(const std::string& run, const std::string& key) {
  if (!fs::is_directory(run)) throw UsageError(fmt::format("'{}' is not a run, so it has no causes", run));
  const nlohmann::json causes = causes_json(run);
  for (const nlohmann::json& cause : causes)
    if (cause.at("key") == key) return cause;
  throw UsageError(fmt::format("{0} has no cause '{1}': `daylight triage {0}` lists its {2} causes", run, key,
                               causes.size()));
}

Pair pair_in(const nlohmann::json& shown) {
  return parse_case(shown.at("pair").dump(), 1).value.value().pair;
}

/// Returns the first stored failure of a method with the cause.
std::optional<OneFailure> stored_failure(const std::string& run, const nlohmann::json& cause,
                                         const std::string& method) {
  const auto ids = cause.at("findings").get<std::set<std::int64_t>>();
  for (const FindingRecord& f : RunStore::open(run).findings())
    if (ids.contains(f.id) && f.method == method)
      if (const CaseLine line = parse_case(f.pair, 1); line.value)
        return OneFailure{f.method, f.kind, line.value->pair};
  return {};
}

OneFailure failure_with_cause(const FailureOptions& options,
                              std::span<const std::unique_ptr<Method>> methods) {
  const std::string run = lasting_name(options.target);
  const nlohmann::json cause = find_cause(run, options.key);
  const auto names = cause.at("methods").get<std::vector<std::string>>();
  OneFailure failure{cause.at("method"), kind_of_word(cause.at("kind")), pair_in(cause.at("simplest"))};
  if (!options.method.empty()) {
    if (std::ranges::find(names, options.method) == names.end())
      throw UsageError(fmt::format("cause '{}' has the methods {}", options.key, fmt::join(names, ", ")));
    failure.method = options.method;
    const auto method = position_of(methods, options.method);
    if (method && !try_method(methods[*method], failure.pair).fails(failure.kind))
      failure = stored_failure(run, cause, options.method).value_or(failure);
  } else if (names.size() > 1) {
    fmt::print("the methods {} share this cause, and this is about {} (--method selects another)\n",
               fmt::join(names, ", "), failure.method);
  }
  if (const auto worst = cause.find("worst"); worst != cause.end() && worst->is_object())
    failure.worst = pair_in(*worst);
  return failure;
}

}  // namespace

void add_failure_options(Command& command, FailureOptions& options) {
  command.option("CASE", options.target, "RUN:ID, FILE:LINE, a file of one case, or RUN with KEY").required();
  command.option("KEY", options.key, "a cause of RUN, as `triage` lists it");
  command.section("Methods");
  command.option("--method NAME", options.method, "the method that is wrong")
      .default_text("the method of the finding");
  command.option("--kind KIND", options.kind, "kind of failure, such as wrong_disjoint")
      .default_text("the kind of the finding, or of the answer now");
  add_guest_options(command, options.guests);
  add_run_guests_option(command, options.guests);
}

OneFailure failure_of(const FailureOptions& options, std::span<const std::unique_ptr<Method>> methods) {
  if (!options.key.empty()) return failure_with_cause(options, methods);
  const std::vector<Target> targets = targets_of(options.target);
  if (targets.size() != 1)
    throw UsageError(
        fmt::format("'{}' has {} pairs: give one pair, as FILE:LINE or RUN:ID, or a cause, as RUN KEY",
                    options.target, targets.size()));
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
