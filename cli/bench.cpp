// SPDX-License-Identifier: MIT
#include "bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>

#include "base/files.hpp"
#include "base/times.hpp"
#include "bench/bench_summary.hpp"
#include "bench/curves.hpp"
#include "cli/build_info.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "reports/run/bench_table.hpp"

namespace cyl {

namespace {

struct BenchArguments {
  BenchOptions bench;
  std::string methods = "all";
  std::string families = "random,margin_1e-06,margin_1e-09";
  std::string json;
  GuestOptions guests;
};

void write_json(const std::string& file, const std::vector<BenchRow>& rows) {
  const BuildInfo info = build_info();
  const nlohmann::ordered_json all{{"commit", info.commit}, {"date", today()}, {"compiler", info.compiler},
                                   {"flags", info.flags},   {"cpu", info.cpu}, {"results", bench_json(rows)}};
  write_file(file, all.dump(1) + '\n');
}

/// Sets the options that --curves or --shapes stands for, unless the command line gives them. Five margins of
/// the 600 pairs have as many pairs as `digits_low` needs. One of 1000 answers may be wrong for `is_right`.
void set_defaults(const Command& command, BenchArguments& options) {
  const auto unless_given = [&](const char* name, auto& option, auto value) {
    if (!command.given(name)) option = value;
  };
  const bool shapes = options.bench.shapes;
  if (!shapes && !options.bench.curves) return;
  unless_given("--families", options.families, shapes ? "all" : "random,margin_1e");
  unless_given("--pairs", options.bench.pairs, std::size_t{shapes ? 1000u : 600u});
  unless_given("--min-time", options.bench.min_time, 0.01);
  unless_given("--passes", options.bench.passes, 3);
}

/// Returns a note on the times of programs. Empty if there are no programs.
std::string through_pipes(const std::vector<Guest>& guests) {
  std::string names;
  for (const Guest& guest : guests)
    if (guest.kind == GuestKind::command) names += (names.empty() ? "" : ", ") + guest.name;
  return names.empty() ? ""
                       : names + ": times of a line there and a line back through a pipe, not of its code\n";
}

void run(const BenchArguments& options) {
  MethodSet set = with_guests(options.guests, options.methods);
  const std::string pipes = through_pipes(set.guests);
  auto methods = std::move(set.methods);
  if (options.bench.curves) std::ranges::move(setting_methods(), std::back_inserter(methods));
  if (options.methods != "all") methods = select_methods(std::move(methods), options.methods);
  const auto progress = [](std::string_view what) { std::cerr << what << std::endl; };
  const std::vector<Family> families = select_families(options.families);
  fmt::print("seed {}, {} pairs a family, {} turns, {} s of timing a row; {}; {}\n\n", options.bench.seed,
             options.bench.pairs, options.bench.passes, options.bench.min_time, build_info().text(),
             build_info().cpu);
  std::fflush(stdout);

  const std::vector<BenchRow> rows = bench(methods, families, options.bench, progress);
  std::vector<QueryComparisons> queries;
  if (!options.bench.curves) queries = summarise(rows);
  fmt::print("{}", options.bench.curves   ? format_curves(speed_points(rows))
                   : options.bench.shapes ? format_shapes(queries)
                                          : format_bench_table(rows) + format_comparisons(queries));
  for (const auto& method : methods)
    if (!options.bench.shapes && std::ranges::count(rows, method->name(), &BenchRow::method) == 0)
      fmt::print("{}: no row, because it does not support these pairs\n", method->name());
  fmt::print("{}", pipes);
  if (!options.json.empty()) write_json(options.json, rows);
}

}  // namespace

void add_bench(Program& program) {
  Command command =
      program.command("Measure", "bench", "Times each method on each family, and counts its wrong answers");
  auto options = std::make_shared<BenchArguments>();
  command.section("Methods");
  add_methods_option(command, options->methods);
  add_guest_options(command, options->guests);
  command.section("Pairs");
  command.option(
      "--families LIST", options->families,
      "families: names or prefixes, separated by commas; a '-' before the list excludes; 'all' for all");
  command.number("--pairs N", options->bench.pairs, "pairs to draw from each family", 1);
  command.number("--seed N", options->bench.seed, "seed; the same seed gives the same pairs");
  command.section("Limits");
  command
      .option("--min-time SECONDS", options->bench.min_time,
              "timing for each row (method, family and query), over all passes")
      .within(0, 1000);
  command.number("--passes N", options->bench.passes,
                 "times that each row is timed, in rotation with the others", 1);
  command.section("What to measure");
  command.flag("--curves", options->bench.curves,
               "time each method at more settings, for the chart of speed against accuracy");
  command.flag(
      "--shapes", options->bench.shapes,
      "split each family by the shapes of its pairs, and compare ours with others for each of these");
  command.section("Output");
  command.option("--json FILE", options->json, "also write the results as JSON").writable();
  command.examples(
      "  daylight bench --methods intersect,decide,fcl --families random --json bench.json\n"
      "  daylight bench --curves --json bench.json",
      "The exit codes 2 and 3 do not occur for bench.");
  command.run([options, command] {
    set_defaults(command, *options);
    run(*options);
    return exit_pass;
  });
}

}  // namespace cyl
