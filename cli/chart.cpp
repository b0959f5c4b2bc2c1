// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/process/child.hpp"
#include "base/source_tree.hpp"
#include "bench/curves.hpp"
#include "bench/paths.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "cli/targets.hpp"
#include "reports/run/charts.hpp"
#include "reports/run/report_data.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

struct ChartArguments {
  std::string run, bench, out;
  bool stability = false;
};

/// Draws the charts as SVG files in `out`, which it makes, by Node.js. Returns their names.
std::vector<std::string> draw_charts(const RunData& data, const std::string& out) {
  const std::string script = in_source_tree("reports/web/chart.mjs");
  if (Child({"/bin/sh", "-c", "command -v node >/dev/null 2>&1"}, {}).wait() != 0)
    throw std::runtime_error("charts need Node.js: apt-get install nodejs");
  if (script.empty()) throw std::runtime_error("reports/web/chart.mjs is not beside this program");
  const auto began = fs::file_time_type::clock::now();
  // The paths are absolute, so that Node.js does not take them for options.
  const std::vector<std::string> command{"node", fs::absolute(script).string(), fs::absolute(out).string()};
  if (Child(command, {.input = report_json(data)}).wait() != 0)
    throw std::runtime_error("node " + script + " failed");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(out))
    if (entry.path().extension() == ".svg" && entry.last_write_time() >= began)
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

void chart(const ChartArguments& arguments) {
  std::vector<BenchRow> rows;
  if (!arguments.bench.empty()) rows = read_bench(arguments.bench);
  RunData run = read_run(arguments.run);
  write_charts(run, rows);
  if (!rows.empty()) set_charts(run, {{"speed_on", origin_of_bench(arguments.bench)}});
  if (arguments.stability)
    set_charts(run,
               {{"paths", paths_json(path_stability(methods_for_targets({}, {arguments.run}).methods))}});
  write_page(run);
  if (!rows.empty()) fmt::print("{}\n", format_curves(speed_points(rows)));
  fmt::print("{}/report.html\n", arguments.run);
  if (arguments.out.empty()) return;
  for (const std::string& file : draw_charts(run, arguments.out)) fmt::print("{}\n", file);
}

}  // namespace

void add_chart(Program& program) {
  Command command =
      program.command("Understand", "chart",
                      "Draws speed against accuracy and maps of failures, on the page of a run and as files");
  auto arguments = std::make_shared<ChartArguments>();
  command.option("RUN", arguments->run, "run folder").required().existing_folder();
  command.section("Input");
  command
      .option("--bench FILE", arguments->bench,
              "results of daylight bench --curves --json; without it, earlier curves stay")
      .existing_file();
  command.flag("--stability", arguments->stability,
               "also measure how steady the answers are along paths of pairs");
  command.section("Output");
  command.option("--out DIR", arguments->out, "folder for SVG files; requires Node.js");
  command.examples(
      "  daylight bench --curves --json bench.json\n"
      "  daylight chart runs/latest --bench bench.json --stability --out charts",
      "The exit codes 2 and 3 do not occur for chart.");
  command.run([arguments] {
    arguments->run = lasting_name(arguments->run);
    chart(*arguments);
    return exit_pass;
  });
}

}  // namespace cyl
