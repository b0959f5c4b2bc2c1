// SPDX-License-Identifier: MIT
#include "fuzz/campaign/merge.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/show_run.hpp"

namespace cyl {
namespace {

struct MergeArguments {
  std::vector<std::string> runs;
  std::string out;
  bool table = false;
};

int merge(const MergeArguments& arguments) {
  const MergeSummary summary = merge_runs(arguments.runs, arguments.out);
  point_latest_at(arguments.out);
  show_run(arguments.out, arguments.table);
  if (!summary.incomplete.empty()) {
    fmt::print("incomplete: every index below {} was done, and some after it\n", summary.whole_below);
    for (const std::string& line : summary.incomplete) fmt::print("  {}\n", line);
  }
  return exit_code(summary);
}

}  // namespace

void add_merge(Program& program) {
  Command command = program.command("Find", "merge", "Makes one run of the shards of a campaign");
  auto arguments = std::make_shared<MergeArguments>();
  command.option("RUN", arguments->runs, "the folders of the shards").required();
  command.option("--out", arguments->out, "run folder; one that was merged before is replaced").required();
  command.flag("--table", arguments->table, "print every method's counts too");
  command.examples(
      "  daylight merge runs/night/shard-* --out runs/night",
      "Here 3 also: a shard is missing or did not reach its limit, 1 also: the harness failed in one.");
  command.run([arguments] { return merge(*arguments); });
}

}  // namespace cyl
