// SPDX-License-Identifier: MIT
#include "oracles/methods/errata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/source_tree.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t family_seed = 1;

struct ErrataOptions {
  std::string id;
  std::uint64_t pairs = 0;
};

/// The methods and cases that the errata name.
class Exhibits {
 public:
  Exhibits() {
    for (const auto make : {literature_2008_methods, literature_2017_methods, errata_methods})
      for (auto& method : make()) methods_.emplace(std::string(method->name()), std::move(method));
    for (const Case& c : read_case_folder(in_source_tree("corpus/cases"))) cases_.emplace(c.id, c.pair);
  }
  Method& method(const std::string& name) const { return *methods_.at(name); }
  const Pair& pair_of(const Erratum& e) const { return cases_.at(case_of(e)); }

 private:
  std::map<std::string, std::unique_ptr<Method>> methods_;
  std::map<std::string, Pair> cases_;
};

constexpr const char* errata_file = "solver/literature/errata.md";

/// Returns the part of errata.md about an erratum, without its heading. Empty if there is none.
std::string section_of(const std::string& all, std::string_view id) {
  const std::string heading = fmt::format("\n### {}\n", id);
  const std::size_t begin = all.find(heading);
  if (begin == all.npos) return {};
  const std::size_t from = begin + heading.size();
  return all.substr(from, std::min(all.find("\n### ", from), all.find("\n## ", from)) - from);
}

/// Returns the text with one space in place of each line break and indentation.
std::string on_one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank || !line.ends_with(' ')) line += blank ? ' ' : c;
  }
  return line;
}

void print_line(std::string_view what, std::string_view text) { fmt::print("  {:<9} {}\n", what, text); }

/// Prints the answers of the methods today. Returns whether the section states the same.
bool print_pair(const Erratum& e, const Exhibits& exhibits, std::string_view section) {
  const Pair& pair = exhibits.pair_of(e);
  const Truth truth = judge(pair);
  const std::string wrong = wrong_method(e), right = right_method(e);
  const Verdict said = exhibits.method(wrong).ask(pair).verdict,
                known = exhibits.method(right).ask(pair).verdict;
  print_line("pair", format_pair(pair));
  print_line("wrong", fmt::format("{} answers {}", wrong, to_string(said)));
  print_line("right", fmt::format("{} answers {}", right, to_string(known)));
  print_line("proof", format_truth(truth));
  const std::string text = format_pair(pair);
  const std::size_t second = text.find("\"b\":");
  const std::string stated[] = {
      fmt::format("{}, by proof. `{}` answers {}, `{}` answers {}.", to_string(truth.verdict), wrong,
                  to_string(said), right, to_string(known)),
      text.substr(0, second), text.substr(second)};  // the section has a line for each solid
  const std::string words = on_one_line(section);
  const bool is_stated =
      std::ranges::all_of(stated, [&](const std::string& x) { return words.find(x) != words.npos; });
  if (truth.verdict == Verdict::touching) return is_stated && said != known;
  return is_stated && known == truth.verdict && said != truth.verdict;
}

/// Counts among the first pairs of each family those on which the verdict is proved wrong, but right without
/// the fault.
void print_rate(const Erratum& e, const Exhibits& exhibits, std::uint64_t pairs) {
  Method& wrong = exhibits.method(wrong_method(e));
  Method& right = exhibits.method(right_method(e));
  std::string line;
  for (const Family& family : families()) {
    std::uint64_t count = 0;
    for (std::uint64_t i = 0; i < pairs; ++i) {
      const Pair pair = family.generate(family_seed, i);
      const Verdict known = right.ask(pair).verdict;
      count += wrong.ask(pair).verdict != known && decide(pair.a, pair.b).verdict == known;
    }
    if (count > 0) line += fmt::format("{}{} {}", line.empty() ? "" : ", ", family.name, count);
  }
  print_line("counted", fmt::format("wrong of {} pairs a family: {}", pairs, line.empty() ? "none" : line));
}

bool print_erratum(const Erratum& e, const Exhibits& exhibits, const std::string& all, std::uint64_t pairs) {
  const std::string section = section_of(all, e.id);
  fmt::print("{}\n{}\n", e.id, section);
  const bool shown = !section.empty() && (e.shown_by == ShownBy::none || print_pair(e, exhibits, section));
  if (!shown) fmt::print("  THIS IS NOT SO TODAY\n");
  if (pairs > 0 && e.fault) print_rate(e, exhibits, pairs);
  fmt::print("\n");
  return shown;
}

int show_errata(const ErrataOptions& options) {
  const auto wanted = [&](const Erratum& e) { return options.id.empty() || e.id == options.id; };
  if (std::ranges::none_of(errata(), wanted)) {
    std::string message = "no erratum '" + options.id + "'; there are";
    for (const Erratum& e : errata()) message.append(" ").append(e.id);
    throw UsageError(message);
  }
  const std::string file = in_source_tree(errata_file);
  if (file.empty()) throw std::runtime_error(fmt::format("cannot find {}", errata_file));
  std::ifstream in(file);
  const std::string all{std::istreambuf_iterator<char>(in), {}};
  const Exhibits exhibits;
  bool shown = true;
  for (const Erratum& e : errata())
    if (wanted(e)) shown &= print_erratum(e, exhibits, all, options.pairs);
  return shown ? exit_pass : exit_findings;
}

}  // namespace

void add_errata(Program& program) {
  Command command = program.command(
      "Understand", "errata",
      "Lists the errors in the published texts that this project started from, with pairs and proofs");
  auto options = std::make_shared<ErrataOptions>();
  command.option("ID", options->id, "erratum to show; all if none is given");
  command.section("Output");
  command.number("--pairs N", options->pairs,
                 "count wrong answers on this many pairs of each family, with the fault and without");
  command.examples(
      "  daylight errata 2017-one-octant\n"
      "  daylight check --method seed2017-only-one-octant pairs.jsonl",
      "Each fault is also a method. seed2017-only-FAULT is seed2017-mended with this fault alone.\n"
      "seed2017-without-FAULT is seed2017-printed without it. The same holds for seed2008- and seedbook-.\n"
      "Campaigns and check ask these methods if you name them.");
  command.run([options] { return show_errata(*options); });
}

}  // namespace cyl
