// SPDX-License-Identifier: MIT
#include "reports/triage/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <tuple>
#include <utility>

#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/stored_answers.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/failure_key.hpp"
#include "oracles/trial/finding_text.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/triage/case_distance.hpp"
#include "reports/triage/group_findings.hpp"
#include "reports/triage/shown_pair.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

/// The most pairs tried as the simplest of a cause, until its method fails on one.
constexpr std::size_t tried_cap = 4;

/// A cause states one kind, so the worst finding is of the kind of the simplest.
void choose_worst(CauseFindings& group) {
  const FindingKind kind = group.first().kind;
  if (group.worst->kind == kind) return;
  group.worst = nullptr;
  for (const FindingRecord* f : group.findings)
    if (f->kind == kind && (group.worst == nullptr || is_worse(*f, *group.worst))) group.worst = f;
}

std::optional<FailingMethod> failing_method_of(const FindingRecord& f,
                                               std::span<const std::unique_ptr<Method>> methods) {
  const auto m = position_of(methods, f.method);
  return m ? std::optional(FailingMethod{*m, f.kind}) : std::nullopt;
}

/// Takes the first candidate on which its method fails when it is asked alone. If none fails, takes the
/// first finding as it was found. Returns what was shown of it, if it was asked about.
std::optional<ShownPair> choose_simplest(CauseFindings& group,
                                         std::span<const std::unique_ptr<Method>> methods, PairShower& shower,
                                         const std::function<bool()>& out_of_time) {
  // Candidates of its kind come first, then candidates simplified to the end, then by least shown_rank(), and
  // then the simplest.
  std::ranges::stable_sort(group.candidates, {}, [kind = group.worst->kind](const ShownCandidate& c) {
    return std::tuple(c.of->kind != kind, !c.finished, shown_rank(c.pair), c.as_found, c.complexity);
  });
  const auto fallback = std::ranges::find(group.candidates, true, &ShownCandidate::as_found);
  if (fallback != group.candidates.end()) group.simplest = *fallback;
  std::optional<ShownPair> of_simplest;
  std::size_t tried = 0;
  for (const ShownCandidate& c : group.candidates) {
    if (tried++ == tried_cap || (tried > 1 && out_of_time())) break;
    const auto blamed = failing_method_of(*c.of, methods);
    if (!blamed) continue;
    ShownPair shown = shower.show(c.pair, blamed);
    group.seen_again = shown.fails(*blamed);
    if (group.seen_again) group.simplest = c;
    if (group.seen_again || &c == &*fallback) of_simplest = std::move(shown);
    if (group.seen_again) break;
  }
  return of_simplest;
}

/// The margin, as narrowly as the trial has it.
std::optional<Enclosure> margin_of(const Trial& trial) {
  const double size = size_of(trial.pair);
  const Enclosure& d = trial.distance;
  if (!(size > 0)) return {};
  return Enclosure{std::max({d.lo, -d.hi, 0.0}) / size, std::max(d.hi, -d.lo) / size};
}

/// `finding` is the finding with this pair, or nullptr. If its method is right now, the case has its answer
/// in the run.
ShownCase shown_case(const ShownPair& shown, const FindingRecord* finding,
                     std::span<const std::unique_ptr<Method>> methods, const std::string& replayed) {
  const Trial& trial = shown.trial;
  nlohmann::ordered_json c;
  c["pair"] = pair_json(trial.pair);
  c["truth"] = truth_to_json(trial.truth);
  c["margin"] = nullptr;
  std::optional<Enclosure> margin;
  if (trial.decided()) margin = add_distance(c, trial.pair, trial.truth.verdict, margin_of(trial));
  c["answers"] = nlohmann::ordered_json::object();
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (shown.asked[m]) c["answers"][std::string(methods[m]->name())] = answer_to_json(trial.answers[m]);
  if (finding != nullptr) {
    const auto m = position_of(methods, finding->method);
    const bool right_today = !m || (shown.asked[*m] && !trial.findings[*m]);
    const Json said = Json::parse(finding->answers, nullptr, false);
    for_each_answer(said, [&](const Json& answer, const auto& its_methods) {
      if (!right_today || std::ranges::count(its_methods, finding->method) == 0) return;
      c["answers"][finding->method] = answer;
      c["note"] = fmt::format("{} gave this answer in the run, but not when it was asked again alone",
                              finding->method);
    });
  }
  c["replay"] = own_command() + " replay " + shell_quoted(replayed);
  return {trial.pair, margin, c.dump()};
}

