// SPDX-License-Identifier: MIT
#include "reports/triage/triage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include "base/process/child.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "fuzz/campaign/batch.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "oracles/methods/guest.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/bucket.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/mechanism.hpp"
#include "props/shrink/simplify.hpp"
#include "reports/triage/buckets.hpp"
#include "reports/triage/suppressed.hpp"
#include "reports/triage/worst_pair.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;
using std::chrono::milliseconds;

/// Findings probed together: more would cost a slow method's user time beyond the budget.
constexpr std::size_t probed_together = 32;
/// Questions of the shrinker about one finding; about one that hangs, where each that does costs half a
/// second.
constexpr std::size_t simplify_cap = 1500, simplify_hang_cap = 600;
/// Part of the budget after which the simplifying makes way for the search for worse pairs.
constexpr double simplify_part = 0.7;
/// Shapes looked at for the worst pair of a cause: two walks, a few seconds.
constexpr std::size_t shapes_cap = 500;
/// As the gate has them: shorter than a campaign's.
constexpr Caps triage_caps{.call_cpu = milliseconds(500), .call_wall = milliseconds(2000), .hangs = 4};
/// Of what hangs one pair at a time is enough.
constexpr Caps hang_caps{.call_cpu = triage_caps.call_cpu, .call_wall = triage_caps.call_wall, .hangs = 1};
/// How often the processes' end is looked for, and how far they are.
constexpr milliseconds poll_interval{50}, show_interval{500};

milliseconds since(Clock::time_point start) {
  return std::chrono::duration_cast<milliseconds>(Clock::now() - start);
}

/// Does `work(job)` in `jobs` processes at once, which die with this one; `meanwhile` is called in this one
/// now and then. Throws where one of them failed.
void in_processes(unsigned jobs, const std::function<void(unsigned)>& work,
                  const std::function<void()>& meanwhile) {
  std::list<Child> running;
  for (unsigned job = 0; job < jobs; ++job)
    running.emplace_back([&]() -> std::string { return work(job), std::string(); }, ChildOptions{"triage"});
  bool failed = false;
  for (Clock::time_point shown = Clock::now(); !running.empty();) {
    std::this_thread::sleep_for(poll_interval);
    running.remove_if([&](Child& child) {
      if (!child.advance()) return false;
      failed |= child.status() != 0;
      return true;
    });
    if (since(shown) < show_interval) continue;
    shown = Clock::now();
    meanwhile();
  }
  meanwhile();
  if (failed) throw std::runtime_error("a process of the triage failed; run it again to go on");
}

/// What of a finding is read once.
struct Subject {
  const FindingRecord* record;
  std::optional<std::size_t> method;
  bool absent = false;  ///< its method is a guest of the run that is not here
  std::optional<FindingKind> kind;
  Severity severity = Severity::contract;
  Pair pair;
};

bool was_searched_for(const Json& bucket) { return bucket["worst"].contains("note"); }

class Triager {
 public:
  Triager(const TriageOptions& options, std::span<const std::unique_ptr<Method>> methods,
          const std::function<void(const TriageProgress&)>& on_progress)
      : options_(options),
        on_progress_(on_progress),
        methods_(methods),
        askers_(askers(options.build, methods)),
        kin_(kin_of(methods)) {
    const RunStore run = RunStore::open(options.folder);
    for (Guest& guest : parse_guests(value_of(run.config(), "guests"))) {
      if (!index_of(guest.name)) absent_.insert(std::move(guest.name));
    }
    sorted_.folder = options.folder;
    sorted_.findings = run.findings();
    sorted_.groups = run.groups();
    for (const MethodRecord& m : run.methods())
      if (!absent_.contains(m.name)) asked_.push_back(m.name);
    began_ = value_of(run.config(), "started");
    for (const FindingRecord& f : sorted_.findings) subjects_.push_back(subject_of(f));
    progress_.findings = subjects_.size();
    for (const Subject& s : subjects_)
      if (s.absent) absent_findings_.insert(s.record->id);
    progress_.absent = absent_findings_.size();
  }

