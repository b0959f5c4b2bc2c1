// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/json.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/store/run_facts.hpp"
#include "reports/triage/causes.hpp"

namespace cyl {
namespace {

/// The most runs that are shown with a cause.
constexpr std::size_t shown_runs_cap = 60;

/// Returns the cause with the key of `of`, if the run has it.
const Cause* find(const TriagedRun& run, const Cause& of) {
  for (const Cause& b : run.causes)
    if (b.status != Recurrence::gone && b.key == of.key) return &b;
  return nullptr;
}

/// The method with the most findings of the cause in all runs, and the groups in which it has any.
struct Places {
  std::string method;
  std::set<ExaminedGroups::key_type> groups;
};

Places places_of(const std::vector<const TriagedRun*>& runs, const std::string& key) {
  std::map<std::string, std::uint64_t> by_method;
  std::map<std::string, std::set<ExaminedGroups::key_type>> groups;
  for (const TriagedRun* run : runs)
    for (const auto& [group, examined] : run->examined)
      if (examined.by_cause.contains(key)) {
        by_method[group.method] += examined.shares().at(key);
        groups[group.method].insert(group);
      }
  Places places;
  std::uint64_t most = 0;
  for (const auto& [method, n] : by_method)
    if (n > most) most = n, places = {method, groups[method]};
  return places;
}

/// A run that examined a part of a group's findings counts as if it had asked only that part of the pairs. A
/// run that asked but examined nothing counts as one pair.
Cause::RunObservation observation_of(const TriagedRun& run, const std::string& key, const Places& places) {
  Cause::RunObservation sight{run.id, run.started};
  double part_asked = 0;
  std::set<std::string> families;
  for (const ExaminedGroups::key_type& group : places.groups) {
    const std::string& family = group.family;
    std::uint64_t pairs = 0;
    for (const TallyRecord& t : run.tallies)
      if (t.method == places.method && t.family == family)
        pairs += t.counts.asked - std::min(t.counts.asked, t.counts.declined);
    if (families.insert(family).second) sight.all.asked += pairs;  // several kinds may be of one family
    double part = 1;
    const auto examined = run.examined.find(group);
    if (examined != run.examined.end() && examined->second.found > 0) {
      const ExaminedFindings& e = examined->second;
      if (const auto n = e.by_cause.find(key); n != e.by_cause.end()) {
        sight.examined.count += n->second;
        sight.all.count += e.shares().at(key);
      }
      part = static_cast<double>(e.looked_at) / static_cast<double>(e.found);
    }
    part_asked += part * static_cast<double>(pairs);
  }
  const std::uint64_t least = sight.all.asked > 0 ? 1 : 0;
  sight.examined.asked = std::max({sight.examined.count, least, static_cast<std::uint64_t>(part_asked)});
  sight.all.asked = std::max(sight.all.asked, sight.all.count);
  return sight;
}

void compare(Cause& b, const TriagedRun& run, const std::vector<TriagedRun>& earlier, std::size_t compared) {
  b.first_seen = b.last_seen = run.id;
  b.first_version = b.last_version = version_in(run.methods, b.method);
  std::vector<const TriagedRun*> runs{&run};
  for (const TriagedRun& past : earlier) runs.push_back(&past);
  const Places places = places_of(runs, b.key);
  std::vector<Observation> observations;
  for (const TriagedRun& past : earlier) {
    Cause::RunObservation sight = observation_of(past, b.key, places);
    observations.push_back(sight.examined);
    if (sight.examined.asked > 0) b.asked_before = true, b.history.push_back(std::move(sight));
    const Cause* const found = find(past, b);
    if (found == nullptr || b.first_seen != run.id) continue;
    b.first_seen = found->first_seen;
    b.first_version =
        found->first_version.empty() ? version_in(past.methods, b.method) : found->first_version;
  }
  b.history.push_back(observation_of(run, b.key, places));
  const Observation here = b.history.back().examined;
  if (b.history.size() > shown_runs_cap) b.history.erase(b.history.begin(), b.history.end() - shown_runs_cap);
  if (earlier.empty()) return;
  const RecurrenceOf recurrence = recurrence_of(here, observations, compared);
  b.status = recurrence.status;
  b.chance = recurrence.chance;
}

/// Returns the state of a cause of the last run that this run lacks. Nothing if no method of it was asked.
std::optional<Cause> missed(Cause b, const TriagedRun& run, const std::vector<TriagedRun>& earlier,
                            std::size_t compared, const FailsToday& fails_today) {
  const bool asked = std::any_of(b.methods.begin(), b.methods.end(), [&](const std::string& name) {
    return std::any_of(run.methods.begin(), run.methods.end(),
                       [&](const MethodRecord& m) { return m.name == name; });
  });
  if (b.status == Recurrence::gone || !asked) return {};
  const std::string last_seen = b.last_seen, last_version = b.last_version, first_seen = b.first_seen;
  b.count = 0;
  b.findings.clear();
  b.history.clear();
  compare(b, run, earlier, compared);
  b.first_seen = first_seen;
  b.last_seen = last_seen;
  b.last_version = last_version.empty() ? version_in(earlier.back().methods, b.method) : last_version;
  const std::optional<bool> fails = fails_today(b);
  if (fails) {
    b.status = *fails ? Recurrence::known : Recurrence::gone;
    b.chance.reset();
  } else if (!b.status) {
    b.status = Recurrence::rare;
  }
  return b;
}

/// The order in which causes are shown.
auto rank_of(const Cause& b) {
  constexpr std::array order{Recurrence::fresh, Recurrence::back, Recurrence::rare, Recurrence::known,
                             Recurrence::gone};
  const auto place = std::ranges::find(order, b.status.value_or(Recurrence::known)) - order.begin();
  return std::tuple(place, b.severity, !is_ordinary(b.simplest.pair), ~b.count);
}

}  // namespace

std::string version_in(const std::vector<MethodRecord>& methods, const std::string& name) {
  for (const MethodRecord& m : methods)
    if (m.name == name) return m.version;
  return {};
}

ExaminedGroups examined_groups(const std::vector<GroupRecord>& groups,
                               const std::vector<FindingHead>& findings,
                               const std::vector<CauseRecord>& causes) {
  std::map<std::int64_t, const std::string*> cause_of;
  for (const CauseRecord& c : causes) cause_of[c.finding] = &c.cause;
  ExaminedGroups examined;
  for (const GroupRecord& g : groups) examined[g].found = g.count;
  for (const FindingHead& f : findings) {
    const auto cause = cause_of.find(f.id);
    if (cause == cause_of.end()) continue;
    ExaminedFindings& e = examined[f];
    ++e.looked_at;
    ++e.by_cause[*cause->second];
  }
  return examined;
}

void compare_with_earlier(TriagedRun& run, const std::vector<TriagedRun>& earlier,
                          const FailsToday& fails_today, const std::set<std::string>& certainly_new) {
  std::vector<const Cause*> absent;
  if (!earlier.empty())
    for (const Cause& b : earlier.back().causes)
      if (find(run, b) == nullptr) absent.push_back(&b);
  const std::size_t compared = run.causes.size() + absent.size();
  std::vector<Cause> not_met;
  for (const Cause* b : absent)
    if (auto now = missed(*b, run, earlier, compared, fails_today)) not_met.push_back(std::move(*now));
  for (Cause& b : run.causes) {
    compare(b, run, earlier, compared);
    if (!certainly_new.contains(b.key)) continue;
    b.status = Recurrence::fresh;
    b.asked_before = true;  // its pairs are those of an earlier run
    b.chance.reset();
  }
  for (Cause& b : not_met) run.causes.push_back(std::move(b));
  std::stable_sort(run.causes.begin(), run.causes.end(),
                   [](const Cause& x, const Cause& y) { return rank_of(x) < rank_of(y); });
}

bool is_of_new_families(const Cause& b) { return b.status == Recurrence::fresh && !b.asked_before; }

std::string what_changed(const std::vector<Cause>& causes) {
  const auto is_compared = [](const Cause& b) { return b.status.has_value(); };
  if (std::none_of(causes.begin(), causes.end(), is_compared)) return counted(causes.size(), "cause");
  std::string text;
  for (const Recurrence status :
       {Recurrence::fresh, Recurrence::back, Recurrence::known, Recurrence::gone, Recurrence::rare}) {
    const auto n =
        std::count_if(causes.begin(), causes.end(), [&](const Cause& b) { return b.status == status; });
    if (n == 0 && status != Recurrence::fresh) continue;
    const std::string word = status == Recurrence::rare ? "too rare to judge" : to_string(status);
    text += text.empty() ? counted(static_cast<std::uint64_t>(n), word + " cause")
                         : fmt::format(", {} {}", n, word);
    if (status != Recurrence::fresh) continue;
    const auto beyond = std::ranges::count_if(causes, [](const Cause& b) {
      return b.status == Recurrence::fresh && b.severity == Severity::contract;
    });
    if (beyond < n) text += fmt::format(" ({} beyond a claim)", beyond);
  }
  if (const auto n = std::ranges::count_if(causes, is_of_new_families); n > 0)
    text += fmt::format(
        ". For {}, no earlier run tested the method on these families, so it is unknown whether {} really "
        "new",
        counted(static_cast<std::uint64_t>(n), "new cause"), n == 1 ? "it is" : "they are");
  return text;
}

}  // namespace cyl
