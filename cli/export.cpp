// SPDX-License-Identifier: MIT
#include "reports/export/export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/json.hpp"
#include "base/own_command.hpp"
#include "base/process/child.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "cli/targets.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/trial/mechanism.hpp"
#include "reports/triage/triage.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// One method's failure on one pair.
struct OneFailure {
  std::string method;
  FindingKind kind;
  Pair pair;
};

struct ExportArguments {
  std::string target, key, method, out;
  GuestOptions guests;
};

/// The time limit for a build and for a program that does not end.
constexpr std::chrono::minutes build_cap{5};

/// Returns the cause that has that key in the last triage.
Cause find_cause(const std::string& run, const std::string& key) {
  if (!fs::is_directory(run)) throw UsageError(fmt::format("'{}' is not a run, so it has no causes", run));
  const nlohmann::json causes = causes_json(run);
  for (const nlohmann::json& cause : causes)
    if (cause.at("key") == key) return cause_from_json(cause);
  throw UsageError(fmt::format("{0} has no cause '{1}': `daylight triage {0}` lists its {2} causes", run, key,
                               causes.size()));
}

/// Asks the method again if export takes the failure. Returns nothing if it does not, or if the method is
/// right.
std::optional<Trial> asked_again(const OneFailure& f, std::span<const std::unique_ptr<Method>> methods) {
  const auto m = position_of(methods, f.method);
  if (!m || !refusal(f.method, f.kind, f.pair, methods[*m]->guest()).empty()) return {};
  Trial now = try_method(methods[*m], f.pair);
  return now.fails(f.kind) ? std::optional(std::move(now)) : std::nullopt;
}

/// Returns the failure that stands for a cause: of its simplest pair, its worst and its stored findings the
/// first that can be sent and recurs. A pair at the edge of the claim gives way to the worst.
OneFailure failure_with_cause(const ExportArguments& options,
                              std::span<const std::unique_ptr<Method>> methods) {
  const std::string run = lasting_name(options.target);
  const Cause cause = find_cause(run, options.key);
  const std::string name = options.method.empty() ? cause.method : options.method;
  if (!cause.methods.contains(name))
    throw UsageError(
        fmt::format("cause '{}' has the methods {}", options.key, fmt::join(cause.methods, ", ")));
  std::optional<OneFailure> chosen;
  for (const ShownCase& shown : {cause.simplest, cause.worst.value_or(cause.simplest)}) {
    const OneFailure failure{name, cause.kind, shown.pair};
    const auto now = asked_again(failure, methods);
    if (!now) continue;
    const bool clear = is_clear(*now, find_method(methods, name)->claim());
    if (!chosen || clear) chosen = failure;
    if (clear) break;
  }
  const std::vector<FindingRecord> stored =
      chosen ? std::vector<FindingRecord>{} : RunStore::open(run).findings();
  for (std::size_t i = 0; i < stored.size() && !chosen; ++i) {
    const FindingRecord& f = stored[i];
    const CaseLine line = parse_case(f.pair, 1);
    if (std::ranges::count(cause.findings, f.id) == 0 || !line.value ||
        (!options.method.empty() && f.method != name))
      continue;
    if (const OneFailure found{f.method, f.kind, line.value->pair}; asked_again(found, methods))
      chosen = found;
  }
  if (!chosen) chosen = {name, cause.kind, cause.simplest.pair};  // export states why it refuses it
  if (options.method.empty() && cause.methods.size() > 1)
    fmt::print("the methods {} share this cause, and this is about {} (--method selects another)\n",
               fmt::join(cause.methods, ", "), chosen->method);
  return *chosen;
}

/// Returns the failure that the command line names. Missing parts come from the stored finding, else from a
/// new answer. Throws UsageError if the command line names neither exactly one pair nor a cause, or if the
/// method is right on the pair.
OneFailure failure_of(const ExportArguments& options, std::span<const std::unique_ptr<Method>> methods) {
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
  if (stored) return {name, target.finding->kind, target.pair};
  const Trial now = try_method(find_method(methods, name), target.pair);
  if (!now.finding())
    throw UsageError(fmt::format("{} is right on {}: it answers {}, and the solids are {}", name,
                                 target.label, format_method_answer(now.answer()), distance_in_words(now)));
  return {name, now.finding()->kind, target.pair};
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
  const auto deadline = std::chrono::steady_clock::now() + build_cap;
  Child child({"sh", "-c", "exec sh \"$0\" 2>&1", name + "/build.sh"}, {.own_group = true});
  while (!child.advance()) {
    if (std::chrono::steady_clock::now() > deadline) child.kill_now();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (!fs::exists(name + "/reproduce")) return false;
  if (!WIFEXITED(child.status()) || WEXITSTATUS(child.status()) != 0) return true;
  throw std::runtime_error(
      "the program that would be sent does not show the failure, so nothing is written. It printed:\n" +
      child.bytes());
}

/// Writes the export and prints what it wrote. A program for a packaged library is built and run first.
int export_case(const ExportArguments& arguments) {
  const MethodSet set = methods_for_targets(arguments.guests, {arguments.target});
  const OneFailure failure = failure_of(arguments, set.methods);
  const auto guest = std::ranges::find(set.guests, failure.method, &Guest::name);
  const bool is_guest = guest != set.guests.end();
  const Export files =
      make_export(set.methods, failure.method, failure.kind, failure.pair, is_guest ? &*guest : nullptr);
  const bool shown = is_guest || shows_failure(files);
  write_export(files, arguments.out);
  std::vector<std::string_view> names;
  for (const auto& [name, text] : files) names.push_back(name);
  fmt::print("{}, {}: {}/{}\n", failure.method, to_string(failure.kind), arguments.out,
             fmt::join(names, ", "));
  if (is_guest)
    fmt::print("ask it again: {}\n", command_for(own_command(), arguments.out + "/case.jsonl", *guest));
  else
    fmt::print("{}\n", shown ? "tested: it was built and run here, and shows the failure"
                             : "not tested: it could not be built here; sh build.sh in that folder shows the "
                               "reason");
  return shown ? exit_pass : exit_undecided;
}

}  // namespace

void add_export(Program& program) {
  Command command =
      program.command("Understand", "export",
                      "Writes a proof, an issue text and a program or case for the maintainers of a library");
  auto arguments = std::make_shared<ExportArguments>();
  command.option("CASE", arguments->target, "RUN:ID, FILE:LINE, a file of one case, or RUN with KEY")
      .required();
  command.option("KEY", arguments->key, "a cause of RUN, as `triage` lists it");
  command.section("Methods");
  command.option("--method NAME", arguments->method, "the method that is wrong")
      .default_text("the method of the finding");
  add_guest_options(command, arguments->guests);
  add_run_guests_option(command, arguments->guests);
  command.section("Output");
  command.option("--out DIR", arguments->out, "folder for the files").required();
  command.examples(
      "  daylight export runs/latest:12 --out upstream\n"
      "  daylight export runs/latest fcl-libccd/hang --out upstream\n"
      "  daylight export failing.jsonl --method mine --plugin ./libmine.so --out sent",
      "A program for a packaged library is built and run first, and not written if it does not show the\n"
      "failure. Exit code 64 of export also means that the method is not wrong on that pair, and 3 that the\n"
      "program could not be built here.");
  command.run([arguments] { return export_case(*arguments); });
}

}  // namespace cyl
