// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/source_tree.hpp"
#include "cli/commands.hpp"
#include "cli/families.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "fuzz/campaign/offline.hpp"

namespace cyl {
namespace {

struct AskOptions {
  std::string out = "-", families;
  std::optional<std::string> cases;
  std::uint64_t pairs = 20'000, seed = 1;
};

/// Pairs between two looks at the clock.
constexpr std::uint64_t shown_pairs = 1024;

int write_questions(const AskOptions& options) {
  const std::string folder = options.cases ? *options.cases : in_source_tree("corpus/cases");
  const std::vector<Case> cases = cases_in(folder, false);
  const std::vector<Family> families = families_named(options.families, false);
  const Workload workload{{}, families, cases, {}};
  const Schedule schedule = schedule_of(workload);
  const auto closed = [](std::FILE* file) {
    if (file != stdout) std::fclose(file);
  };
  const std::unique_ptr<std::FILE, decltype(closed)> file(
      options.out == "-" ? stdout : std::fopen(options.out.c_str(), "w"), closed);
  if (!file) throw std::runtime_error(options.out + ": cannot be written");
  ProgressLine line;
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < options.pairs; ++i) {
    fmt::print(file.get(), "{}\n", format_case(question_at(workload, schedule, options.seed, i)));
    if (i % shown_pairs != 0) continue;
    const auto elapsed =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
    if (line.due(elapsed))
      line.show(elapsed, static_cast<double>(i) / static_cast<double>(options.pairs),
                fmt::format("{} pairs", i));
  }
  if (std::fflush(file.get()) != 0 || std::ferror(file.get()) != 0)
    throw std::runtime_error(options.out + ": could not be written");
  return exit_pass;
}

}  // namespace

void add_ask(Program& program) {
  Command command =
      program.command("Find", "ask", "Writes a campaign's pairs down, to be answered on another machine");
  auto options = std::make_shared<AskOptions>();
  command.option("--out", options->out, "file of pairs, a line each; '-': standard output");
  command.number("--pairs", options->pairs, "exactly this many pairs: the cases first, then drawn ones", 1);
  command.number("--seed", options->seed, "same seed, same pairs; a campaign with it draws the same");
  command
      .option("--families", options->families,
              "a,b: pairs of these families; --families=-a,b: of all but these; a name stands for all that "
              "begin with it")
      .default_text("all");
  command.option("--cases", options->cases, "folder of case files asked first; '' for none")
      .default_text("corpus/cases/");
  command.examples("  daylight ask --pairs 100000 --seed 7 --out pairs.jsonl",
                   "What answers them writes a line for each, in any order, with its id: "
                   "{\"id\":\"17\",\"verdict\":\"disjoint\"};\ndaylight judge reads that.");
  command.run([options] { return write_questions(*options); });
}

}  // namespace cyl
