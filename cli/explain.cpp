// SPDX-License-Identifier: MIT
#include "reports/explain/explain.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "base/files.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/one_failure.hpp"
#include "cli/targets.hpp"
#include "cli/unsigned_option.hpp"
#include "oracles/trial/probe.hpp"

namespace cyl {
namespace {

struct Arguments {
  std::string target, method, kind, out, json;
  std::uint64_t seed = explain_seed_default;
  GuestOptions guests;
};

/// What the command line names; what it leaves out is taken from the stored finding, else found by asking.
OneFailure failure_of(const Arguments& arguments, std::span<const std::unique_ptr<Method>> methods) {
  const std::vector<Target> targets = targets_of(arguments.target);
  if (targets.size() != 1)
    throw UsageError(
        fmt::format("'{}' names {} pairs; give one: FILE:LINE or RUN:ID", arguments.target, targets.size()));
  const Target& target = targets.front();
  const bool stored =
      target.finding && (arguments.method.empty() || arguments.method == target.finding->method);
  const std::string name = stored ? target.finding->method : arguments.method;
  if (name.empty()) throw UsageError("which method? Give --method NAME");
  const std::string word = !arguments.kind.empty() ? arguments.kind : stored ? target.finding->kind : "";
  if (!word.empty()) return {name, kind_of_word(word), target.pair};
  const Probe now = probe_one(find_method(methods, name), target.pair);
  if (!now.finding)
    throw UsageError(fmt::format("{} is not wrong on {}: it says {}, and they are {}", name, target.label,
                                 format_method_answer(now.answer), distance_in_words(now)));
  return {name, now.finding->kind, target.pair};
}

void add_common(CLI::App& command, Arguments& arguments) {
  command.add_option("CASE", arguments.target, "RUN:ID, FILE:LINE, or a FILE of one case")->required();
  command.add_option("--method", arguments.method, "who is wrong; a stored finding says it itself");
  command.add_option("--kind", arguments.kind, "how, like wrong_disjoint; asked where not given");
  add_guest_options(command, arguments.guests);
}

int explain_case(const Arguments& arguments) {
  const auto methods = company_for(arguments.guests, {arguments.target}).methods;
  const OneFailure failure = failure_of(arguments, methods);
  fmt::print("seed {}\n", arguments.seed);
  std::fflush(stdout);
  const Explanation e = explain(methods, failure.method, failure.kind, failure.pair, arguments.seed);
  if (!arguments.json.empty()) write_file(arguments.json, explanation_json(e));
  fmt::print("{}", explanation_text(e));
  return exit_pass;
}

int export_case(const Arguments& arguments) {
  const Company company = company_for(arguments.guests, {arguments.target});
  export_failure(company, failure_of(arguments, company.methods), arguments.out);
  return exit_pass;
}

void describe_explain(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("explain", "Says why a method is wrong on one pair");
  add_common(*command, *arguments);
  add_unsigned(*command, "--seed", arguments->seed, "of the pairs drawn from the pair's stratum");
  command->add_option("--json", arguments->json,
                      "write everything as JSON, each end with its pair and proof");
  command->footer(
      "Example:\n  daylight explain runs/latest:12\n"
      "Exit code: 0 explained, 1 the harness failed, 64 usage, or the method is not wrong there.");
  command->callback([arguments, &exit_code] { exit_code = explain_case(*arguments); });
}

void describe_export(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("export", "Writes a finding as one would send it to the library's maintainers");
  add_common(*command, *arguments);
  command->add_option("--out", arguments->out, "folder for the files")->required();
  command->footer(
      "Example:\n  daylight export runs/latest:12 --out upstream\n"
      "Exit code: 0 written, 1 the harness failed, 64 usage, or the method is not wrong there.");
  command->callback([arguments, &exit_code] { exit_code = export_case(*arguments); });
}

}  // namespace

void add_explain(CLI::App& app, int& exit_code) {
  describe_explain(app, exit_code);
  describe_export(app, exit_code);
}

}  // namespace cyl