  Triage run() {
    forget_changed_guests();
    tell_causes();
    simplify_findings(simplify_part);
    search_worst();
    simplify_findings(1);
    const TriageStore store(options_.folder, askers_);
    sorted_.causes = here(store.causes());
    sorted_.simples = here(store.simples());
    sorted_.worsts = store.worsts();
    count_progress();
    Triage triage;
    triage.buckets = make_buckets(sorted_, methods_);
    hold_against(triage.buckets, fs::canonical(options_.folder).filename().string(), asked_, earlier());
    write_pairs(triage.buckets);
    suppress(triage.buckets, options_.suppressions, options_.today);
    TriageStore(options_.folder, askers_).set_buckets(triage.buckets.dump());
    if (!options_.suppressions.empty()) {
      std::size_t stale = 0;
      triage.remarks =
          remarks_on(options_.suppressions, options_.today, causes_of(methods_, options_.cases), stale);
    }
    triage.progress = progress_;
    return triage;
  }

 private:
  std::optional<std::size_t> index_of(std::string_view name) const {
    for (std::size_t m = 0; m < methods_.size(); ++m)
      if (methods_[m]->name() == name) return m;
    return {};
  }

  Subject subject_of(const FindingRecord& f) const {
    Subject s{&f,
              index_of(f.method),
              absent_.contains(f.method),
              from_word<FindingKind>(f.kind),
              from_word<Severity>(f.severity).value_or(Severity::contract),
              {}};
    const CaseLine line = parse_case(f.pair, 1);
    if (!line.value) throw std::runtime_error(fmt::format("finding {}: {}", f.id, line.error));
    s.pair = line.value->pair;
    return s;
  }

  bool out_of_time(double part = 1) const { return Clock::now() - start_ >= part * options_.budget; }

  static std::size_t ended(const std::vector<SimpleRecord>& simples) {
    return static_cast<std::size_t>(
        std::count_if(simples.begin(), simples.end(), [](const SimpleRecord& s) { return s.ended; }));
  }

  void count_progress() {
    progress_.told = sorted_.causes.size();
    progress_.simplified = ended(sorted_.simples);
    progress_.searched = sorted_.worsts.size();
    progress_.elapsed = since(start_);
  }
  void show_progress() {
    const TriageStore store(options_.folder, askers_);
    progress_.told = here(store.causes()).size();
    progress_.simplified = ended(here(store.simples()));
    progress_.searched = store.worsts().size();
    progress_.elapsed = since(start_);
    if (on_progress_) on_progress_(progress_);
  }

  // ---- causes

