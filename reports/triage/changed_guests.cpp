// SPDX-License-Identifier: MIT
#include "reports/triage/changed_guests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/number_text.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/store/run_facts.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/triage/triage_context.hpp"

namespace cyl {
namespace {

/// Pairs of one method that are drawn again, in all families together, and pairs that are asked at once.
constexpr std::uint64_t redrawn_cap = 100'000, redraw_batch = 256;
constexpr Caps again_caps = attended_caps(1);

struct DrawnPair {
  Pair pair;
  const Family* family;
};

/// The pairs on which the earlier version was right, as far as the run shows.
std::vector<DrawnPair> pairs_it_had_right(const RunStore& run, const std::string& method) {
  const auto seed = number_in<std::uint64_t>(value_of(run.config(), "seed"));
  if (!seed) return {};
  std::map<std::string, std::uint64_t> found, kept;
  std::map<std::string, std::set<std::uint64_t>> wrong;
  for (const GroupRecord& g : run.groups())
    if (g.method == method) found[g.family] += g.count;
  for (const FindingRecord& f : run.findings())
    if (f.method == method) ++kept[f.family], wrong[f.family].insert(f.family_index);
  std::vector<std::pair<const Family*, std::uint64_t>> drawn;
  std::uint64_t all = 0;
  for (const TallyRecord& t : run.tallies()) {
    const Family* const family = t.method == method ? find_family(t.family) : nullptr;
    if (family == nullptr || found[t.family] > kept[t.family]) continue;
    drawn.emplace_back(family, t.counts.asked);
    all += t.counts.asked;
  }
  const double part = all > redrawn_cap ? static_cast<double>(redrawn_cap) / static_cast<double>(all) : 1;
  std::vector<DrawnPair> pairs;
  for (const auto& [family, asked] : drawn) {
    const std::set<std::uint64_t>& known = wrong[std::string(family->name)];
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(part * static_cast<double>(asked)); ++i)
      if (!known.contains(i)) pairs.push_back({family->generate(*seed, i), family});
  }
  return pairs;
}

void ask(const TriageContext& context, std::size_t method, const std::vector<DrawnPair>& drawn, double part,
         ChangedGuest& guest) {
  Asker asker(context.methods, again_caps);
  const Claim claim = context.methods[method]->claim();
  for (std::size_t first = 0; first < drawn.size() && !context.out_of_time(part); first += redraw_batch) {
    std::vector<Pair> some;
    std::vector<Question> questions;
    for (std::size_t p = 0; p < redraw_batch && first + p < drawn.size(); ++p) {
      some.push_back(drawn[first + p].pair);
      questions.push_back({method, p});
    }
    const std::vector<ContainedAnswer> answers = asker.ask(some, questions);
    for (std::size_t p = 0; p < some.size(); ++p) {
      const MethodAnswer& said = answers[p].answer;
      if (said.status == Status::declined) continue;
      ++guest.asked;
      Trial trial(some[p], {&said, 1});
      const auto wrong = compare(trial, claim, said);
      if (!wrong || wrong->severity != Severity::contract) continue;
      NewFault& fault = guest.newly_wrong[find_cause(context.grouped(), {method, wrong->kind, some[p]},
                                                     wrong->severity, said.reason, asker)];
      const bool simpler = fault.pairs++ == 0 || complexity(some[p]) < complexity(fault.pair);
      if (simpler) fault = {fault.pairs, some[p], method, *wrong, std::string(drawn[first + p].family->name)};
    }
  }
}

}  // namespace

std::vector<ChangedGuest> ask_earlier_pairs(const TriageContext& context,
                                            const std::vector<TriagedRun>& earlier, double part) {
  const std::vector<MethodRecord> now = RunStore::open(context.options.folder).methods();
  std::vector<ChangedGuest> changed;
  for (std::size_t m = 0; m < context.methods.size(); ++m) {
    const std::string name(context.methods[m]->name());
    if (!context.methods[m]->guest() || std::ranges::count(context.asked, name) == 0) continue;
    const auto past = std::find_if(earlier.rbegin(), earlier.rend(), [&](const TriagedRun& run) {
      return !version_in(run.methods, name).empty();
    });
    const std::string version = version_in(now, name);
    // The version that is here must be the one that the run asked.
    if (past == earlier.rend() || version != context.methods[m]->version()) continue;
    ChangedGuest guest{name, version, version_in(past->methods, name), past->id, 0, {}};
    if (guest.earlier_version == version) continue;
    ask(context, m, pairs_it_had_right(RunStore::open(past->folder), name), part, guest);
    changed.push_back(std::move(guest));
  }
  return changed;
}

std::string in_words(const ChangedGuest& guest) {
  std::uint64_t wrong = 0;
  for (const auto& [key, fault] : guest.newly_wrong) wrong += fault.pairs;
  return fmt::format("{} {} is wrong beyond its claim on {} of {} pairs of {}, on which version {} was right",
                     guest.method, guest.version, wrong, guest.asked, guest.earlier_run,
                     guest.earlier_version);
}

}  // namespace cyl
