// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "cli/targets.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/trial/finding_text.hpp"
#include "oracles/trial/trial.hpp"
#include "props/laws/examine.hpp"

namespace cyl {
namespace {

/// The number of pairs that are asked together, because one worker is forked for all of them.
constexpr std::size_t together_cap = 64;

struct ReplayArguments {
  std::vector<std::string> targets;
  std::string methods;
  std::vector<int> laws;
  GuestOptions guests;
};

/// Returns what became of a stored finding: "stands", or why it does not.
std::string outcome(const FindingRecord& stored, std::span<const std::unique_ptr<Method>> methods,
                    Trial& now) {
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m]->name() != stored.method) continue;
    if (!now.findings[m]) {
      if (now.truth.verdict == Verdict::undecided) return "open: the truth is undecided";
      return now.answers[m].status == Status::declined ? "gone: declined now" : "gone";
    }
    if (now.findings[m]->kind != stored.kind) return "stands, as " + describe_finding(*now.findings[m]);
    if (now.findings[m]->severity != stored.severity)
      return "stands, now " + describe_finding(*now.findings[m]);
    return "stands";
  }
  if (stored.method == "referee")
    return now.truth.verdict == Verdict::undecided ? "stands" : "gone: proved now";
  if (stored.method == "corpus") {
    const auto stated = parse_case(stored.pair, 1).value->truth;
    return stated && compare_statement(now, *stated) ? "stands: the verdict of the case is wrong" : "gone";
  }
  return "not asked: this build or --methods does not have the method";
}

class Replayer {
 public:
  explicit Replayer(const ReplayArguments& arguments) : laws_(arguments.laws) {
    for (const int law : laws_)
      if (std::ranges::count(all_laws(), law, &Law::number) == 0)
        throw UsageError("no law has the number " + std::to_string(law));
    methods_ = methods_for_targets(arguments.guests, arguments.targets, arguments.methods).methods;
    if (!arguments.methods.empty()) methods_ = select_methods(std::move(methods_), arguments.methods);
    const auto is_of_another = [&](const Target& target) {
      return target.finding && !position_of(methods_, target.finding->method);
    };
    for (const std::string& name : arguments.targets) {
      std::vector<Target> named = targets_of(name);
      if (!arguments.methods.empty() && named.size() > 1) std::erase_if(named, is_of_another);
      std::ranges::move(named, std::back_inserter(targets_));
    }
  }

  int run() {
    for (std::size_t first = 0; first < targets_.size(); first += together_cap) {
      const std::size_t count = std::min(together_cap, targets_.size() - first);
      std::vector<Pair> pairs;
      for (std::size_t i = 0; i < count; ++i) pairs.push_back(targets_[first + i].pair);
      std::vector<Trial> now = try_methods(methods_, pairs, Caps{}, 2);
      const LawFilter wanted = [&](std::size_t, const Law& law) {
        return std::ranges::count(laws_, law.number) > 0;
      };
      const Examined examined = laws_.empty() ? Examined{} : examine(methods_, pairs, wanted);
      for (std::size_t i = 0; i < count; ++i) {
        print(targets_[first + i], now[i]);
        bool beyond = stands_by_contract(targets_[first + i], now[i]);
        for (const LawViolation& violation : examined.violations) {
          if (violation.pair != i) continue;
          print(violation);
          beyond |= violation.violation.severity == Severity::contract;
        }
        contract_ += beyond;
      }
    }
    fmt::print("{} replayed, {} beyond a claim, {} of undecided truth\n", targets_.size(), contract_,
               undecided_);
    if (refuted_ > 0) {
      fmt::print("{} stored {} wrong\n", refuted_, refuted_ == 1 ? "truth is" : "truths are");
      return exit_invalid_input;
    }
    if (contract_ > 0) return exit_findings;
    return undecided_ > 0 ? exit_undecided : exit_pass;
  }

