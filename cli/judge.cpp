// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "base/files.hpp"
#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "fuzz/campaign/offline.hpp"
#include "oracles/trial/finding_text.hpp"
#include "reports/run/tally_table.hpp"

namespace cyl {
namespace {

struct JudgeOptions {
  std::string answers, pairs, name, keep;
  double claim = -1;  ///< negative: as the answers state, else 0
};

/// The most lines that are reported one by one. The others are only counted.
constexpr std::uint64_t told_cap = 20;

/// Reports lines with errors, up to a limit.
class ErrorPrinter {
 public:
  void operator()(const std::string& file, std::size_t line, const std::string& what) {
    if (++count_ <= told_cap) fmt::print(stderr, "{}:{}: {}\n", one_line(file), line, one_line(what));
  }
  ~ErrorPrinter() {
    if (count_ > told_cap) fmt::print(stderr, "and {} more lines with something wrong\n", count_ - told_cap);
  }

 private:
  std::uint64_t count_ = 0;
};

bool fails(const JudgedFinding& f) { return f.finding.severity == Severity::contract; }

std::string failing_lines(const OfflineJudge& judged) {
  std::string lines;
  for (const JudgedFinding& f : judged.findings()) {
    if (!fails(f)) continue;
    Case kept = f.question;
    if (f.truth.verdict != Verdict::undecided) kept.truth = f.truth.verdict;
    kept.source = fmt::format("daylight judge, {}", kept.source.empty() ? kept.id : kept.source);
    kept.note = fmt::format("{}: {}, answer {}, proof {}", judged.name(), describe_finding(f.finding),
                            format_method_answer(f.answer), format_certificate(f.truth.certificate));
    lines += format_case(kept) + '\n';
  }
  return lines;
}

/// Prints the worst finding of each kind with its proof. A larger error counts as worse.
void print_findings(const OfflineJudge& judged, const JudgeOptions& options) {
  std::map<std::tuple<Severity, FindingKind>, std::pair<const JudgedFinding*, std::uint64_t>> worst;
  for (const JudgedFinding& f : judged.findings()) {
    auto& [most, count] = worst[{f.finding.severity, f.finding.kind}];
    const auto margin = [](const JudgedFinding& x) { return x.finding.margin ? x.finding.margin->lo : -1; };
    if (!most || margin(f) > margin(*most)) most = &f;
  }
  for (const GroupRecord& g : judged.groups()) worst[{g.severity, g.kind}].second += g.count;
  for (const auto& [key, value] : worst) {
    const auto& [f, count] = value;
    fmt::print("\n{}: {}. The worst has the id {}", describe_finding(f->finding), counted(count, "finding"),
               one_line(f->question.id));
    fmt::print("{}:\n", f->line == 0 ? "" : fmt::format(", {}:{}", one_line(options.answers), f->line));
    fmt::print("  {}\n  truth: {}. {}\n", format_pair(f->question.pair), to_string(f->truth.verdict),
               in_words(f->truth.certificate));
    if (f->truth.verdict != Verdict::undecided)
      fmt::print("  distance: {} to {}\n", format_end(f->distance.lo), format_end(f->distance.hi));
    const std::string miss = f->finding.kind == FindingKind::bad_witness
                                 ? miss_in_words(f->question.pair, f->answer)
                                 : std::string();
    fmt::print("  {}: {}{}\n", one_line(judged.name()), format_method_answer(f->answer),
               miss.empty() ? "" : "; " + miss);
  }
}

int judge_answers(const JudgeOptions& options) {
  ErrorPrinter printer;
  const OnBadLine on_bad_line = std::ref(printer);
  std::optional<Questions> questions;
  if (!options.pairs.empty()) questions.emplace(options.pairs, on_bad_line);
  std::ifstream file;
  double bytes = 0;
  if (options.answers != "-") {
    file.open(options.answers);
    std::error_code none;
    bytes = static_cast<double>(std::filesystem::file_size(options.answers, none));
  }
  std::istream& in = options.answers == "-" ? std::cin : file;
  OfflineJudge judged(options.name, options.claim < 0 ? std::optional<double>() : options.claim,
                      questions ? &*questions : nullptr, on_bad_line);
  {
    ProgressLine line;
    judged.judge_all(in, options.answers, [&](std::uint64_t lines) {
      if (!line.due()) return;
      const double share = &in == &file && bytes > 0 ? static_cast<double>(in.tellg()) / bytes : 0;
      line.show(share, fmt::format("{} answers", lines));
    });
  }
  fmt::print("{}", format_tallies(tally_methods(judged.tallies())));
  const Claim& claim = judged.claim();
  fmt::print("claim: always right if the gap or overlap exceeds {} size + {}\n",
             format_double(claim.relative), format_double(claim.absolute));
  print_findings(judged, options);
  if (judged.lines_passed_over() > 0)
    fmt::print("{} lines do not answer a pair\n", judged.lines_passed_over());
  if (!options.keep.empty()) {
    write_file(options.keep, failing_lines(judged));
    if (std::ranges::any_of(judged.findings(), fails))
      fmt::print("next: {} replay {}\n", own_command(), shell_quoted(options.keep));
  }
  return judged.exit_code();
}

}  // namespace

void add_judge(Program& program) {
  Command command =
      program.command("Find", "judge", "Judges the answers of another machine to the pairs of `ask`");
  auto options = std::make_shared<JudgeOptions>();
  command
      .option("ANSWERS", options->answers,
              "answers with the id of their pair, one a line in any order; '-' is standard input")
      .required()
      .readable();
  command.section("Input");
  command
      .option("--pairs FILE", options->pairs,
              "the pairs of the answers; without it, each answer has its own a and b")
      .readable();
  command.option("--name NAME", options->name, "name of the method that answered")
      .default_text("the name in the hello of the answers");
  command
      .option("--claim MARGIN", options->claim,
              "answers may be wrong only below this margin, relative to the size")
      .within(0, 1)
      .default_text("the claim in the hello of the answers, else 0");
  command.section("Output");
  command.option("--keep FILE", options->keep, "write the failing pairs as a case file, with the proofs")
      .writable();
  command.examples(
      "  daylight judge answers.jsonl --pairs pairs.jsonl --name mine --claim 1e-6 --keep failing.jsonl\n"
      "  daylight judge - --name mine < answers.jsonl",
      "An answer is {\"id\":\"17\",\"verdict\":\"disjoint\"}, with a distance, direction or point if there "
      "is one. It is\n"
      "{\"id\":\"17\",\"declined\":\"why\"} or {\"id\":\"17\",\"error\":\"why\"} if there is no verdict. "
      "Exit code 2\n"
      "of judge also means that an answer failed, is missing, or was given twice, or that a line is not an\n"
      "answer. Such lines are reported by number and affect no others.");
  command.run([options] { return judge_answers(*options); });
}

}  // namespace cyl
