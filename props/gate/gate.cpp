// SPDX-License-Identifier: MIT
#include "props/gate/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "corpus/pairs/strata.hpp"
#include "oracles/trial/bucket.hpp"
#include "oracles/trial/contact.hpp"
#include "props/gate/law_search.hpp"
#include "props/shrink/simplify.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Cases asked together.
constexpr std::size_t cases_at_once = 32;
/// Draws of one round of the hunt: as often the clock is looked at.
constexpr int draws_per_round = 4;
/// Pairs of one cell in one round of the sample.
constexpr std::uint64_t pairs_per_cell = 4;
/// Enclosing a distance takes a hundred times as long as proving a verdict: that law is held in one round of
/// so many.
constexpr std::uint64_t distance_share = 8;
constexpr int distance_law = 33;

/// How often a failing case is run again.
constexpr unsigned rerun_count = 10;
/// Questions of the shrinker about one failure. Beyond them it stays as simple as it is.
constexpr std::size_t simplify_cap = 1200;

/// Shares of the budget, the corpus not counted: what is left is for shrinking and running again.
constexpr double laws_share = 0.4, sample_share = 0.4;

/// Of the budget: a method that has hung longer is not asked any more.
constexpr double hang_share = 0.25;

/// Where so many pairs got the same answer, it is no answer.
constexpr std::uint64_t enough_to_remark = 100;

/// On more than half of what it is asked: it passes no gate for what it does not say.
bool abstains(const AnswerCounts& counts) {
  const auto silent = counts.declined + counts.said[static_cast<std::size_t>(Verdict::undecided)];
  return counts.asked == 0 || 2 * silent > counts.asked;
}

bool of_the_answer(const Law& law) { return law.kind == LawKind::answer; }

/// "wrong_disjoint" of a refuted verdict, "crash" of a failure, else the law's name.
std::string kind_of_break(const Law& law, const Broken& broken) {
  if (law.number != answer_law && law.number != verdict_law) return std::string(law.name);
  return broken.what.substr(0, broken.what.find_first_of(",:"));
}

std::optional<ContactFeature> feature_of(const Pair& pair) { return contact_feature(pair, judge(pair)); }

/// Where a pair stands, by its construction.
struct Stratum {
  ContactFeature feature;
  int decade;
};

/// Relative: 10^-13 computed, and a claim rounded up, are still 1e-13.
constexpr double claim_rounding_error = 0x1p-48;

/// Whether every pair of this size and decade of margin is beyond the claim.
bool claims(const Claim& claim, double size, int decade) {
  return std::pow(10.0, -decade - 1) * size * (1 + claim_rounding_error) >= reach(claim, size);
}

class Gate {
 public:
  Gate(std::span<const std::unique_ptr<Method>> methods, std::span<const Case> cases,
       const GateOptions& options, const std::function<void(const GateProgress&)>& on_progress)
      : methods_(methods), cases_(cases), options_(options), on_progress_(on_progress), start_(Clock::now()) {
    report_.seed = options.seed;
    report_.budget = options.budget;
    for (const auto& method : methods) {
      GateMethod& m = report_.methods.emplace_back();
      m.name = method->name();
      m.version = method->version();
      m.claim = method->claim();
      for (const std::string_view feature : contact_features())
        for (int decade = first_decade; decade <= last_decade; ++decade)
          m.cells.push_back({feature, decade, true});
    }
  }

  GateReport run() {
    in_phase(GatePhase::corpus, [&] {
      replay_cases([](std::size_t, const Law& law) { return of_the_answer(law); }, Clock::time_point::max());
    });
    in_phase(GatePhase::corpus_laws, [&] {
      const auto changed = [](std::size_t, const Law& law) { return !of_the_answer(law); };
      if (options_.amount)
        replay_cases(changed, Clock::time_point::max(),
                     options_.amount->cases_under_laws.value_or(cases_.size()));
      else
        replay_cases(changed, start_ + options_.budget / 2);
    });
    const milliseconds left = std::max(options_.budget - elapsed(), options_.budget / 4);
    const auto share = [&](double part) {
      return Clock::now() + std::chrono::duration_cast<milliseconds>(part * left);
    };
    in_phase(GatePhase::laws, [&] { hunt_until(share(laws_share)); });
    in_phase(GatePhase::sample, [&] { sample_until(share(sample_share)); });
    // Failures wait for both, so that what is found does not depend on how long they take to shrink. The
    // first of each law and kind first: the others are like it.
    const Clock::time_point end = share(1 - laws_share - sample_share);
    std::set<std::tuple<std::string, int, std::string>> seen;
    std::vector<GateFailure*> like_others;
    for (GateFailure& failure : report_.failures) {
      if (failure.severity != Severity::contract) continue;
      if (seen.emplace(failure.method, failure.law->number, failure.kind).second)
        look_closer(failure, end);
      else
        like_others.push_back(&failure);
    }
    for (GateFailure* failure : like_others)
      if (Clock::now() < end) look_closer(*failure, end);
    for (std::size_t m = 0; m < methods_.size(); ++m)
      report_.methods[m].remark =
          asleep(m) ? "hangs, and was not asked to the end" : remark_on(report_.methods[m].counts);
    return std::move(report_);
  }

