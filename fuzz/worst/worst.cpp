// SPDX-License-Identifier: MIT
#include "fuzz/worst/worst.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <limits>
#include <utility>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/strata.hpp"
#include "fuzz/guided/mutator.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/shown_distance.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;

/// The value of a shape on which nothing is wrong.
constexpr double nothing_wrong = -1000;
/// Added to the value of what is beyond the claim, so that it is above all that is within.
constexpr double beyond = 100;
/// Improvements below this many decades are not proved.
constexpr double gain_tol = 1e-4;

/// Margins asked about: 1e-15 to 10 apart, to 1 into each other.
constexpr int margins_per_decade = 4, decades_down = 15, decades_up = 1;
/// Parts into which the step from the last margin that is wrong to the next is cut, again and again.
constexpr int parts = 16, cuts = 2;

/// A search ends after so many crashes, or hangs of a second each: it has found its worst.
constexpr unsigned crash_cap = 64, hang_cap = 3;

/// A call is timed this often, and its least time counts. Calls that take too long are timed less often.
constexpr int timed_calls = 3;
constexpr double repeat_ns_cap = 1e8;
constexpr int clock_looks = 8;

/// Enclosures are asked to this part of the margin, and to no less than doubles give.
constexpr double enclosure_part = 1e-4, enclosure_least = 1e-18, enclosure_most = 1e-6;

/// The relative width of enclosures of depths for `error`, a part of the error that a claim allows.
constexpr double error_width = 1e-14;

/// Evaluations of one walk. Walks of this length from several places find more than longer ones.
constexpr int walk_cap = 250;
/// Changes in a coordinate below which a walk is over.
constexpr double walk_step_tol = 1e-5;
/// Mutations of the worst pair. The next walk may start from the worst of them.
constexpr int mutations = 12;
/// Part of the budget that looking at the starts may take.
constexpr double starts_part = 0.25;

int rank(Failure failure) {
  return failure == Failure::crash ? 3 : failure == Failure::hang ? 2 : failure == Failure::none ? 0 : 1;
}

/// Answers with the time of a call as the distance.
class Timed final : public Method {
 public:
  Timed(Method& method, double (*clock)()) : Method(method.name_parts()), method_(method), clock_(clock) {}
  std::string_view version() const override { return method_.version(); }
  Claim claim() const override { return method_.claim(); }
  bool supports(SolidKind kind) const override { return method_.supports(kind); }
  MethodAnswer answer(const Pair& pair) override {
    double reading = std::numeric_limits<double>::infinity();
    for (int i = 0; i < clock_looks; ++i) {
      const double start = clock_();
      reading = std::min(reading, clock_() - start);
    }
    double least = std::numeric_limits<double>::infinity(), all = 0;
    MethodAnswer answer;
    for (int i = 0; i < timed_calls && all < repeat_ns_cap; ++i) {
      const double start = clock_();
      answer = method_.ask(pair);
      const double ns = clock_() - start;
      least = std::min(least, ns);
      all += ns;
    }
    answer.has_distance = true;
    answer.distance = std::max(0.0, least - reading);
    answer.witness = CertificateKind::none;
    return answer;
  }

 private:
  Method& method_;
  double (*clock_)();
};

/// A shape: the solids touching, and the direction in which b moves away from a. Apart, the margin along it
/// is the distance; into each other it is no less than the depth.
struct Ray {
  Pair touching;
  Vector3 direction;
  double size;

  Pair at(double margin) const {
    Pair p = touching;
    p.b.center += margin * size * direction;
    return p;
  }
};

/// One slide may not quite touch, so there are two.
std::optional<Ray> ray_of(const Pair& pair) {
  Ray ray{pair, {0, 0, 0}, size_of(pair)};
  for (int i = 0; i < 2; ++i) {
    const MeasuredDistance d = approximate_distance(ray.touching);
    if (!(d.direction.norm() > 0.5)) return {};
    ray.direction = d.direction;
    ray.touching.b.center -= d.value * d.direction;
  }
  return ray;
}

