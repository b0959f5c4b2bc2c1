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
#include "oracles/trial/trial.hpp"
#include "props/shrink/simplify.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// The number of cases asked together.
constexpr std::size_t cases_at_once = 32;
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
    for (const auto& method : methods)
      report_.methods.push_back({.name = std::string(method->name()),
                                 .version = std::string(method->version()),
                                 .claim = method->claim(),
                                 .cells = empty_cells(),
                                 .close_cells = empty_close_cells()});
  }

  GateReport run() {
    replay_cases(GatePhase::corpus, cases_.size());
    replay_cases(GatePhase::corpus_laws, amount_.cases_under_laws.value_or(cases_.size()));
    if (solids_.cylinders) {
      check_laws(GatePhase::laws, draw_law_pairs, amount_.law_rounds);
      sample(GatePhase::sample, draw_strata, amount_.sample_rounds, distance_share);
      check_laws(GatePhase::close_laws, draw_close_law_pairs, amount_.close_law_rounds);
      sample(GatePhase::close_sample, draw_close_contacts, amount_.close_rounds, close_distance_share);
    }
    if (amount_.rounded_rounds > 0) {
      check_laws(GatePhase::rounded_laws, draw_rounded_law_pairs, amount_.rounded_law_rounds);
      sample(GatePhase::rounded_sample, draw_rounded_solids, amount_.rounded_rounds, distance_share);
    }
    if (!options_.as_found && std::ranges::any_of(report_.failures, is_error))
      in_phase(GatePhase::simplify, [&] { simplify_failures(); });
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      GateMethod& method = report_.methods[m];
      const bool hung = method.counts.hangs >= options_.caps.hangs;
      method.remark = given_up(m)
                          ? fmt::format("{}, and was not asked to the end", hung ? "hangs" : "crashes")
                          : remark_on(method.counts);
      if (skipped_[m])
        report_.not_asked.push_back(
            method.name +
            (hung ? ", after it had hung too often"
                  : ", after it had crashed too often: a program that catches exceptions can answer "
                    "{\"error\":\"why\"} and go on"));
    }
    return std::move(report_);
  }

 private:
  void in_phase(GatePhase phase, auto work) {
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
    on_progress_({now.phase, now.pairs, static_cast<std::size_t>(beyond), share});
  }

  /// Adds a break to the breaks of the same law and cause. The first is kept until a worse one comes.
  void record(const LawViolation& found, const Pair& pair, const std::string& origin,
              const std::optional<Stratum>& stratum = {}) {
    const Law& law = *found.law;
    const Violation& violation = found.violation;
    std::string kind = violation_kind(law, violation);
    const std::string& name = report_.methods[found.method].name;
    const bool contract = violation.severity == Severity::contract;
    std::string cause = stratum ? failure_key(name, kind, to_string(stratum->feature),
                                              coordinate_of(pair, std::pow(10.0, -stratum->decade - 0.5)))
                                : failure_key_of(name, kind, pair);
    const auto [at, is_new] =
        by_cause_.try_emplace(std::tuple(law.number, cause, contract), report_.failures.size());
    GateFailure& failure = is_new ? report_.failures.emplace_back() : report_.failures[at->second];
    ++failure.count;
    const GatePhase phase = report_.phases.back().phase;
    if (!is_new &&
        (violation.excess <= failure.excess || (failure.in_case() && phase > GatePhase::corpus_laws)))
      return;
    failure.method = name;
    failure.law = found.law;
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
  }

  /// `again`: the pairs were counted before, so only their hangs are added.
  void count(const std::vector<AnswerCounts>& counts, bool again = false) {
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      AnswerCounts more = counts[m];
      if (again) more.asked = more.declined = more.failed = 0, more.said = {};
      report_.methods[m].counts += more;
      skipped_[m] = skipped_[m] || given_up(m) || counts[m].hangs >= options_.caps.hangs ||
                    (is_program(m) && counts[m].crashes >= options_.caps.program_crashes);
    }
  }

  void count_undecided(const Examined& examined) {
    report_.undecided_truths +=
        static_cast<std::uint64_t>(std::ranges::count(examined.truths, Verdict::undecided));
  }

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

  /// Checks the laws of the answer itself, and in the second phase all others.
  void replay_cases(GatePhase phase, std::uint64_t wanted) {
    const bool at_first = phase == GatePhase::corpus;
    const std::size_t due = std::min<std::uint64_t>(wanted, cases_.size());
    in_phase(phase, [&] {
      for (std::size_t first = 0; goes_on(first, due, "cases"); first += cases_at_once) {
        std::vector<Pair> pairs;
        for (const Case& c : cases_.subspan(first, std::min(cases_at_once, due - first)))
          pairs.push_back(c.pair);
        const Examined examined =
            examine_all(pairs, [&](std::size_t, const Law& law) { return is_of_answer(law) == at_first; });
        count(examined.counts, !at_first);
        if (at_first) {
          count_undecided(examined);
          for (const Pair& pair : pairs) report_.cases.push_back(digest_of(pair, fnv1a({})));
        }
        for (const LawViolation& b : examined.violations) {
          const Case& c = cases_[first + b.pair];
          record(b, c.pair, fmt::format("{}:{} {}", c.file, c.line, c.id));
        }
        show_progress(pairs, part(first + pairs.size(), due));
      }
    });
  }

  static double part(std::uint64_t done, std::uint64_t due) {
    return static_cast<double>(done) / static_cast<double>(due);
  }

  using Draw = SampleRound(std::uint64_t seed, std::uint64_t round);

  void check_laws(GatePhase phase, Draw* draw, std::uint64_t due) {
    check_rounds(
        phase, draw, due, [](auto...) { return true; }, [](auto&...) {});
  }

  /// Checks the laws that need no further question. The law of the distance is checked in one round of
  /// `distances`.
  void sample(GatePhase phase, Draw* draw, std::uint64_t due, std::uint64_t distances) {
    const LawFilter wanted = [&](std::size_t, const Law& law) {
      return is_of_answer(law) && law.queries == needs_none &&
             (report_.phases.back().rounds % distances == 0 || law.number != distance_law);
    };
    check_rounds(phase, draw, due, wanted, [&](const SampleRound& drawn, const Examined& examined) {
      const std::vector<bool> none(drawn.pairs.size(), false);
      std::vector<RoundAnswers> said(methods_.size(), RoundAnswers{{}, examined.truths, none, none});
      for (std::size_t i = 0; i < examined.answers.size(); ++i)
        said[i % methods_.size()].answers.push_back(examined.answers[i]);
      for (const LawViolation& b : examined.violations) {
        if (b.law->number != verdict_law) continue;  // a failed answer has no verdict
        said[b.method].wrong[b.pair] = true;
        if (b.violation.severity == Severity::contract) said[b.method].wrong_beyond[b.pair] = true;
      }
      for (std::size_t m = 0; m < methods_.size(); ++m) count_cells(report_.methods[m], drawn, said[m]);
      count_undecided(examined);
    });
  }

  /// Draws rounds, and checks the laws of `wanted`. `count_more` gets each round and what was found.
  void check_rounds(GatePhase phase, Draw* draw, std::uint64_t due, const LawFilter& wanted,
                    auto count_more) {
    in_phase(phase, [&] {
      for (std::uint64_t& round = report_.phases.back().rounds; goes_on(round, due, "rounds");) {
        SampleRound drawn = draw(options_.seed, round);
        keep_supported(drawn, methods_, solids_.sizes);
        const Examined examined = examine_all(drawn.pairs, wanted);
        count(examined.counts);
        for (const LawViolation& b : examined.violations)
          record(b, drawn.pairs[b.pair], drawn.origins[b.pair],
                 drawn.strata.empty() ? std::nullopt : std::optional(drawn.strata[b.pair]));
        count_more(drawn, examined);
        show_progress(drawn.pairs, part(++round, due));
      }
    });
  }

  std::span<const std::unique_ptr<Method>> method_of(const GateFailure& failure) const {
    return {&find_method(methods_, failure.method), 1};
  }

  static LawFilter law_of(const GateFailure& failure) {
    return [&](std::size_t, const Law& law) { return law.number == failure.law->number; };
  }

  /// Returns which of the pairs break the law of `failure` in the same way.
  std::vector<bool> fails_again(const GateFailure& failure, std::span<const Pair> pairs, Asker& asker) {
    std::vector<bool> fails(pairs.size(), false);
    const Examined examined = examine(method_of(failure), pairs, law_of(failure), asker);
    const AnswerCounts& counts = examined.counts[0];
    const std::uint64_t crash_cost = method_of(failure)[0]->is_out_of_process() ? program_crash_cost : 0;
    questions_left_ -=
        std::min(questions_left_, pairs.size() + hang_cost * counts.hangs + crash_cost * counts.crashes);
    for (const LawViolation& b : examined.violations)
      fails[b.pair] =
          b.violation.severity == failure.severity && violation_kind(*b.law, b.violation) == failure.kind;
    return fails;
  }

  /// Returns what breaks on the simplest pair, in words.
  std::string what_breaks(const GateFailure& failure) const {
    const Examined examined =
        examine(method_of(failure), {&failure.simplest, 1}, law_of(failure), options_.caps);
    return examined.violations.empty() ? "" : examined.violations.front().violation.what;
  }

  // Starts when all failures are found, so that these do not depend on the shrinking. The first failure of
  // each law and kind comes first, because the others are like it.
  void simplify_failures() {
    std::set<std::tuple<std::string, int, std::string>> seen;
    std::vector<GateFailure*> in_order, duplicates;
    for (GateFailure& failure : report_.failures) {
      if (!is_error(failure)) continue;
      std::tuple way(failure.method, failure.law->number, failure.kind);
      if (failure.failed)  // one crash is one way to fail, under any law
        way = {failure.method, 0, to_string(*failure.failed) + (": " + failure.reason)};
      (seen.insert(way).second ? in_order : duplicates).push_back(&failure);
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
      Asker asker(method_of(failure), options_.caps);  // a worker that knows nothing else
      failure.failed_again += fails_again(failure, {&failure.found, 1}, asker)[0];
    }
    if (failure.failed_again < rerun_count) return;  // a failure that comes and goes cannot be shrunk
    // Keeps the feature in contact. Otherwise every failure would shrink to points.
    const auto feature = contact_feature(failure.found);
    Asker asker(method_of(failure),
                options_.caps);  // for all questions: starting a worker costs more than asking 32 pairs
    const StillFails still_fails = [&](std::span<const Pair> pairs) {
      if (questions_left_ == 0 || out_of_time()) return std::vector<bool>(pairs.size(), false);
      std::vector<bool> fails = fails_again(failure, pairs, asker);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        fails[i] = fails[i] && contact_feature(pairs[i]) == feature;
      return fails;
    };
    failure.simplest = simplify(failure.found, still_fails, simplify_cap).pair;
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

}  // namespace cyl