 private:
  milliseconds elapsed() const { return std::chrono::duration_cast<milliseconds>(Clock::now() - start_); }

  template <class Work>
  void in_phase(GatePhase phase, Work work) {
    const auto from = Clock::now();
    report_.phases.push_back({phase});
    work();
    report_.phases.back().time = std::chrono::duration_cast<milliseconds>(Clock::now() - from);
  }

  void show_progress(std::size_t pairs) {
    GatePhaseReport& now = report_.phases.back();
    now.pairs += pairs;
    if (!on_progress_) return;
    const auto beyond = std::count_if(report_.failures.begin(), report_.failures.end(),
                                      [](const auto& f) { return f.severity == Severity::contract; });
    on_progress_({now.phase, now.pairs, static_cast<std::size_t>(beyond), elapsed()});
  }

  /// A break joins those of the same law and bucket.
  void note(std::size_t method, const Law& law, const Broken& broken, const Pair& pair,
            const std::string& origin, const std::string& reproduce = {},
            const std::optional<Stratum>& stratum = {}) {
    std::string kind = kind_of_break(law, broken);
    const std::string& name = report_.methods[method].name;
    const bool contract = broken.severity == Severity::contract;
    std::string bucket = stratum ? bucket_key(name, kind, stratum->feature,
                                              coordinate_of(pair, std::pow(10.0, -stratum->decade - 0.5)))
                                 : bucket_of(name, kind, pair);
    if (contract) broken_.emplace(method, law.number, kind);
    const auto [at, is_new] =
        by_bucket_.try_emplace(std::tuple(law.number, bucket, contract), report_.failures.size());
    if (!is_new) {
      ++report_.failures[at->second].count;
      return;
    }
    GateFailure& failure = report_.failures.emplace_back();
    failure.method = name;
    failure.law = &law;
    failure.kind = std::move(kind);
    failure.bucket = std::move(bucket);
    failure.what = broken.what;
    failure.severity = broken.severity;
    failure.phase = report_.phases.back().phase;
    failure.origin = origin;
    failure.found = failure.simplest = pair;
    failure.count = 1;
    failure.reproduce = reproduce;
  }

  void count(const std::vector<AnswerCounts>& counts) {
    for (std::size_t m = 0; m < methods_.size(); ++m) report_.methods[m].counts += counts[m];
  }

  /// A method that has used up its time hanging is not asked any more: the gate is to end.
  bool asleep(std::size_t m) const {
    return report_.methods[m].counts.hung_seconds >
           hang_share * 1e-3 * static_cast<double>(options_.budget.count());
  }
  Examined examine_awake(std::span<const Pair> pairs, const Wanted& wanted) const {
    return examine(
        methods_, pairs, [&](std::size_t m, const Law& law) { return !asleep(m) && wanted(m, law); },
        options_.caps);
  }

  void replay_cases(const Wanted& wanted, Clock::time_point end,
                    std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
    for (std::size_t first = 0; first < std::min<std::uint64_t>(most, cases_.size()) && Clock::now() < end;
         first += cases_at_once) {
      std::vector<Pair> pairs;
      for (const Case& c : cases_.subspan(first, std::min(cases_at_once, cases_.size() - first)))
        pairs.push_back(c.pair);
      const Examined examined = examine_awake(pairs, wanted);
      if (report_.phases.back().phase == GatePhase::corpus) {
        count(examined.counts);
        report_.undecided_truths += static_cast<std::uint64_t>(
            std::count(examined.truths.begin(), examined.truths.end(), Verdict::undecided));
      }
      for (const BrokenLaw& b : examined.broken) {
        const Case& c = cases_[first + b.pair];
        note(b.method, *b.law, b.broken, c.pair, fmt::format("{}:{} {}", c.file, c.line, c.id));
      }
      show_progress(pairs.size());
    }
  }

  /// Whether a phase goes on: by the clock, or by the rounds that are to be drawn.
  bool goes_on(std::uint64_t round, Clock::time_point end, std::uint64_t GateAmount::*rounds) {
    report_.phases.back().rounds = round;
    return options_.amount ? round < *options_.amount.*rounds : Clock::now() < end;
  }

