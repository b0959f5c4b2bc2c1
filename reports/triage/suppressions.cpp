// SPDX-License-Identifier: MIT
#include "reports/triage/suppressions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "base/usage_error.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

constexpr std::array<std::pair<const char*, std::string Suppression::*>, 5> suppression_fields{{
    {"cause", &Suppression::cause},
    {"reason", &Suppression::reason},
    {"link", &Suppression::link},
    {"owner", &Suppression::owner},
    {"expires", &Suppression::expires},
}};

[[noreturn]] void refuse_line(std::size_t line, std::size_t at, const std::string& why) {
  throw std::invalid_argument("line " + std::to_string(line) + ", column " + std::to_string(at + 1) + ": " +
                              why);
}

/// Returns the place in the text of a key's value, or of the key itself, or 0.
std::size_t column_of(const std::string& text, const std::string& key) {
  const std::size_t at = text.find(nlohmann::json(key).dump());
  if (at == text.npos) return 0;
  const std::size_t value = text.find_first_not_of(" \t:", at + nlohmann::json(key).dump().size());
  return value == text.npos ? at : value;
}

bool is_date(const std::string& text) {
  constexpr std::string_view form = "dddd-dd-dd";
  if (text.size() != form.size()) return false;
  for (std::size_t i = 0; i < form.size(); ++i)
    if (form[i] == 'd' ? text[i] < '0' || text[i] > '9' : text[i] != form[i]) return false;
  const auto number = [&](std::size_t from, std::size_t count) {
    return static_cast<unsigned>(std::stoul(text.substr(from, count)));
  };
  return (std::chrono::year(static_cast<int>(number(0, 4))) / std::chrono::month(number(5, 2)) /
          std::chrono::day(number(8, 2)))
      .ok();
}

Suppression parse_suppression(const std::string& text, std::size_t line) {
  nlohmann::json object;
  try {
    object = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    refuse_line(line, error.byte > 0 ? error.byte - 1 : 0, "no JSON");
  }
  if (!object.is_object()) refuse_line(line, 0, "no object");
  Suppression s;
  s.line = line;
  for (const auto& item : object.items()) {
    const std::string& key = item.key();
    const nlohmann::json& value = item.value();
    const auto field = std::find_if(suppression_fields.begin(), suppression_fields.end(),
                                    [&](const auto& f) { return f.first == key; });
    if (field == suppression_fields.end())
      refuse_line(line, text.find(nlohmann::json(key).dump()), "'" + key + "' is not a field");
    if (!value.is_string()) refuse_line(line, column_of(text, key), key + " is not a text");
    if (value.get<std::string>().empty())
      refuse_line(line, column_of(text, key), key + " is empty: fill it in");
    s.*field->second = value.get<std::string>();
  }
  for (const auto& [key, member] : suppression_fields)
    if ((s.*member).empty()) refuse_line(line, 0, std::string(key) + " is missing");
  if (!is_date(s.expires)) refuse_line(line, column_of(text, "expires"), "expires is not a day YYYY-MM-DD");
  return s;
}

constexpr std::size_t cases_at_once = 32;
constexpr Caps caps = attended_caps(1);

/// A wrong answer, its severity and the method's own words.
struct WrongAnswer {
  Failing failing;
  Severity severity;
  std::string reason;
};

/// Returns whether the key of a method's cause may be suppressed: it begins with "own" or with its library.
bool may_name(const std::vector<Suppression>& suppressions, const Method& method) {
  return std::ranges::any_of(suppressions, [&](const Suppression& s) {
    return s.cause.starts_with(method.library()) || (!method.foreign() && s.cause.starts_with("own/"));
  });
}

std::set<std::string> causes_of(const GroupedMethods& of, const std::vector<WrongAnswer>& wrong) {
  // The key of an answer within the claim names no mechanism, so none is looked for.
  const auto within = [](const WrongAnswer& w) { return w.severity == Severity::resolution; };
  std::vector<Failing> failing;
  for (const WrongAnswer& w : wrong)
    if (!within(w)) failing.push_back(w.failing);
  const std::vector<Classification> classified = classify(of.methods, failing, caps);
  std::set<std::string> causes;
  std::size_t next = 0;
  for (const WrongAnswer& w : wrong) {
    const auto mechanism = within(w) ? Mechanism::unclassified : classified[next++].mechanism;
    causes.insert(cause_key(of, w.failing, w.severity, mechanism, w.reason));
  }
  return causes;
}

/// Returns the answers beyond the claim that explain a failure. A broken law compares several answers or an
/// answer with the truth, so at least one of its answers is wrong. Returns nothing for a law that asks about
/// the pair in another way, because its answers may all be right.
std::vector<WrongAnswer> wrong_answers(const JudgedFailure& f,
                                       std::span<const std::unique_ptr<Method>> methods, std::size_t m) {
  const auto kind = from_word<FindingKind>(f.kind);
  if (kind || (f.failed && *f.failed != FindingKind::non_finite)) {
    std::vector<WrongAnswer> both;  // the simplest pair may fail for another reason than the one found
    for (const Pair& pair : {f.simplest, f.found})
      both.push_back({{m, kind ? *kind : *f.failed, pair}, f.severity, f.reason});
    return both;
  }
  std::vector<Pair> pairs{f.simplest};
  if (f.law->queries != needs_none) {
    if (f.law->kind == LawKind::answer) return {};
    const MethodAnswer first = try_method(methods[m], pairs, caps)[0].answer();
    if (first.status != Status::answered) return {};
    for (const LawQuery& query : f.law->queries(*methods[m], f.simplest, first)) pairs.push_back(query.pair);
  }
  std::vector<WrongAnswer> wrong;
  for (const Trial& trial : try_method(methods[m], pairs, caps))
    if (const auto& finding = trial.finding(); finding && finding->severity == Severity::contract)
      wrong.push_back({{m, finding->kind, trial.pair}, finding->severity, trial.answer().reason});
  return wrong;
}

}  // namespace

