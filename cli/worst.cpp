// SPDX-License-Identifier: MIT
#include "fuzz/worst/worst.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
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
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/strata.hpp"
#include "corpus/store/case_files.hpp"
#include "corpus/store/run_store.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// The greatest size and offset with --extremes: about what a float can hold for a world in metres.
constexpr double extreme_size = 1e12;

struct WorstArguments {
  std::string methods, feature, budget, out, search = to_string(Objective::margin);
  std::vector<std::string> from;
  std::optional<std::uint64_t> evaluations;
  std::uint64_t seed = 1;
  bool time = false, extremes = false;
  GuestOptions guests;
};

std::vector<Pair> pairs_of(const std::string& name) {
  std::vector<Pair> pairs;
  const auto add = [&](const CaseLine& line) {
    if (!line.value) throw InputError(name + ": " + line.error);
    pairs.push_back(line.value->pair);
  };
  if (fs::is_directory(name)) {
    for (const FindingRecord& finding : RunStore::open(name).findings()) add(parse_case(finding.pair, 1));
    return pairs;
  }
  std::ifstream in(name);
  if (!in) throw UsageError("'" + name + "' is neither a run nor a file of cases");
  CaseReader reader(in);
  while (const auto line = reader.next()) add(*line);
  if (in.bad()) throw std::runtime_error(name + " cannot be read");
  return pairs;
}

