// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

namespace {

/// The most lines that are answered together, because one worker of a foreign method is forked for all of
/// them.
constexpr std::size_t batch_cap = 1000;

struct CheckOptions {
  std::vector<std::string> files;
  std::string method;
  bool text = false;
  bool distance = false;
  double clearance = 0;  ///< in the unit of the pairs
  GuestOptions guests;
  bool asks_somebody() const { return !method.empty() || guests.any(); }
};

struct Reply {
  Verdict verdict;
  std::string line;
};

std::string label(const CaseLine& c) {
  return c.value && !c.value->id.empty() ? c.value->id : fmt::format("line {}", c.line);
}

Reply malformed(const CaseLine& c, const std::string& file, bool text) {
  const std::string error = file.empty() ? c.error : file + ": " + c.error;
  return {Verdict::invalid, text ? "invalid: " + error
                                 : fmt::format(R"({{"verdict":"invalid","error":{}}})", quote_json(error))};
}

std::string describe(Verdict verdict, const Enclosure& d) {
  if (verdict == Verdict::touching) return "";
  const bool apart = verdict == Verdict::disjoint;
  return fmt::format(", {} to {} {}", format_end(apart ? d.lo : 0 - d.hi),
                     format_end(apart ? d.hi : 0 - d.lo), apart ? "apart" : "deep");
}

/// Adds the clearance, so that the line answers the question that was asked.
std::string with_clearance(std::string line, const CheckOptions& options) {
  if (options.clearance == 0) return line;
  line.back() = ',';
  return line + "\"clearance\":" + format_double(options.clearance) + '}';
}

/// Returns the verdict that the referee proves. It tries the certificate of the solver first.
Reply certified(const CaseLine& c, Method& solver, const CheckOptions& options) {
  const Pair& pair = c.value->pair;
  const MethodAnswer offered[] = {solver.ask(pair)};
  const Truth truth = judge(pair, offered);
  std::optional<Enclosure> distance;
  if (options.distance) distance = enclose_distance(pair, truth);
  if (!options.text)
    return {truth.verdict, with_clearance(format_truth(truth, distance ? &*distance : nullptr), options)};
  return {truth.verdict, fmt::format("{}: {}{}, proof {}", label(c), to_string(truth.verdict),
                                     distance ? describe(truth.verdict, *distance) : "",
                                     format_certificate(truth.certificate))};
}

/// Returns the method's own answer, which has no proof.
Reply reported(const CaseLine& c, const Method& method, const MethodAnswer& answer,
               const CheckOptions& options) {
  const bool text = options.text;
  if (answer.status == Status::answered) {
    std::string said = format_method_answer(answer);
    if (text) return {answer.verdict, fmt::format("{}: {} answers {}", label(c), method.name(), said)};
    said.back() = ',';
    return {answer.verdict,
            with_clearance(fmt::format(R"({}"method":{}}})", said, quote_json(method.name())), options)};
  }
  const std::string error = fmt::format(
      "{} {}: {}", method.name(), answer.status == Status::declined ? "declined" : "failed", answer.reason);
  return {Verdict::undecided, text ? label(c) + ": " + error
                                   : fmt::format(R"({{"verdict":"undecided","method":{},"error":{}}})",
                                                 quote_json(method.name()), quote_json(error))};
}

class Checker {
 public:
  explicit Checker(const CheckOptions& options) : options_(options) {
    if (!options.asks_somebody()) {
      methods_.push_back(certifying_method());
      return;
    }
    methods_ = with_guests(options.guests, options.method).select(options.method, options.method);
    const auto named = [&](const auto& method) { return method->name() == options.method; };
    if (std::any_of(methods_.begin(), methods_.end(), named)) std::erase_if(methods_, std::not_fn(named));
    if (methods_.size() == 1) return;
    std::string message = options.method.empty() ? "ask one method at a time:"
                                                 : "--method " + options.method + " selects several methods:";
    for (const auto& method : methods_) message.append(" ").append(method->name());
    throw UsageError(message);
  }