 private:
  void print(const Target& target, Trial& now) {
    fmt::print("{}\n  {}\n", target.label, format_pair(target.pair));
    fmt::print("  truth: {}. {}\n", to_string(now.truth.verdict), in_words(now.truth.certificate));
    if (target.stated && compare_statement(now, *target.stated)) {
      fmt::print("  the stored truth, {}, is refuted\n", to_string(*target.stated));
      ++refuted_;
    }
    if (now.decided())
      fmt::print("  distance: {} to {}\n", format_double(now.distance.lo), format_double(now.distance.hi));
    std::vector<std::size_t> wrong_first(methods_.size());
    std::iota(wrong_first.begin(), wrong_first.end(), std::size_t{0});
    std::ranges::stable_partition(wrong_first, [&](std::size_t m) { return now.findings[m].has_value(); });
    const bool brief = std::ranges::count_if(now.answers, declined) > 1;
    for (const std::size_t m : wrong_first) {
      if (brief && declined(now.answers[m])) continue;
      const bool wrong = now.findings[m].has_value();
      fmt::print("  {:<26} {}{}\n", methods_[m]->name(), format_method_answer(now.answers[m]),
                 wrong ? "  <- " + describe_finding(*now.findings[m]) : "");
      if (!wrong || now.findings[m]->kind != FindingKind::bad_witness) continue;
      if (const std::string miss = miss_in_words(target.pair, now.answers[m]); !miss.empty())
        fmt::print("  {:<26} {}\n", "", miss);
    }
    if (brief) print_declined(now);
    if (target.finding) {
      const std::string what = outcome(*target.finding, methods_, now);
      fmt::print("  finding of {}, {} ({}): {}\n", target.finding->method, to_string(target.finding->kind),
                 in_words(target.finding->severity), what);
    }
    undecided_ += now.truth.verdict == Verdict::undecided;
  }

  static bool declined(const MethodAnswer& answer) { return answer.status == Status::declined; }

  /// Prints one line for all methods that decline, with their reasons.
  static void print_declined(const Trial& now) {
    std::map<std::string, std::size_t> reasons;
    std::size_t count = 0;
    for (const MethodAnswer& answer : now.answers) {
      if (!declined(answer)) continue;
      ++reasons[answer.reason];
      ++count;
    }
    std::string line;
    for (const auto& [reason, times] : reasons)
      line += fmt::format("{}{} ({})", line.empty() ? "" : ", ", quote_json(reason), times);
    fmt::print("  {} methods decline: {}\n", count, line);
  }

  void print(const LawViolation& b) const {
    fmt::print("  {} breaks law {} {} ({}): {}\n    {}\n", methods_[b.method]->name(), b.law->number,
               b.law->name, in_words(b.violation.severity), b.violation.what, b.law->statement);
    for (std::size_t i = 0; i < b.asked.size(); ++i)
      fmt::print("    pair   {}\n    answer {}\n", format_pair(b.asked[i].pair),
                 format_method_answer(b.answers[i]));
  }

  /// Returns whether an answer is wrong beyond a claim. For a stored finding, only its own method counts.
  /// For a case, any method does.
  bool stands_by_contract(const Target& target, Trial& now) const {
    if (target.finding && target.finding->method == "corpus")
      return outcome(*target.finding, methods_, now).starts_with("stands");
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      if (target.finding && target.finding->method != methods_[m]->name()) continue;
      if (now.findings[m] && now.findings[m]->severity == Severity::contract) return true;
    }
    return false;
  }

  std::vector<int> laws_;
  std::vector<std::unique_ptr<Method>> methods_;
  std::vector<Target> targets_;
  std::size_t contract_ = 0;
  std::size_t undecided_ = 0;
  std::size_t refuted_ = 0;  ///< stored truths
};

}  // namespace

void add_replay(Program& program) {
  Command command =
      program.command("Understand", "replay", "Runs stored findings or cases again on this build");
  auto arguments = std::make_shared<ReplayArguments>();
  command
      .option("TARGET", arguments->targets,
              "RUN (all its findings of these methods), RUN:ID, FILE (cases), FILE:LINE, or '-' for standard "
              "input")
      .required();
  command.section("Methods");
  add_methods_option(command, arguments->methods);
  command
      .option("--laws LIST", arguments->laws,
              "also check these laws, by the numbers that gate --laws lists, such as 1,10")
      .separated_by(',')
      .one_each();
  add_guest_options(command, arguments->guests);
  add_run_guests_option(command, arguments->guests);
  command.examples(
      "  daylight replay runs/latest:12\n"
      "  daylight replay corpus/cases/reported.jsonl --methods decide,fcl",
      "Exit code 2 of replay means that a method is still wrong beyond its claim. 65 means that a stored\n"
      "truth is wrong, and comes before 2.");
  command.run([arguments] { return Replayer(*arguments).run(); });
}

}  // namespace cyl