/// Returns the least and the greatest error of the distance over its bound. For a depth, the bound limits
/// how much deeper the solids are. No direction shows how much less deep they are, so the claim limits that.
Enclosure error_over_bound(Trial& trial, const Claim& claim, const MethodAnswer& answer, bool by_referee) {
  if (!trial.decided() || answer.verdict == Verdict::invalid) return {0, 0};
  const double said = answer.distance, most = allowed_error(claim, trial.pair);
  Enclosure real = shown_distance(trial.pair, measure_with_points(trial.pair));
  if (trial.truth.verdict == Verdict::touching)
    real = {0, 0};
  else if (trial.meets() || by_referee) {
    const Enclosure proved = trial.distance_at(error_width);
    real = {std::max(real.lo, proved.lo), std::min(real.hi, proved.hi)};
  }
  if (answer.error_bound == 0)
    return {std::max({0.0, real.lo - said, said - real.hi}) / most,
            std::max(real.hi - said, said - real.lo) / most};
  const double deeper_stated = said > 0 ? 0 : std::max(0.0, real.lo - said) / most;
  const Enclosure error = error_bound_of(real, answer);
  return {std::max(deeper_stated, error.lo / answer.error_bound),
          std::max(deeper_stated, error.hi / answer.error_bound)};
}

/// How bad the method is on a shape, and the pair on its ray on which it is.
struct Evaluation {
  double value = nothing_wrong;
  Pair pair{};
};

struct Score {
  double value = 0;
  bool beyond = false;
};

/// Measures how bad the method is on one shape after the other, and walks from the worst. For a shape, the
/// solids are moved until they touch, and the method is asked about pairs along the direction in which they
/// separate. The solver's estimate guides the search, and kept pairs are proved.
class WorstSearch {
 public:
  WorstSearch(const std::unique_ptr<Method>& method, const Sought& sought, const WorstOptions& options,
              const OnWorst& on_worst)
      : method_(method), sought_(sought), options_(options), on_worst_(on_worst), claim_(method->claim()) {
    if (options.objective == Objective::time) timed_ = std::make_unique<Timed>(*method, options.clock);
  }

  Worst run(std::span<const Pair> starts) {
    evaluate_starts(starts);
    RandomStream stream("worst", options_.seed, 0);
    for (std::size_t round = 0; !starts.empty() && !over(); ++round) {
      if (candidates_.empty())
        try_start(mutate(starts[stream.below(starts.size())], stream.bits()));
      else
        walk(next_start(round, stream), stream);
    }
    return std::move(worst_);
  }

 private:
  struct Probe {
    Pair pair;
    double margin;  ///< signed, along the ray
    MethodAnswer answer{};
  };