  /// Writes one line for each non-blank input line, as soon as no more input waits.
  void answer_all(std::istream& in, const std::string& file) {
    CaseReader reader(in);
    std::vector<CaseLine> batch;
    bool more = true;
    while (more) {
      batch.clear();
      do {
        std::optional<CaseLine> line = reader.next();
        more = line.has_value();
        if (more) batch.push_back(widened(std::move(*line)));
      } while (more && batch.size() < batch_cap && in.rdbuf()->in_avail() > 0);
      answer(batch, file);
      if (std::fflush(stdout) != 0) throw std::runtime_error("standard output could not be written");
    }
    if (in.bad()) throw std::runtime_error("reading failed");
  }

  int exit_code() const { return invalid_ ? exit_invalid_input : undecided_ ? exit_undecided : exit_pass; }

 private:
  /// Adds the clearance to the rounding of a, because all roundings count alike.
  CaseLine widened(CaseLine line) const {
    if (!line.value || options_.clearance == 0) return line;
    Cylinder& a = line.value->pair.a;
    a.rounding += options_.clearance;
    if (find_defect(a) == Defect::none) return line;
    return {line.line, std::nullopt,
            fmt::format("line {}: the clearance: {}", line.line, to_string(find_defect(a)))};
  }

  void answer(const std::vector<CaseLine>& batch, const std::string& file) {
    std::vector<ContainedAnswer> said;
    if (options_.asks_somebody()) {
      std::vector<Pair> pairs;
      std::vector<Question> questions;
      for (const CaseLine& c : batch) {
        if (!c.value) continue;
        questions.push_back({0, pairs.size()});
        pairs.push_back(c.value->pair);
      }
      said = ask_contained(methods_, pairs, questions);
    }
    auto next = said.begin();
    for (const CaseLine& c : batch) {
      print(!c.value                    ? malformed(c, file, options_.text)
            : !options_.asks_somebody() ? certified(c, *methods_[0], options_)
                                        : reported(c, *methods_[0], (next++)->answer, options_));
    }
  }

  void print(const Reply& reply) {
    invalid_ |= reply.verdict == Verdict::invalid;
    undecided_ |= reply.verdict == Verdict::undecided;
    // JSON escapes control characters. A line of text may quote an id or a reason with control characters.
    fmt::print("{}\n", options_.text ? escaped_controls(reply.line) : reply.line);
  }

  const CheckOptions& options_;
  std::vector<std::unique_ptr<Method>> methods_;
  bool invalid_ = false;
  bool undecided_ = false;
};

int check(const CheckOptions& options) {
  if (!(options.clearance >= 0 && options.clearance <= std::numeric_limits<double>::max()))
    throw UsageError(
        fmt::format("--clearance {} is not a length: give a finite number, 0 or more", options.clearance));
  Checker checker(options);
  std::vector<std::string> files = options.files;
  if (files.empty()) files.push_back("-");
  for (const std::string& file : files) {
    std::ifstream in(file);
    checker.answer_all(file == "-" ? std::cin : in, files.size() > 1 ? file : "");
  }
  return checker.exit_code();
}

}  // namespace

void add_check(Program& program) {
  Command command =
      program.command("Ask", "check", "Reads pairs and writes a proved answer for each, one a line");
  auto options = std::make_shared<CheckOptions>();
  command.option("FILE", options->files, "JSON Lines of pairs; '-' or no file is standard input").readable();
  command.section("Output");
  command.flag("--text", options->text, "write sentences instead of JSON");
  command.section("Question");
  command.flag("--distance", options->distance, "add a certified enclosure of the signed distance");
  command
      .option("--clearance LENGTH", options->clearance,
              "decide whether the gap is at most this length, which is added to the rounding of a in doubles")
      .not_empty("a length is expected");
  command.section("Methods");
  command
      .option("--method NAME", options->method, "ask this method instead; its answer is reported, not proved")
      .excludes("--distance");
  add_guest_options(command, options->guests);
  command.examples(
      "  echo "
      "'{\"a\":{\"center\":[0,0,0],\"axis\":[0,0,1],\"radius\":1,\"height\":2},\"b\":{\"center\":[3,0,0],"
      "\"axis\":[0,1,0],\"radius\":1,\"height\":2}}' | daylight check\n"
      "  daylight check --text --distance pairs.jsonl",
      "Exit code 0 of check means that all pairs are answered, 3 that some are undecided,\n"
      "and 65 that some are not valid.");
  command.run([options] { return check(*options); });
}

}  // namespace cyl
