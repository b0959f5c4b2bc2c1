// SPDX-License-Identifier: MIT
#include "props/gate/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/fnv.hpp"
#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_digest.hpp"
#include "corpus/pairs/strata.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/failure_key.hpp"
#include "props/gate/law_pairs.hpp"
#include "props/shrink/simplify.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// The number of cases asked together.
constexpr std::size_t cases_at_once = 32;
/// A pair under all laws takes as long as this many of the sample. Both phases are to take equally long.
constexpr std::uint64_t law_cost = 50;
/// It takes a hundred times as long to enclose a distance as to prove a verdict. So that law is checked in
/// one round of this many. A close contact takes ten times as long again.
constexpr std::uint64_t distance_share = 8, close_distance_share = 64;
constexpr int distance_law = 33;

/// How often a failing case is run again.
constexpr unsigned rerun_count = 10;
/// The most questions of the shrinker about one failure. After these, the failure stays as it is.
constexpr std::size_t simplify_cap = 1200;
/// The questions about all failures, reruns included. They suffice for a few failures in the smallest gate,
/// and there is one more for this many pairs drawn.
constexpr std::uint64_t least_questions = 4 * simplify_cap, pairs_per_rerun = 10;
/// A hang counts as this many questions. It takes half a second, and a question takes some tenths of a
/// millisecond.
constexpr std::uint64_t hang_cost = 1000;
/// The same for a crash of a program, which is started again.
constexpr std::uint64_t program_crash_cost = 50;

/// A method that hangs this often is not asked any more. This is 8 s of CPU time, or half a minute of sleep.
constexpr std::uint64_t hang_cap = 16;
/// A program that crashes this often is not asked any more. At half a second a start this is half a minute.
constexpr std::uint64_t program_crash_cap = 64;

bool is_of_answer(const Law& law) { return law.kind == LawKind::answer; }

/// Returns "wrong_disjoint" of a refuted verdict, "crash" of a failure, else the law's name.
std::string violation_kind(const Law& law, const Violation& violation) {
  return shows_in_answer(law) && violation.kind ? to_string(*violation.kind) : std::string(law.name);
}

class Gate {
 public:
  Gate(std::span<const std::unique_ptr<Method>> methods, std::span<const Case> cases,
       const GateOptions& options, const std::function<void(const GateProgress&)>& on_progress)
      : methods_(methods),
        cases_(cases),
        options_(options),
        on_progress_(on_progress),
        solids_(solids_of(methods)),
        asker_(methods, options.caps) {
    amount_ = options.amount.value_or(amount_of(options.pairs, solids_));
    questions_left_ = least_questions + options.pairs / pairs_per_rerun;
    skipped_.resize(methods.size());
    report_.seed = options.seed;
    report_.pairs = options.pairs;
    report_.cap = options.cap;
    for (const auto& method : methods) {
      GateMethod& m = report_.methods.emplace_back();
      m.name = method->name();
      m.version = method->version();
      m.claim = method->claim();
      m.cells = empty_cells();
      m.close_cells = empty_close_cells();
    }
  }

