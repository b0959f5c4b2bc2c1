// SPDX-License-Identifier: MIT
#include "reports/triage/buckets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/strata.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "corpus/store/stored_answers.hpp"
#include "fuzz/campaign/climbed.hpp"
#include "oracles/trial/bucket.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/finding_text.hpp"
#include "oracles/trial/hangs_on_sums.hpp"
#include "oracles/trial/trial.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/explain/failing_region.hpp"
#include "reports/triage/case_distance.hpp"
#include "reports/triage/shown_pair.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

constexpr Caps share_caps{.call_cpu = shown_caps.call_cpu, .call_wall = shown_caps.call_wall, .hangs = 2};
/// Seed of the sample of a stratum.
constexpr std::uint64_t share_seed = 1;
/// Pairs tried as the simplest of a bucket, until its method fails on one.
constexpr std::size_t tried_cap = 4;
/// Keys and labels listed with a bucket.
constexpr std::size_t merged_cap = 200, labels_cap = 6;

/// A pair that may be shown as a bucket's simplest.
struct Candidate {
  bool as_found;  ///< not simplified
  Complexity complexity;
  const FindingRecord* of;
  Pair pair;
};

/// What one bucket is made of.
struct Group {
  std::vector<const FindingRecord*> findings;  ///< by id
  std::set<Mechanism> mechanisms;
  std::map<std::string, std::size_t> labels;
  std::set<std::string> merged;
  std::vector<Candidate> candidates;
  std::optional<Candidate> simplest;
  bool seen_again = false;  ///< on the simplest
  const FindingRecord* worst = nullptr;
  const WorstRecord* found = nullptr;  ///< a pair that is said to be worse

  /// The finding that stands for the others.
  const FindingRecord& first() const { return simplest ? *simplest->of : *worst; }
  Mechanism mechanism() const {
    return mechanisms.size() == 1 ? *mechanisms.begin() : Mechanism::unclassified;
  }
};

std::size_t index_of(std::span<const std::unique_ptr<Method>> methods, const std::string& name) {
  std::size_t m = 0;
  while (m < methods.size() && methods[m]->name() != name) ++m;
  return m;
}

std::optional<Pair> pair_of(const std::string& line) {
  auto parsed = parse_case(line, 1);
  if (!parsed.value) return {};
  return parsed.value->pair;
}

void add(Group& group, const FindingRecord& finding, const CauseRecord& cause) {
  group.findings.push_back(&finding);
  group.mechanisms.insert(from_word<Mechanism>(cause.mechanism).value_or(Mechanism::unclassified));
  for (std::size_t at = 0; at < cause.labels.size();) {
    const std::size_t end = std::min(cause.labels.find('\n', at), cause.labels.size());
    ++group.labels[cause.labels.substr(at, end - at)];
    at = end + 1;
  }
  if (group.worst == nullptr || is_worse(finding, *group.worst)) group.worst = &finding;
}

void offer(Group& group, const FindingRecord* of, const std::string& line, bool as_found) {
  const auto pair = pair_of(line);
  if (!pair) return;
  if (!as_found && !is_legal(*pair)) return;
  group.candidates.push_back({as_found, complexity(*pair), of, *pair});
}

/// Simplified ones before those as they were found, then the simplest.
bool is_shown_before(const Candidate& x, const Candidate& y) {
  return x.as_found != y.as_found ? y.as_found : x.complexity < y.complexity;
}

std::optional<FailingMethod> failing_method_of(const FindingRecord& f,
                                               std::span<const std::unique_ptr<Method>> methods) {
  const auto kind = from_word<FindingKind>(f.kind);
  const std::size_t m = index_of(methods, f.method);
  return kind && m < methods.size() ? std::optional(FailingMethod{m, *kind}) : std::nullopt;
}

/// Takes the first of the candidates on which its method fails when it is asked alone; where there is none,
/// the first finding, as it was found.
void choose_simplest(Group& group, std::span<const std::unique_ptr<Method>> methods,
                     const std::function<bool()>& out_of_time) {
  std::stable_sort(group.candidates.begin(), group.candidates.end(), is_shown_before);
  const auto fallback = std::find_if(group.candidates.begin(), group.candidates.end(),
                                     [](const Candidate& c) { return c.as_found; });
  if (fallback != group.candidates.end()) group.simplest = *fallback;
  std::size_t tried = 0;
  for (const Candidate& c : group.candidates) {
    if (tried++ == tried_cap || (tried > 1 && out_of_time())) return;
    const auto blamed = failing_method_of(*c.of, methods);
    if (!blamed || !fails_alone(methods, *blamed, c.pair)) continue;
    group.simplest = c;
    group.seen_again = true;
    return;
  }
}