  /// What was told of a guest that is another one now is told anew; of one that is not here it is kept.
  void forget_changed_guests() {
    TriageStore store(options_.folder, askers_);
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      if (!methods_[m]->guest()) continue;
      std::vector<std::int64_t> findings;
      for (const Subject& s : subjects_)
        if (s.method == m) findings.push_back(s.record->id);
      store.expect(std::string(methods_[m]->name()), std::string(methods_[m]->version()), findings);
    }
  }

  /// Without those of findings whose guest is not here.
  template <class Record>
  std::vector<Record> here(std::vector<Record> records) const {
    std::erase_if(records, [&](const Record& r) { return absent_findings_.contains(r.finding); });
    return records;
  }

  void tell_causes() {
    std::set<std::int64_t> known;
    {
      const TriageStore store(options_.folder, askers_);
      for (const CauseRecord& c : here(store.causes())) known.insert(c.finding);
    }
    std::vector<const Subject*> open;
    for (const Subject& s : subjects_)
      if (!s.absent && !known.contains(s.record->id)) open.push_back(&s);
    if (open.empty()) return;
    in_processes(
        options_.jobs,
        [&](unsigned job) {
          TriageStore store(options_.folder, askers_);
          for (std::size_t first = job * probed_together; first < open.size() && !out_of_time();
               first += options_.jobs * probed_together)
            store.add(tell(std::span(open).subspan(first, std::min(probed_together, open.size() - first))));
        },
        [&] { show_progress(); });
  }

  std::vector<CauseRecord> tell(std::span<const Subject* const> subjects) const {
    std::vector<Failing> failing;
    for (const Subject* s : subjects)
      if (can_be_probed(*s)) failing.push_back({*s->method, *s->kind, s->pair});
    const std::vector<Told> told = tell_mechanisms(methods_, kin_, failing, triage_caps);
    std::vector<CauseRecord> causes;
    auto next = told.begin();
    for (const Subject* s : subjects) {
      const Told of = can_be_probed(*s) ? *next++ : Told{};
      causes.push_back({s->record->id, key_of(*s, of), std::string(to_string(of.mechanism)), labels_of(of)});
    }
    return causes;
  }

  // What hangs or comes and goes answers no probe.
  static bool can_be_probed(const Subject& s) {
    return s.method && s.kind && s.kind != FindingKind::hang && s.kind != FindingKind::nondeterminism;
  }

  std::string key_of(const Subject& s, const Told& told) const {
    if (!is_method_row(s.record->method)) return s.record->method + '/' + s.record->kind;
    if (!s.method || !s.kind) return s.record->method + "/not-in-this-build";
    return cause_key(methods_, kin_, *s.method, *s.kind, s.severity, told, s.record->reason);
  }

  std::string labels_of(const Told& told) const {
    std::string labels;
    const auto add = [&](const std::string& label) { labels += (labels.empty() ? "" : "\n") + label; };
    if (told.moving_cures) add("offset: right at the origin");
    if (told.capped) add("iteration cap: its search used up its steps");
    if (told.larger_cures) add("absolute length: right where it is larger");
    if (told.smaller_cures) add("absolute length: right where it is smaller");
    if (told.right_sibling)
      add(fmt::format("own setting: {} is right", methods_[*told.right_sibling]->name()));
    return labels;
  }

  std::map<std::int64_t, const Subject*> subjects_by_id() const {
    std::map<std::int64_t, const Subject*> by_id;
    for (const Subject& s : subjects_) by_id[s.record->id] = &s;
    return by_id;
  }

  // ---- simple pairs

  /// Bucket by bucket in turns, in each the simplest first and of other methods, kinds and families before
  /// more of the same: an order that is the findings' own.
  std::vector<const Subject*> in_turns(const std::vector<CauseRecord>& causes) const {
    const std::map<std::int64_t, const Subject*> by_id = subjects_by_id();
    struct Candidate {
      std::size_t turn;
      Complexity complexity;
      const Subject* subject;
    };
    std::map<std::string, std::vector<Candidate>> buckets;
    for (const CauseRecord& c : causes) {
      const auto found = by_id.find(c.finding);
      if (found == by_id.end() || !can_be_simplified(*found->second)) continue;
      if (c.mechanism == to_string(Mechanism::gone)) continue;
      buckets[c.bucket].push_back({0, complexity(found->second->pair), found->second});
    }
    struct Next {
      std::size_t turn;
      std::string bucket;
      const Subject* subject;
    };
    std::vector<Next> order;
    for (auto& [bucket, candidates] : buckets) {
      std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
        return x.complexity != y.complexity ? x.complexity < y.complexity
                                            : x.subject->record->id < y.subject->record->id;
      });
      std::map<std::tuple<std::string, std::string, std::string>, std::size_t> seen;
      for (Candidate& c : candidates)
        c.turn = seen[{c.subject->record->method, c.subject->record->kind, c.subject->record->family}]++;
      std::stable_sort(candidates.begin(), candidates.end(),
                       [](const Candidate& x, const Candidate& y) { return x.turn < y.turn; });
      for (std::size_t i = 0; i < candidates.size(); ++i) order.push_back({i, bucket, candidates[i].subject});
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const Next& x, const Next& y) { return x.turn < y.turn; });
    std::vector<const Subject*> subjects;
    for (const Next& next : order) subjects.push_back(next.subject);
    return subjects;
  }

  static bool can_be_simplified(const Subject& s) {
    return s.method && s.kind && s.kind != FindingKind::nondeterminism;
  }

  /// Until that part of the budget is used up. What is cut goes on from what it came to.
  void simplify_findings(double part) {
    std::map<std::int64_t, SimpleRecord> known;
    std::vector<const Subject*> open;
    {
      const TriageStore store(options_.folder, askers_);
      for (SimpleRecord& s : here(store.simples())) known[s.finding] = std::move(s);
      sorted_.causes = here(store.causes());
    }
    for (const CauseRecord& c : sorted_.causes) key_of_finding_[c.finding] = c.bucket;
    for (const Subject* s : in_turns(sorted_.causes))
      if (!known[s->record->id].ended) open.push_back(s);
    if (open.empty() || out_of_time(part)) return;
    in_processes(
        options_.jobs,
        [&](unsigned job) {
          TriageStore store(options_.folder, askers_);
          for (std::size_t i = job; i < open.size() && !out_of_time(part); i += options_.jobs)
            store.add(simplified(*open[i], known.at(open[i]->record->id)));
        },
        [&] { show_progress(); });
  }

  SimpleRecord simplified(const Subject& s, const SimpleRecord& earlier) const {
    const std::string& key = key_of_finding_.at(s.record->id);
    const auto feature = contact_feature(s.pair, judge(s.pair));
    bool cut = false;
    const StillFails still_fails = [&](std::span<const Pair> pairs) {
      cut = cut || out_of_time();
      return cut ? std::vector<bool>(pairs.size()) : fail_alike(s, key, feature, pairs);
    };
    const CaseLine begun = parse_case(earlier.pair, 1);
    const std::size_t cap = s.kind == FindingKind::hang ? simplify_hang_cap : simplify_cap;
    const Simplified simple = simplify(begun.value ? begun.value->pair : s.pair, still_fails, cap);
    return {s.record->id, format_pair(simple.pair), bucket_of(s.record->method, s.record->kind, simple.pair),
            simple.questions, !cut};
  }

  /// Which of the pairs fail in the same way, of the same cause and feature: no more than the first of them,
  /// since no others are looked at.
  std::vector<bool> fail_alike(const Subject& s, const std::string& key,
                               std::optional<ContactFeature> feature, std::span<const Pair> pairs) const {
    std::vector<bool> fails(pairs.size(), false);
    std::vector<Question> questions;
    for (std::size_t p = 0; p < pairs.size(); ++p) questions.push_back({*s.method, p});
    const bool hangs = s.kind == FindingKind::hang;
    const auto said = ask_contained(methods_, pairs, questions, hangs ? hang_caps : triage_caps);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const Truth truth = judge(pairs[p], {&said[p].answer, 1});
      LazyDistance distance([&](double width) { return enclose_distance(pairs[p], truth, width); });
      const auto found = compare(pairs[p], truth, distance, methods_[*s.method]->claim(), said[p].answer);
      if (!found || found->kind != *s.kind || found->severity != s.severity) continue;
      if (contact_feature(pairs[p], truth) != feature) continue;
      if (s.severity == Severity::contract && can_be_probed(s)) {
        const Failing now{*s.method, *s.kind, pairs[p]};
        const Told told = tell_mechanisms(methods_, kin_, {&now, 1}, triage_caps)[0];
        if (cause_key(methods_, kin_, *s.method, *s.kind, s.severity, told, said[p].answer.reason) != key)
          continue;
      }
      fails[p] = true;
      break;
    }
    return fails;
  }

  // ---- worst pairs

  // Of a crash or a hang there is no margin; of touching, no search.
  static bool can_be_searched(const Subject& s) {
    return s.method && s.severity == Severity::contract &&
           (s.kind == FindingKind::wrong_disjoint || s.kind == FindingKind::wrong_intersecting);
  }

  void search_worst() {
    std::map<std::string, WorstRecord> earlier;
    std::vector<CauseSought> open;
    {
      const TriageStore store(options_.folder, askers_);
      for (const WorstRecord& w : store.worsts()) earlier[w.bucket] = w;
      for (CauseSought& cause : causes_sought(store))
        if (!earlier[cause.key].ended) open.push_back(std::move(cause));
    }
    if (open.empty() || out_of_time()) return;
    in_processes(
        options_.jobs,
        [&](unsigned job) {
          TriageStore store(options_.folder, askers_);
          for (std::size_t i = job; i < open.size() && !out_of_time(); i += options_.jobs) {
            const auto left = static_cast<milliseconds::rep>((open.size() - i - 1) / options_.jobs + 1);
            store.add(searched(open[i], earlier[open[i].key], (options_.budget - since(start_)) / left));
          }
        },
        [&] { show_progress(); });
  }

  /// In the order of their keys. Of each cause: the method and the way of the worst finding, and all that is
  /// wrong in that way, other methods' last.
  std::vector<CauseSought> causes_sought(const TriageStore& store) const {
    const std::map<std::int64_t, const Subject*> by_id = subjects_by_id();
    std::map<std::string, std::vector<const Subject*>> buckets;
    std::map<std::int64_t, Mechanism> mechanism_of;
    for (const CauseRecord& c : here(store.causes())) {
      const auto found = by_id.find(c.finding);
      const Mechanism mechanism = from_word<Mechanism>(c.mechanism).value_or(Mechanism::gone);
      if (found == by_id.end() || mechanism == Mechanism::gone || !can_be_searched(*found->second)) continue;
      buckets[c.bucket].push_back(found->second);
      mechanism_of[c.finding] = mechanism;
    }
    std::map<std::int64_t, Pair> simple_of;
    for (const SimpleRecord& s : here(store.simples()))
      if (const CaseLine line = parse_case(s.pair, 1); line.value) simple_of[s.finding] = line.value->pair;

    std::vector<CauseSought> causes;
    for (auto& [key, subjects] : buckets) {
      const auto worse = [](const Subject* x, const Subject* y) {
        return is_worse(*x->record, *y->record) ||
               (!is_worse(*y->record, *x->record) && x->record->id < y->record->id);
      };
      const Subject& worst = **std::min_element(subjects.begin(), subjects.end(), worse);
      std::erase_if(subjects, [&](const Subject* s) { return s->kind != worst.kind; });
      std::sort(subjects.begin(), subjects.end(), [&](const Subject* x, const Subject* y) {
        const bool own_x = x->method == worst.method, own_y = y->method == worst.method;
        return own_x != own_y ? own_x : worse(x, y);
      });
      CauseSought cause{key, mechanism_of[worst.record->id], *worst.method, *worst.kind, {}};
      for (const Subject* s : subjects) cause.starts.push_back(s->pair);
      if (const Pair* simplest = simplest_of(subjects, simple_of))
        cause.starts.insert(cause.starts.begin() + 1, *simplest);
      causes.push_back(std::move(cause));
    }
    return causes;
  }

  static const Pair* simplest_of(const std::vector<const Subject*>& subjects,
                                 const std::map<std::int64_t, Pair>& simple_of) {
    const Pair* simplest = nullptr;
    for (const Subject* s : subjects) {
      const auto found = simple_of.find(s->record->id);
      if (found == simple_of.end()) continue;
      if (simplest == nullptr || complexity(found->second) < complexity(*simplest)) simplest = &found->second;
    }
    return simplest;
  }

  /// A search that is cut goes on from what it came to.
  WorstRecord searched(CauseSought cause, const WorstRecord& earlier, milliseconds budget) const {
    if (const CaseLine line = parse_case(earlier.pair, 1); line.value)
      cause.starts.insert(cause.starts.begin(), line.value->pair);
    WorstOptions options;
    options.evaluation_cap = shapes_cap;
    options.budget = budget;
    const Clock::time_point began = Clock::now();
    const auto found = worst_of_cause(methods_, kin_, cause, options, triage_caps);
    return {cause.key, std::string(methods_[cause.method]->name()), to_string(cause.kind),
            found ? format_pair(found->pair) : earlier.pair, since(began) < budget};
  }

  // ---- other runs

  std::vector<Json> earlier() const {
    std::vector<std::tuple<std::string, std::string>> runs;  // when it began, folder
    const fs::path here = fs::canonical(options_.folder);
    const std::vector<std::string> folders =
        options_.against.empty() ? runs_in(here.parent_path().string()) : options_.against;
    for (const std::string& folder : folders) {
      if (fs::canonical(folder) == here || stored_buckets(folder).empty()) continue;
      const std::string began = value_of(RunStore::open(folder).config(), "started");
      if (!options_.against.empty() || std::pair(began, folder) < std::pair(began_, here.string()))
        runs.emplace_back(began, folder);
    }
    std::sort(runs.begin(), runs.end());
    std::vector<Json> earlier;
    for (const auto& [began, folder] : runs) earlier.push_back(buckets_json(folder));
    return earlier;
  }

  /// FOLDER/buckets/: the simplest pair of each bucket, and the worst where it was searched for, each as a
  /// file of one case.
  void write_pairs(const Json& buckets) const {
    const fs::path folder = fs::path(options_.folder) / "buckets";
    fs::create_directories(folder);
    for (const Json& b : buckets) {
      if (b["standing"] == "gone") continue;
      const std::string name = letters_only(b["key"].get<std::string>());
      write_pair(folder / (name + ".jsonl"), b, b["simplest"]);
      if (was_searched_for(b)) write_pair(folder / (name + ".worst.jsonl"), b, b["worst"]);
    }
  }

  static void write_pair(const fs::path& file, const Json& bucket, const Json& shown) {
    Json line = shown["pair"];
    line["id"] = bucket["key"];
    line["note"] = bucket["cause"];
    std::ofstream out(file);
    out << line.dump() << '\n';
    out.close();
    if (!out) throw std::runtime_error(file.string() + " cannot be written");
  }

  const TriageOptions& options_;
  const std::function<void(const TriageProgress&)>& on_progress_;
  const std::span<const std::unique_ptr<Method>> methods_;
  const std::string askers_;
  const std::vector<std::size_t> kin_;
  const Clock::time_point start_ = Clock::now();
  std::set<std::string, std::less<>> absent_;  ///< guests of the run
  std::set<std::int64_t> absent_findings_;
  Sorted sorted_;
  std::vector<Subject> subjects_;
  std::map<std::int64_t, std::string> key_of_finding_;
  std::vector<std::string> asked_;
  std::string began_;
  TriageProgress progress_;
};