  std::chrono::milliseconds elapsed() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - began_);
  }
  bool over() const {
    return worst_.evaluations >= options_.evaluation_cap || elapsed() >= options_.budget ||
           breaks_ >= crash_cap;
  }

  /// Starts that already have the wanted features go first.
  void evaluate_starts(std::span<const Pair> starts) {
    for (const bool of_it : {true, false}) {
      for (const Pair& start : starts) {
        if (over() ||
            static_cast<double>(worst_.evaluations) >=
                starts_part * static_cast<double>(options_.evaluation_cap) ||
            elapsed() >= starts_part * options_.budget)
          break;
        if (likely_sought(start, approximate_distance(start)) == of_it) try_start(start);
      }
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Evaluation& x, const Evaluation& y) { return x.value > y.value; });
  }

  void try_start(const Pair& start) {
    const std::optional<Pair> pair = bring_into(options_.domain, start);
    if (!pair) {
      ++worst_.evaluations;
      return;
    }
    const Evaluation found = evaluate(*pair);
    if (found.value > nothing_wrong) candidates_.push_back(found);
  }

  /// Returns the start of the next walk: the worst pair, the next of the starts, or the worst of some
  /// mutations of the worst pair.
  Pair next_start(std::size_t round, RandomStream& stream) {
    const Pair& worst = best_.value > nothing_wrong ? best_.pair : candidates_.front().pair;
    if (round % 3 == 0) return worst;
    if (round % 3 == 1) return candidates_[round / 3 % candidates_.size()].pair;
    Evaluation kept{nothing_wrong, worst};
    for (int i = 0; i < mutations && !over(); ++i) {
      const std::optional<Pair> pair = bring_into(options_.domain, mutate(worst, stream.bits()));
      if (!pair) continue;
      const Evaluation found = evaluate(*pair);
      if (found.value > kept.value) kept = found;
    }
    return kept.pair;
  }

  // NLopt's status codes do not matter, because finds are noted on the way. The sizes of the first steps are
  // drawn, or two walks from one place would be the same.
  void walk(const Pair& from, RandomStream& stream) {
    Walk w{*this, PairChart(from, sought_.feature, options_.domain), nullptr, nullptr};
    w.optimizer = nlopt_create(NLOPT_LN_SBPLX, PairChart::dimensions);
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> owner(w.optimizer, nlopt_destroy);
    nlopt_set_max_objective(w.optimizer, objective, &w);
    nlopt_set_lower_bounds(w.optimizer, w.chart.low().data());
    nlopt_set_upper_bounds(w.optimizer, w.chart.high().data());
    PairChart::Point steps = w.chart.step();
    const double common = std::pow(10, stream.between(-2, 0.3));
    for (double& step : steps) step *= common * stream.between(0.2, 1);
    nlopt_set_initial_step(w.optimizer, steps.data());
    nlopt_set_xtol_abs1(w.optimizer, walk_step_tol);
    nlopt_set_maxeval(w.optimizer, walk_cap);
    PairChart::Point x{};
    double value = 0;
    const std::size_t before = worst_.evaluations;
    nlopt_optimize(w.optimizer, x.data(), &value);
    if (worst_.evaluations == before) ++worst_.evaluations;  // a walk that does not begin must end too
    if (w.thrown) std::rethrow_exception(w.thrown);
  }

  struct Walk {
    WorstSearch& search;
    PairChart chart;
    nlopt_opt optimizer;
    std::exception_ptr thrown;
  };

  static double objective(unsigned, const double* x, double*, void* data) {
    Walk& w = *static_cast<Walk*>(data);
    const unsigned breaks = w.search.breaks_;
    double value = nothing_wrong;
    try {
      const Pair pair =
          w.chart.pair(std::span<const double, PairChart::dimensions>(x, PairChart::dimensions));
      value = w.search.evaluate(pair).value;
    } catch (...) {
      w.thrown = std::current_exception();
    }
    if (w.thrown || w.search.over() || w.search.breaks_ > breaks) nlopt_force_stop(w.optimizer);
    return value;
  }

  /// Asks about a shape, and keeps in worst_ what is worse than all before. A shape on which something breaks
  /// counts for nothing: it is not walked from.
  Evaluation evaluate(const Pair& pair) {
    ++worst_.evaluations;
    if (on_worst_) on_worst_(worst_, elapsed());
    const std::optional<Ray> ray = ray_of(pair);
    if (!ray || !is_in(options_.domain, pair) || !is_in(options_.domain, ray->touching)) return {};
    const unsigned breaks = breaks_;
    const Evaluation found = worst_on(pair, *ray);
    if (breaks_ > breaks) return {};
    if (found.value > best_.value) best_ = found;
    return found;
  }

  /// Asks about the pair itself and about others of its ray, and returns all of them.
  std::vector<Probe> ask_along(const Pair& pair, const Ray& ray, int per_decade) {
    std::vector<Probe> probes{{pair, approximate_distance(pair).value / ray.size}};
    for (int i = per_decade * decades_up; i >= -per_decade * decades_down; --i) {
      const double margin = std::pow(10, static_cast<double>(i) / per_decade);
      probes.push_back({ray.at(margin), margin});
      if (margin <= 1) probes.push_back({ray.at(-margin), -margin});
    }
    ask(probes);
    return probes;
  }

  /// Stops at the first hang and notes what fails.
  void ask(std::vector<Probe>& probes) {
    std::vector<Pair> pairs;
    std::vector<Question> questions;
    for (const Probe& probe : probes) {
      questions.push_back({0, pairs.size()});
      pairs.push_back(probe.pair);
    }
    const std::unique_ptr<Method>& asked = timed_ ? timed_ : method_;
    worst_.questions += probes.size();
    if (!method_->foreign()) {
      for (Probe& probe : probes) probe.answer = asked->ask(probe.pair);
      return;
    }
    if (!asker_) {
      Caps caps;
      caps.hangs = 1;
      asker_.emplace(std::span(&asked, 1), caps);
    }
    const auto said = asker_->ask(pairs, questions);
    for (std::size_t i = 0; i < said.size(); ++i) {
      probes[i].answer = said[i].answer;
      if (said[i].answer.status == Status::failed) note_failure(probes[i]);
    }
  }

  void note_failure(const Probe& probe) {
    const Failure failure = probe.answer.failure;
    if (failure == Failure::crash) ++breaks_;
    if (failure == Failure::hang) breaks_ += crash_cap / hang_cap + 1;
    if (worst_.failed && rank(failure) <= rank(worst_.failed->failure)) return;
    if (!likely_sought(probe.pair, approximate_distance(probe.pair))) return;
    if (sought_.also && !sought_.also(probe.pair)) return;
    worst_.failed = FailedPair{probe.pair, failure, probe.answer.reason};
  }

  /// Returns whether the wanted features meet, approximately. That is fast, and proved later if it matters.
  bool likely_sought(const Pair& pair, const MeasuredDistance& d) const {
    if (!sought_.feature) return true;
    if (d.direction.isZero(0)) return false;
    return feature_at(pair, d.value < 0, d.direction) == *sought_.feature;
  }

  /// For the optimiser: beyond the claim by the margin, else by the part of the claim that is used.
  double value_of(double margin, double size) const {
    const double gap = margin * size, claimed = reach(claim_, size);
    return gap >= claimed ? beyond + std::log10(margin) : std::log10(gap / claimed);
  }

  /// The value by the approximate distance, which is fast.
  double likely_value(const Probe& probe) const {
    if (probe.answer.status != Status::answered) return nothing_wrong;
    if (options_.objective != Objective::margin) {
      const double score = score_of(probe, false).value;
      const bool counts = score > 0 && likely_sought(probe.pair, approximate_distance(probe.pair));
      return counts ? std::log10(score) : nothing_wrong;
    }
    const Verdict said = probe.answer.verdict;
    const bool wrong = probe.margin < 0 ? said == Verdict::disjoint
                                        : said == Verdict::intersecting || said == Verdict::touching;
    if (!wrong || (sought_.kind && (*sought_.kind == FindingKind::wrong_intersecting) != (probe.margin > 0)))
      return nothing_wrong;
    const MeasuredDistance d = approximate_distance(probe.pair);
    if ((d.value < 0) != (probe.margin < 0)) return nothing_wrong;
    if (!likely_sought(probe.pair, d)) return nothing_wrong;
    const double size = size_of(probe.pair);
    return value_of(std::abs(d.value) / size, size);
  }

  /// The worst of the answers, if that is worse than `value`.
  const Probe* worst_among(const std::vector<Probe>& probes, double& value) const {
    const Probe* worst = nullptr;
    for (const Probe& probe : probes) {
      const double v = likely_value(probe);
      if (v <= value) continue;
      value = v;
      worst = &probe;
    }
    return worst;
  }

  Evaluation worst_on(const Pair& pair, const Ray& ray) {
    const bool by_margin = options_.objective == Objective::margin;
    Evaluation found;
    const std::vector<Probe> probes = ask_along(pair, ray, by_margin ? margins_per_decade : 1);
    const Probe* first = worst_among(probes, found.value);
    if (first == nullptr) return found;
    Probe worst = *first;
    if (by_margin) refine(worst, found.value, ray);
    found.pair = worst.pair;
    if (found.value > proved_ + gain_tol) found.value = prove(worst, found.value);
    return found;
  }

  /// Looks for a larger margin at which the answer is still wrong.
  void refine(Probe& worst, double& value, const Ray& ray) {
    double step = std::pow(10, 1.0 / margins_per_decade);
    for (int cut = 0; cut < cuts && value + std::log10(step) > best_.value; ++cut) {
      const double part = std::pow(step, 1.0 / parts);
      std::vector<Probe> between;
      double margin = worst.margin;
      for (int i = 1; i < parts; ++i) between.push_back({ray.at(margin *= part), margin});
      ask(between);
      if (const Probe* worse = worst_among(between, value)) worst = *worse;
      step = part;
    }
  }

  /// Returns the proved value, at most `likely`, and keeps the pair if it is the worst so far.
  double prove(const Probe& probe, double likely) {
    const double value = options_.objective == Objective::margin ? prove_verdict(probe) : prove_score(probe);
    return std::min(value, likely);
  }

  double prove_verdict(const Probe& wrong) {
    const MethodAnswer& answer = wrong.answer;
    Proofs proofs(wrong.pair, {&answer, 1});
    Trial& proved = proofs.of(wrong.pair);
    if (!proved.decided()) return nothing_wrong;
    proved.distance_at(std::clamp(enclosure_part * std::abs(wrong.margin), enclosure_least, enclosure_most));
    const auto finding = compare(proved, claim_, answer);
    if (!finding || !is_refuted_verdict(finding->kind) || !finding->margin) return nothing_wrong;
    if (sought_.kind && finding->kind != *sought_.kind) return nothing_wrong;
    if (sought_.feature && contact_feature(wrong.pair, proved.truth) != sought_.feature) return nothing_wrong;
    if (sought_.also && !sought_.also(wrong.pair)) return nothing_wrong;
    const double size = size_of(wrong.pair), margin = finding->margin->lo;
    const double value = finding->severity == Severity::contract ? beyond + std::log10(margin)
                                                                 : std::min(value_of(margin, size), 0.0);
    if (value > proved_) {
      proved_ = value;
      worst_.wrong = WrongPair{wrong.pair, proved.truth.verdict, *finding};
    }
    return value;
  }

  // A time that something else caused does not come again. An error is proved.
  double prove_score(const Probe& probe) {
    Score score = score_of(probe, true);
    if (timed_) {
      std::vector<Probe> again{probe, probe};
      ask(again);
      for (const Probe& a : again) score.value = std::min(score.value, score_of(a, true).value);
    }
    if (!(score.value > 0) || (sought_.feature && contact_feature(probe.pair) != sought_.feature) ||
        (sought_.also && !sought_.also(probe.pair)))
      return nothing_wrong;
    const double value = std::log10(score.value);
    if (value > proved_) {
      proved_ = value;
      worst_.scored = ScoredPair{probe.pair, score.value, score.beyond};
    }
    return value;
  }

  Score score_of(const Probe& probe, bool proved) const {
    if (probe.answer.status != Status::answered) return {};
    if (timed_) return {std::max(1.0, probe.answer.distance)};
    if (!probe.answer.has_distance && !(probe.answer.error_bound > 0)) return {};
    Trial trial = proved ? Trial(probe.pair) : Trial(probe.pair, judge_verdict(probe.pair));
    const Enclosure ratio = error_over_bound(trial, claim_, probe.answer, proved);
    return {ratio.hi, proved && ratio.lo > 1};
  }

  const std::unique_ptr<Method>& method_;
  const Sought& sought_;
  const WorstOptions& options_;
  const OnWorst& on_worst_;
  const Claim claim_;
  const Clock::time_point began_ = Clock::now();
  std::unique_ptr<Method> timed_;
  std::optional<Asker> asker_;  ///< of the one that is asked
  std::vector<Evaluation> candidates_;
  Evaluation best_;
  double proved_ = nothing_wrong;
  unsigned breaks_ = 0;  ///< crashes, and hangs for several each
  Worst worst_;
};