// Severity goes with a bucket (its key is the severity's, or no finding within a claim has it).
std::map<std::string, Group> groups_of(const TriageRecords& records) {
  std::map<std::int64_t, const FindingRecord*> by_id;
  for (const FindingRecord& f : records.findings) by_id[f.id] = &f;
  std::map<std::string, Group> groups;
  std::map<std::int64_t, Group*> group_of;
  for (const CauseRecord& c : records.causes) {
    const auto found = by_id.find(c.finding);
    if (found == by_id.end()) continue;
    group_of[c.finding] = &groups[c.bucket];
    add(groups[c.bucket], *found->second, c);
  }
  for (const SimpleRecord& s : records.simples) {
    if (!group_of.contains(s.finding)) continue;
    group_of[s.finding]->merged.insert(s.key);
    offer(*group_of[s.finding], by_id[s.finding], s.pair, false);
  }
  for (const WorstRecord& w : records.worsts)
    if (groups.contains(w.bucket) && !w.pair.empty()) groups[w.bucket].found = &w;
  for (auto& [key, group] : groups)
    for (const FindingRecord* f : group.findings) offer(group, f, f->pair, true);
  return groups;
}

/// Whether what was searched for is wrong today in the way it was found, beyond the claim, and worse than the
/// worst finding.
bool surpasses(const Group& group, const Trial& now, std::span<const std::unique_ptr<Method>> methods) {
  if (group.found == nullptr) return false;
  const std::size_t m = index_of(methods, group.found->method);
  if (m == methods.size()) return false;
  const std::optional<Finding>& wrong = now.findings[m];
  if (!wrong || !wrong->margin || to_string(wrong->kind) != group.found->kind) return false;
  return wrong->severity == Severity::contract && wrong->margin->lo > least_margin(*group.worst);
}

std::optional<CaseDistance> distance_of(const Trial& trial) {
  if (!trial.decided()) return {};
  const double size = size_of(trial.pair);
  const Enclosure& d = trial.distance;
  std::optional<Enclosure> margin;
  if (size > 0) margin = Enclosure{std::max({d.lo, -d.hi, 0.0}) / size, std::max(d.hi, -d.lo) / size};
  return case_distance(trial.pair, trial.truth.verdict, margin);
}

/// In the form of the page's Case. `finding`: that the pair is of, or nullptr; what its method said then
/// stands where it is right today.
Json case_json(const ShownPair& shown, const std::optional<CaseDistance>& distance,
               const FindingRecord* finding, std::span<const std::unique_ptr<Method>> methods,
               const std::string& replayed) {
  const Trial& trial = shown.trial;
  Json c;
  c["pair"] = pair_to_json(trial.pair);
  c["truth"] = truth_to_json(trial.truth);
  c["margin"] = nullptr;
  if (distance) add_distance(c, *distance);
  c["answers"] = Json::object();
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (shown.asked[m]) c["answers"][std::string(methods[m]->name())] = answer_to_json(trial.answers[m]);
  if (finding != nullptr) {
    const std::size_t m = index_of(methods, finding->method);
    const bool right_today = m == methods.size() || !trial.findings[m];
    const Json said = Json::parse(finding->answers, nullptr, false);
    for_each_answer(said, [&](const Json& answer, const auto& its_methods) {
      if (!right_today || std::ranges::count(its_methods, finding->method) == 0) return;
      c["answers"][finding->method] = answer;
      c["note"] = fmt::format("{} gave this answer in the run, but not when it was asked again alone",
                              finding->method);
    });
  }
  c["replay"] = own_command() + " replay " + shell_quoted(replayed);
  return c;
}

