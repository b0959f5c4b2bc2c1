// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "reports/charts.hpp"
#include "reports/curves.hpp"

namespace cyl {
namespace {

struct Arguments {
  std::string run, bench;
};

void chart(const Arguments& arguments) {
  std::vector<BenchRow> rows;
  if (!arguments.bench.empty()) rows = read_bench(arguments.bench);
  write_charts(arguments.run, rows);
  if (!rows.empty()) fmt::print("{}\n", format_curves(speed_points(rows)));
  fmt::print("{}/charts.json\n", arguments.run);
}

}  // namespace

void add_chart(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("chart", "Failure maps of a run, and speed against accuracy, as data: charts.json");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("RUN", arguments->run, "the run's folder")->required()->check(CLI::ExistingDirectory);
  command
      ->add_option("--bench", arguments->bench,
                   "what `daylight bench --curves --json FILE` measured; without it speed and cost stay as "
                   "they are")
      ->check(CLI::ExistingFile);
  command->footer(
      "Example:\n  daylight bench --curves --json bench.json\n"
      "  daylight chart runs/latest --bench bench.json");
  command->callback([arguments, &exit_code] {
    chart(*arguments);
    exit_code = exit_pass;
  });
}

}  // namespace cyl