double nanoseconds_on(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

}  // namespace

double cpu_clock() { return nanoseconds_on(CLOCK_PROCESS_CPUTIME_ID); }
double wall_clock() { return nanoseconds_on(CLOCK_MONOTONIC); }

bool Worst::beyond_claim() const {
  return failed || (scored && scored->beyond) || (wrong && wrong->finding.severity == Severity::contract);
}

Worst worst_of(const std::unique_ptr<Method>& method, std::span<const Pair> starts, const Sought& sought,
               const WorstOptions& options, const OnWorst& on_worst) {
  return WorstSearch(method, sought, options, on_worst).run(starts);
}

std::vector<Pair> drawn_starts(std::optional<ContactFeature> feature, std::uint64_t seed,
                               Objective objective) {
  constexpr std::uint64_t of_a_cell = 4, of_a_family = 4;
  std::vector<Pair> starts;
  if (objective == Objective::error)
    for (const CloseContact& contact : draw_close_round(seed, 0))
      if (!feature || contact.feature == *feature || *feature == ContactFeature::containment)
        starts.push_back(contact.pair);
  for (std::uint64_t index = 0; objective != Objective::error && index < of_a_cell; ++index)
    for (int decade = first_decade; decade <= last_decade; ++decade)
      for (const ContactFeature drawn : enum_values<ContactFeature>)
        if (const auto pair =
                !feature || drawn == *feature ? draw_in_stratum(drawn, decade, seed, index) : std::nullopt)
          starts.push_back(*pair);
  for (std::uint64_t index = 0; index < of_a_family; ++index)
    for (const Family& family : families()) starts.push_back(family.generate(seed, index));
  return starts;
}

std::optional<double> usual_ns(const std::unique_ptr<Method>& method, double (*clock)()) {
  constexpr std::uint64_t count = 101, seed = 1;
  const std::unique_ptr<Method> asked = std::make_unique<Timed>(*method, clock);
  std::vector<Pair> pairs;
  std::vector<Question> questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    questions.push_back({0, pairs.size()});
    pairs.push_back(find_family("random")->generate(seed, i));
  }
  Caps caps;
  caps.hangs = 1;
  std::vector<double> ns;
  for (const ContainedAnswer& said : ask_contained({&asked, 1}, pairs, questions, caps))
    if (said.answer.status == Status::answered) ns.push_back(said.answer.distance);
  if (ns.empty()) return {};
  const auto middle = ns.begin() + static_cast<std::ptrdiff_t>(ns.size() / 2);
  std::nth_element(ns.begin(), middle, ns.end());
  return *middle;
}

}  // namespace cyl
