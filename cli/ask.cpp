// SPDX-License-Identifier: MIT
#include <fmt/format.h>

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
#include "corpus/pairs/pair_numbers.hpp"
#include "fuzz/campaign/offline.hpp"

namespace cyl {
namespace {

struct AskOptions {
  std::string out = "-", families;
  std::optional<std::string> cases;
  std::uint64_t pairs = 20'000, seed = 1;
};

/// The number of pairs between two looks at the clock.
constexpr std::uint64_t shown_pairs = 1024;

int write_questions(const AskOptions& options) {
  const std::string folder = options.cases ? *options.cases : in_source_tree("corpus/cases");
  const auto of_cylinders = [](const Pair& pair) {
    return !is_rounded(pair) && !has_half_space(pair) && !has_box(pair);
  };
  const std::vector<Case> cases = cases_in(folder, of_cylinders);
  const std::vector<Family> families = families_named(options.families, of_cylinders);
  const Workload workload{{}, families, cases, {}};
  const auto closed = [](std::FILE* file) {
    if (file != stdout) std::fclose(file);
  };
  const std::unique_ptr<std::FILE, decltype(closed)> file(
      options.out == "-" ? stdout : std::fopen(options.out.c_str(), "w"), closed);
  if (!file) throw std::runtime_error(options.out + ": cannot be written");
  ProgressLine line;
  for (std::uint64_t i = 0; i < options.pairs; ++i) {
    fmt::print(file.get(), "{}\n", format_case(question_at(workload, options.seed, i)));
    if (i % shown_pairs == 0 && line.due())
      line.show(static_cast<double>(i) / static_cast<double>(options.pairs), fmt::format("{} pairs", i));
  }
  if (std::fflush(file.get()) != 0 || std::ferror(file.get()) != 0)
    throw std::runtime_error(options.out + ": could not be written");
  return exit_pass;
}

}  // namespace

void add_ask(Program& program) {
  Command command =
      program.command("Find", "ask", "Writes the pairs of a campaign, for a method on another machine");
  auto options = std::make_shared<AskOptions>();
  command.section("Output");
  command.option("--out FILE", options->out, "file for the pairs, one a line; '-' is standard output");
  command.section("Pairs");
  command.number("--pairs N", options->pairs, "number of pairs: first the cases, then drawn pairs", 1);
  command.number("--seed N", options->seed, "seed; a campaign with the same seed draws the same pairs");
  command
      .option("--families LIST", options->families,
              "families: names or prefixes, separated by commas; a '-' before the list excludes")
      .default_text("all");
  command.option("--cases DIR", options->cases, "folder of case files that come first; '' for none")
      .default_text("corpus/cases/");
  command.examples(
      "  daylight ask --pairs 100000 --seed 7 --out pairs.jsonl\n"
      "  daylight ask --families random --pairs 1000 --cases ''",
      "Your library answers with one line for each pair, in any order: "
      "{\"id\":\"17\",\"verdict\":\"disjoint\"}.\n"
      "daylight judge reads these lines. The exit codes 2 and 3 do not occur for ask.");
  command.run([options] { return write_questions(*options); });
}

}  // namespace cyl
