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
#include "corpus/pairs/scaled_pair.hpp"
#include "corpus/pairs/strata.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "fuzz/worst/worst.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/trial/bucket.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/triage/case_distance.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

/// As the triage has them; enough hangs that a method which is told to hang is seen to, on the pairs of one
/// bucket.
constexpr Caps shown_caps{
    .call_cpu = std::chrono::milliseconds(500), .call_wall = std::chrono::milliseconds(2000), .hangs = 6};
constexpr Caps share_caps{.call_cpu = shown_caps.call_cpu, .call_wall = shown_caps.call_wall, .hangs = 2};
/// Seed of the sample of a stratum.
constexpr std::uint64_t share_seed = 1;
/// Keys and labels listed with a bucket.
constexpr std::size_t merged_cap = 200, labels_cap = 6;

/// What one bucket is made of.
struct Heap {
  std::vector<const FindingRecord*> findings;  ///< by id
  std::set<std::string> mechanisms;
  std::map<std::string, std::size_t> labels;
  std::set<std::string> merged;
  const FindingRecord* simplest_of = nullptr;  ///< the finding that the simplest pair comes from
  Pair simplest;
  const FindingRecord* worst = nullptr;
  const WorstRecord* found = nullptr;  ///< a pair that is said to be worse
};

std::optional<Pair> pair_of(const std::string& line) {
  auto parsed = parse_case(line, 1);
  if (!parsed.value) return {};
  return parsed.value->pair;
}

double least_margin(const FindingRecord& f) { return f.margin ? f.margin->lo : -1; }

// Severity goes with a bucket (its key is the severity's, or no finding within a claim has it).
std::map<std::string, Heap> heaps_of(const Sorted& sorted) {
  std::map<std::int64_t, const FindingRecord*> by_id;
  for (const FindingRecord& f : sorted.findings) by_id[f.id] = &f;
  std::map<std::string, Heap> heaps;
  std::map<std::int64_t, Heap*> heap_of;
  for (const CauseRecord& c : sorted.causes) {
    const auto found = by_id.find(c.finding);
    if (found == by_id.end()) continue;
    Heap& heap = heaps[c.bucket];
    heap_of[c.finding] = &heap;
    heap.findings.push_back(found->second);
    heap.mechanisms.insert(c.mechanism);
    for (std::size_t at = 0; at < c.labels.size();) {
      const std::size_t end = std::min(c.labels.find('\n', at), c.labels.size());
      ++heap.labels[c.labels.substr(at, end - at)];
      at = end + 1;
    }
    if (heap.worst == nullptr || is_worse(*found->second, *heap.worst)) heap.worst = found->second;
  }
  std::map<Heap*, Complexity> best;
  const auto offer = [&](Heap& heap, const FindingRecord* of, const std::string& line) {
    const auto pair = pair_of(line);
    if (!pair || find_defect(pair->a) != Defect::none || find_defect(pair->b) != Defect::none) return;
    const Complexity now = complexity(*pair);
    const auto [at, first] = best.try_emplace(&heap, now);
    if (!first && !(now < at->second)) return;
    at->second = now;
    heap.simplest = *pair;
    heap.simplest_of = of;
  };
  for (const SimpleRecord& s : sorted.simples) {
    if (!heap_of.contains(s.finding)) continue;
    heap_of[s.finding]->merged.insert(s.key);
    offer(*heap_of[s.finding], by_id[s.finding], s.pair);
  }
  for (const WorstRecord& w : sorted.worsts)
    if (heaps.contains(w.bucket) && !w.pair.empty()) heaps[w.bucket].found = &w;
  // As they were found, where none is simplified yet.
  for (auto& [key, heap] : heaps)
    if (heap.simplest_of == nullptr)
      for (const FindingRecord* f : heap.findings) offer(heap, f, f->pair);
  return heaps;
}

std::optional<MarginRecord> known_margin(const Pair& pair, const Enclosure& d) {
  const double size = size_of(pair);
  if (!(size > 0)) return {};
  return MarginRecord{std::max({d.lo, -d.hi, 0.0}) / size, std::max(d.hi, -d.lo) / size};
}

/// What is wrong today with what the method of that name says, and by how much.
std::optional<Finding> wrong_today(const Replayed& now, std::span<const std::unique_ptr<Method>> methods,
                                   const std::string& method) {
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (methods[m]->name() == method) return now.findings[m];
  return {};
}

