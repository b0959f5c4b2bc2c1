// SPDX-License-Identifier: MIT
#include "reports/triage/triage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "base/safe_text.hpp"
#include "base/times.hpp"
#include "base/usage_error.hpp"
#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/targets.hpp"
#include "reports/run/report_data.hpp"

namespace cyl {
namespace {

struct TriageArguments {
  std::string run, budget, json;
  std::vector<std::string> against;
  unsigned jobs = 2;
  bool new_only = false;
  GuestOptions guests;
};

/// Whether the run has the cause, and the cause is new, or nothing is compared.
bool is_new(const Cause& b) { return b.count > 0 && b.status != Recurrence::known; }

int triage(const TriageArguments& arguments) {
  TriageOptions options;
  options.folder = arguments.run;
  options.against = arguments.against;
  if (!arguments.budget.empty()) options.budget = parse_duration(arguments.budget);
  options.jobs = arguments.jobs;
  options.build = build_info().text();

  const auto methods = methods_for_targets(arguments.guests, {arguments.run}).methods;
  Triage result;
  {
    ProgressLine line;
    result = run_triage(options, methods, [&](const TriageProgress& p) {
      if (!line.due()) return;
      line.show(static_cast<double>(p.elapsed.count()) / static_cast<double>(options.budget.count()),
                fmt::format("{} of {} findings have a cause, {} simplified", p.classified, p.findings,
                            p.simplified));
    });
  }
  const auto here = std::ranges::count_if(result.causes, [](const Cause& b) { return b.count > 0; });
  const auto others = result.causes.size() - static_cast<std::size_t>(here);
  const TriageProgress& p = result.progress;
  const auto remaining = p.findings - p.absent - p.classified;
  std::string changed = what_changed(result.causes);
  if (remaining > 0)
    changed = p.classified == 0 ? "the time was over before a finding was looked at"
                                : fmt::format("{}. {} % of the findings were looked at", changed,
                                              100 * p.classified / (p.classified + remaining));
  if (arguments.new_only) std::erase_if(result.causes, std::not_fn(is_new));
  if (!arguments.json.empty()) write_file(arguments.json, to_json(result.causes).dump(1) + '\n');
  write_page(read_run(arguments.run, std::move(result.findings)));
  fmt::print("{}\n\n", changed);  // after the files, because a pager that ends takes this process with it
  fmt::print("{}{}, {}", format_causes(result.causes), counted(static_cast<std::uint64_t>(here), "cause"),
             counted(p.classified, "stored finding"));
  if (others > 0) fmt::print(", and {} only in other runs", counted(others, "cause"));
  fmt::print("\n{} simplified (--for gives more time)\n", counted(p.simplified, "pair"));
  if (remaining > 0)
    fmt::print("the time was over, and {} findings remain: run triage again to continue\n", remaining);
  if (p.absent > 0) fmt::print("{} findings are of guests that this machine does not have\n", p.absent);
  for (const std::string& remark : result.remarks) fmt::print("{}\n", remark);
  fmt::print("page: {}/report.html\n", arguments.run);
  return exit_code(result);
}

}  // namespace

void add_triage(Program& program) {
  Command command = program.command("Understand", "triage",
                                    "Sorts the findings of a run by cause, each with a simple pair");
  auto arguments = std::make_shared<TriageArguments>();
  command.option("RUN", arguments->run, "run folder").required();
  command.section("Input");
  command.option("--against DIR", arguments->against, "triaged runs to compare with")
      .default_text("the runs in the same folder");
  command.section("Limits");
  command.option("--for DURATION", arguments->budget, "wall time, such as 5m").default_text("30s");
  command.number("--jobs N", arguments->jobs, "processes; the causes do not depend on it", 1, 1024);
  command.section("Methods");
  add_guest_options(command, arguments->guests);
  add_run_guests_option(command, arguments->guests);
  command.section("Output");
  command.option("--json FILE", arguments->json, "write the causes as JSON").writable();
  command.flag("--new-only", arguments->new_only, "report only new causes; only these set exit code 2");
  command.examples(
      "  daylight triage runs/latest --for 2m\n"
      "  daylight triage runs/latest --new-only --json new.json",
      "RUN/triage.sqlite stores the results, and the next triage of the run continues from there.\n"
      "RUN/causes/ has a pair of each cause, the simplest if there was time.\n"
      "Plug-ins and commands are those of the run, unless you give some.\n"
      "Exit code 3 of triage also means that findings remain to be examined.");
  command.run([arguments] {
    arguments->run = lasting_name(arguments->run);
    return triage(*arguments);
  });
}

}  // namespace cyl