/// `simplest` is the pair as it was shown. The worst pair is often the same pair. A hang is not shown again,
/// because no hang is worse than another and each costs a second.
void show_worst(Cause& b, const CauseFindings& group, const ShownPair& simplest, PairShower& shower,
                std::span<const std::unique_ptr<Method>> methods, const std::string& folder) {
  const auto line = parse_case(group.worst->pair, 1).value;
  const Pair& worst = line ? line->pair : group.simplest->pair;
  const auto blamed = failing_method_of(*group.worst, methods);
  const bool is_simplest =
      numbers_of(worst) == numbers_of(group.simplest->pair) && group.first().method == group.worst->method;
  if (!is_simplest && blamed && blamed->kind == FindingKind::hang) return;
  const ShownPair shown = is_simplest ? simplest : shower.show(worst, blamed);
  b.worst = shown_case(shown, group.worst, methods, fmt::format("{}:{}", folder, group.worst->id));
}

/// Fills in what is seen of the simplest pair.
void show_simplest(Cause& b, const CauseFindings& group, const ShownPair& shown,
                   std::span<const std::unique_ptr<Method>> methods, const std::string& folder) {
  const Trial& now = shown.trial;
  const Pair& pair = group.simplest->pair;
  const std::string file = fmt::format("{}/causes/{}.jsonl", folder, file_name_of(b.key));
  b.simplest = shown_case(shown, group.simplest->as_found ? group.simplest->of : nullptr, methods, file);
  b.simplified = group.simplest->finished;
  b.seen_again = group.seen_again;
  const auto m = position_of(methods, b.method);
  if (!m || b.kind != FindingKind::bad_witness) return;
  if (const std::string miss = miss_in_words(pair, now.answers[*m]); !miss.empty())
    b.description += fmt::format("; on {} {}", shown_in_words(b), miss);
}

/// The most labels listed with a cause.
constexpr std::size_t labels_cap = 6;

/// Describes what a method does that fails in this way.
const char* kind_in_words(FindingKind kind) {
  constexpr std::array words{"answers disjoint for pairs that meet",
                             "answers intersecting for disjoint pairs",
                             "answers touching for pairs that do not touch",
                             "answers invalid for valid pairs",
                             "returns a witness that proves nothing",
                             "returns a wrong distance",
                             "returns a number that is infinite, the largest double, or not a number",
                             "throws an exception",
                             "crashes",
                             "hangs",
                             "returns a meaningless answer",
                             "answers the same pair in two ways",
                             "the truth is undecided",
                             "is undecided on pairs that it claims to decide",
                             "answers, but has a forbidden side effect",
                             "fails after many pairs, but not on the pair alone",
                             "failed"};
  static_assert(words.size() == enum_values<FindingKind>.size());
  return words[static_cast<std::size_t>(kind)];
}

/// Returns the description of a cause. `reasons` has the kinds of its findings, each with the method's own
/// words on a failure, which may be empty.
std::string cause_in_words(const std::string& key, Mechanism mechanism,
                           const std::map<FindingKind, std::string>& reasons) {
  const bool within = key.ends_with("/within-claim");
  std::string said;
  for (const auto& [kind, reason] : reasons) {
    said += said.empty() ? "" : "; ";
    said += kind_in_words(kind);
    if (within && kind == FindingKind::bad_witness) said += ", by no more than the claim explains";
    const bool thrown = kind == FindingKind::exception;
    if (!reason.empty()) said += (thrown ? ", with the message: " : ": ") + escaped_controls(reason);
  }
  if (within) return "within its claim: " + said;
  return mechanism == Mechanism::unclassified ? said : fmt::format("{} ({})", in_words(mechanism), said);
}

/// Returns the description and the labels of a cause: what applies to how many of its findings, and which
/// other methods are wrong. `simplest_now` holds the answers to its simplest pair.
std::vector<std::string> labels_of(const Cause& b, const CauseFindings& group, const ShownPair& simplest_now,
                                   const GroupedMethods& of) {
  const std::span<const std::unique_ptr<Method>> methods = of.methods;
  std::vector<std::string> labels{b.description};
  const auto own = position_of(methods, b.method);
  const bool was_asked = !own || simplest_now.asked[*own];
  if (!b.seen_again)
    labels.push_back(fmt::format(
        fmt::runtime(was_asked ? "not reproduced: {} does not fail in this way when it is asked alone"
                               : "not asked again: no time was left for {}, which hangs"),
        b.method));
  if (depends_on_last_bit(b.method, b.kind, group.simplest->pair).value_or(false))
    labels.push_back(shown_in_words(b) +
                     " depends on the last bit of our support function: the method is right if its sums "
                     "change their order");
  std::string elsewhere;
  if (own)
    for (const std::size_t sharer : methods_sharing_algorithm(of, *own))
      elsewhere += (elsewhere.empty() ? "" : ", ") + std::string(methods[sharer]->name());
  if (!elsewhere.empty()) labels.push_back("shared code, judging by common errors: " + elsewhere);
  std::vector<std::pair<std::size_t, std::string>> often;
  for (const auto& [label, n] : group.labels) often.emplace_back(group.findings.size() - n, label);
  std::sort(often.begin(), often.end());
  if (often.size() > labels_cap) often.resize(labels_cap);
  for (const auto& [rarity, label] : often)
    labels.push_back(rarity == 0 ? label
                                 : fmt::format("{} ({} of {})", label, group.findings.size() - rarity,
                                               group.findings.size()));
  std::string shared;
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (const auto& wrong = simplest_now.trial.findings[m];
        methods[m]->name() != b.method && wrong && wrong->kind == b.kind)
      shared += (shared.empty() ? "" : ", ") + std::string(methods[m]->name());
  if (!shared.empty())
    labels.push_back(fmt::format("wrong in the same way on {}: {}", shown_in_words(b), shared));
  return labels;
}