/// `simplest`: as it was shown; often the worst is the same pair. No hang is worse than another, and each
/// costs a second.
void show_worst(Bucket& b, const Group& group, const ShownPair& simplest, PairShower& shower,
                std::span<const std::unique_ptr<Method>> methods, const std::string& folder) {
  const std::string stored = fmt::format("{}:{}", folder, group.worst->id);
  const std::string file = fmt::format("{}/buckets/{}.worst.jsonl", folder, file_name_of(b.key));
  const auto pair = pair_of(group.worst->pair),
             found = group.found ? pair_of(group.found->pair) : std::nullopt;
  const auto blamed = failing_method_of(*group.worst, methods);
  const std::vector<FailingMethod> failing(blamed ? 1 : 0, blamed.value_or(FailingMethod{}));
  const Pair& worst = found ? *found : pair ? *pair : group.simplest->pair;
  const bool is_simplest =
      numbers_of(worst) == numbers_of(group.simplest->pair) && group.first().method == group.worst->method;
  if (!is_simplest && blamed && blamed->kind == FindingKind::hang) return;
  ShownPair shown = is_simplest ? simplest : shower.show(worst, failing);
  b.worst_was_searched = found && surpasses(group, shown.trial, methods);
  if (found && !b.worst_was_searched) shown = shower.show(pair.value_or(group.simplest->pair), failing);
  b.worst = case_json(shown, distance_of(shown.trial), b.worst_was_searched ? nullptr : group.worst, methods,
                      b.worst_was_searched ? file : stored);
  if (b.worst_was_searched)
    b.worst["note"] =
        fmt::format("found by a search from {}. The worst finding of the run is {}, with the margin {:.3g}",
                    group.found->method, stored, least_margin(*group.worst));
}

/// Returns the drawn pair brought to the size of the model and, if `moved`, to its place.
Pair like(const Pair& drawn, const Pair& model, bool moved) {
  const auto exponent = [](const Pair& p) { return size_of(p) > 0 ? std::ilogb(size_of(p)) : 0; };
  Pair pair = scaled(drawn, exponent(model) - exponent(drawn));
  if (moved)
    for (Cylinder* c : {&pair.a, &pair.b}) c->center += model.a.center;
  return pair;
}

/// How often the method fails in the same way on drawn pairs of the same stratum, brought to the size and,
/// where that matters, the place of the simplest.
std::optional<Bucket::Share> share_of(const Pair& simplest, double margin, ContactFeature feature, bool moved,
                                      const std::unique_ptr<Method>& method, const std::string& kind) {
  std::vector<Pair> pairs;
  for (std::uint64_t index = 0; index < share_sample; ++index)
    if (const auto drawn = draw_in_stratum(feature, margin_decade(margin), share_seed, index))
      pairs.push_back(like(*drawn, simplest, moved));
  if (pairs.empty()) return {};
  Bucket::Share share;
  for (const Trial& trial : try_method(method, pairs, share_caps)) {
    if (trial.answer().status == Status::declined || trial.truth.verdict == Verdict::undecided) continue;
    ++share.asked;
    share.wrong += trial.fails(from_word<FindingKind>(kind).value_or(FindingKind::undecided_truth));
  }
  return share;
}

bool is_of_scale(Mechanism m) {
  return m == Mechanism::absolute_length || m == Mechanism::underflow || m == Mechanism::overflow;
}

/// What of the simplest pair and its stratum is seen.
void show_simplest(Bucket& b, const Group& group, const ShownPair& shown,
                   std::span<const std::unique_ptr<Method>> methods, const std::string& folder, bool drawn) {
  const Trial& now = shown.trial;
  const Pair& pair = group.simplest->pair;
  const auto distance = distance_of(now);
  const std::string file = fmt::format("{}/buckets/{}.jsonl", folder, file_name_of(b.key));
  b.simplest =
      case_json(shown, distance, group.simplest->as_found ? group.simplest->of : nullptr, methods, file);
  b.simplified = !group.simplest->as_found;
  b.seen_again = group.seen_again;
  std::optional<double> margin;
  if (distance && distance->margin)
    margin = std::min(distance->margin->hi, std::numeric_limits<double>::max());
  const auto feature = contact_feature(pair, now.truth);
  b.feature = feature ? to_string(*feature) : "unknown";
  b.coordinate = to_string(coordinate_of(pair, margin.value_or(0)));
  const std::size_t m = index_of(methods, b.method);
  if (m < methods.size() && b.kind == to_string(FindingKind::bad_witness))
    if (const std::string miss = miss_in_words(pair, now.answers[m]); !miss.empty())
      b.cause += "; on the simplest pair " + miss;
  if (drawn && b.seen_again && is_of_scale(b.mechanism)) {
    const Failing failing{m, *from_word<FindingKind>(b.kind), pair};
    const std::string scale = scale_in_words(classify_closely(methods, failing, share_caps), now);
    if (!scale.empty()) b.cause += "; the simplest pair is " + scale;
  }
  // Of what hangs each question would cost a second, or two.
  const bool answers = m < methods.size() && now.answers[m].failure != Failure::hang &&
                       now.answers[m].status != Status::declined;
  const bool moved = b.mechanism == Mechanism::offset;
  const auto blamed_kind = from_word<FindingKind>(b.kind);
  const bool may_turn =
      blamed_kind && b.seen_again && b.severity == Severity::contract && b.coordinate != "angle";
  if (drawn && answers && margin && may_turn && hangs_on_angle(methods[m], pair, *blamed_kind))
    b.coordinate = to_string(Coordinate::angle);
  if (drawn && answers && margin && feature)
    b.share = share_of(pair, *margin, *feature, moved, methods[m], b.kind);
}

