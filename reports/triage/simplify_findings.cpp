// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "corpus/pairs/pair_io.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/trial.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/triage/group_findings.hpp"
#include "reports/triage/triage_context.hpp"

namespace cyl {
namespace {

/// The most questions of the shrinker about one finding, and about a finding that hangs. Each question that
/// hangs costs half a second.
constexpr std::size_t simplify_cap = 1500, simplify_hang_cap = 600;
/// The hangs in one round of questions about a finding. If it hangs, one pair at a time is enough.
constexpr unsigned round_hangs_cap = 4, hang_hangs_cap = 1;

/// A finding that waits in its cause for its turn.
struct Waiting {
  std::size_t turn;
  Complexity complexity;
  const Subject* subject;
};

/// Puts the least shown_rank() and the simplest first, and other methods, kinds and families before repeated
/// ones.
void put_in_order(std::vector<Waiting>& cause) {
  std::ranges::sort(cause, {}, [](const Waiting& w) {
    return std::tuple(shown_rank(w.subject->pair), w.complexity, w.subject->record->id);
  });
  std::map<std::tuple<std::string, FindingKind, std::string>, std::size_t> seen;
  for (Waiting& w : cause)
    w.turn = seen[{w.subject->record->method, w.subject->record->kind, w.subject->record->family}]++;
  std::ranges::stable_sort(cause, {}, &Waiting::turn);
}

/// The properties that a simpler pair shares with the finding, besides the way to fail and the cause.
struct Likeness {
  std::optional<ContactFeature> feature;
  std::optional<bool> too_far;  ///< of a wrong distance: it is greater than the true one
};

std::optional<bool> is_too_far(const Trial& trial, const MethodAnswer& said) {
  return said.has_distance && said.distance > trial.distance.hi;
}

/// Whether the trial fails as the finding does: in the same way, with the same cause and likeness.
bool fails_alike(const GroupedMethods& methods, const Subject& s, const std::string& cause,
                 const Likeness& like, Trial trial, const MethodAnswer& said, Asker& asker) {
  const auto found = compare(trial, methods.methods[*s.method]->claim(), said);
  if (!found || found->kind != s.kind() || found->severity != s.severity()) return false;
  if (like.too_far && is_too_far(trial, said) != like.too_far) return false;
  if (contact_feature(trial.pair, trial.truth) != like.feature) return false;
  if (!s.can_be_classified()) return true;
  return find_cause(methods, {*s.method, s.kind(), trial.pair}, s.severity(), said.reason, asker) == cause;
}

/// Marks the first pair that fails alike, because the others are not examined.
std::vector<bool> fail_alike(const GroupedMethods& methods, const Subject& s, const std::string& cause,
                             const Likeness& like, std::span<const Pair> pairs, Asker& asker) {
  std::vector<Question> questions;
  for (std::size_t p = 0; p < pairs.size(); ++p) questions.push_back({*s.method, p});
  const auto said = asker.ask(pairs, questions);
  std::vector<bool> fails(pairs.size(), false);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const MethodAnswer& answer = said[p].answer;
    fails[p] = fails_alike(methods, s, cause, like, Trial(pairs[p], {&answer, 1}), answer, asker);
    if (fails[p]) break;
  }
  return fails;
}

SimpleRecord simplified(const TriageContext& context, const Subject& s, const std::string& cause,
                        const SimpleRecord& earlier, double part) {
  Asker asker(context.methods,
              context.caps(part, s.kind() == FindingKind::hang ? hang_hangs_cap : round_hangs_cap));
  Likeness like{contact_feature(s.pair), {}};
  if (s.kind() == FindingKind::distance_outside) {
    const Question question{*s.method, 0};
    const MethodAnswer said = asker.ask({&s.pair, 1}, {&question, 1})[0].answer;
    Trial trial(s.pair, {&said, 1});
    if (compare(trial, context.methods[*s.method]->claim(), said)) like.too_far = is_too_far(trial, said);
  }
  bool cut = false;
  const StillFails still_fails = [&](std::span<const Pair> pairs) {
    std::vector<bool> fails(pairs.size());
    if (!cut) fails = fail_alike(context.grouped(), s, cause, like, pairs, asker);
    cut = cut || context.out_of_time(part);
    if (cut) fails.assign(pairs.size(), false);
    return fails;
  };
  const CaseLine begun = parse_case(earlier.pair, 1);
  const std::size_t cap = s.kind() == FindingKind::hang ? simplify_hang_cap : simplify_cap;
  const Simplified simple = simplify(begun.value ? begun.value->pair : s.pair, still_fails, cap);
  return {s.record->id, format_pair(simple.pair), !cut};
}

}  // namespace

std::vector<const Subject*> simplification_order(const TriageContext& context,
                                                 const std::set<std::string>& known) {
  const std::vector<CauseRecord> records = context.causes();
  std::map<std::string, std::uint64_t> counts =
      count_by_cause(context.finding_groups, context.findings, records);
  using Rank =
      std::tuple<bool, bool, std::uint64_t, std::string>;  // known, not beyond a claim, how many others
  std::map<Rank, std::vector<Waiting>> causes;
  for (const CauseRecord& c : records) {
    const auto found = context.by_id.find(c.finding);
    if (found == context.by_id.end() || !found->second->can_be_simplified()) continue;
    if (c.mechanism == Mechanism::gone) continue;
    causes[{known.contains(c.cause), found->second->severity() != Severity::contract, ~counts[c.cause],
            c.cause}]
        .push_back({0, complexity(found->second->pair), found->second});
  }
  std::size_t longest = 0;
  for (auto& [key, cause] : causes) {
    put_in_order(cause);
    longest = std::max(longest, cause.size());
  }
  std::vector<const Subject*> order;
  for (std::size_t turn = 0; turn < longest; ++turn)
    for (const auto& [key, cause] : causes)
      if (turn < cause.size()) order.push_back(cause[turn].subject);
  return order;
}

void simplify_findings(const TriageContext& context, const std::set<std::string>& known_causes, double part) {
  std::map<std::int64_t, SimpleRecord> known;
  for (SimpleRecord& s : context.simples()) known[s.finding] = std::move(s);
  std::map<std::int64_t, std::string> cause_of;
  for (const CauseRecord& c : context.causes()) cause_of[c.finding] = c.cause;
  std::vector<const Subject*> open;
  for (const Subject* s : simplification_order(context, known_causes))
    if (!known[s->record->id].ended) open.push_back(s);
  if (open.empty() || context.out_of_time(part)) return;
  context.in_processes([&](unsigned job) {
    TriageStore store = context.store();
    for (std::size_t i = job; i < open.size() && !context.out_of_time(part); i += context.options.jobs) {
      const std::int64_t id = open[i]->record->id;
      store.add(simplified(context, *open[i], cause_of.at(id), known.at(id), part));
    }
  });
}

}  // namespace cyl
