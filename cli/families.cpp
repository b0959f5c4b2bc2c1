// SPDX-License-Identifier: MIT
#include "cli/families.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <memory>

#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {

namespace {

struct FamiliesOptions {
  std::string name;
  std::uint64_t seed = 1;
  std::uint64_t count = 10;
  std::uint64_t from = 0;
};

void print_pairs(const FamiliesOptions& options) {
  const Family* family = find_family(options.name);
  if (!family) {
    std::string message = "no family '" + options.name + "'; there are";
    for (const Family& f : campaign_families()) message.append(" ").append(f.name);
    throw UsageError(message);
  }
  for (std::uint64_t i = 0; i < options.count; ++i) {
    const std::uint64_t index = options.from + i;
    Case c;
    c.pair = family->generate(options.seed, index);
    c.id = fmt::format("{}/{}/{}", family->name, options.seed, index);
    fmt::print("{}\n", format_case(c));
  }
}

}  // namespace

std::vector<Family> families_named(std::string_view spec, const PairFilter& is_wanted) {
  const auto all = campaign_families();
  if (spec.empty()) {
    std::vector<Family> kept(all.begin(), all.end());
    // A family may have solids of several kinds.
    constexpr std::uint64_t looked_at = 8;
    std::erase_if(kept, [&](const Family& family) {
      std::uint64_t index = 0;
      while (index < looked_at && !is_wanted(family.generate(0, index))) ++index;
      return index == looked_at;
    });
    return kept;
  }
  std::vector<std::string> names;
  for (const Family& family : all) names.emplace_back(family.name);
  std::vector<Family> kept;
  for (const std::size_t i : select_names(names, spec)) kept.push_back(all[i]);
  return kept;
}

std::vector<Case> cases_in(const std::string& folder, const PairFilter& is_wanted) {
  std::vector<Case> cases = folder.empty() ? std::vector<Case>{} : read_case_folder(folder);
  std::erase_if(cases, [&](const Case& c) { return !is_wanted(c.pair); });
  return cases;
}

void add_families(Program& program) {
  Command command =
      program.command("Measure", "families", "Lists the generators of pairs, or prints pairs of one");
  auto options = std::make_shared<FamiliesOptions>();
  command.option("NAME", options->name, "family to print pairs of; without it, list the families");
  command.section("Pairs");
  command.number("--seed N", options->seed, "seed; the same seed gives the same pairs on every machine");
  command.number("--count N", options->count, "number of pairs to print");
  command.number("--from N", options->from, "index of the first pair to print");
  command.examples(
      "  daylight families\n"
      "  daylight families random --count 1000 | daylight check",
      "The exit codes 2 and 3 do not occur for families.");
  command.run([options] {
    if (!options->name.empty()) {
      print_pairs(*options);
      return exit_pass;
    }
    for (const Family& family : campaign_families()) fmt::print("{:<28} {}\n", family.name, family.summary);
    return exit_pass;
  });
}

}  // namespace cyl