/// Whether what was searched for is wrong in the way it was found, beyond the claim, and worse than the
/// finding.
bool surpasses(const WorstRecord& found, const std::optional<Finding>& wrong, const FindingRecord& stored) {
  if (!wrong || !wrong->margin || to_string(wrong->kind) != found.kind) return false;
  return wrong->severity == Severity::contract && wrong->margin->lo > least_margin(stored);
}

/// In the form of the page's Case.
Json case_json(const Pair& pair, const Replayed& now, std::span<const std::unique_ptr<Method>> methods,
               const std::string& replay) {
  Json c;
  c["pair"] = pair_to_json(pair);
  const bool decided = now.truth.verdict != Verdict::undecided && now.truth.verdict != Verdict::invalid;
  c["truth"] = truth_to_json(now.truth);
  c["margin"] = nullptr;
  if (decided) add_distance(c, case_distance(pair, now.truth.verdict, known_margin(pair, now.distance)));
  c["answers"] = Json::object();
  for (std::size_t m = 0; m < methods.size(); ++m)
    c["answers"][std::string(methods[m]->name())] = answer_to_json(now.answers[m]);
  c["replay"] = replay;
  return c;
}

Pair like(Pair drawn, const Pair& model, bool moved) {
  const auto exponent = [](const Pair& p) { return size_of(p) > 0 ? std::ilogb(size_of(p)) : 0; };
  const int by = exponent(model) - exponent(drawn);
  drawn = scaled(drawn, by);
  if (moved)
    for (Cylinder* c : {&drawn.a, &drawn.b}) c->center += model.a.center;
  return drawn;
}

/// How often the method fails in the same way on drawn pairs of the same stratum, brought to the size and,
/// where that matters, the place of the simplest.
Json share_json(const Pair& simplest, const Json& margin, std::optional<ContactFeature> feature, bool moved,
                std::size_t method, const std::string& kind,
                std::span<const std::unique_ptr<Method>> methods) {
  if (margin.is_null() || !feature) return nullptr;
  const int decade = margin_decade(margin[1].get<double>());
  std::vector<Pair> pairs;
  std::vector<Question> questions;
  for (std::uint64_t index = 0; index < share_sample; ++index)
    if (const auto drawn = draw_in_stratum(*feature, decade, share_seed, index)) {
      questions.push_back({method, pairs.size()});
      pairs.push_back(like(*drawn, simplest, moved));
    }
  if (pairs.empty()) return nullptr;
  const auto said = ask_contained(methods, pairs, questions, share_caps);
  std::uint64_t asked = 0, wrong = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const MethodAnswer& answer = said[p].answer;
    if (answer.status == Status::declined) continue;
    const Truth truth = judge(pairs[p], {&answer, 1});
    if (truth.verdict == Verdict::undecided) continue;
    LazyDistance distance([&](double width) { return enclose_distance(pairs[p], truth, width); });
    const auto found = compare(pairs[p], truth, distance, methods[method]->claim(), answer);
    ++asked;
    wrong += found && to_string(found->kind) == kind;
  }
  return Json{{"wrong", wrong}, {"asked", asked}};
}

/// `said`: what is wrong with the answers.
std::string cause_in_words(const std::string& key, const std::string& mechanism, const std::string& said) {
  if (key.ends_with("/within-claim")) return "within what it claims of itself: " + said;
  if (mechanism == to_string(Mechanism::untold)) return said;
  const auto told = from_word<Mechanism>(mechanism);
  return told ? fmt::format("{} ({})", in_words(*told), said) : said;
}

int rank_of(const std::string& severity) {
  return severity == "contract" ? 0 : severity == "unresolved" ? 1 : 2;
}

std::string said_of(const std::string& kind) {
  constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"wrong_disjoint", "says disjoint of pairs that meet"},
      {"wrong_intersecting", "says intersecting of pairs with daylight between"},
      {"wrong_touching", "says touching of pairs that do not"},
      {"wrong_invalid", "says invalid of legal pairs"},
      {"bad_witness", "offers a witness that proves nothing"},
      {"distance_outside", "says a distance that is not"},
      {"non_finite", "answers a number that is not finite"},
      {"exception", "throws"},
      {"crash", "crashes"},
      {"hang", "does not come to an end"},
      {"malformed", "gives no answer that means anything"},
      {"nondeterminism", "answers one question in two ways"},
      {"undecided_truth", "the truth is undecided"}};
  for (const auto& [word, text] : words)
    if (word == kind) return std::string(text);
  return kind;
}

}  // namespace

