// SPDX-License-Identifier: MIT
#include "reports/export/export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
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
  std::string target, key, method, kind, out;
  GuestOptions guests;
};

/// The time limit for a build and for a program that does not end.
constexpr std::chrono::minutes build_cap{5};

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

/// Returns the first stored failure with the cause that fits.
std::optional<OneFailure> stored_failure(const std::string& run, const nlohmann::json& cause,
                                         const std::function<bool(const OneFailure&)>& fits) {
  const auto ids = cause.at("findings").get<std::set<std::int64_t>>();
  for (const FindingRecord& f : RunStore::open(run).findings())
    if (ids.contains(f.id))
      if (const CaseLine line = parse_case(f.pair, 1); line.value)
        if (OneFailure found{f.method, f.kind, line.value->pair}; fits(found)) return found;
  return {};
}

/// A cause stands for the failure of its shown method on pair_to_send(), or for one of --method. If export
/// refuses that pair, it stands for the first stored failure that export takes.
OneFailure failure_with_cause(const ExportArguments& options,
                              std::span<const std::unique_ptr<Method>> methods) {
  const std::string run = lasting_name(options.target);
  const nlohmann::json cause = find_cause(run, options.key);
  const auto names = cause.at("methods").get<std::vector<std::string>>();
  OneFailure failure{cause.at("method"), kind_of_word(cause.at("kind")), pair_in(cause.at("simplest"))};
  if (!options.method.empty()) {
    if (std::ranges::find(names, options.method) == names.end())
      throw UsageError(fmt::format("cause '{}' has the methods {}", options.key, fmt::join(names, ", ")));
    failure.method = options.method;
    const auto asked = position_of(methods, options.method);
    if (asked && !try_method(methods[*asked], failure.pair).fails(failure.kind))
      failure = stored_failure(run, cause, [&](const OneFailure& f) {
                  return f.method == options.method;
                }).value_or(failure);
  }
  const auto method = position_of(methods, failure.method);
  if (const auto worst = cause.find("worst"); method && worst != cause.end() && worst->is_object())
    failure.pair = pair_to_send(methods[*method], failure.kind, failure.pair, pair_in(*worst));
  const auto can_be_sent = [&](const OneFailure& f) {
    const auto m = position_of(methods, f.method);
    return m && (options.method.empty() || f.method == options.method) &&
           refusal(f.method, f.kind, f.pair, methods[*m]->guest()).empty() &&
           try_method(methods[*m], f.pair).fails(f.kind);
  };
  if (!can_be_sent(failure)) failure = stored_failure(run, cause, can_be_sent).value_or(failure);
  if (options.method.empty() && names.size() > 1)
    fmt::print("the methods {} share this cause, and this is about {} (--method selects another)\n",
               fmt::join(names, ", "), failure.method);
  return failure;
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
  if (!options.kind.empty()) return {name, kind_of_word(options.kind), target.pair};
  if (stored) return {name, target.finding->kind, target.pair};
  const Trial now = try_method(find_method(methods, name), target.pair);
  if (!now.finding())
    throw UsageError(fmt::format("{} is right on {}: it answers {}, and the solids are {}", name,
                                 target.label, format_method_answer(now.answer()), distance_in_words(now)));
  return {name, now.finding()->kind, target.pair};
}

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
  command.option("--kind KIND", arguments->kind, "kind of failure, such as wrong_disjoint")
      .default_text("the finding's kind, or that of a fresh answer");
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
