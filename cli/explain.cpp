// SPDX-License-Identifier: MIT
#include "reports/explain/explain.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <string>

#include "base/files.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/one_failure.hpp"
#include "cli/options.hpp"

namespace cyl {
namespace {

struct ExplainArguments {
  FailureOptions failure;
  std::string json;
  std::uint64_t seed = explain_seed_default;
};

int explain_case(const ExplainArguments& arguments) {
  const auto methods = methods_for_targets(arguments.failure.guests, {arguments.failure.target}).methods;
  const OneFailure failure = failure_of(arguments.failure, methods);
  fmt::print("seed {}\n", arguments.seed);
  std::fflush(stdout);
  const Explanation e = explain(methods, failure.method, failure.kind, failure.pair, arguments.seed);
  if (!arguments.json.empty()) write_file(arguments.json, explanation_json(e));
  fmt::print("{}", explanation_text(e));
  return exit_pass;
}

}  // namespace

void add_explain(Program& program) {
  Command command = program.command("Understand", "explain", "Reports why a method is wrong on one pair");
  auto arguments = std::make_shared<ExplainArguments>();
  add_failure_options(command, arguments->failure);
  command.section("Pairs");
  command.number("--seed N", arguments->seed, "seed of the pairs drawn from the stratum of the pair");
  command.section("Output");
  command.option("--json FILE", arguments->json, "write everything as JSON, each end with its pair and proof")
      .writable();
  command.examples(
      "  daylight explain runs/latest:12\n"
      "  daylight explain runs/latest fcl-libccd/overflow\n"
      "  daylight explain failing.jsonl:3 --method fcl-libccd --json why.json",
      "Exit code 64 of explain also means that the method is not wrong on that pair. 2 and 3 do not occur.");
  command.run([arguments] { return explain_case(*arguments); });
}

}  // namespace cyl
