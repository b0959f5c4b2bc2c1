// SPDX-License-Identifier: MIT
#include "props/gate/gate.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/files.hpp"
#include "base/process/stop_signals.hpp"
#include "base/safe_text.hpp"
#include "base/source_tree.hpp"
#include "base/times.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/case_files.hpp"
#include "reports/gate/failure_text.hpp"
#include "reports/gate/gate_json.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

struct GateArguments {
  std::string cap, methods, junit, json, against, keep;
  std::optional<std::string> cases;
  std::optional<std::uint64_t> seed, pairs;
  bool laws = false;
  GuestOptions guests;
};

constexpr const char* our_methods = "intersect,decide,distance,exact";

/// Returns the failures as lines of a case file, to be kept beside the other cases.
std::string case_lines(const JudgedGate& gate) {
  std::string lines;
  for (const JudgedFailure& failure : gate.failures) {
    if (!is_error(failure)) continue;
    Case c;
    c.pair = failure.simplest;
    c.id = failure.cause;
    c.source = fmt::format("daylight gate, simplified from {}", failure.origin);
    c.note = fmt::format("{} breaks law {}, {}: {}", failure.method, failure.law->number, failure.law->name,
                         failure.what_of_simplest.empty() ? failure.what : failure.what_of_simplest);
    lines += format_case(c) + '\n';
  }
  return lines;
}

GateReport run_with_progress(std::span<const std::unique_ptr<Method>> methods, std::span<const Case> cases,
                             const GateOptions& options) {
  ProgressLine line;
  return run_gate(methods, cases, options, [&](const GateProgress& p) {
    if (!line.due()) return;
    line.show(p.share, fmt::format("{}: {}, {}", to_string(p.phase), counted(p.pairs, "pair"),
                                   counted(p.failures, "failing cause")));
  });
}

int gate(const GateArguments& arguments) {
  if (arguments.laws) {
    for (const Law& law : all_laws())
      fmt::print("{:>3} {:<12} {:<12} {}\n{:30}({})\n", law.number, to_string(law.kind), law.name,
                 law.statement, "", law.where);
    return exit_pass;
  }
  GateOptions options;
  MethodSet set = with_guests(arguments.guests, arguments.methods, true);
  const std::vector<Guest> guests = set.guests;
  const auto methods = std::move(set).select(arguments.methods, our_methods);
  options.seed = arguments.seed.value_or(options.seed);
  options.pairs = arguments.pairs.value_or(options.pairs);
  if (!arguments.cap.empty()) options.cap = parse_duration(arguments.cap);
  const std::string folder = arguments.cases ? *arguments.cases : in_source_tree("corpus/cases");
  const std::vector<Case> cases = folder.empty() ? std::vector<Case>{} : read_case_folder(folder);
  GateBase base;
  if (!arguments.against.empty()) {
    base = read_base(arguments.against);
    options.seed = base.seed;
    options.pairs = base.pairs;
    options.amount = base.amount;
  }
  const StopSignals signals;  // before the first line, after which a caller may stop the gate
  fmt::print("seed {}\n", options.seed);
  std::fflush(stdout);

  options.stopped = StopSignals::asked;
  JudgedGate result = judged(run_with_progress(methods, cases, options));
  mark_known(result, base);
  note_gaps(result, base);
  for (const Guest& guest : guests)
    for (JudgedFailure& failure : result.failures)
      if (failure.method == guest.name) failure.options = options_for(guest);
  fmt::print("{}", gate_text(result));
  if (!arguments.junit.empty()) write_file(arguments.junit, gate_junit(result));
  if (!arguments.json.empty()) write_file(arguments.json, gate_json(result));
  if (!arguments.keep.empty()) write_file(arguments.keep, case_lines(result));
  return exit_code(result);
}

}  // namespace

void add_gate(Program& program) {
  Command command = program.command(
      "Guard", "gate", "Tests methods before a merge: on all known cases, all laws, and random pairs");
  auto arguments = std::make_shared<GateArguments>();
  command.section("Limits");
  command
      .number("--pairs N", arguments->pairs, "number of random pairs, rounded up, in addition to the cases",
              1)
      .default_text(std::to_string(gate_pairs));
  command.option("--for DURATION", arguments->cap,
                 "limit of wall time, such as 40s; if it skips pairs, the exit code is 3");
  command.section("Methods");
  command
      .option("--method LIST", arguments->methods,
              "methods that must pass: names or prefixes, separated by commas")
      .default_text("your plug-ins and commands, else ours");
  add_guest_options(command, arguments->guests);
  command.section("Pairs");
  command.number("--seed N", arguments->seed, "seed; the same seed and number of pairs give the same pairs")
      .default_text(std::to_string(GateOptions{}.seed));
  command.option("--cases DIR", arguments->cases, "folder of known cases to run first; '' for none")
      .default_text("corpus/cases/");
  command.section("Output");
  command.option("--junit FILE", arguments->junit, "write JUnit XML").writable();
  command
      .option("--json FILE", arguments->json, "write the failures and what was asked as JSON, for --against")
      .writable();
  command.option("--keep FILE", arguments->keep, "write the simplified failing pairs as a case file")
      .writable();
  command.flag("--laws", arguments->laws, "only list the laws");
  command.section("Baseline");
  command
      .option("--against FILE", arguments->against,
              "rerun the pairs of this earlier gate's JSON, and fail only on new or more frequent causes")
      .excludes("--pairs")
      .excludes("--seed");
  command.examples(
      "  daylight gate --method fcl --junit gate.xml\n"
      "  daylight gate --plugin ./libmine.so --claim 1e-6 --against main.json",
      "Exit code 2 of gate means broken laws, verdicts that are proved wrong, crashes or hangs. 3 can\n"
      "also mean that a method gave no verdict on more than half of its pairs.");
  command.run([arguments] { return gate(*arguments); });
}

}  // namespace cyl
