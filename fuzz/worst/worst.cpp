// SPDX-License-Identifier: MIT
#include "fuzz/worst/worst.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/strata.hpp"
#include "fuzz/guided/mutator.hpp"
#include "fuzz/worst/shapes.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/own_answers.hpp"
#include "oracles/referee/shown_distance.hpp"
#include "oracles/trial/contact.hpp"
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

/// Enclosures are asked to this part of the margin, and to no less than doubles give.
constexpr double enclosure_part = 1e-4, enclosure_least = 1e-18, enclosure_most = 1e-6;

/// The relative width of enclosures of depths for `error`, a part of the error that a claim allows.
constexpr double error_width = 1e-14;

/// Part of the budget that looking at the starts may take.
constexpr double starts_part = 0.25;
/// Shapes of one walk. Walks of this length from several places find more than longer ones.
constexpr int walk_cap = 250;
/// One shape in this many of a walk is a mutation.
constexpr std::size_t mutation_share = 4;

int rank(FindingKind failure) {
  return failure == FindingKind::crash ? 3 : failure == FindingKind::hang ? 2 : 1;
}

/// Returns the least and the greatest error of the distance over its bound. For a depth, the bound limits
/// how much deeper the solids are. No direction shows how much less deep they are, so the claim limits that.
Enclosure error_over_bound(Trial& trial, const Claim& claim, const MethodAnswer& answer, bool by_referee) {
  if (!trial.decided() || answer.verdict == Verdict::invalid) return {0, 0};
  const double said = answer.distance, most = allowed_error(claim, trial.pair);
  // The solver's points are good, and the bounds that they show are proved in any case.
  Enclosure real = shown_distance(trial.pair, measured_of(distance(trial.pair.a, trial.pair.b)));
  if (trial.truth.verdict == Verdict::touching)
    real = {0, 0};
  else if (trial.meets() || by_referee) {
    const Enclosure proved = trial.distance_at(error_width);
    real = {std::max(real.lo, proved.lo), std::min(real.hi, proved.hi)};
  }
  if (answer.error_bound == 0)
    return {std::max({0.0, real.lo - said, said - real.hi}) / most,
            std::max(real.hi - said, said - real.lo) / most};
  const double deeper_stated = said > 0 || !answer.has_distance ? 0 : std::max(0.0, real.lo - said) / most;
  const Enclosure error = error_bound_of(real, answer);
  return {std::max(deeper_stated, error.lo / answer.error_bound),
          std::max(deeper_stated, error.hi / answer.error_bound)};
}

/// How bad the method is on a shape, and the pair on its ray on which it is.
struct Evaluation {
  double value = nothing_wrong;
  Pair pair{};
};

/// Measures how bad the method is on one shape after the other, and walks from the worst. The solver's
/// estimate guides the search, and kept pairs are proved.
class WorstSearch {
 public:
  WorstSearch(const std::unique_ptr<Method>& method, const WorstOptions& options, const OnWorst& on_worst)
      : method_(method),
        options_(options),
        on_worst_(on_worst),
        claim_(method->claim()),
        by_margin_(options.objective == Objective::margin),
        stream_("worst", options.seed, 0) {}