  GateReport run() {
    in_phase(GatePhase::corpus, [&] {
      replay_cases([](std::size_t, const Law& law) { return is_of_answer(law); }, cases_.size());
    });
    in_phase(GatePhase::corpus_laws, [&] {
      replay_cases([](std::size_t, const Law& law) { return !is_of_answer(law); },
                   std::min<std::uint64_t>(amount_.cases_under_laws.value_or(cases_.size()), cases_.size()));
    });
    if (solids_.cylinders) {
      in_phase(GatePhase::laws, [&] { check_laws(draw_law_pairs, amount_.law_rounds); });
      in_phase(GatePhase::sample, [&] { sample(draw_strata, amount_.sample_rounds, distance_share); });
      in_phase(GatePhase::close_laws, [&] { check_laws(draw_close_law_pairs, amount_.close_law_rounds); });
      in_phase(GatePhase::close_sample,
               [&] { sample(draw_close_contacts, amount_.close_rounds, close_distance_share); });
    }
    if (amount_.rounded_rounds > 0) {
      in_phase(GatePhase::rounded_laws,
               [&] { check_laws(draw_rounded_law_pairs, amount_.rounded_law_rounds); });
      in_phase(GatePhase::rounded_sample,
               [&] { sample(draw_rounded_solids, amount_.rounded_rounds, distance_share); });
    }
    if (!options_.as_found && std::any_of(report_.failures.begin(), report_.failures.end(), is_error))
      in_phase(GatePhase::simplify, [&] { simplify_failures(); });
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      GateMethod& method = report_.methods[m];
      const bool hung = method.counts.hangs >= options_.caps.hangs;
      method.remark = given_up(m)
                          ? fmt::format("{}, and was not asked to the end", hung ? "hangs" : "crashes")
                          : remark_on(method.counts);
      if (skipped_[m])
        report_.not_asked.push_back(
            hung ? method.name + ", after it had hung too often"
                 : method.name +
                       ", after it had crashed too often: a program that catches exceptions can answer "
                       "{\"error\":\"why\"} and go on");
    }
    return std::move(report_);
  }

 private:
  milliseconds elapsed() const {
    return std::chrono::duration_cast<milliseconds>(Clock::now() - options_.start);
  }

  template <class Work>
  void in_phase(GatePhase phase, Work work) {
    const auto from = Clock::now();
    report_.phases.push_back({.phase = phase, .digest = fnv1a({})});
    work();
    report_.phases.back().time = std::chrono::duration_cast<milliseconds>(Clock::now() - from);
  }

  bool out_of_time() const { return cyl::out_of_time(options_); }

  /// Returns whether a phase that has `done` of its rounds or cases goes on. If the time is over, the rest
  /// is not asked, and the report states it.
  bool goes_on(std::uint64_t done, std::uint64_t due, const char* things) {
    if (done >= due) return false;
    const bool is_first = done == 0 && report_.phases.size() == 1;  // the first cases are always asked
    if (is_first || !out_of_time()) return true;
    report_.not_asked.push_back(fmt::format("{}: {} of {} {}, {}", to_string(report_.phases.back().phase),
                                            due - done, due, things, why_not(options_)));
    return false;
  }

  void show_progress(std::span<const Pair> pairs, double share) {
    GatePhaseReport& now = report_.phases.back();
    now.pairs += static_cast<std::uint64_t>(std::ranges::count_if(pairs, [&](const Pair& pair) {
      return std::ranges::any_of(methods_, [&](const auto& method) { return method->supports(pair); });
    }));
    for (const Pair& pair : pairs) now.digest = digest_of(pair, now.digest);
    if (!on_progress_) return;
    const auto beyond = std::count_if(report_.failures.begin(), report_.failures.end(), is_error);
    on_progress_({now.phase, now.pairs, static_cast<std::size_t>(beyond), share, elapsed()});
  }

  /// Adds a break to the breaks of the same law and cause. Returns the failure if this is its first or its
  /// worst break so far.
  GateFailure* record(std::size_t method, const Law& law, const Violation& violation, const Pair& pair,
                      const std::string& origin, const std::optional<Stratum>& stratum = {}) {
    std::string kind = violation_kind(law, violation);
    const std::string& name = report_.methods[method].name;
    const bool contract = violation.severity == Severity::contract;
    std::string cause = stratum ? failure_key(name, kind, stratum->feature,
                                              coordinate_of(pair, std::pow(10.0, -stratum->decade - 0.5)))
                                : failure_key_of(name, kind, pair);
    const auto [at, is_new] =
        by_cause_.try_emplace(std::tuple(law.number, cause, contract), report_.failures.size());
    GateFailure& failure = is_new ? report_.failures.emplace_back() : report_.failures[at->second];
    ++failure.count;
    const GatePhase phase = report_.phases.back().phase;
    if (!is_new && (violation.excess <= failure.excess || (failure.in_case() && cases_are_done())))
      return nullptr;
    failure.method = name;
    failure.law = &law;
    failure.kind = std::move(kind);
    failure.cause = std::move(cause);
    failure.what = violation.what;
    failure.reason = violation.reason;
    if (violation.kind && is_failure(*violation.kind)) failure.failed = violation.kind;
    failure.severity = violation.severity;
    failure.phase = phase;
    failure.origin = origin;
    failure.found = failure.simplest = pair;
    failure.excess = violation.excess;
    return &failure;
  }

  /// `again`: the pairs were counted before, so only their hangs are added.
  void count(const std::vector<AnswerCounts>& counts, bool again = false) {
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      AnswerCounts& all = report_.methods[m].counts;
      if (again) {
        all.hangs += counts[m].hangs;
        all.crashes += counts[m].crashes;
        all.hung_seconds += counts[m].hung_seconds;
      } else {
        all += counts[m];
      }
      skipped_[m] = skipped_[m] || given_up(m) || counts[m].hangs >= options_.caps.hangs ||
                    (is_program(m) && counts[m].crashes >= options_.caps.program_crashes);
    }
  }

  bool cases_are_done() const { return report_.phases.back().phase > GatePhase::corpus_laws; }
  bool is_program(std::size_t m) const { return methods_[m]->is_out_of_process(); }
  /// A method that hangs again and again is not asked any more. Otherwise the gate would not end.
  bool given_up(std::size_t m) const {
    const AnswerCounts& counts = report_.methods[m].counts;
    return counts.hangs >= hang_cap || (is_program(m) && counts.crashes >= program_crash_cap);
  }
  Examined examine_all(std::span<const Pair> pairs, const LawFilter& wanted) {
    return examine(
        methods_, pairs, [&](std::size_t m, const Law& law) { return !given_up(m) && wanted(m, law); },
        asker_);
  }

  void replay_cases(const LawFilter& wanted, std::size_t due) {
    for (std::size_t first = 0; goes_on(first, due, "cases"); first += cases_at_once) {
      std::vector<Pair> pairs;
      for (const Case& c : cases_.subspan(first, std::min(cases_at_once, due - first)))
        pairs.push_back(c.pair);
      const Examined examined = examine_all(pairs, wanted);
      count(examined.counts, report_.phases.back().phase == GatePhase::corpus_laws);
      if (report_.phases.back().phase == GatePhase::corpus) {
        report_.undecided_truths += static_cast<std::uint64_t>(
            std::count(examined.truths.begin(), examined.truths.end(), Verdict::undecided));
        for (const Pair& pair : pairs) report_.cases.push_back(digest_of(pair, fnv1a({})));
      }
      for (const LawViolation& b : examined.violations) {
        const Case& c = cases_[first + b.pair];
        record(b.method, *b.law, b.violation, c.pair, fmt::format("{}:{} {}", c.file, c.line, c.id));
      }
      show_progress(pairs, part(first + pairs.size(), due));
    }
  }

  static double part(std::uint64_t done, std::uint64_t due) {
    return static_cast<double>(done) / static_cast<double>(due);
  }

  void check_laws(SampleRound (*draw)(std::uint64_t, std::uint64_t), std::uint64_t due) {
    for (std::uint64_t& round = report_.phases.back().rounds; goes_on(round, due, "rounds");) {
      SampleRound drawn = draw(options_.seed, round);
      keep_supported(drawn, methods_, solids_.sizes);
      const Examined examined = examine_all(drawn.pairs, [](std::size_t, const Law&) { return true; });
      count(examined.counts);
      for (const LawViolation& b : examined.violations)
        record(b.method, *b.law, b.violation, drawn.pairs[b.pair], drawn.origins[b.pair]);
      show_progress(drawn.pairs, part(++round, due));
    }
  }

  /// Draws rounds and checks the laws that need no further question. The law of the distance is checked in
  /// one round of `distances`.
  void sample(SampleRound (*draw)(std::uint64_t, std::uint64_t), std::uint64_t due, std::uint64_t distances) {
    for (std::uint64_t& round = report_.phases.back().rounds; goes_on(round, due, "rounds");) {
      SampleRound drawn = draw(options_.seed, round);
      keep_supported(drawn, methods_, solids_.sizes);
      const LawFilter wanted = [&](std::size_t, const Law& law) {
        return is_of_answer(law) && law.queries == needs_none &&
               (round % distances == 0 || law.number != distance_law);
      };
      const Examined examined = examine_all(drawn.pairs, wanted);
      count(examined.counts);
      const std::vector<bool> none(drawn.pairs.size(), false);
      std::vector<RoundAnswers> said(methods_.size(), RoundAnswers{{}, examined.truths, none, none});
      for (std::size_t i = 0; i < examined.answers.size(); ++i)
        said[i % methods_.size()].answers.push_back(examined.answers[i]);
      for (const LawViolation& b : examined.violations) {
        if (b.law->number == verdict_law) {  // a failed answer has no verdict
          said[b.method].wrong[b.pair] = true;
          if (b.violation.severity == Severity::contract) said[b.method].wrong_beyond[b.pair] = true;
        }
        record(b.method, *b.law, b.violation, drawn.pairs[b.pair], drawn.origins[b.pair],
               drawn.strata.empty() ? std::nullopt : std::optional(drawn.strata[b.pair]));
      }
      for (std::size_t m = 0; m < methods_.size(); ++m) count_cells(report_.methods[m], drawn, said[m]);
      report_.undecided_truths += static_cast<std::uint64_t>(
          std::count(examined.truths.begin(), examined.truths.end(), Verdict::undecided));
      show_progress(drawn.pairs, part(++round, due));
    }
  }

  /// Returns an asker of the method of `failure` alone, in a worker that knows nothing else.
  Asker new_asker(const GateFailure& failure) const { return Asker(method_of(failure), options_.caps); }

  std::span<const std::unique_ptr<Method>> method_of(const GateFailure& failure) const {
    const auto method = std::find_if(methods_.begin(), methods_.end(),
                                     [&](const auto& m) { return m->name() == failure.method; });
    return {&*method, 1};
  }

  /// Returns which of the pairs break the law of `failure` in the same way.
  std::vector<bool> fails_again(const GateFailure& failure, std::span<const Pair> pairs, Asker& asker) {
    const LawFilter this_law = [&](std::size_t, const Law& law) { return law.number == failure.law->number; };
    std::vector<bool> fails(pairs.size(), false);
    const Examined examined = examine(method_of(failure), pairs, this_law, asker);
    const AnswerCounts& counts = examined.counts[0];
    const bool program = method_of(failure)[0]->is_out_of_process();
    questions_left_ -= std::min(questions_left_, pairs.size() + hang_cost * counts.hangs +
                                                     (program ? program_crash_cost * counts.crashes : 0));
    for (const LawViolation& b : examined.violations)
      fails[b.pair] =
          b.violation.severity == failure.severity && violation_kind(*b.law, b.violation) == failure.kind;
    return fails;
  }

  /// Returns what breaks on the simplest pair, in words.
  std::string what_breaks(const GateFailure& failure) const {
    const LawFilter this_law = [&](std::size_t, const Law& law) { return law.number == failure.law->number; };
    const Examined examined = examine(method_of(failure), {&failure.simplest, 1}, this_law, options_.caps);
    return examined.violations.empty() ? "" : examined.violations.front().violation.what;
  }

  // Starts when all failures are found, so that these do not depend on the shrinking. The first failure of
  // each law and kind comes first, because the others are like it.
  void simplify_failures() {
    std::set<std::tuple<std::string, int, std::string>> seen;
    std::vector<GateFailure*> in_order, duplicates;
    for (GateFailure& failure : report_.failures) {
      if (!is_error(failure)) continue;
      // One crash is one way to fail, under any law.
      const bool is_new =
          failure.failed
              ? seen.emplace(failure.method, 0, to_string(*failure.failed) + (": " + failure.reason)).second
              : seen.emplace(failure.method, failure.law->number, failure.kind).second;
      (is_new ? in_order : duplicates).push_back(&failure);
    }
    const std::size_t first_of_kind = in_order.size();
    in_order.insert(in_order.end(), duplicates.begin(), duplicates.end());
    std::uint64_t done = 0;
    for (GateFailure* failure : in_order) {
      if (done >= first_of_kind && questions_left_ == 0) break;
      if (out_of_time()) {
        report_.not_asked.push_back(fmt::format("simplification: {} of {} kinds of failures, {}",
                                                in_order.size() - done, in_order.size(), why_not(options_)));
        break;
      }
      rerun_and_simplify(*failure);
      show_progress({&failure->simplest, 1}, part(++done, in_order.size()));
    }
  }

  /// Reruns a failure even if no questions are left. Simplifies it while there are some.
  void rerun_and_simplify(GateFailure& failure) {
    for (; !out_of_time() && failure.reruns < rerun_count; ++failure.reruns) {
      Asker asker = new_asker(failure);
      failure.failed_again += fails_again(failure, {&failure.found, 1}, asker)[0];
    }
    if (failure.failed_again < rerun_count) {  // a failure that comes and goes cannot be shrunk
      failure.simplest = failure.found;
      return;
    }
    // Keeps the feature in contact. Otherwise every failure would shrink to points.
    const auto feature = contact_feature(failure.found);
    Asker asker = new_asker(failure);  // for all questions: starting a worker costs more than asking 32 pairs
    const StillFails still_fails = [&](std::span<const Pair> pairs) {
      if (questions_left_ == 0 || out_of_time()) return std::vector<bool>(pairs.size(), false);
      std::vector<bool> fails = fails_again(failure, pairs, asker);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        fails[i] = fails[i] && contact_feature(pairs[i]) == feature;
      return fails;
    };
    if (!still_fails({&failure.simplest, 1})[0]) failure.simplest = failure.found;
    failure.simplest = simplify(failure.simplest, still_fails, simplify_cap).pair;
    if (failure.failed == FindingKind::hang || out_of_time()) return;
    failure.what_of_simplest = what_breaks(failure);
    if (failure.what_of_simplest.empty()) failure.simplest = failure.found;  // it fails only after others
  }

  std::span<const std::unique_ptr<Method>> methods_;
  std::span<const Case> cases_;
  const GateOptions& options_;
  const std::function<void(const GateProgress&)>& on_progress_;
  const DrawnSolids solids_;
  Asker asker_;  ///< not for the reruns of a failure, which have workers that know nothing else
  GateAmount amount_;
  std::uint64_t questions_left_ = 0;
  GateReport report_;
  std::vector<bool> skipped_;  ///< by method: some pairs were not asked because others of their batch hung
  std::map<std::tuple<int, std::string, bool>, std::size_t> by_cause_;  ///< index of failures
};

}  // namespace