  void hunt_until(Clock::time_point end) {
    const Wanted all = [&](std::size_t m, const Law&) { return !asleep(m); };
    const IsNews is_news = [&](const Catch& c) {
      return !broken_.contains(std::tuple(c.method, c.law->number, kind_of_break(*c.law, c.broken)));
    };
    for (std::uint64_t round = 0; goes_on(round, end, &GateAmount::law_rounds); ++round) {
      // Each round has a seed of its own; neighbouring ones of RapidCheck's generator are unrelated.
      const HuntRound found =
          hunt(methods_, all, is_news, options_.seed + round, draws_per_round, options_.caps);
      count(found.counts);
      std::size_t pairs = 0;
      for (const auto& [kind, n] : found.drawn) {
        report_.drawn[kind] += n;
        pairs += n;
      }
      for (const Catch& c : found.caught)
        note(c.method, *c.law, c.broken, c.pair, c.from + fmt::format(", seed {}", options_.seed + round),
             c.reproduce);
      show_progress(pairs);
    }
  }

  struct Drawn {
    std::size_t cell;
    std::uint64_t index;
    Stratum stratum;
  };

  void sample_until(Clock::time_point end) {
    for (std::uint64_t round = 0; goes_on(round, end, &GateAmount::sample_rounds); ++round) {
      std::vector<Pair> pairs;
      std::vector<Drawn> drawn;
      std::size_t cell = 0;
      for (std::size_t feature = 0; feature < contact_feature_count; ++feature) {
        for (int decade = first_decade; decade <= last_decade; ++decade, ++cell) {
          for (std::uint64_t i = 0; i < pairs_per_cell; ++i) {
            const std::uint64_t index = round * pairs_per_cell + i;
            if (const auto pair =
                    draw_in_stratum(static_cast<ContactFeature>(feature), decade, options_.seed, index)) {
              pairs.push_back(*pair);
              drawn.push_back({cell, index, {static_cast<ContactFeature>(feature), decade}});
            }
          }
        }
      }
      const bool distances = round % distance_share == 0;
      const Wanted wanted = [&](std::size_t, const Law& law) {
        return of_the_answer(law) && law.ask == needs_none && (distances || law.number != distance_law);
      };
      const Examined examined = examine_awake(pairs, wanted);
      count(examined.counts);
      for (std::size_t m = 0; m < methods_.size(); ++m) {
        for (std::size_t p = 0; p < pairs.size(); ++p) {
          GateCell& at = report_.methods[m].cells[drawn[p].cell];
          const MethodAnswer& answer = examined.answers[p * methods_.size() + m];
          if (!claims(methods_[m]->claim(), size_of(pairs[p]), at.decade)) at.claimed = false;
          if (answer.status == Status::declined) continue;
          if (answer.status == Status::answered && answer.verdict == Verdict::undecided)
            ++at.undecided;
          else if (examined.truths[p] != Verdict::undecided)
            ++at.pairs;
        }
      }
      std::set<std::pair<std::size_t, std::size_t>> wrong;  // one pair may break several laws
      for (const BrokenLaw& b : examined.broken) {
        const GateCell& at = report_.methods[b.method].cells[drawn[b.pair].cell];
        if (b.law->number <= verdict_law) wrong.emplace(b.method, b.pair);
        note(b.method, *b.law, b.broken, pairs[b.pair],
             fmt::format("{} 1e-{:02}, seed {}, index {}", at.feature, at.decade, options_.seed,
                         drawn[b.pair].index),
             {}, drawn[b.pair].stratum);
      }
      for (const auto& [m, p] : wrong) ++report_.methods[m].cells[drawn[p].cell].wrong;
      report_.undecided_truths += static_cast<std::uint64_t>(
          std::count(examined.truths.begin(), examined.truths.end(), Verdict::undecided));
      show_progress(pairs.size());
    }
  }

  /// Which of the pairs break the law of `failure` in its way.
  std::vector<bool> still_broken(const GateFailure& failure, std::span<const Pair> pairs) {
    const auto method = std::find_if(methods_.begin(), methods_.end(),
                                     [&](const auto& m) { return m->name() == failure.method; });
    const Wanted this_law = [&](std::size_t, const Law& law) { return law.number == failure.law->number; };
    std::vector<bool> broken(pairs.size(), false);
    for (const BrokenLaw& b : examine({&*method, 1}, pairs, this_law, options_.caps).broken)
      broken[b.pair] =
          b.broken.severity == failure.severity && kind_of_break(*b.law, b.broken) == failure.kind;
    return broken;
  }