/// "fcl-libccd, ode and 3 more".
std::string some_of(const Json& names) {
  constexpr std::size_t named_cap = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), named_cap); ++i)
    text += (i == 0 ? "" : ", ") + names[i].get<std::string>();
  if (names.size() > named_cap) text += fmt::format(" and {} more", names.size() - named_cap);
  return text;
}

/// "1.0e-05", "0.0e+00" or "-".
std::string short_number(const Json& x) { return x.is_null() ? "-" : fmt::format("{:.1e}", x.get<double>()); }

}  // namespace

std::string askers(const std::string& build, std::span<const std::unique_ptr<Method>> methods) {
  std::string text = build;
  for (const auto& method : methods)
    if (!method->guest()) text += fmt::format("\n{} {}", method->name(), method->version());
  return text;
}

Triage run_triage(const TriageOptions& options, std::span<const std::unique_ptr<Method>> methods,
                  const std::function<void(const TriageProgress&)>& on_progress) {
  return Triager(options, methods, on_progress).run();
}

Json buckets_json(const std::string& run_folder) {
  const std::string text = stored_buckets(run_folder);
  return text.empty() ? Json::array() : Json::parse(text);
}

int exit_code(const Triage& triage) {
  bool undecided = triage.progress.told < triage.progress.findings;
  for (const Json& b : triage.buckets) {
    if (b["standing"] == "gone" || !b["suppressed"].is_null()) continue;
    if (b["severity"] == "contract") return 2;
    undecided |= b["severity"] == "unresolved";
  }
  return undecided ? 3 : 0;
}

