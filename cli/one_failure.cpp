// SPDX-License-Identifier: MIT
#include "cli/one_failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "base/json.hpp"
#include "base/usage_error.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/targets.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"
#include "reports/export/export.hpp"
#include "reports/triage/triage.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

FindingKind kind_of_word(const std::string& word) {
  if (const auto kind = from_word<FindingKind>(word)) return *kind;
  throw UsageError(fmt::format("'{}' is not a kind of finding", word));
}

/// Returns the cause that has that key in the last triage.
nlohmann::json find_cause(const std::string& run, const std::string& key) {
  if (!fs::is_directory(run)) throw UsageError(fmt::format("'{}' is not a run, so it has no causes", run));
  const nlohmann::json causes = causes_json(run);
  for (const nlohmann::json& cause : causes)
    if (cause.at("key") == key) return cause;
  throw UsageError(fmt::format("{0} has no cause '{1}': `daylight triage {0}` lists its {2} causes", run, key,
                               causes.size()));
}

Pair pair_in(const nlohmann::json& shown) {
  return parse_case(shown.at("pair").dump(), 1).value.value().pair;
}

/// Returns the first stored failure with the cause that fits.
std::optional<OneFailure> stored_failure(const std::string& run, const nlohmann::json& cause,
                                         const std::function<bool(const OneFailure&)>& fits) {
  const auto ids = cause.at("findings").get<std::set<std::int64_t>>();
  for (const FindingRecord& f : RunStore::open(run).findings())
    if (ids.contains(f.id))
      if (const CaseLine line = parse_case(f.pair, 1); line.value)
        if (OneFailure found{f.method, f.kind, line.value->pair}; fits(found)) return found;
  return {};
}

OneFailure failure_with_cause(const FailureOptions& options,
                              std::span<const std::unique_ptr<Method>> methods) {
  const std::string run = lasting_name(options.target);
  const nlohmann::json cause = find_cause(run, options.key);
  const auto names = cause.at("methods").get<std::vector<std::string>>();
  OneFailure failure{cause.at("method"), kind_of_word(cause.at("kind")), pair_in(cause.at("simplest"))};
  if (!options.method.empty()) {
    if (std::ranges::find(names, options.method) == names.end())
      throw UsageError(fmt::format("cause '{}' has the methods {}", options.key, fmt::join(names, ", ")));
    failure.method = options.method;
    const auto asked = position_of(methods, options.method);
    if (asked && !try_method(methods[*asked], failure.pair).fails(failure.kind))
      failure = stored_failure(run, cause, [&](const OneFailure& f) {
                  return f.method == options.method;
                }).value_or(failure);
  }
  const auto method = position_of(methods, failure.method);
  if (const auto worst = cause.find("worst"); method && worst != cause.end() && worst->is_object())
    failure.pair = pair_to_send(methods[*method], failure.kind, failure.pair, pair_in(*worst));
  const auto can_be_sent = [&](const OneFailure& f) {
    const auto m = position_of(methods, f.method);
    return m && (options.method.empty() || f.method == options.method) &&
           refusal(f.method, f.kind, f.pair, methods[*m]->guest()).empty() &&
           try_method(methods[*m], f.pair).fails(f.kind);
  };
  if (!can_be_sent(failure)) failure = stored_failure(run, cause, can_be_sent).value_or(failure);
  if (options.method.empty() && names.size() > 1)
    fmt::print("the methods {} share this cause, and this is about {} (--method selects another)\n",
               fmt::join(names, ", "), failure.method);
  return failure;
}

}  // namespace

void add_failure_options(Command& command, FailureOptions& options) {
  command.option("CASE", options.target, "RUN:ID, FILE:LINE, a file of one case, or RUN with KEY").required();
  command.option("KEY", options.key, "a cause of RUN, as `triage` lists it");
  command.section("Methods");
  command.option("--method NAME", options.method, "the method that is wrong")
      .default_text("the method of the finding");
  command.option("--kind KIND", options.kind, "kind of failure, such as wrong_disjoint")
      .default_text("the finding's kind, or that of a fresh answer");
  add_guest_options(command, options.guests);
  add_run_guests_option(command, options.guests);
}

OneFailure failure_of(const FailureOptions& options, std::span<const std::unique_ptr<Method>> methods) {
  if (!options.key.empty()) return failure_with_cause(options, methods);
  const std::vector<Target> targets = targets_of(options.target);
  if (targets.size() != 1)
    throw UsageError(
        fmt::format("'{}' has {} pairs: give one pair, as FILE:LINE or RUN:ID, or a cause, as RUN KEY",
                    options.target, targets.size()));
  const Target& target = targets.front();
  const bool stored = target.finding && (options.method.empty() || options.method == target.finding->method);
  const std::string name = stored ? target.finding->method : options.method;
  if (name.empty()) throw UsageError("give the method with --method NAME");
  if (!options.kind.empty()) return {name, kind_of_word(options.kind), target.pair};
  if (stored) return {name, target.finding->kind, target.pair};
  const Trial now = try_method(find_method(methods, name), target.pair);
  if (!now.finding())
    throw UsageError(fmt::format("{} is right on {}: it answers {}, and the solids are {}", name,
                                 target.label, format_method_answer(now.answer()), distance_in_words(now)));
  return {name, now.finding()->kind, target.pair};
}

}  // namespace cyl
