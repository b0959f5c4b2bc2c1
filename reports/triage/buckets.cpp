// SPDX-License-Identifier: MIT
#include "reports/triage/buckets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
#include "oracles/trial/bucket.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/finding_text.hpp"
#include "oracles/trial/trial.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/triage/case_distance.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

/// As the triage has them; enough hangs that a method which is known to hang is seen to, on the pairs of one
/// bucket.
constexpr Caps shown_caps{
    .call_cpu = std::chrono::milliseconds(500), .call_wall = std::chrono::milliseconds(2000), .hangs = 6};
constexpr Caps share_caps{.call_cpu = shown_caps.call_cpu, .call_wall = shown_caps.call_wall, .hangs = 2};
/// Seed of the sample of a stratum.
constexpr std::uint64_t share_seed = 1;
/// Keys and labels listed with a bucket.
constexpr std::size_t merged_cap = 200, labels_cap = 6;

/// What one bucket is made of.
struct Group {
  std::vector<const FindingRecord*> findings;  ///< by id
  std::set<Mechanism> mechanisms;
  std::map<std::string, std::size_t> labels;
  std::set<std::string> merged;
  const FindingRecord* simplest_of = nullptr;  ///< the finding that the simplest pair comes from
  Pair simplest;
  std::optional<Complexity> complexity;  ///< of the simplest
  const FindingRecord* worst = nullptr;
  const WorstRecord* found = nullptr;  ///< a pair that is said to be worse

  /// The finding that stands for the others.
  const FindingRecord& first() const { return simplest_of != nullptr ? *simplest_of : *worst; }
  Mechanism mechanism() const {
    return mechanisms.size() == 1 ? *mechanisms.begin() : Mechanism::unclassified;
  }
};

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

/// Takes the pair as the simplest if it is.
void offer(Group& group, const FindingRecord* of, const std::string& line) {
  const auto pair = pair_of(line);
  if (!pair || find_defect(pair->a) != Defect::none || find_defect(pair->b) != Defect::none) return;
  const Complexity now = complexity(*pair);
  if (group.complexity && !(now < *group.complexity)) return;
  group.complexity = now;
  group.simplest = *pair;
  group.simplest_of = of;
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
    offer(*group_of[s.finding], by_id[s.finding], s.pair);
  }
  for (const WorstRecord& w : records.worsts)
    if (groups.contains(w.bucket) && !w.pair.empty()) groups[w.bucket].found = &w;
  // As they were found, where none is simplified yet.
  for (auto& [key, group] : groups)
    if (group.simplest_of == nullptr)
      for (const FindingRecord* f : group.findings) offer(group, f, f->pair);
  return groups;
}

// The pairs of a group that every method is asked about, in this order.
enum Shown : std::size_t { simplest, worst, found, shown_count };

std::vector<Trial> try_groups(const std::map<std::string, Group>& groups,
                              std::span<const std::unique_ptr<Method>> methods) {
  std::vector<Pair> pairs;
  for (const auto& [key, group] : groups) {
    pairs.push_back(group.simplest);
    pairs.push_back(pair_of(group.worst->pair).value_or(group.simplest));
    pairs.push_back(group.found != nullptr ? pair_of(group.found->pair).value_or(pairs.back())
                                           : pairs.back());
  }
  return try_methods(methods, pairs, shown_caps, 2);
}

