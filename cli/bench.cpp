// SPDX-License-Identifier: MIT
#include "reports/bench.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/unsigned_option.hpp"
#include "corpus/pair_io.hpp"

namespace cyl {

namespace {

void write_json(const std::string& file, const std::vector<BenchRow>& rows) {
  const BuildInfo info = build_info();
  std::ofstream out(file);
  out << fmt::format("{{\"commit\":{},\"compiler\":{},\"flags\":{},\"cpu\":{},\"results\":[",
                     quote_json(info.commit), quote_json(info.compiler), quote_json(info.flags),
                     quote_json(info.cpu));
  for (std::size_t i = 0; i < rows.size(); ++i) out << (i == 0 ? "\n" : ",\n") << format_bench_row(rows[i]);
  out << "\n]}\n";
  if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
  struct Options {
    BenchOptions bench;
    std::string json;
  };
  CLI::App* command =
      app.add_subcommand("bench", "Nanoseconds a pair by method and family, faults beside them");
  auto options = std::make_shared<Options>();
  options->bench.families = "random";
  command->add_option("--methods", options->bench.methods,
                      "a,b or (--methods=-a,b) all but these; default all");
  command->add_option("--families", options->bench.families, "the same rule")->capture_default_str();
  add_unsigned(*command, "--pairs", options->bench.pairs, "of each family", 1);
  add_unsigned(*command, "--passes", options->bench.passes, "timed passes", 1);
  add_unsigned(*command, "--seed", options->bench.seed, "of the families");
  command->add_option("--json", options->json, "also write the results to this file");
  command->footer(
      "Example:\n  daylight bench --methods intersect,decide,fcl --families random --json bench.json");
  command->callback([options, &exit_code] {
    fmt::print("seed {}, {} pairs a family, {} passes; {}; {}\n\n", options->bench.seed, options->bench.pairs,
               options->bench.passes, build_info().text(), build_info().cpu);
    std::fflush(stdout);
    const auto rows = bench(options->bench, [](std::string_view what) { std::cerr << what << std::endl; });
    fmt::print("{}", format_bench_table(rows));
    if (!options->json.empty()) write_json(options->json, rows);
    exit_code = exit_pass;
  });
}

}  // namespace cyl
