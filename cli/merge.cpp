// SPDX-License-Identifier: MIT
#include "fuzz/campaign/merge.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/show_run.hpp"

namespace cyl {
namespace {

struct Arguments {
  std::vector<std::string> runs;
  std::string out;
};

int merge(const Arguments& arguments) {
  const MergeSummary summary = merge_runs(arguments.runs, arguments.out);
  point_latest_at(arguments.out);
  show_run(arguments.out, summary.progress.done);
  if (!summary.incomplete.empty()) {
    fmt::print("incomplete: every index below {} was done, and some after it\n", summary.whole_below);
    for (const std::string& line : summary.incomplete) fmt::print("  {}\n", line);
  }
  return exit_code(summary);
}

}  // namespace

void add_merge(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("merge", "Makes one run of the shards of a campaign");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("RUN", arguments->runs, "the folders of the shards")->required();
  command->add_option("--out", arguments->out, "run folder; one that was merged before is replaced")
      ->required();
  command->footer(
      "Example:\n  daylight merge runs/night/shard-* --out runs/night\n"
      "Exit code: as of campaign; 3 also where a shard is missing or did not reach its limit, 1 also where "
      "the "
      "harness failed in one.");
  command->callback([arguments, &exit_code] { exit_code = merge(*arguments); });
}

}  // namespace cyl
