// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
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

#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/guests.hpp"
#include "cli/options.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/referee/half_space.hpp"
#include "oracles/referee/interval.hpp"
#include "oracles/referee/referee.hpp"

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
  bool text = false;
  bool distance = false;
  double clearance = 0;  ///< in the unit of the pairs. If negative, minus the tolerated depth
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

std::string describe(const Enclosure& d) {
  if (d.lo == 0 && d.hi == 0) return "";
  if (d.lo < 0 && d.hi > 0) return fmt::format(", {} deep to {} apart", format_end(-d.lo), format_end(d.hi));
  const bool apart = d.lo >= 0;
  return fmt::format(", {} to {} {}", format_end(apart ? d.lo : 0 - d.hi),
                     format_end(apart ? d.hi : 0 - d.lo), apart ? "apart" : "deep");
}

/// Returns what the verdict means for the solids themselves.
std::string in_words(Verdict verdict, double clearance) {
  if (clearance == 0 || verdict == Verdict::undecided) return to_string(verdict);
  const std::string length = format_double(std::abs(clearance));
  const bool meet = verdict == Verdict::intersecting;
  if (clearance < 0) return (meet ? "deeper than " : "not deeper than ") + length;
  if (meet) return "within " + length;
  return (verdict == Verdict::touching ? "exactly " : "more than ") + length + " apart";
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

/// Adds a length to both ends, rounded outward.
Enclosure shifted(const Enclosure& d, const Interval& length) {
  const Interval sum = Interval(d.lo, d.hi) + length;
  return {sum.lo, sum.hi};
}

/// Returns whether |distance| may be as small as the rounding of the decimals of a pair. `distance` encloses
/// it at a relative width.
bool is_within_rounding(const Pair& pair, const std::function<Enclosure(double)>& distance) {
  double error = 0;
  for (const Solid* c : {&pair.a, &pair.b})
    for (const double x :
         {c->center.x(), c->center.y(), c->center.z(), c->radius, c->height, c->rounding, edges_of(*c)})
      error += decimal_rounding_error * std::abs(x);
  for (const double width : decisive_widths) {
    const Enclosure d = distance(width);
    if (std::max(d.lo, -d.hi) > error) return false;
    if (std::max(-d.lo, d.hi) <= error) return true;
  }
  return true;
}

/// Returns the solid that a clearance grows: a, or b if a is a half-space.
auto& growing(auto& pair) { return is_half_space(pair.a) ? pair.b : pair.a; }

/// Returns the pair whose verdict answers the question: the clearance is added to one rounding, because all
/// roundings count alike.
Pair widened(Pair pair, double clearance) {
  if (clearance > 0) growing(pair).rounding += clearance;
  return pair;
}

/// Decides by the distance whether the solids overlap by more than the tolerated depth. Sets the verdict. A
/// direction proves that they do not; one of doubles may not exist for touching solids 1e16 times as large as
/// the tolerated depth. That they do has no certificate but the enclosure. Returns the enclosure, less the
/// clearance.
Enclosure decide_depth(const Pair& pair, Truth& truth, double clearance) {
  const bool no_overlap = truth.verdict == Verdict::disjoint || truth.verdict == Verdict::touching;
  Enclosure beyond{};
  AttainedDistance attained;
  for (const double width : decisive_widths) {
    attained = attain_distance(pair, truth, width);
    beyond = shifted(attained.distance, Interval(-clearance));
    if (beyond.lo > 0 || beyond.hi < 0) break;
  }
  const bool shown = beyond.lo > 0;
  if (no_overlap) beyond.lo = std::max(beyond.lo, -clearance);
  truth.verdict = beyond.lo > 0   ? Verdict::disjoint
                  : beyond.hi < 0 ? Verdict::intersecting
                                  : Verdict::undecided;
  if (shown || truth.certificate.kind != CertificateKind::direction) truth.certificate = {};
  if (shown && attained.direction != std::array{0.0, 0.0, 0.0}) {
    truth.certificate.kind = CertificateKind::direction;
    truth.certificate.vector.head = attained.direction;
    if (has_half_space(pair)) {  // only the normal itself separates
      const Vector3 n = direction_of_half_space(pair);
      truth.certificate.vector.head = {n.x(), n.y(), n.z()};
    }
  }
  return beyond;
}

/// Returns the verdict that the referee proves. It tries the certificate of the solver first.
Reply certified(const CaseLine& c, Method& solver, const CheckOptions& options) {
  const Pair pair = widened(c.value->pair, options.clearance);
  const MethodAnswer offered[] = {solver.ask(pair)};
  Truth truth = judge(pair, offered);
  std::optional<Enclosure> distance;
  if (options.clearance < 0)
    distance = decide_depth(pair, truth, options.clearance);
  else if (options.distance)
    distance = enclose_distance(pair, truth);
  const bool rounded = (truth.verdict == Verdict::disjoint || truth.verdict == Verdict::intersecting) &&
                       is_within_rounding(pair, [&](double width) {
                         return options.clearance < 0 ? *distance : enclose_distance(pair, truth, width);
                       });
  if (!options.text)
    return {truth.verdict,
            with_members(format_truth(truth, distance ? &*distance : nullptr),
                         clearance_member(options) + (rounded ? "\"within_rounding\":true," : ""))};
  const Interval added = options.clearance < 0
                             ? Interval(options.clearance)
                             : Interval(growing(pair).rounding) - Interval(growing(c.value->pair).rounding);
  const Certificate& proof = truth.certificate;
  return {truth.verdict,
          fmt::format("{}: {}{}{}{}", label(c), in_words(truth.verdict, options.clearance),
                      distance ? describe(shifted(*distance, added)) : "",
                      proof.kind == CertificateKind::none ? "" : ", proof " + format_certificate(proof),
                      rounded ? ". The rounding of decimals to doubles may decide this" : "")};
}

/// Returns the method's own answer, which has no proof.
Reply reported(const CaseLine& c, const Method& method, const MethodAnswer& answer,
               const CheckOptions& options) {
  const bool text = options.text;
  if (answer.status == Status::answered) {
    std::string said = format_method_answer(answer);
    if (text) return {answer.verdict, fmt::format("{}: {} answers {}", label(c), method.name(), said)};
    said.back() = ',';
    return {answer.verdict, with_members(fmt::format(R"({}"method":{}}})", said, quote_json(method.name())),
                                         clearance_member(options))};
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
  if (!std::isfinite(options.clearance))
    throw UsageError(fmt::format("--clearance {} is not a length: give a finite number", options.clearance));
  if (options.clearance < 0 && options.asks_somebody())
    throw UsageError("a --clearance below 0 is decided by proved distances, not by a method");
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
              "decide if the signed distance is <= LENGTH; if LENGTH is below 0, if it is < LENGTH")
      .not_empty("a length is expected");
  command.section("Methods");
  command.option("--method NAME", options->method, "print the unproved answer of this method instead of ours")
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