  void look_closer(GateFailure& failure, Clock::time_point end) {
    for (; failure.reruns < rerun_count; ++failure.reruns)
      failure.failed_again += still_broken(failure, {&failure.found, 1})[0];
    if (failure.failed_again < failure.reruns) return;  // what comes and goes cannot be shrunk
    // What meets stays: else all becomes a matter of points.
    const auto feature = feature_of(failure.found);
    const StillFails still_fails = [&](std::span<const Pair> pairs) {
      if (Clock::now() >= end) return std::vector<bool>(pairs.size(), false);
      std::vector<bool> broken = still_broken(failure, pairs);
      for (std::size_t i = 0; i < pairs.size(); ++i) broken[i] = broken[i] && feature_of(pairs[i]) == feature;
      return broken;
    };
    failure.simplest = simplify(failure.found, still_fails, simplify_cap).pair;
  }

  static std::string remark_on(const AnswerCounts& counts) {
    if (counts.asked < enough_to_remark) return {};
    const auto said = [&](Verdict v) { return counts.said[static_cast<std::size_t>(v)]; };
    if (counts.failed == counts.asked) return "fails on every pair";
    const std::uint64_t silent = counts.declined + said(Verdict::undecided);
    if (silent == counts.asked) return "abstains on every pair";
    if (abstains(counts)) return fmt::format("abstains on {} of {} pairs", silent, counts.asked);
    for (const Verdict v : {Verdict::disjoint, Verdict::intersecting, Verdict::touching, Verdict::invalid})
      if (said(v) + counts.declined + counts.failed == counts.asked)
        return fmt::format("answers {} to every pair", to_string(v));
    return {};
  }

  std::span<const std::unique_ptr<Method>> methods_;
  std::span<const Case> cases_;
  const GateOptions& options_;
  const std::function<void(const GateProgress&)>& on_progress_;
  const Clock::time_point start_;
  GateReport report_;
  std::map<std::tuple<int, std::string, bool>, std::size_t> by_bucket_;  ///< to failures
  std::set<std::tuple<std::size_t, int, std::string>> broken_;  ///< method, law and kind: contracts broken
};

}  // namespace

GateReport run_gate(std::span<const std::unique_ptr<Method>> methods, std::span<const Case> cases,
                    const GateOptions& options, const std::function<void(const GateProgress&)>& on_progress) {
  return Gate(methods, cases, options, on_progress).run();
}

// Where `wrong` of n were wrong, the greatest rate p at which so few are seen with a probability of 5 %: of
// Poisson's law, which bounds the binomial one there. None wrong: e^(-np) = 0.05, np = 3.0.
double error_rate_bound(std::uint64_t pairs, std::uint64_t wrong) {
  if (pairs == 0) return 1;
  const auto seen_at_most = [&](double mean) {
    double term = std::exp(-mean), sum = term;
    for (std::uint64_t k = 1; k <= wrong; ++k) sum += term *= mean / static_cast<double>(k);
    return sum;
  };
  constexpr double level = 0.05;
  const double k = static_cast<double>(wrong), n = static_cast<double>(pairs);
  if (wrong == 0) return std::min(1.0, 3 / n);
  if (wrong > 200) return std::min(1.0, (k + 1.645 * std::sqrt(k) + 1.5) / n);  // where e^-mean would vanish
  double low = k, high = 2 * k + 10;
  for (int i = 0; i < 60; ++i) (seen_at_most((low + high) / 2) > level ? low : high) = (low + high) / 2;
  return std::min(1.0, high / n);
}

int exit_code(const GateReport& report) {
  for (const GateFailure& failure : report.failures)
    if (failure.severity == Severity::contract && !failure.known) return 2;
  const auto unsampled = [](const GatePhaseReport& p) {
    return p.phase == GatePhase::sample && p.pairs == 0;
  };
  const bool undecided = report.undecided_truths > 0 ||
                         std::any_of(report.phases.begin(), report.phases.end(), unsampled) ||
                         std::any_of(report.methods.begin(), report.methods.end(),
                                     [](const GateMethod& m) { return abstains(m.counts); });
  return undecided ? 3 : 0;
}

const char* to_string(GatePhase phase) noexcept {
  switch (phase) {
    case GatePhase::corpus:
      return "corpus";
    case GatePhase::corpus_laws:
      return "laws on the corpus";
    case GatePhase::laws:
      return "laws on drawn pairs";
    case GatePhase::sample:
      return "sample of all strata";
  }
  return "corpus";
}

}  // namespace cyl