bool is_worse(const FindingRecord& x, const FindingRecord& y) {
  const auto refutes_verdict = [](const FindingRecord& f) {
    const auto kind = from_word<FindingKind>(f.kind);
    return kind && is_refuted_verdict(*kind);
  };
  return std::pair(refutes_verdict(x), least_margin(x)) > std::pair(refutes_verdict(y), least_margin(y));
}

std::map<std::string, std::uint64_t> count_by_bucket(const Sorted& sorted) {
  using Group = std::tuple<std::string, std::string, std::string, std::string>;
  std::map<std::int64_t, std::string> bucket_of;
  for (const CauseRecord& c : sorted.causes) bucket_of[c.finding] = c.bucket;
  std::map<Group, std::map<std::string, std::uint64_t>> kept;
  for (const FindingRecord& f : sorted.findings)
    if (bucket_of.contains(f.id)) ++kept[{f.method, f.kind, f.severity, f.family}][bucket_of[f.id]];
  std::map<std::string, std::uint64_t> counts;
  for (const GroupRecord& g : sorted.groups) {
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

Json make_buckets(const Sorted& sorted, std::span<const std::unique_ptr<Method>> methods) {
  std::map<std::string, Heap> heaps = heaps_of(sorted);
  const std::map<std::string, std::uint64_t> counts = count_by_bucket(sorted);
  std::vector<Pair> pairs;
  for (const auto& [key, heap] : heaps) {
    pairs.push_back(heap.simplest);
    pairs.push_back(pair_of(heap.worst->pair).value_or(heap.simplest));
    pairs.push_back(heap.found != nullptr ? pair_of(heap.found->pair).value_or(pairs.back()) : pairs.back());
  }
  const std::vector<Replayed> now = replay(methods, pairs, shown_caps);

  Json buckets = Json::array();
  std::size_t at = 0;
  for (const auto& [key, heap] : heaps) {
    const Replayed& simplest_now = now[at];
    const bool reached =
        heap.found != nullptr &&
        surpasses(*heap.found, wrong_today(now[at + 2], methods, heap.found->method), *heap.worst);
    const Replayed& worst_now = now[at + (reached ? 2 : 1)];
    const Pair& worst_pair = pairs[at + (reached ? 2 : 1)];
    at += 3;
    const FindingRecord& of = heap.simplest_of != nullptr ? *heap.simplest_of : *heap.worst;
    Json b;
    b["key"] = key;
    std::set<std::string> names, kinds, families;
    std::string severity = "resolution";
    std::optional<MarginRecord> margin;
    std::string reason;
    Json ids = Json::array();
    for (const FindingRecord* f : heap.findings) {
      names.insert(f->method);
      kinds.insert(f->kind);
      if (reason.empty()) reason = f->reason;
      families.insert(f->family);
      if (rank_of(f->severity) < rank_of(severity)) severity = f->severity;
      if (f->margin)
        margin = margin
                     ? MarginRecord{std::min(margin->lo, f->margin->lo), std::max(margin->hi, f->margin->lo)}
                     : MarginRecord{f->margin->lo, f->margin->lo};
      ids.push_back(f->id);
    }
    b["method"] = of.method;
    b["methods"] = names;
    b["kind"] = of.kind;
    b["severity"] = severity;
    b["count"] = counts.contains(key) ? counts.at(key) : heap.findings.size();
    b["families"] = families;
    b["findings"] = ids;
    // Of infinite margins (two points apart) JSON has no number.
    const auto finite = [](double x) { return std::isfinite(x) ? Json(x) : Json(1e308); };
    b["margin"] = margin ? Json::array({finite(margin->lo), finite(margin->hi)}) : Json(nullptr);
    b["merged"] = Json::array();
    for (const std::string& k : heap.merged)
      if (b["merged"].size() < merged_cap) b["merged"].push_back(k);

    const std::string file = fmt::format("{}/buckets/{}.jsonl", sorted.folder, letters_only(key));
    b["simplest"] =
        case_json(heap.simplest, simplest_now, methods, own_command() + " replay " + shell_quoted(file));
    const std::string stored = fmt::format("{}:{}", sorted.folder, heap.worst->id);
    const std::string worst_file = fmt::format("{}/buckets/{}.worst.jsonl", sorted.folder, letters_only(key));
    b["worst"] = case_json(worst_pair, worst_now, methods,
                           own_command() + " replay " + shell_quoted(reached ? worst_file : stored));
    if (reached)
      b["worst"]["note"] =
          fmt::format("searched for, with {}; the worst of the findings is {}, margin {:.3g}",
                      heap.found->method, stored, least_margin(*heap.worst));
    const auto feature = contact_feature(heap.simplest, simplest_now.truth);
    const Json& m = b["simplest"]["margin"];
    b["feature"] = feature ? to_string(*feature) : "unknown";
    b["coordinate"] = to_string(coordinate_of(heap.simplest, m.is_null() ? 0 : m[1].get<double>()));
    const std::string mechanism =
        heap.mechanisms.size() == 1 ? *heap.mechanisms.begin() : std::string("untold");
    b["mechanism"] = mechanism;

    std::string cause;
    for (const std::string& kind : kinds) cause += (cause.empty() ? "" : "; ") + said_of(kind);
    cause = cause_in_words(key, mechanism, cause);
    if (!reason.empty()) cause += ", in its words: " + escaped_controls(reason);
    b["cause"] = cause;
    Json labels = Json::array({cause});
    std::vector<std::pair<std::size_t, std::string>> often;
    for (const auto& [label, n] : heap.labels) often.emplace_back(heap.findings.size() - n, label);
    std::sort(often.begin(), often.end());
    if (often.size() > labels_cap) often.resize(labels_cap);
    for (const auto& [rarity, label] : often)
      labels.push_back(rarity == 0 ? label
                                   : fmt::format("{} ({} of {})", label, heap.findings.size() - rarity,
                                                 heap.findings.size()));
    std::string shared;
    std::size_t method = methods.size();
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (methods[i]->name() == of.method) method = i;
      if (methods[i]->name() != of.method && simplest_now.findings[i] &&
          to_string(simplest_now.findings[i]->kind) == of.kind)
        shared += (shared.empty() ? "" : ", ") + std::string(methods[i]->name());
    }
    if (!shared.empty()) labels.push_back("wrong in the same way on the simplest pair: " + shared);
    b["labels"] = labels;
    // Of what hangs each question would cost a second, or two.
    const bool answers = method < methods.size() && simplest_now.answers[method].failure != Failure::hang &&
                         simplest_now.answers[method].status != Status::declined;
    b["share"] = !answers
                     ? Json(nullptr)
                     : share_json(heap.simplest, m, feature, mechanism == "offset", method, of.kind, methods);
    b["standing"] = nullptr;
    b["suppressed"] = nullptr;
    buckets.push_back(std::move(b));
  }
  std::stable_sort(buckets.begin(), buckets.end(), [](const Json& x, const Json& y) {
    const auto rank = [](const Json& b) {
      return std::pair(rank_of(b["severity"]), -b["count"].get<std::int64_t>());
    };
    return rank(x) < rank(y);
  });
  return buckets;
}

void hold_against(Json& buckets, const std::string& id, const std::vector<std::string>& asked,
                  const std::vector<Json>& earlier) {
  const auto find = [](const Json& all, const Json& key) -> const Json* {
    for (const Json& b : all)
      if (b["key"] == key && b["standing"] != "gone") return &b;
    return nullptr;
  };
  for (Json& b : buckets) {
    b["first_seen"] = b["last_seen"] = id;
    const Json* first = nullptr;
    for (const Json& run : earlier)
      if (const Json* had = find(run, b["key"]); had != nullptr && first == nullptr) first = had;
    if (first != nullptr) b["first_seen"] = (*first)["first_seen"];
    if (earlier.empty()) continue;
    b["standing"] = first == nullptr ? "new" : find(earlier.back(), b["key"]) != nullptr ? "known" : "back";
  }
  if (earlier.empty()) return;
  for (Json b : earlier.back()) {
    if (b["standing"] == "gone" || find(buckets, b["key"]) != nullptr) continue;
    const bool again = std::any_of(b["methods"].begin(), b["methods"].end(), [&](const Json& name) {
      return std::find(asked.begin(), asked.end(), name.get<std::string>()) != asked.end();
    });
    if (!again) continue;
    b["standing"] = "gone";
    b["count"] = 0;
    b["findings"] = Json::array();
    buckets.push_back(std::move(b));
  }
}

void suppress(Json& buckets, const std::vector<Suppression>& suppressions, std::string_view today) {
  for (Json& b : buckets) {
    b["suppressed"] = nullptr;
    if (const Suppression* s = find_suppression(suppressions, b["key"].get<std::string>(), today))
      b["suppressed"] = {
          {"reason", s->reason}, {"link", s->link}, {"owner", s->owner}, {"expires", s->expires}};
  }
}

}  // namespace cyl
