// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/source_tree.hpp"
#include "reports/draw_charts.hpp"

namespace cyl {
namespace {

struct Arguments {
  std::string run, out;
};

void chart(const Arguments& arguments) {
  for (const std::string& file :
       draw_charts(arguments.run, arguments.out, in_source_tree("reports/page/chart.mjs")))
    fmt::print("{}\n", file);
}

}  // namespace

void add_chart(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("chart", "Draws the plots of a run's page as files");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("RUN", arguments->run, "the run's folder")->required()->check(CLI::ExistingDirectory);
  command->add_option("--out", arguments->out, "folder for the files, made where it is not there")
      ->required();
  command->footer(
      "Example:\n  daylight chart runs/latest --out charts\n"
      "SVG, and PNG where rsvg-convert is there; maps and curves of one method a library. Needs Node.js (apt-get install nodejs).");
  command->callback([arguments, &exit_code] {
    chart(*arguments);
    exit_code = exit_pass;
  });
}

}  // namespace cyl