bool out_of_time(const GateOptions& options) {
  return options.stopped() || (options.cap && Clock::now() - options.start >= *options.cap);
}

const char* why_not(const GateOptions& options) {
  return options.stopped() ? "since the gate was stopped" : "since the time was over";
}

GateReport run_gate(std::span<const std::unique_ptr<Method>> methods, std::span<const Case> cases,
                    const GateOptions& options, const std::function<void(const GateProgress&)>& on_progress) {
  return Gate(methods, cases, options, on_progress).run();
}

GateAmount amount_of(std::uint64_t pairs, const DrawnSolids& solids) {
  constexpr std::uint64_t law_round = draws_per_round * pairs_per_draw;
  constexpr std::uint64_t sample_round = pairs_per_stratum * drawn_strata.size();
  const auto rounds = [](std::uint64_t amount, std::uint64_t round) {
    return std::max<std::uint64_t>(1, (amount + round - 1) / round);
  };
  const std::uint64_t parts = std::max<std::uint64_t>(1, (solids.cylinders ? 2 : 0) + (solids.rounded > 0));
  const std::uint64_t under_laws = pairs / (1 + law_cost) / parts,
                      sampled = (pairs - parts * under_laws) / parts;
  GateAmount amount;
  if (solids.cylinders) {
    amount.law_rounds = amount.close_law_rounds = rounds(under_laws, law_round);
    amount.sample_rounds = rounds(sampled, sample_round);
    amount.close_rounds = rounds(sampled, close_round);
  }
  if (solids.rounded > 0) {
    // Only the drawn pairs that a method supports are asked.
    const std::uint64_t all = pairs_per_kinds * rounded_families().size() + close_round;
    amount.rounded_law_rounds = rounds(under_laws * all / solids.rounded, law_round);
    amount.rounded_rounds = rounds(sampled, solids.rounded);
  }
  return amount;
}

}  // namespace cyl
