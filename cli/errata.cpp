// SPDX-License-Identifier: MIT
#include "oracles/methods/errata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
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
constexpr std::size_t columns_cap = 120;

struct ErrataOptions {
  std::string id;
  std::uint64_t pairs = 0;
  bool markdown = false;
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

void print_line(std::string_view what, std::string_view text) { fmt::print("  {:<9} {}\n", what, text); }

/// Returns whether the methods say what the table says of the pair.
bool print_pair(const Erratum& e, const Exhibits& exhibits) {
  const Pair& pair = exhibits.pair_of(e);
  const Truth truth = judge(pair);
  const std::string wrong = wrong_method(e), right = right_method(e);
  const Verdict said = exhibits.method(wrong).ask(pair).verdict,
                known = exhibits.method(right).ask(pair).verdict;
  print_line("pair", format_pair(pair));
  print_line("wrong", fmt::format("{} says {}", wrong, to_string(said)));
  print_line("right", fmt::format("{} says {}", right, to_string(known)));
  print_line("proof", format_truth(truth));
  if (truth.verdict == Verdict::touching) return said != known;
  return known == truth.verdict && said != truth.verdict;
}

/// Of the first pairs of each family, those on which the verdict is proved wrong, and right without the
/// fault.
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

bool print_erratum(const Erratum& e, const Exhibits& exhibits, std::uint64_t pairs) {
  fmt::print("{}: {}, {}\n", e.id, title_of(e.document), e.place);
  print_line("kind", to_string(e.kind));
  print_line("says", e.says);
  print_line("should", e.should);
  print_line("why", e.why);
  if (!e.test.empty()) print_line("test", e.test);
  if (!e.rate.empty()) print_line("how often", e.rate);
  if (!e.numbers.empty()) print_line("numbers", e.numbers);
  const bool shown = e.shown_by == ShownBy::none || print_pair(e, exhibits);
  if (!shown) fmt::print("  THIS IS NOT SO TODAY\n");
  if (pairs > 0 && e.fault) print_rate(e, exhibits, pairs);
  return shown;
}

/// Prints the text in lines of at most `columns_cap`, those after the first indented by `indent`.
void print_wrapped(std::string_view text, std::size_t indent) {
  std::size_t column = 0;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    if (column > 0 && column + 1 + word.size() > columns_cap) {
      fmt::print("\n{:{}}", "", indent);
      column = indent;
    } else if (column > 0) {
      fmt::print(" ");
      ++column;
    }
    fmt::print("{}", word);
    column += word.size();
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  fmt::print("\n");
}

void print_item(std::string_view what, std::string_view text) {
  print_wrapped(fmt::format("* **{}** {}", what, text), 2);
}

/// An item of the list in solver/literature/errata.md.
void print_markdown(const Erratum& e, const Exhibits& exhibits) {
  fmt::print("### {}\n\n", e.id);
  print_wrapped(fmt::format("In {}. Kind: {}.", e.place, to_string(e.kind)), 0);
  fmt::print("\n");
  print_item("It says:", e.says);
  print_item("It should say:", e.should);
  print_item("Why:", e.why);
  if (!e.test.empty()) print_item("Checked by", fmt::format("the test `{}`.", e.test));
  if (!e.rate.empty()) print_item("How often:", e.rate);
  if (e.shown_by != ShownBy::none) {
    const Pair& pair = exhibits.pair_of(e);
    const auto said = [&](const std::string& name) {
      return fmt::format("`{}` says {}", name, to_string(exhibits.method(name).ask(pair).verdict));
    };
    print_item("A pair:", fmt::format("{}, by proof. {}, {}. {}", to_string(judge(pair).verdict),
                                      said(wrong_method(e)), said(right_method(e)), e.numbers));
    fmt::print("\n  ```json\n");
    const std::string text = format_pair(pair);
    const std::size_t second = text.find("\"b\":");
    fmt::print("  {}\n   {}\n  ```\n", text.substr(0, second), text.substr(second));
  }
  fmt::print("\n");
}

constexpr const char* list_head = R"(# Errata

What a reader of the documents that this project starts from may want to know, in our own words and notation: W_i, r_i
and h_i are the unit axis, the radius and the height of solid i; Delta points from the first centre to the second; the
line along D separates the solids if f(D) < 0 (or = 0, if what only touches counts as separated); P_i D is the part of D
square to W_i. Other symbols are those of the section that is named. The list claims to be complete in nothing.

Each row has a kind:

* error: a program that does what is written gives wrong verdicts;
* gap in the argument: a reason does not hold as written, or a case is left out;
* rounding: right in exact arithmetic, but digits are lost in doubles;
* trap: right as written, and easily carried on wrongly;
* remark: a slip of the pen, or advice.

Each fault that a program can have is a method here. `seed2017-printed` is the text as it stands, `seed2017-mended` the
text put right, both to the letter: nothing of ours repairs or polishes what they compute. `seed2017-only-FAULT` is the
mended text with one fault, `seed2017-without-FAULT` the printed text without it; `seed2008-` and `seedbook-` likewise.
How often a fault is wrong is counted with these. `daylight errata ID` shows one row, `daylight errata` all, with the
proofs. [How the documents are read](readings.md) says what was open in them. `daylight errata --markdown` writes this
file.

)";

int show_errata(const ErrataOptions& options) {
  const auto wanted = [&](const Erratum& e) { return options.id.empty() || e.id == options.id; };
  if (std::ranges::none_of(errata(), wanted)) {
    std::string message = "no erratum '" + options.id + "'; there are";
    for (const Erratum& e : errata()) message.append(" ").append(e.id);
    throw UsageError(message);
  }
  const Exhibits exhibits;
  bool shown = true;
  std::string_view title;
  if (options.markdown) fmt::print("{}", list_head);
  for (const Erratum& e : errata()) {
    if (!wanted(e)) continue;
    if (!options.markdown) {
      shown &= print_erratum(e, exhibits, options.pairs);
      fmt::print("\n");
      continue;
    }
    if (title != title_of(e.document)) fmt::print("## {}\n\n", title_of(e.document));
    title = title_of(e.document);
    print_markdown(e, exhibits);
  }
  return shown ? exit_pass : exit_findings;
}

}  // namespace

void add_errata(Program& program) {
  Command command = program.command(
      "Understand", "errata",
      "Shows the errata of the documents of this project, each with its kind, a pair and a proof");
  auto options = std::make_shared<ErrataOptions>();
  command.option("ID", options->id, "erratum to show; all if none is given");
  command.section("Output");
  command.number("--pairs N", options->pairs,
                 "count wrong answers on this many pairs of each family, with the fault and without");
  command.flag("--markdown", options->markdown, "print the list of solver/literature/errata.md");
  command.examples(
      "  daylight errata 2017-one-octant\n"
      "  daylight check --method seed2017-only-one-octant pairs.jsonl",
      "Each fault is also a method. seed2017-only-FAULT is seed2017-mended with this fault alone.\n"
      "seed2017-without-FAULT is seed2017-printed without it. The same holds for seed2008- and seedbook-.\n"
      "Campaigns and check ask these methods if you name them.");
  command.run([options] { return show_errata(*options); });
}

}  // namespace cyl