std::vector<Pair> known_pairs(const WorstArguments& arguments) {
  std::vector<Pair> pairs;
  for (const std::string& name : arguments.from) {
    const std::vector<Pair> more = pairs_of(name);
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
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

std::vector<std::unique_ptr<Method>> with_judge(std::vector<std::unique_ptr<Method>> methods) {
  methods.push_back(judge_method());
  return methods;
}

/// Searches the methods one after the other, and the features of each in turn. If a search ends early, the
/// later ones get the time that is left.
class Searcher {
 public:
  explicit Searcher(const WorstArguments& arguments)
      : arguments_(arguments),
        methods_(select_methods(
            with_judge(methods_for_targets(arguments.guests, arguments.from, arguments.methods).methods),
            arguments.methods)),
        known_(known_pairs(arguments)) {
    options_.seed = arguments.seed;
    options_.objective = arguments.time ? Objective::time : *from_word<Objective>(arguments.search);
    if (arguments.evaluations) options_.evaluation_cap = *arguments.evaluations;
    if (arguments.extremes)
      options_.domain = {1 / extreme_size, extreme_size, 1 / extreme_size, extreme_size};
    options_.domain.fine = options_.objective != Objective::margin && !arguments.time;
    budget_ = arguments.budget.empty()
                  ? (arguments.evaluations ? options_.budget : milliseconds(std::chrono::minutes(1)))
                  : parse_duration(arguments.budget);
    if (arguments.feature.empty()) {
      features_.assign(enum_values<ContactFeature>.begin(), enum_values<ContactFeature>.end());
    } else if (const auto feature = from_word<ContactFeature>(arguments.feature)) {
      features_.push_back(*feature);
    } else {
      throw UsageError("--feature: '" + arguments.feature + "' is none of side-side, side-rim, " +
                       "rim-rim, cap-side, cap-rim, cap-cap, containment");
    }
    if (!arguments.out.empty()) out_.open(arguments.out);
  }

  int run() {
    std::size_t left = methods_.size() * features_.size();
    for (const auto& method : methods_) {
      options_.clock = method->guest() ? wall_clock : cpu_clock;
      if (options_.objective == Objective::time) usual_ = usual_ns(method, options_.clock);
      for (const ContactFeature feature : features_) search(method, feature, left--);
    }
    out_.close();
    if (!out_ && !arguments_.out.empty()) throw std::runtime_error(arguments_.out + " cannot be written");
    return beyond_claim_ ? exit_findings : exit_pass;
  }

 private:
  milliseconds elapsed() const {
    return std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - began_);
  }

  void search(const std::unique_ptr<Method>& method, ContactFeature feature, std::size_t left) {
    std::vector<Pair> starts = known_;
    if (arguments_.from.empty()) {
      const std::vector<Pair> drawn = options_.domain.fine ? close_starts(feature, arguments_.seed)
                                                           : drawn_starts(feature, arguments_.seed);
      starts.insert(starts.end(), drawn.begin(), drawn.end());
    }
    options_.budget = std::max(milliseconds(0), (budget_ - elapsed()) / static_cast<int>(left));
    const std::string name = fmt::format("{} {}", method->name(), cyl::to_string(feature));
    Worst worst;
    {
      ProgressLine line;
      worst = worst_of(method, starts, {feature, {}}, options_, [&](const Worst& w, milliseconds) {
        if (line.due(elapsed()))
          line.show(elapsed(), share_done(w, left),
                    fmt::format("{}: {}{}", name, counted(w.evaluations, "shape"), so_far(w)));
      });
    }
    print(method, name, worst);
    beyond_claim_ |= worst.beyond_claim();
  }

  double share_done(const Worst& w, std::size_t left) const {
    const auto part = [](auto done, auto all) {
      return static_cast<double>(done) / static_cast<double>(all);
    };
    if (!arguments_.evaluations) return part(elapsed().count(), budget_.count());
    const std::size_t all = methods_.size() * features_.size();
    return part(all - left, all) + part(w.evaluations, options_.evaluation_cap) / static_cast<double>(all);
  }

  std::string so_far(const Worst& w) const {
    std::string text;
    if (w.wrong) text += fmt::format(", margin {:.3g}", w.wrong->finding.margin->lo);
    if (w.slow) text += fmt::format(", {:.3g} ns", w.slow->ns);
    if (w.scored) text += fmt::format(", {} {:.3g}", to_string(options_.objective), w.scored->score);
    if (w.failed) text += fmt::format(", {}", to_string(w.failed->failure));
    return text;
  }

  void print(const std::unique_ptr<Method>& method, const std::string& name, const Worst& worst) {
    if (worst.failed) {
      const FailedPair& f = *worst.failed;
      show(method, name, to_string(f.failure), in_words(Severity::contract), f.pair, f.reason);
    }
    if (worst.wrong) {
      const WrongPair& w = *worst.wrong;
      show(method, name, fmt::format("margin {:.4g} {}", w.finding.margin->lo, to_string(w.finding.kind)),
           in_words(w.finding.severity), w.pair, {});
    }
    if (worst.slow) {
      const std::string times = usual_ && *usual_ > 0 ? fmt::format("{:.0f} times its usual {:.0f}",
                                                                    worst.slow->ns / *usual_, *usual_)
                                                      : "it answers no random pair";
      show(method, name, fmt::format("{:.0f} ns", worst.slow->ns), times, worst.slow->pair, {});
    }
    if (worst.scored) {
      const ScoredPair& s = *worst.scored;
      show(method, name, fmt::format("{} {:.4g}", to_string(options_.objective), s.score),
           s.beyond                                                ? "beyond its claim"
           : s.score > 1 && options_.objective == Objective::error ? "at most"
                                                                   : "within its claim",
           s.pair, {});
    }
    if (!worst.failed && !worst.wrong && !worst.slow && !worst.scored)
      fmt::print("{} nothing in {}, {}\n", name, counted(worst.evaluations, "shape"),
                 counted(worst.questions, "question"));
    std::fflush(stdout);
  }

  void show(const std::unique_ptr<Method>& method, const std::string& name, const std::string& what,
            const std::string& beside, const Pair& pair, const std::string& note) {
    const std::string id = fmt::format("{}/{}", method->name(), name.substr(method->name().size() + 1));
    const std::string remark = note.empty() ? what : what + ": " + note;
    const std::string line =
        case_line(pair, "worst/" + id, fmt::format("{}, {}", remark, beside), arguments_.seed);
    fmt::print("{} {} ({}) {}\n", name, what, beside, line);
    known_.insert(known_.begin(), pair);  // a bad pair for one method may be bad for the next
    if (out_.is_open()) out_ << line << '\n' << std::flush;
  }

  const WorstArguments& arguments_;
  std::vector<std::unique_ptr<Method>> methods_;
  std::vector<Pair> known_;
  std::vector<ContactFeature> features_;
  WorstOptions options_;
  milliseconds budget_;
  std::ofstream out_;
  std::optional<double> usual_;
  bool beyond_claim_ = false;
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace

void add_worst(Program& program) {
  Command command = program.command(
      "Find", "worst", "Searches for the pair with the largest error, or the longest time, of a method");
  auto arguments = std::make_shared<WorstArguments>();
  command.section("Methods");
  command
      .option("--method LIST", arguments->methods,
              "names or prefixes, separated by commas; 'judge' is the referee")
      .required();
  add_guest_options(command, arguments->guests);
  add_run_guests_option(command, arguments->guests);
  command.section("Question");
  command.option("--feature NAME", arguments->feature, "contact feature, such as side-rim")
      .default_text("each in turn");
  command.section("Limits");
  command.option("--for DURATION", arguments->budget, "wall time for all searches together, such as 60s")
      .default_text("60s");
  command.section("Question");
  command
      .option("--search GOAL", arguments->search,
              "quantity to maximize: margin, time, steps, error, bound or undecided")
      .one_of({enum_words<Objective>.begin(), enum_words<Objective>.end()});
  command.flag("--time", arguments->time, "the same as --search time");
  command.option("--from RUN|FILE", arguments->from, "start from the findings of a run, or from a case file")
      .default_text("corpus/cases/ and drawn pairs");
  command.section("Limits");
  command.number("--seed N", arguments->seed,
                 "seed; with --evaluations, the same seed gives the same result");
  command.number("--evaluations N", arguments->evaluations,
                 "evaluations for each method and feature; then only --for limits the time", 1);
  command.section("Output");
  command.option("--out FILE", arguments->out, "write the pairs as a case file").writable();
  command.section("Question");
  command.flag("--extremes", arguments->extremes, "sizes from 1e-12 to 1e12 instead of 1e-3 to 1e3");
  command.examples(
      "  daylight worst --method fcl-libccd --feature side-rim --for 60s --out worst.jsonl\n"
      "  daylight worst --method mine --plugin ./libmine.so --search time",
      "Each line has the method, the feature, the proved margin relative to the size (or the quantity that\n"
      "--search names), its description, and the pair. 3 does not occur for worst.");
  command.run([arguments] { return Searcher(*arguments).run(); });
}

}  // namespace cyl
