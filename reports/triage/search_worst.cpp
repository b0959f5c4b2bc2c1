// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>

#include "corpus/pairs/pair_io.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/triage/causes.hpp"
#include "reports/triage/group_findings.hpp"
#include "reports/triage/triage_context.hpp"
#include "reports/triage/worst_pair.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

/// The most shapes examined for the worst pair of a cause: two walks, which take a few seconds.
constexpr std::size_t shapes_cap = 500;

const Pair* simplest_of(const std::vector<const Subject*>& subjects,
                        const std::map<std::int64_t, Pair>& simple_of) {
  const Pair* simplest = nullptr;
  for (const Subject* s : subjects) {
    const auto found = simple_of.find(s->record->id);
    if (found == simple_of.end()) continue;
    if (simplest == nullptr || complexity(found->second) < complexity(*simplest)) simplest = &found->second;
  }
  return simplest;
}

bool is_worse_subject(const Subject* x, const Subject* y) {
  return is_worse(*x->record, *y->record) ||
         (!is_worse(*y->record, *x->record) && x->record->id < y->record->id);
}

/// Takes method and kind from the worst finding. Starts at all findings of this kind, other methods' last.
CauseSought cause_sought(const std::string& key, std::vector<const Subject*> subjects,
                         const std::map<std::int64_t, Mechanism>& mechanism_of,
                         const std::map<std::int64_t, Pair>& simple_of) {
  const Subject& worst = **std::min_element(subjects.begin(), subjects.end(), is_worse_subject);
  std::erase_if(subjects, [&](const Subject* s) { return s->kind() != worst.kind(); });
  std::sort(subjects.begin(), subjects.end(), [&](const Subject* x, const Subject* y) {
    const bool own_x = x->method == worst.method, own_y = y->method == worst.method;
    return own_x != own_y ? own_x : is_worse_subject(x, y);
  });
  CauseSought cause{key, mechanism_of.at(worst.record->id), *worst.method, worst.kind(), {}};
  for (const Subject* s : subjects) cause.starts.push_back(s->pair);
  if (const Pair* simplest = simplest_of(subjects, simple_of))
    cause.starts.insert(cause.starts.begin() + 1, *simplest);
  return cause;
}

/// Returns the causes in the order of their keys.
std::vector<CauseSought> causes_sought(const TriageContext& context) {
  std::map<std::string, std::vector<const Subject*>> subjects_of;
  std::map<std::int64_t, Mechanism> mechanism_of;
  for (const CauseRecord& c : context.causes()) {
    const auto found = context.by_id.find(c.finding);
    if (found == context.by_id.end() || c.mechanism == Mechanism::gone || !found->second->can_be_searched())
      continue;
    subjects_of[c.cause].push_back(found->second);
    mechanism_of[c.finding] = c.mechanism;
  }
  std::map<std::int64_t, Pair> simple_of;
  for (const SimpleRecord& s : context.simples())
    if (const CaseLine line = parse_case(s.pair, 1); line.value) simple_of[s.finding] = line.value->pair;
  std::vector<CauseSought> causes;
  for (const auto& [key, subjects] : subjects_of)
    causes.push_back(cause_sought(key, subjects, mechanism_of, simple_of));
  return causes;
}

/// Continues from the result of an earlier search that was cut.
WorstRecord searched(const TriageContext& context, CauseSought cause, const WorstRecord& earlier,
                     milliseconds budget, double part) {
  if (const CaseLine line = parse_case(earlier.pair, 1); line.value)
    cause.starts.insert(cause.starts.begin(), line.value->pair);
  WorstOptions options;
  options.evaluation_cap = shapes_cap;
  options.budget = budget;
  const milliseconds began = context.elapsed();
  const auto found = worst_of_cause(context.grouped(), cause, options, context.caps(part));
  return {cause.key, std::string(context.methods[cause.method]->name()), cause.kind,
          found ? format_pair(found->pair) : earlier.pair, context.elapsed() - began < budget};
}

}  // namespace

void search_worst(const TriageContext& context, double part) {
  std::map<std::string, WorstRecord> earlier;
  for (const WorstRecord& w : context.store().worsts()) earlier[w.cause] = w;
  std::vector<CauseSought> open;
  for (CauseSought& cause : causes_sought(context))
    if (!earlier[cause.key].ended) open.push_back(std::move(cause));
  if (open.empty() || context.out_of_time(part)) return;
  const unsigned jobs = context.options.jobs;
  context.in_processes([&](unsigned job) {
    TriageStore store = context.store();
    for (std::size_t i = job; i < open.size() && !context.out_of_time(part); i += jobs) {
      const auto left = static_cast<milliseconds::rep>((open.size() - i - 1) / jobs + 1);
      const auto until = std::chrono::duration_cast<milliseconds>(part * context.budget);
      const milliseconds budget = (until - context.elapsed()) / left;
      store.add(searched(context, open[i], earlier[open[i].key], budget, part));
    }
  });
}

}  // namespace cyl
