// SPDX-License-Identifier: MIT
#include "fuzz/worst/worst.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/safe_text.hpp"
#include "base/source_tree.hpp"
#include "base/times.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/targets.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/case_files.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

struct WorstArguments {
  std::string methods, feature, budget, out, search = to_string(Objective::margin);
  std::vector<std::string> from;
  std::optional<std::uint64_t> evaluations;
  std::uint64_t seed = 1;
  GuestOptions guests;
};

std::vector<Pair> known_pairs(const WorstArguments& arguments) {
  std::vector<Pair> pairs;
  for (const std::string& name : arguments.from)
    for (const Target& target : targets_of(name)) pairs.push_back(target.pair);
  if (arguments.from.empty())
    for (const Case& c : read_case_folder(in_source_tree("corpus/cases"))) pairs.push_back(c.pair);
  return pairs;
}

std::string case_line(const Pair& pair, std::string id, std::string note, std::uint64_t seed) {
  Case c;
  c.pair = pair;
  c.id = std::move(id);
  c.source = fmt::format("daylight worst, seed {}", seed);
  if (const Verdict truth = judge(pair).verdict; truth != Verdict::undecided) c.truth = truth;
  c.note = std::move(note);
  return format_case(c);
}

std::vector<ContactFeature> features_of(const std::string& name) {
  if (name.empty()) return {enum_values<ContactFeature>.begin(), enum_values<ContactFeature>.end()};
  if (const auto feature = from_word<ContactFeature>(name)) return {*feature};
  throw UsageError("--feature: '" + name + "' is none of side-side, side-rim, " +
                   "rim-rim, cap-side, cap-rim, cap-cap, containment");
}

std::string score_text(const WorstPair& found) {
  if (is_failure(found.kind)) return to_string(found.kind);
  if (found.kind == FindingKind::distance_outside) return fmt::format("error {:.4g}", found.score);
  return fmt::format("margin {:.4g} {}", found.score, to_string(found.kind));
}

/// Searches the methods one after the other, and the features of each in turn. If a search ends early, the
/// later ones get the time that is left.
int search_all(const WorstArguments& arguments) {
  const auto methods = select_methods(
      methods_for_targets(arguments.guests, arguments.from, arguments.methods).methods, arguments.methods);
  const std::vector<ContactFeature> features = features_of(arguments.feature);
  std::vector<Pair> known = known_pairs(arguments);
  WorstOptions options{.objective = *from_word<Objective>(arguments.search), .seed = arguments.seed};
  if (arguments.evaluations) options.evaluation_cap = *arguments.evaluations;
  const milliseconds budget = !arguments.budget.empty() ? parse_duration(arguments.budget)
                              : arguments.evaluations   ? options.budget
                                                        : milliseconds(std::chrono::minutes(1));
  std::ofstream out;
  if (!arguments.out.empty()) out.open(arguments.out);
  const auto began = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - began);
  };
  const auto part = [](auto done, auto all) { return static_cast<double>(done) / static_cast<double>(all); };
  const std::size_t all = methods.size() * features.size();
  std::size_t ended = 0;
  bool beyond_claim = false;
  for (const auto& method : methods) {
    for (const ContactFeature feature : features) {
      options.feature = feature;
      std::vector<Pair> starts = known;
      if (arguments.from.empty())
        std::ranges::move(drawn_starts(*method, options), std::back_inserter(starts));
      options.budget = std::max(milliseconds(0), (budget - elapsed()) / static_cast<int>(all - ended));
      const std::string name = fmt::format("{} {}", method->name(), to_string(feature));
      Worst worst;
      {
        ProgressLine line;
        worst = worst_of(method, starts, options, [&](const Worst& w) {
          if (!line.due()) return;
          const double share = arguments.evaluations
                                   ? part(ended, all) + part(w.evaluations, options.evaluation_cap * all)
                                   : part(elapsed().count(), budget.count());
          line.show(share, fmt::format("{}: {}", name, counted(w.evaluations, "shape")));
        });
      }
      ++ended;
      beyond_claim |= worst.beyond_claim();
      if (!worst.failed && !worst.worst)
        fmt::print("{} nothing in {}, {}\n", name, counted(worst.evaluations, "shape"),
                   counted(worst.questions, "question"));
      for (const auto& found : {worst.failed, worst.worst}) {
        if (!found) continue;
        const std::string what = score_text(*found), beside = in_words(found->severity),
                          remark = found->reason.empty() ? what : what + ": " + found->reason;
        const std::string id = fmt::format("worst/{}/{}", method->name(), to_string(feature));
        const std::string line =
            case_line(found->pair, id, fmt::format("{}, {}", remark, beside), arguments.seed);
        fmt::print("{} {} ({}) {}\n", name, what, beside, line);
        known.insert(known.begin(), found->pair);  // a bad pair for one method may be bad for the next
        if (out.is_open()) out << line << '\n' << std::flush;
      }
      std::fflush(stdout);
    }
  }
  out.close();
  if (!out && !arguments.out.empty()) throw std::runtime_error(arguments.out + " cannot be written");
  return beyond_claim ? exit_findings : exit_pass;
}

}  // namespace

void add_worst(Program& program) {
  Command command =
      program.command("Find", "worst", "Searches for the pair with the largest error of a method");
  auto arguments = std::make_shared<WorstArguments>();
  command.section("Methods");
  command.option("--method LIST", arguments->methods, "names or prefixes, separated by commas").required();
  add_guest_options(command, arguments->guests);
  add_run_guests_option(command, arguments->guests);
  command.section("Question");
  command.option("--feature NAME", arguments->feature, "contact feature, such as side-rim")
      .default_text("each in turn");
  command.option("--search GOAL", arguments->search, "quantity to maximize: margin or error")
      .one_of({enum_words<Objective>.begin(), enum_words<Objective>.end()});
  command.option("--from RUN|FILE", arguments->from, "start from the findings of a run, or from a case file")
      .default_text("corpus/cases/ and drawn pairs");
  command.section("Limits");
  command.option("--for DURATION", arguments->budget, "wall time for all searches together, such as 60s")
      .default_text("60s");
  command.number("--seed N", arguments->seed,
                 "seed; with --evaluations, the same seed gives the same result");
  command.number("--evaluations N", arguments->evaluations,
                 "search steps per method and feature, instead of a share of the time", 1);
  command.section("Output");
  command.option("--out FILE", arguments->out, "write the pairs as a case file").writable();
  command.examples(
      "  daylight worst --method fcl-libccd --feature side-rim --for 60s --out worst.jsonl\n"
      "  daylight worst --method mine --plugin ./libmine.so --search error",
      "Each line has the method, the feature, the proved margin relative to the size (or the quantity that\n"
      "--search names), its description, and the pair. 3 does not occur for worst.");
  command.run([arguments] { return search_all(*arguments); });
}

}  // namespace cyl