std::size_t index_of(std::span<const std::unique_ptr<Method>> methods, const std::string& name) {
  std::size_t m = 0;
  while (m < methods.size() && methods[m]->name() != name) ++m;
  return m;
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

/// In the form of the page's Case.
Json case_json(const Trial& trial, const std::optional<CaseDistance>& distance,
               std::span<const std::unique_ptr<Method>> methods, const std::string& replayed) {
  Json c;
  c["pair"] = pair_to_json(trial.pair);
  c["truth"] = truth_to_json(trial.truth);
  c["margin"] = nullptr;
  if (distance) add_distance(c, *distance);
  c["answers"] = Json::object();
  for (std::size_t m = 0; m < methods.size(); ++m)
    c["answers"][std::string(methods[m]->name())] = answer_to_json(trial.answers[m]);
  c["replay"] = own_command() + " replay " + shell_quoted(replayed);
  return c;
}

void show_worst(Bucket& b, const Group& group, std::span<const Trial> now,
                std::span<const std::unique_ptr<Method>> methods, const std::string& folder) {
  b.worst_was_searched = surpasses(group, now[found], methods);
  const std::string stored = fmt::format("{}:{}", folder, group.worst->id);
  const std::string file = fmt::format("{}/buckets/{}.worst.jsonl", folder, letters_only(b.key));
  const Trial& trial = now[b.worst_was_searched ? found : worst];
  b.worst = case_json(trial, distance_of(trial), methods, b.worst_was_searched ? file : stored);
  if (b.worst_was_searched)
    b.worst["note"] = fmt::format("searched for, with {}; the worst of the findings is {}, margin {:.3g}",
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

/// What of the simplest pair and its stratum is seen.
void show_simplest(Bucket& b, const Group& group, const Trial& now,
                   std::span<const std::unique_ptr<Method>> methods, const std::string& folder) {
  const auto distance = distance_of(now);
  const std::string file = fmt::format("{}/buckets/{}.jsonl", folder, letters_only(b.key));
  b.simplest = case_json(now, distance, methods, file);
  std::optional<double> margin;
  if (distance && distance->margin) margin = finite(distance->margin->hi);
  const auto feature = contact_feature(group.simplest, now.truth);
  b.feature = feature ? to_string(*feature) : "unknown";
  b.coordinate = to_string(coordinate_of(group.simplest, margin.value_or(0)));
  const std::size_t m = index_of(methods, b.method);
  if (m < methods.size() && b.kind == to_string(FindingKind::bad_witness))
    if (const std::string miss = miss_in_words(group.simplest, now.answers[m]); !miss.empty())
      b.cause += "; on the simplest pair " + miss;
  // Of what hangs each question would cost a second, or two.
  const bool answers = m < methods.size() && now.answers[m].failure != Failure::hang &&
                       now.answers[m].status != Status::declined;
  const bool moved = b.mechanism == Mechanism::offset;
  if (answers && margin && feature)
    b.share = share_of(group.simplest, *margin, *feature, moved, methods[m], b.kind);
}

/// What is said of a kind of finding.
std::string kind_in_words(const std::string& kind) {
  constexpr std::array words{"says disjoint of pairs that meet",
                             "says intersecting of pairs with daylight between",
                             "says touching of pairs that do not",
                             "says invalid of legal pairs",
                             "offers a witness that proves nothing",
                             "says a distance that is not",
                             "answers a number that is not finite",
                             "throws",
                             "crashes",
                             "does not come to an end",
                             "gives no answer that means anything",
                             "answers one question in two ways",
                             "the truth is undecided",
                             "leaves pairs undecided that it promises to decide",
                             "answers, and does what a method may not",
                             "fails where much was asked before, and not alone",
                             "failed"};
  static_assert(words.size() == enum_values<FindingKind>.size());
  const auto known = from_word<FindingKind>(kind);
  return known ? words[static_cast<std::size_t>(*known)] : kind;
}

/// `reason`: the method's own words on a failure.
std::string cause_in_words(const std::string& key, Mechanism mechanism, const std::set<std::string>& kinds,
                           const std::string& reason) {
  std::string said;
  for (const std::string& kind : kinds) said += (said.empty() ? "" : "; ") + kind_in_words(kind);
  if (key.ends_with("/within-claim"))
    said = "within what it claims of itself: " + said;
  else if (mechanism != Mechanism::unclassified)
    said = fmt::format("{} ({})", in_words(mechanism), said);
  const auto is_thrown = [](const std::string& kind) { return kind == to_string(FindingKind::exception); };
  const bool thrown = std::any_of(kinds.begin(), kinds.end(), is_thrown);
  if (!reason.empty()) said += (thrown ? ", in its words: " : ": ") + escaped_controls(reason);
  return said;
}

int rank_of(Severity severity) {
  return severity == Severity::contract ? 0 : severity == Severity::unresolved ? 1 : 2;
}

/// Puts together what the findings say.
Bucket sum_up(const std::string& key, const Group& group, std::uint64_t count) {
  Bucket b;
  b.key = key;
  b.method = group.first().method;
  b.kind = group.first().kind;
  b.count = count;
  b.mechanism = group.mechanism();
  std::set<std::string> kinds;
  std::string reason;
  for (const FindingRecord* f : group.findings) {
    b.methods.insert(f->method);
    b.families.insert(f->family);
    b.findings.push_back(f->id);
    kinds.insert(f->kind);
    if (reason.empty()) reason = f->reason;
    const Severity severity = from_word<Severity>(f->severity).value_or(Severity::resolution);
    if (rank_of(severity) < rank_of(b.severity)) b.severity = severity;
    if (!f->margin) continue;
    if (!b.margin) b.margin = Enclosure{f->margin->lo, f->margin->lo};
    b.margin = Enclosure{std::min(b.margin->lo, f->margin->lo), std::max(b.margin->hi, f->margin->lo)};
  }
  for (const std::string& merged : group.merged)
    if (b.merged.size() < merged_cap) b.merged.push_back(merged);
  b.cause = cause_in_words(key, b.mechanism, kinds, reason);
  return b;
}

/// The cause, what else was told of how many, and who else is wrong.
std::vector<std::string> labels_of(const Bucket& b, const Group& group, const Trial& simplest_now,
                                   std::span<const std::unique_ptr<Method>> methods) {
  std::vector<std::string> labels{b.cause};
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

std::map<std::string, std::uint64_t> count_by_bucket(const TriageRecords& records) {
  using Counted = std::tuple<std::string, std::string, std::string, std::string>;
  std::map<std::int64_t, std::string> bucket_of;
  for (const CauseRecord& c : records.causes) bucket_of[c.finding] = c.bucket;
  std::map<Counted, std::map<std::string, std::uint64_t>> kept;
  for (const FindingRecord& f : records.findings)
    if (bucket_of.contains(f.id)) ++kept[{f.method, f.kind, f.severity, f.family}][bucket_of[f.id]];
  std::map<std::string, std::uint64_t> counts;
  for (const GroupRecord& g : records.groups) {
    const auto found = kept.find({g.method, g.kind, g.severity, g.family});
    if (found == kept.end()) continue;
    std::uint64_t all = 0, given = 0;
    for (const auto& [bucket, n] : found->second) all += n;
    std::vector<std::pair<std::uint64_t, std::string>> parts;
    for (const auto& [bucket, n] : found->second) {
      const std::uint64_t part = g.count / all * n + g.count % all * n / all;
      counts[bucket] += part;
      given += part;
      parts.emplace_back(n, bucket);
    }
    std::sort(parts.rbegin(), parts.rend());
    for (std::size_t i = 0; given < g.count; ++given, ++i) ++counts[parts[i % parts.size()].second];
  }
  return counts;
}

std::vector<Bucket> make_buckets(const TriageRecords& records,
                                 std::span<const std::unique_ptr<Method>> methods) {
  const std::map<std::string, Group> groups = groups_of(records);
  const std::map<std::string, std::uint64_t> counts = count_by_bucket(records);
  const std::vector<Trial> trials = try_groups(groups, methods);
  std::vector<Bucket> buckets;
  for (const auto& [key, group] : groups) {
    const auto now = std::span(trials).subspan(shown_count * buckets.size(), shown_count);
    const auto counted = counts.find(key);
    Bucket b = sum_up(key, group, counted != counts.end() ? counted->second : group.findings.size());
    show_simplest(b, group, now[simplest], methods, records.folder);
    show_worst(b, group, now, methods, records.folder);
    b.labels = labels_of(b, group, now[simplest], methods);
    buckets.push_back(std::move(b));
  }
  std::stable_sort(buckets.begin(), buckets.end(), [](const Bucket& x, const Bucket& y) {
    return rank_of(x.severity) != rank_of(y.severity) ? rank_of(x.severity) < rank_of(y.severity)
                                                      : x.count > y.count;
  });
  return buckets;
}

}  // namespace cyl