  Worst run(std::span<const Pair> starts) {
    evaluate_starts(starts);
    for (std::size_t round = 0; !starts.empty() && !over(); ++round) {
      if (candidates_.empty())
        try_start(mutate(starts[stream_.below(starts.size())], stream_.bits()));
      else
        walk(next_start(round));
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

  /// Starts that already have the wanted feature go first.
  void evaluate_starts(std::span<const Pair> starts) {
    const double evaluation_part = starts_part * static_cast<double>(options_.evaluation_cap);
    for (const bool of_it : {true, false})
      for (const Pair& start : starts) {
        if (over() || static_cast<double>(worst_.evaluations) >= evaluation_part ||
            elapsed() >= starts_part * options_.budget)
          break;
        if (has_feature(start, approximate_distance(start)) == of_it) try_start(start);
      }
    std::ranges::stable_sort(candidates_, std::greater(), &Evaluation::value);
  }

  void try_start(const Pair& start) {
    const Evaluation found = evaluate(start);
    if (found.value > nothing_wrong) candidates_.push_back(found);
  }

  /// Returns the start of the next walk: the worst pair, or the next of the starts.
  Evaluation next_start(std::size_t round) const {
    if (round % 2 == 0 && best_.value > nothing_wrong) return best_;
    return candidates_[round / 2 % candidates_.size()];
  }

  void walk(Evaluation at) {
    for (int i = 0; i < walk_cap && !over(); ++i) {
      const unsigned breaks = breaks_;
      const Evaluation next = evaluate(stream_.below(mutation_share) == 0 ? mutate(at.pair, stream_.bits())
                                                                          : nudged(at.pair, stream_));
      if (breaks_ > breaks) return;
      if (next.value > at.value) at = next;
    }
  }

  /// Asks about a shape, and keeps in worst_ what is worse than all before. A shape on which something breaks
  /// counts for nothing: it is not walked from.
  Evaluation evaluate(const Pair& any) {
    ++worst_.evaluations;
    if (on_worst_) on_worst_(worst_);
    const std::optional<Pair> pair = bring_into_domain(any);
    const std::optional<Ray> ray = pair ? ray_of(*pair) : std::nullopt;
    if (!ray || !is_in_domain(ray->touching)) return {};
    const unsigned breaks = breaks_;
    const Evaluation found = worst_on(*pair, *ray);
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
    worst_.questions += probes.size();
    if (!method_->foreign()) {
      for (Probe& probe : probes) probe.answer = method_->ask(probe.pair);
      return;
    }
    if (!asker_) asker_.emplace(std::span(&method_, 1), Caps{.hangs = 1});
    const auto said = asker_->ask(pairs, questions);
    for (std::size_t i = 0; i < said.size(); ++i) {
      probes[i].answer = said[i].answer;
      if (said[i].answer.status == Status::failed) note_failure(probes[i]);
    }
  }

  void note_failure(const Probe& probe) {
    const FindingKind failure = finding_of(probe.answer.failure);
    if (failure == FindingKind::crash) ++breaks_;
    if (failure == FindingKind::hang) breaks_ += crash_cap / hang_cap + 1;
    if (worst_.failed && rank(failure) <= rank(worst_.failed->kind)) return;
    if (has_feature(probe.pair, approximate_distance(probe.pair)))
      worst_.failed = WorstPair{probe.pair, failure, Severity::contract, 0, probe.answer.reason};
  }

  /// Returns whether the wanted feature meets, by an approximate distance. That is proved later if it
  /// matters.
  bool has_feature(const Pair& pair, const MeasuredDistance& d) const {
    return !options_.feature ||
           (!d.direction.isZero(0) && feature_at(pair, d.value < 0, d.direction) == *options_.feature);
  }

  /// For the walk: beyond the claim by the margin, else by the part of the claim that is used.
  double value_of(double margin, double size) const {
    const double gap = margin * size, claimed = reach(claim_, size);
    return gap >= claimed ? beyond + std::log10(margin) : std::log10(gap / claimed);
  }

  /// The value by the approximate distance, which is fast.
  double likely_value(const Probe& probe) const {
    if (probe.answer.status != Status::answered) return nothing_wrong;
    const Verdict said = probe.answer.verdict;
    const bool wrong = probe.margin < 0 ? said == Verdict::disjoint
                                        : said == Verdict::intersecting || said == Verdict::touching;
    if (by_margin_ && !wrong) return nothing_wrong;
    const MeasuredDistance d = approximate_distance(probe.pair);
    if (!has_feature(probe.pair, d)) return nothing_wrong;
    if (!by_margin_) {
      const double error = error_of(probe, false).hi;
      return error > 0 ? std::log10(error) : nothing_wrong;
    }
    if ((d.value < 0) != (probe.margin < 0)) return nothing_wrong;
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
    Evaluation found;
    const std::vector<Probe> probes = ask_along(pair, ray, by_margin_ ? margins_per_decade : 1);
    const Probe* first = worst_among(probes, found.value);
    if (first == nullptr) return found;
    Probe worst = *first;
    if (by_margin_) refine(worst, found.value, ray);
    found.pair = worst.pair;
    if (found.value > proved_ + gain_tol) found.value = std::min(found.value, prove(worst));
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

  /// Returns the proved value, and keeps the pair if it is the worst so far.
  double prove(const Probe& probe) {
    const std::optional<WorstPair> proved = by_margin_ ? proved_verdict(probe) : proved_error(probe);
    if (!proved || (options_.feature && contact_feature(probe.pair) != options_.feature))
      return nothing_wrong;
    const bool by_score = !by_margin_ || proved->severity == Severity::contract;
    const double value = by_score ? std::log10(proved->score) + (by_margin_ ? beyond : 0)
                                  : std::min(value_of(proved->score, size_of(probe.pair)), 0.0);
    if (value > proved_) {
      proved_ = value;
      worst_.worst = proved;
    }
    return value;
  }

  std::optional<WorstPair> proved_verdict(const Probe& probe) const {
    Trial trial(probe.pair, {&probe.answer, 1});
    if (!trial.decided()) return {};
    trial.distance_at(std::clamp(enclosure_part * std::abs(probe.margin), enclosure_least, enclosure_most));
    const auto finding = compare(trial, claim_, probe.answer);
    if (!finding || !is_refuted_verdict(finding->kind) || !finding->margin) return {};
    return WorstPair{probe.pair, finding->kind, finding->severity, finding->margin->lo};
  }

  std::optional<WorstPair> proved_error(const Probe& probe) const {
    const Enclosure error = error_of(probe, true);
    if (!(error.hi > 0)) return {};
    const bool outside = error.lo > 1;
    return WorstPair{probe.pair, FindingKind::distance_outside,
                     outside ? Severity::contract : Severity::resolution,
                     outside ? error.lo : std::min(error.hi, 1.0)};
  }

  Enclosure error_of(const Probe& probe, bool proved) const {
    if (!probe.answer.has_distance && !(probe.answer.error_bound > 0)) return {0, 0};
    Trial trial = proved ? Trial(probe.pair) : Trial(probe.pair, judge_verdict(probe.pair));
    return error_over_bound(trial, claim_, probe.answer, proved);
  }

  const std::unique_ptr<Method>& method_;
  const WorstOptions& options_;
  const OnWorst& on_worst_;
  const Claim claim_;
  const bool by_margin_;
  const Clock::time_point began_ = Clock::now();
  RandomStream stream_;
  std::optional<Asker> asker_;
  std::vector<Evaluation> candidates_;
  Evaluation best_;
  double proved_ = nothing_wrong;
  unsigned breaks_ = 0;  ///< crashes, and hangs for several each
  Worst worst_;
};

}  // namespace

Worst worst_of(const std::unique_ptr<Method>& method, std::span<const Pair> starts,
               const WorstOptions& options, const OnWorst& on_worst) {
  return WorstSearch(method, options, on_worst).run(starts);
}

std::vector<Pair> drawn_starts(const Method& method, const WorstOptions& options) {
  constexpr std::uint64_t of_a_cell = 4, of_a_family = 4;
  const auto wanted = [&](ContactFeature feature) { return !options.feature || feature == *options.feature; };
  std::vector<Pair> starts;
  if (options.objective == Objective::error) {
    for (const CloseContact& contact : draw_close_round(options.seed, 0))
      if (wanted(contact.feature) || options.feature == ContactFeature::containment)
        starts.push_back(contact.pair);
  } else {
    for (std::uint64_t index = 0; index < of_a_cell; ++index)
      for (const Stratum& stratum : drawn_strata)
        if (const auto pair = wanted(stratum.feature)
                                  ? draw_in_stratum(stratum.feature, stratum.decade, options.seed, index)
                                  : std::nullopt)
          starts.push_back(*pair);
  }
  for (std::uint64_t index = 0; index < of_a_family; ++index)
    for (const std::span<const Family> all : {families(), box_families()})
      for (const Family& family : all)
        if (const Pair pair = family.generate(options.seed, index); method.supports(pair))
          starts.push_back(pair);
  return starts;
}

}  // namespace cyl