/// What is said of a kind of finding.
std::string kind_in_words(const std::string& kind) {
  constexpr std::array words{"answers disjoint for pairs that meet",
                             "answers intersecting for disjoint pairs",
                             "answers touching for pairs that do not touch",
                             "answers invalid for valid pairs",
                             "returns a witness that proves nothing",
                             "returns a wrong distance",
                             "returns a number that is not finite",
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
  const auto known = from_word<FindingKind>(kind);
  return known ? words[static_cast<std::size_t>(*known)] : kind;
}

/// `reasons`: by kind the method's own words on a failure, or none.
std::string cause_in_words(const std::string& key, Mechanism mechanism,
                           const std::map<std::string, std::string>& reasons) {
  const bool within = key.ends_with("/within-claim");
  std::string said;
  for (const auto& [kind, reason] : reasons) {
    said += (said.empty() ? "" : "; ") + kind_in_words(kind);
    if (within && kind == to_string(FindingKind::bad_witness))
      said += ", which a claim with a tolerance allows";
    const bool thrown = kind == to_string(FindingKind::exception);
    if (!reason.empty()) said += (thrown ? ", with the message: " : ": ") + escaped_controls(reason);
  }
  if (within) return "within its claim: " + said;
  return mechanism == Mechanism::unclassified ? said : fmt::format("{} ({})", in_words(mechanism), said);
}

int rank_of(Severity severity) {
  return severity == Severity::contract ? 0 : severity == Severity::unresolved ? 1 : 2;
}

/// Puts together what the findings say.
Bucket sum_up(const std::string& key, const Group& group, const BucketCount& count) {
  Bucket b;
  b.key = key;
  b.method = group.first().method;
  b.kind = group.first().kind;
  b.count = count.findings;
  b.pairs = count.most();
  b.mechanism = group.mechanism();
  std::map<std::string, std::string> reasons;
  for (const FindingRecord* f : group.findings) {
    b.methods.insert(f->method);
    b.families.insert(f->family);
    b.findings.push_back(f->id);
    if (std::string& reason = reasons[f->kind]; reason.empty()) reason = f->reason;
    const Severity severity = from_word<Severity>(f->severity).value_or(Severity::resolution);
    if (rank_of(severity) < rank_of(b.severity)) b.severity = severity;
    if (!f->margin) continue;
    if (!b.margin) b.margin = Enclosure{f->margin->lo, f->margin->lo};
    b.margin = Enclosure{std::min(b.margin->lo, f->margin->lo), std::max(b.margin->hi, f->margin->lo)};
  }
  for (const std::string& merged : group.merged)
    if (b.merged.size() < merged_cap) b.merged.push_back(merged);
  b.cause = cause_in_words(key, b.mechanism, reasons);
  return b;
}

/// The cause, what else was told of how many, and who else is wrong.
std::vector<std::string> labels_of(const Bucket& b, const Group& group, const Trial& simplest_now,
                                   const GroupedMethods& of) {
  const std::span<const std::unique_ptr<Method>> methods = of.methods;
  std::vector<std::string> labels{b.cause};
  if (!b.seen_again)
    labels.push_back(
        fmt::format("not reproduced: {} does not fail in this way when it is asked alone", b.method));
  const auto kind = from_word<FindingKind>(b.kind);
  if (kind && hangs_on_our_sums(b.method, *kind, group.simplest->pair).value_or(false))
    labels.push_back(
        "the simplest pair depends on the last bit of our support function: the method is right if its sums "
        "change their order");
  std::string elsewhere;
  if (const std::size_t m = index_of(methods, b.method); m < methods.size())
    for (const std::size_t sharer : methods_sharing_algorithm(of, m))
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
    if (const auto& wrong = simplest_now.findings[m];
        methods[m]->name() != b.method && wrong && to_string(wrong->kind) == b.kind)
      shared += (shared.empty() ? "" : ", ") + std::string(methods[m]->name());
  if (!shared.empty()) labels.push_back("wrong in the same way on the simplest pair: " + shared);
  return labels;
}

}  // namespace

double least_margin(const FindingRecord& f) { return f.margin ? f.margin->lo : -1; }

