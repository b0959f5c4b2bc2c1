// SPDX-License-Identifier: MIT
#include "fuzz/campaign/merge.hpp"

#include <fmt/format.h>

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
  Command command = program.command("Find", "merge", "Merges the shards of a campaign into one run");
  auto arguments = std::make_shared<MergeArguments>();
  command.option("RUN", arguments->runs, "folders of the shards").required();
  command.section("Output");
  command.option("--out DIR", arguments->out, "run folder; an earlier merge there is replaced").required();
  command.flag("--table", arguments->table, "also print the counts of each method");
  command.examples(
      "  daylight merge runs/night/shard-* --out runs/night\n"
      "  daylight merge shard-0 shard-1 --out whole --table",
      "Exit code 3 of merge also means that a shard is missing or stopped before its limit. Exit code 1\n"
      "also means that daylight failed in a shard.");
  command.run([arguments] { return merge(*arguments); });
}

}  // namespace cyl
