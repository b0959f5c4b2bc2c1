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

/// Pairs of one method and family that are drawn again, and pairs that are asked at once.
constexpr std::uint64_t redrawn_cap = 4'096, redraw_batch = 256;
constexpr unsigned again_hangs_cap = 1;

/// The pairs of a family that the earlier version was asked about.
struct DrawnFamily {
  const Family* family;
  std::uint64_t asked = 0;              ///< indices below it were
  std::uint64_t wrong = 0;              ///< beyond its claim
  std::set<std::uint64_t> known_wrong;  ///< the indices that are stored
};

std::vector<DrawnFamily> families_of(const RunStore& run, const std::string& method) {
  std::vector<DrawnFamily> drawn;
  for (const TallyRecord& t : run.tallies())
    if (const Family* const family = t.method == method ? find_family(t.family) : nullptr)
      drawn.push_back({family, t.counts.asked, 0, {}});
  const auto of = [&](const std::string& name) {
    return std::ranges::find_if(drawn, [&](const DrawnFamily& d) { return d.family->name == name; });
  };
  for (const GroupRecord& g : run.groups())
    if (const auto d = of(g.family);
        d != drawn.end() && g.method == method && g.severity == Severity::contract)
      d->wrong += g.count;
  for (const FindingRecord& f : run.findings())
    if (const auto d = of(f.family);
        d != drawn.end() && f.method == method && f.severity == Severity::contract)
      d->known_wrong.insert(f.family_index);
  return drawn;
}

// A run keeps the first findings of a group only. If it kept all of a family, each other pair that is wrong
// now was right. If it did not, and w pairs of the family were wrong, but more than w are now, then the rest
// was right. If all pairs that it kept are right now, what is wrong now has another reason.
void ask(const TriageContext& context, std::size_t method, const RunStore& run, const DrawnFamily& drawn,
         double part, ChangedGuest& guest, Asker& asker) {
  const auto seed = number_in<std::uint64_t>(value_of(run.config(), "seed"));
  const bool all_known = drawn.known_wrong.size() == drawn.wrong;
  const std::uint64_t end = std::min(drawn.asked, redrawn_cap);
  if (!seed || (!all_known && end < drawn.asked)) {
    guest.skipped += end;
    return;
  }
  const Claim claim = context.methods[method]->claim();
  std::map<std::string, NewFault> faults;
  std::uint64_t asked = 0, wrong_now = 0;
  bool kept_is_wrong = drawn.known_wrong.empty();
  for (std::uint64_t first = 0; first < end; first += redraw_batch) {
    if (context.out_of_time(part)) {
      if (!all_known) return;
      break;
    }
    std::vector<Pair> some;
    std::vector<Question> questions;
    for (std::uint64_t i = first; i < std::min(end, first + redraw_batch); ++i) {
      if (all_known && drawn.known_wrong.contains(i)) continue;
      questions.push_back({method, some.size()});
      some.push_back(drawn.family->generate(*seed, i));
    }
    const std::vector<ContainedAnswer> answers = asker.ask(some, questions);
    for (std::size_t p = 0; p < some.size(); ++p) {
      const MethodAnswer& said = answers[p].answer;
      if (said.status == Status::declined) continue;
      ++asked;
      Trial trial(some[p], {&said, 1});
      const auto wrong = compare(trial, claim, said);
      if (!wrong || wrong->severity != Severity::contract) continue;
      ++wrong_now;
      kept_is_wrong = kept_is_wrong || (!all_known && drawn.known_wrong.contains(first + p));
      const std::string cause =
          find_cause(context.grouped(), {method, wrong->kind, some[p]}, wrong->severity, said.reason, asker);
      if (context.out_of_time(part)) break;
      NewFault& fault = faults[cause];
      const bool simpler = fault.pairs++ == 0 || complexity(some[p]) < complexity(fault.pair);
      if (simpler) fault = {fault.pairs, some[p], method, *wrong, std::string(drawn.family->name)};
    }
  }
  guest.asked += asked;
  const std::uint64_t wrong_before = all_known ? 0 : drawn.wrong;
  if (wrong_now > wrong_before)
    guest.wrong += wrong_now - wrong_before;
  else if (wrong_now > 0 && !kept_is_wrong)
    guest.wrong_elsewhere += wrong_now;
  else
    return;
  for (const auto& [key, fault] : faults) {
    NewFault& known = guest.newly_wrong[key];
    const std::uint64_t pairs = known.pairs + fault.pairs;
    if (known.pairs == 0 || complexity(fault.pair) < complexity(known.pair)) known = fault;
    known.pairs = pairs;
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
    ChangedGuest guest{name, version, version_in(past->methods, name), past->id, 0, 0, {}};
    if (guest.earlier_version == version) continue;
    const RunStore run = RunStore::open(past->folder);
    Asker asker(context.methods, context.caps(part, again_hangs_cap));
    for (const DrawnFamily& drawn : families_of(run, name)) ask(context, m, run, drawn, part, guest, asker);
    changed.push_back(std::move(guest));
  }
  return changed;
}

std::string in_words(const ChangedGuest& guest) {
  if (guest.asked == 0)
    return fmt::format("{} {} was not compared with version {}: no pair of {} could be asked again",
                       guest.method, guest.version, guest.earlier_version, guest.earlier_run);
  std::string text;
  if (guest.wrong > 0)
    text = fmt::format(
        "{} {} is wrong beyond its claim on {} of the {} pairs of {} that were asked again, on which version "
        "{} was right",
        guest.method, guest.version, guest.wrong, guest.asked, guest.earlier_run, guest.earlier_version);
  if (guest.wrong_elsewhere > 0)
    text += fmt::format(
        "{}{} {} is right on the failures of version {} that {} keeps, and wrong on {} pairs "
        "of the same families",
        text.empty() ? "" : "; ", guest.method, guest.version, guest.earlier_version, guest.earlier_run,
        guest.wrong_elsewhere);
  if (guest.skipped > 0)
    text += fmt::format("{}{} {} was not compared with version {} in families of more than {} pairs",
                        text.empty() ? "" : "; ", guest.method, guest.version, guest.earlier_version,
                        redrawn_cap);
  return text;
}

}  // namespace cyl
