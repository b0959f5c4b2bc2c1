// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "corpus/store/run_facts.hpp"
#include "reports/triage/triage_context.hpp"

namespace cyl {
namespace {

/// The causes that are stored in one transaction.
constexpr std::size_t together_cap = 32;

/// Drops the results about a guest that has changed. Keeps the results about a guest that is not here.
void forget_changed_guests(const TriageContext& context) {
  TriageStore store = context.store();
  for (std::size_t m = 0; m < context.methods.size(); ++m) {
    const Method& method = *context.methods[m];
    if (!method.guest()) continue;
    std::vector<std::int64_t> findings;
    for (const Subject& s : context.subjects)
      if (s.method == m) findings.push_back(s.record->id);
    store.expect(std::string(method.name()), std::string(method.version()), findings);
  }
}

/// Puts the first of each method, kind, severity and family before the second of any. If time runs out, few
/// causes are missing then.
void put_in_turns(std::vector<const Subject*>& subjects) {
  std::map<FindingGroup, std::size_t> seen;
  std::vector<std::pair<std::size_t, const Subject*>> turns;
  for (const Subject* s : subjects) turns.emplace_back(seen[*s->record]++, s);
  std::ranges::stable_sort(turns, {}, [](const auto& turn) { return turn.first; });
  for (std::size_t i = 0; i < turns.size(); ++i) subjects[i] = turns[i].second;
}

std::string key_of(const Subject& s, const GroupedMethods& methods, Mechanism mechanism) {
  if (!is_method_row(s.record->method)) return s.record->method + '/' + to_string(s.kind());
  if (!s.method) return s.record->method + "/not-in-this-build";
  return cause_key(methods, {*s.method, s.kind(), s.pair}, s.severity(), mechanism, s.record->reason);
}

std::string mechanism_labels(const Classification& found, std::span<const std::unique_ptr<Method>> methods) {
  std::string labels;
  const auto add = [&](const std::string& label) { labels += (labels.empty() ? "" : "\n") + label; };
  if (found.right_at_origin) add("offset: right at the origin");
  if (found.capped) add("iteration cap: its search reached its maximum number of steps");
  if (found.larger) add("absolute length: right if the pair is larger");
  if (found.smaller) add("absolute length: right if the pair is smaller");
  if (found.right_sibling)
    add(fmt::format("own setting: {} is right", methods[*found.right_sibling]->name()));
  return labels;
}

CauseRecord cause_of(const Subject& s, const GroupedMethods& methods, Asker& asker) {
  constexpr Mechanism none = Mechanism::unclassified;
  if (!s.can_be_classified()) return {s.record->id, key_of(s, methods, none), none, ""};
  const Failing failing = s.failing();
  const Classification c = classify(methods.methods, failing, asker);
  return {s.record->id, key_of(s, methods, c.mechanism), c.mechanism, mechanism_labels(c, methods.methods)};
}

}  // namespace

void classify_findings(const TriageContext& context, double part) {
  forget_changed_guests(context);
  std::set<std::int64_t> known;
  for (const CauseRecord& c : context.causes()) known.insert(c.finding);
  std::vector<const Subject*> open;
  for (const Subject& s : context.subjects)
    if (!s.absent && !known.contains(s.record->id)) open.push_back(&s);
  if (open.empty()) return;
  put_in_turns(open);
  context.in_processes([&](unsigned job) {
    TriageStore store = context.store();
    Asker asker(context.methods, context.caps(part));
    std::vector<CauseRecord> causes;  // stored a few at a time, as each transaction takes a while
    for (std::size_t i = job; i < open.size(); i += context.options.jobs) {
      CauseRecord cause = cause_of(*open[i], context.grouped(), asker);
      if (context.out_of_time(part)) break;
      causes.push_back(std::move(cause));
      if (causes.size() < together_cap) continue;
      store.add(causes);
      causes.clear();
    }
    store.add(causes);
  });
}

}  // namespace cyl