bool is_worse(const FindingRecord& x, const FindingRecord& y) {
  const auto refutes_verdict = [](const FindingRecord& f) {
    const auto kind = from_word<FindingKind>(f.kind);
    return kind && is_refuted_verdict(*kind);
  };
  return std::pair(refutes_verdict(x), least_margin(x)) > std::pair(refutes_verdict(y), least_margin(y));
}

std::uint64_t BucketCount::most() const {
  std::uint64_t most = 0;
  for (const auto& [method, n] : by_method) most = std::max(most, n);
  return most;
}

std::map<std::string, BucketCount> count_by_bucket(const TriageRecords& records) {
  using Counted = std::tuple<std::string, std::string, std::string, std::string>;
  std::map<std::int64_t, std::string> bucket_of;
  for (const CauseRecord& c : records.causes) bucket_of[c.finding] = c.bucket;
  std::map<Counted, std::map<std::string, std::uint64_t>> kept;
  for (const FindingRecord& f : records.findings)
    if (bucket_of.contains(f.id)) ++kept[{f.method, f.kind, f.severity, f.family}][bucket_of[f.id]];
  std::map<std::string, BucketCount> counts;
  // Given out family by family, so that the pairs of one climb count as one.
  std::map<std::pair<std::string, std::string>, std::map<std::string, std::uint64_t>> in_family;
  const auto add = [&](const std::string& bucket, const GroupRecord& of, std::uint64_t n) {
    counts[bucket].findings += n;
    in_family[{bucket, of.method}][of.family] += n;
  };
  for (const GroupRecord& g : records.groups) {
    const auto found = kept.find({g.method, g.kind, g.severity, g.family});
    if (found == kept.end()) continue;
    std::uint64_t all = 0, given = 0;
    for (const auto& [bucket, n] : found->second) all += n;
    std::vector<std::pair<std::uint64_t, std::string>> parts;
    for (const auto& [bucket, n] : found->second) {
      const std::uint64_t part = g.count / all * n + g.count % all * n / all;
      add(bucket, g, part);
      given += part;
      parts.emplace_back(n, bucket);
    }
    std::sort(parts.rbegin(), parts.rend());
    for (std::size_t i = 0; given < g.count; ++given, ++i) add(parts[i % parts.size()].second, g, 1);
  }
  for (const auto& [of, families] : in_family)
    for (const auto& [family, n] : families)
      counts[of.first].by_method[of.second] += independent_draws(family, n);
  return counts;
}

std::string file_name_of(std::string_view key) {
  constexpr std::size_t length_cap = 100;  // of a file's name, whose own cap is 255
  std::string name;
  bool replaced = key.size() > length_cap;
  for (const char c : key.substr(0, length_cap)) {
    const bool fit = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    name += fit ? c : '.';
    replaced = replaced || (!fit && c != '/');
  }
  return replaced ? name + '.' + letter_hash(key) : name;
}

std::vector<Bucket> make_buckets(const TriageRecords& records, const GroupedMethods& of,
                                 const std::function<bool()>& out_of_time) {
  std::map<std::string, Group> groups = groups_of(records);
  const std::map<std::string, BucketCount> counts = count_by_bucket(records);
  PairShower shower(of.methods, out_of_time);
  std::vector<Bucket> buckets;
  for (auto& [key, group] : groups) {
    choose_simplest(group, of.methods, out_of_time);
    if (!group.simplest) continue;  // no pair of it can be read
    const auto counted = counts.find(key);
    const BucketCount kept{group.findings.size(), {{group.first().method, group.findings.size()}}};
    Bucket b = sum_up(key, group, counted != counts.end() ? counted->second : kept);
    const auto blamed = failing_method_of(group.first(), of.methods);
    const std::vector<FailingMethod> failing(blamed ? 1 : 0, blamed.value_or(FailingMethod{}));
    const ShownPair shown = shower.show(group.simplest->pair, failing);
    show_simplest(b, group, shown, of.methods, records.folder, !out_of_time());
    show_worst(b, group, shown, shower, of.methods, records.folder);
    b.ordinary = is_ordinary(group.simplest->pair);
    b.labels = labels_of(b, group, shown.trial, of);
    buckets.push_back(std::move(b));
  }
  std::stable_sort(buckets.begin(), buckets.end(), [](const Bucket& x, const Bucket& y) {
    return std::tuple(rank_of(x.severity), !x.ordinary, y.count) <
           std::tuple(rank_of(y.severity), !y.ordinary, x.count);
  });
  return buckets;
}

}  // namespace cyl