std::vector<Suppression> read_suppressions(std::istream& in) {
  std::vector<Suppression> all;
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    if (text.find_first_not_of(" \t\r") == text.npos) continue;
    Suppression s = parse_suppression(text, line);
    const auto same = std::find_if(all.begin(), all.end(), [&](const auto& x) { return x.cause == s.cause; });
    if (same != all.end())
      refuse_line(line, column_of(text, "cause"),
                  "the cause has line " + std::to_string(same->line) + " already");
    all.push_back(std::move(s));
  }
  return all;
}

std::vector<Suppression> read_suppressions(const std::optional<std::string>& given,
                                           const std::string& usual) {
  const std::string file = given.value_or(usual);
  if (file.empty()) return {};
  if (!std::filesystem::exists(file)) {
    if (given) throw UsageError(file + ": is not a file; '' means no suppressions");
    return {};
  }
  std::ifstream in(file);
  try {
    std::vector<Suppression> all = read_suppressions(in);
    if (in.bad() || !in.eof()) throw std::invalid_argument("cannot be read");
    return all;
  } catch (const std::invalid_argument& error) {
    throw UsageError(file + ": " + error.what());
  }
}

std::string line_of(const Suppression& s) {
  nlohmann::ordered_json line;
  for (const auto& [key, member] : suppression_fields) line[key] = s.*member;
  return line.dump();
}

// Days in this form have the order of their texts.
bool is_expired(const Suppression& suppression, std::string_view today) {
  return std::string_view(suppression.expires) < today;
}

const Suppression* find_suppression(const std::vector<Suppression>& suppressions, std::string_view cause,
                                    std::string_view today) {
  for (const Suppression& s : suppressions)
    if (s.cause == cause && !is_expired(s, today)) return &s;
  return nullptr;
}

std::set<std::string> causes_of(const GroupedMethods& of, std::span<const Case> cases,
                                const std::vector<Suppression>& suppressions) {
  std::set<std::string> causes;
  for (std::size_t first = 0; first < cases.size(); first += cases_at_once) {
    std::vector<Pair> pairs;
    for (const Case& c : cases.subspan(first, std::min(cases_at_once, cases.size() - first)))
      pairs.push_back(c.pair);
    std::vector<WrongAnswer> found;
    for (std::size_t m = 0; m < of.methods.size(); ++m) {
      if (!may_name(suppressions, *of.methods[m])) continue;
      for (const Trial& trial : try_method(of.methods[m], pairs, caps))
        if (const std::optional<Finding>& wrong = trial.finding())
          found.push_back({{m, wrong->kind, trial.pair}, wrong->severity, trial.answer().reason});
    }
    causes.merge(causes_of(of, found));
  }
  return causes;
}

void judge_suppressions(JudgedGate& gate, std::span<const std::unique_ptr<Method>> methods,
                        std::span<const Case> cases, const std::vector<Suppression>& suppressions,
                        std::string_view today) {
  if (suppressions.empty()) return;
  const auto named = [&](const Method& method) { return may_name(suppressions, method); };
  const std::vector<std::size_t> groups = algorithm_groups(methods, named);
  const GroupedMethods grouped{methods, groups};
  const auto suppressed = [&](std::string_view key) {
    return find_suppression(suppressions, key, today) != nullptr;
  };
  std::set<std::string> stored = causes_of(grouped, cases, suppressions);
  for (JudgedFailure& f : gate.failures) {
    f.known |= suppressed(f.cause);
    if (f.in_case()) stored.insert(f.cause);
    const auto method = position_of(methods, f.method);
    if (f.known || !method || !named(*methods[*method])) continue;
    const std::set<std::string> causes = causes_of(grouped, wrong_answers(f, methods, *method));
    f.known = !causes.empty() && std::ranges::all_of(causes, suppressed);
  }
  for (GateRemark& remark : suppression_remarks(suppressions, today, stored))
    gate.remarks.push_back(std::move(remark));
}

std::vector<GateRemark> suppression_remarks(const std::vector<Suppression>& suppressions,
                                            std::string_view today, const std::set<std::string>& causes) {
  std::vector<GateRemark> remarks;
  for (const Suppression& s : suppressions) {
    const std::string which = fmt::format("the suppression of {} (line {})", s.cause, s.line);
    if (is_expired(s, today))
      remarks.push_back({fmt::format("{} expired on {}; its owner is {}", which, s.expires, s.owner)});
    if (!causes.contains(s.cause))
      remarks.push_back({which + " matches no stored case: remove it, or keep a case of it", exit_findings});
  }
  return remarks;
}

}  // namespace cyl