/// Sums up the findings of a cause. `shown` is its simplest pair.
Cause sum_up(const std::string& key, const CauseFindings& group, std::uint64_t count, const ShownPair& shown,
             const GroupedMethods& of, const std::string& folder) {
  Cause b;
  b.key = key;
  b.method = group.first().method;
  b.kind = group.first().kind;
  b.severity = group.first().severity;
  b.count = count;
  std::map<FindingKind, std::string> reasons;
  for (const FindingRecord* f : group.findings) {
    b.methods.insert(f->method);
    if (f->kind == b.kind) b.methods_of_kind.insert(f->method);
    b.families.insert(f->family);
    b.findings.push_back(f->id);
    if (std::string& reason = reasons[f->kind]; reason.empty()) reason = f->reason;
    if (f->kind != b.kind || !f->margin) continue;
    if (!b.margin) b.margin = Enclosure{f->margin->lo, f->margin->lo};
    b.margin = Enclosure{std::min(b.margin->lo, f->margin->lo), std::max(b.margin->hi, f->margin->lo)};
  }
  b.description = cause_in_words(key, group.mechanism(), reasons);
  show_simplest(b, group, shown, of.methods, folder);
  b.labels = labels_of(b, group, shown, of);
  return b;
}

}  // namespace

std::string file_name_of(std::string_view key) {
  constexpr std::size_t length_cap = 100;  // of a file name, which has a limit of 255
  std::string name;
  bool replaced = key.size() > length_cap;
  for (const char c : key.substr(0, length_cap)) {
    const bool fit = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    name += fit ? c : '.';
    replaced = replaced || (!fit && c != '/');
  }
  return replaced ? name + '.' + letter_hash(key) : name;
}

Cause make_cause(const std::string& key, const NewFault& fault, const GroupedMethods& of,
                 const std::string& run_folder, const std::function<bool()>& out_of_time) {
  FindingRecord found;
  found.method = of.methods[fault.method]->name();
  found.kind = fault.finding.kind;
  found.severity = fault.finding.severity;
  found.family = fault.family;
  found.margin = fault.finding.margin;
  const FailingMethod failing{fault.method, found.kind};
  CauseFindings group;
  group.findings = {&found};
  group.simplest = ShownCandidate{true, false, complexity(fault.pair), &found, fault.pair};
  const ShownPair shown = PairShower(of.methods, out_of_time).show(fault.pair, failing);
  group.seen_again = shown.fails(failing);
  Cause b = sum_up(key, group, fault.pairs, shown, of, run_folder);
  b.findings.clear();
  return b;
}

std::vector<Cause> make_causes(const TriageRecords& records, const GroupedMethods& of,
                               const std::vector<Cause>& last, const std::function<bool()>& out_of_time) {
  std::map<std::string, CauseFindings> groups = group_by_cause(records);
  const std::map<std::string, std::uint64_t> counts =
      count_by_cause(records.groups, records.findings, records.causes);
  PairShower shower(of.methods, out_of_time);
  std::vector<Cause> causes;
  for (auto& [key, group] : groups) {
    const auto shown_last = std::ranges::find(last, key, &Cause::key);
    if (shown_last != last.end() && shown_last->findings.size() == group.findings.size() && out_of_time()) {
      causes.push_back(*shown_last);
      causes.back().status.reset();  // compare_with_earlier() sets it
      continue;
    }
    std::optional<ShownPair> shown = choose_simplest(group, of.methods, shower, out_of_time);
    if (!group.simplest) continue;  // none of its pairs can be read
    choose_worst(group);
    const auto counted = counts.find(key);
    if (!shown) shown = shower.show(group.simplest->pair, failing_method_of(group.first(), of.methods));
    Cause b = sum_up(key, group, counted != counts.end() ? counted->second : group.findings.size(), *shown,
                     of, records.folder);
    show_worst(b, group, *shown, shower, of.methods, records.folder);
    causes.push_back(std::move(b));
  }
  return causes;
}

}  // namespace cyl