std::string format_buckets(const Json& buckets) {
  std::string text;
  for (const Json& b : buckets) {
    const Json& margin = b["margin"];
    const Json& share = b["share"];
    const auto word = [&](const char* key) { return b[key].get<std::string>(); };
    text += fmt::format("{} {}{}{}\n", word("severity") == "contract" ? "*" : " ", word("key"),
                        b["standing"].is_null() ? "" : ", " + word("standing"),
                        b["suppressed"].is_null() ? "" : ", suppressed");
    text += fmt::format("    {}\n", word("cause"));
    text += fmt::format(
        "    {} findings of {} methods in {} families; margins {} to {}{}{}\n",
        b["count"].get<std::uint64_t>(), b["methods"].size(), b["families"].size(),
        short_number(margin.is_null() ? margin : margin[0]),
        short_number(margin.is_null() ? margin : margin[1]),
        was_searched_for(b) ? fmt::format(", {} searched for", short_number(b["worst"]["margin"][0])) : "",
        share.is_null()
            ? ""
            : fmt::format("; {} wrong on {} of {} drawn like it", word("method"),
                          share["wrong"].get<std::uint64_t>(), share["asked"].get<std::uint64_t>()));
    text += fmt::format("    {}: {}\n", some_of(b["methods"]), b["simplest"]["pair"].dump());
  }
  return text;
}

}  // namespace cyl
