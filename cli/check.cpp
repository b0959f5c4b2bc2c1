// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

namespace {

/// The most lines that are answered together, because one worker of a foreign method is forked for all of
/// them.
constexpr std::size_t batch_cap = 1000;

/// Decimals are read as the nearest doubles. Each length and coordinate is off by up to 2^-53 of itself, that
/// is 1.1e-16, and so are the components of the axes. A gap or overlap of less than this part of all lengths
/// and coordinates may be such an error.
constexpr double decimal_rounding_error = 1e-15;

/// The relative widths of the enclosures that are asked for, until one decides.
constexpr double decisive_widths[] = {1e-2, 1e-6, 1e-9, 1e-12, 1e-15, 1e-18};

struct CheckOptions {
  std::vector<std::string> files;
  std::string method;
  bool distance = false;
  double clearance = 0;  ///< in the unit of the pairs
  GuestOptions guests;
  bool asks_somebody() const { return !method.empty() || guests.any(); }
};

struct Reply {
  Verdict verdict;
  std::string line;
};

Reply malformed(const CaseLine& c, const std::string& file) {
  const std::string error = file.empty() ? c.error : file + ": " + c.error;
  return {Verdict::invalid, fmt::format(R"({{"verdict":"invalid","error":{}}})", quote_json(error))};
}

/// Adds members to the object of a line.
std::string with_members(std::string line, const std::string& members) {
  if (members.empty()) return line;
  line.back() = ',';
  return line + members.substr(0, members.size() - 1) + '}';
}

/// Returns the clearance as a member, so that the line answers the question that was asked.
std::string clearance_member(const CheckOptions& options) {
  return options.clearance == 0 ? "" : "\"clearance\":" + format_double(options.clearance) + ',';
}

/// Returns whether |distance| may be as small as the rounding of the decimals of a pair.
bool is_within_rounding(const Pair& pair, const Truth& truth) {
  double error = 0;
  for (const Solid* c : {&pair.a, &pair.b})
    for (const double x :
         {c->center.x(), c->center.y(), c->center.z(), c->radius, c->height, c->rounding, edges_of(*c)})
      error += decimal_rounding_error * std::abs(x);
  for (const double width : decisive_widths) {
    const Enclosure d = enclose_distance(pair, truth, width);
    if (std::max(d.lo, -d.hi) > error) return false;
    if (std::max(-d.lo, d.hi) <= error) return true;
  }
  return true;
}

/// Returns the pair whose verdict answers the question: the clearance is added to one rounding, because all
/// roundings count alike. A half-space has none.
Pair widened(Pair pair, double clearance) {
  (is_half_space(pair.a) ? pair.b : pair.a).rounding += clearance;
  return pair;
}

/// Returns the verdict that the referee proves. It tries the certificate of the solver first.
Reply certified(const CaseLine& c, Method& solver, const CheckOptions& options) {
  const Pair pair = widened(c.value->pair, options.clearance);
  const MethodAnswer offered[] = {solver.ask(pair)};
  Truth truth = judge(pair, offered);
  std::optional<Enclosure> distance;
  if (options.distance) distance = enclose_distance(pair, truth);
  const bool rounded = (truth.verdict == Verdict::disjoint || truth.verdict == Verdict::intersecting) &&
                       is_within_rounding(pair, truth);
  return {truth.verdict,
          with_members(format_truth(truth, distance ? &*distance : nullptr),
                       clearance_member(options) + (rounded ? "\"within_rounding\":true," : ""))};
}

/// Returns the method's own answer, which has no proof.
Reply reported(const Method& method, const MethodAnswer& answer, const CheckOptions& options) {
  if (answer.status == Status::answered) {
    std::string said = format_method_answer(answer);
    said.back() = ',';
    return {answer.verdict, with_members(fmt::format(R"({}"method":{}}})", said, quote_json(method.name())),
                                         clearance_member(options))};
  }
  const std::string error = fmt::format(
      "{} {}: {}", method.name(), answer.status == Status::declined ? "declined" : "failed", answer.reason);
  return {Verdict::undecided, fmt::format(R"({{"verdict":"undecided","method":{},"error":{}}})",
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
        if (more) batch.push_back(checked(std::move(*line)));
      } while (more && batch.size() < batch_cap && in.rdbuf()->in_avail() > 0);
      answer(batch, file);
      if (std::fflush(stdout) != 0) throw std::runtime_error("standard output could not be written");
    }
    if (in.bad()) throw std::runtime_error("reading failed");
  }

  int exit_code() const { return invalid_ ? exit_invalid_input : undecided_ ? exit_undecided : exit_pass; }

 private:
  /// Returns the line, with an error if the solid that grows is too large for the clearance.
  CaseLine checked(CaseLine line) const {
    if (!line.value || options_.clearance == 0) return line;
    const Pair wide = widened(line.value->pair, options_.clearance);
    const Defect defect = std::max(find_defect(wide.a), find_defect(wide.b));
    if (defect == Defect::none) return line;
    return {line.line, std::nullopt, fmt::format("line {}: the clearance: {}", line.line, to_string(defect))};
  }

  void answer(const std::vector<CaseLine>& batch, const std::string& file) {
    std::vector<ContainedAnswer> said;
    if (options_.asks_somebody()) {
      std::vector<Pair> pairs;
      std::vector<Question> questions;
      for (const CaseLine& c : batch) {
        if (!c.value) continue;
        questions.push_back({0, pairs.size()});
        pairs.push_back(widened(c.value->pair, options_.clearance));
      }
      said = ask_contained(methods_, pairs, questions);
    }
    auto next = said.begin();
    for (const CaseLine& c : batch) {
      print(!c.value                    ? malformed(c, file)
            : !options_.asks_somebody() ? certified(c, *methods_[0], options_)
                                        : reported(*methods_[0], (next++)->answer, options_));
    }
  }

  void print(const Reply& reply) {
    invalid_ |= reply.verdict == Verdict::invalid;
    undecided_ |= reply.verdict == Verdict::undecided;
    fmt::print("{}\n", reply.line);
  }

  const CheckOptions& options_;
  std::vector<std::unique_ptr<Method>> methods_;
  bool invalid_ = false;
  bool undecided_ = false;
};

int check(const CheckOptions& options) {
  if (!std::isfinite(options.clearance) || options.clearance < 0)
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
  command.section("Question");
  command.flag("--distance", options->distance, "add a certified enclosure of the signed distance");
  command.option("--clearance LENGTH", options->clearance, "decide if the signed distance is at most LENGTH")
      .not_empty("a length is expected");
  command.section("Methods");
  command.option("--method NAME", options->method, "print the unproved answer of this method instead of ours")
      .excludes("--distance");
  add_guest_options(command, options->guests);
  command.examples(
      "  echo "
      "'{\"a\":{\"center\":[0,0,0],\"axis\":[0,0,1],\"radius\":1,\"height\":2},\"b\":{\"center\":[3,0,0],"
      "\"axis\":[0,1,0],\"radius\":1,\"height\":2}}' | daylight check\n"
      "  daylight check --distance pairs.jsonl",
      "Exit code 0 of check means that all pairs are answered, 3 that some are undecided,\n"
      "and 65 that some are not valid.");
  command.run([options] { return check(*options); });
}

}  // namespace cyl
