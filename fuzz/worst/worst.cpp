// SPDX-License-Identifier: MIT
#include "fuzz/worst/worst.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <utility>

#include "corpus/pairs/close_contact.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/strata.hpp"
#include "fuzz/guided/mutator.hpp"
#include "fuzz/worst/shape_evaluator.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;

/// Evaluations of one walk. Walks of this length from several places find more than longer ones.
constexpr int walk_cap = 250;
/// Changes in a coordinate below which a walk is over.
constexpr double walk_step_tol = 1e-5;
/// Mutations of the worst pair. The next walk may start from the worst of them.
constexpr int mutations = 12;
/// Part of the budget that looking at the starts may take.
constexpr double starts_part = 0.25;

/// Walks from the starts by the failure measured on each shape.
class ShapeSearch {
 public:
  ShapeSearch(const std::unique_ptr<Method>& method, const Sought& sought, const WorstOptions& options,
              const OnWorst& on_worst)
      : sought_(sought), options_(options), on_worst_(on_worst), evaluator_(method, sought, options) {}

  Worst run(std::span<const Pair> starts) {
    evaluate_starts(starts);
    RandomStream stream("worst", options_.seed, 0);
    for (std::size_t round = 0; !starts.empty() && !over(); ++round) {
      if (candidates_.empty())
        try_start(mutate(starts[stream.below(starts.size())], stream.bits()));
      else
        walk(next_start(round, stream), stream);
    }
    return std::move(evaluator_.worst());
  }

 private:
  std::chrono::milliseconds elapsed() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - began_);
  }
  bool over() const {
    return evaluator_.worst().evaluations >= options_.evaluation_cap || elapsed() >= options_.budget ||
           evaluator_.broken();
  }

  /// Starts that already have the wanted features go first.
  void evaluate_starts(std::span<const Pair> starts) {
    for (const bool of_it : {true, false}) {
      for (const Pair& start : starts) {
        if (over() ||
            static_cast<double>(evaluator_.worst().evaluations) >=
                starts_part * static_cast<double>(options_.evaluation_cap) ||
            elapsed() >= starts_part * options_.budget)
          break;
        if (evaluator_.likely_sought(start, distance(start.a, start.b)) == of_it) try_start(start);
      }
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Evaluation& x, const Evaluation& y) { return x.value > y.value; });
  }

  void try_start(const Pair& start) {
    const std::optional<Pair> pair = bring_into(options_.domain, start);
    if (!pair) {
      ++evaluator_.worst().evaluations;
      return;
    }
    const Evaluation found = evaluate(*pair);
    if (found.value > nothing_wrong) candidates_.push_back(found);
  }

  /// Returns the start of the next walk: the worst pair, the next of the starts, or the worst of some
  /// mutations of the worst pair.
  Pair next_start(std::size_t round, RandomStream& stream) {
    const Pair& worst =
        evaluator_.best().value > nothing_wrong ? evaluator_.best().pair : candidates_.front().pair;
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
    const std::size_t before = evaluator_.worst().evaluations;
    nlopt_optimize(w.optimizer, x.data(), &value);
    if (evaluator_.worst().evaluations == before)
      ++evaluator_.worst().evaluations;  // a walk that does not begin must end too
    if (w.thrown) std::rethrow_exception(w.thrown);
  }

  struct Walk {
    ShapeSearch& search;
    PairChart chart;
    nlopt_opt optimizer;
    std::exception_ptr thrown;
  };

  static double objective(unsigned, const double* x, double*, void* data) {
    Walk& w = *static_cast<Walk*>(data);
    const unsigned breaks = w.search.evaluator_.breaks();
    double value = nothing_wrong;
    try {
      const Pair pair =
          w.chart.pair(std::span<const double, PairChart::dimensions>(x, PairChart::dimensions));
      value = w.search.evaluate(pair).value;
    } catch (...) {
      w.thrown = std::current_exception();
    }
    if (w.thrown || w.search.over() || w.search.evaluator_.breaks() > breaks) nlopt_force_stop(w.optimizer);
    return value;
  }

  Evaluation evaluate(const Pair& pair) {
    ++evaluator_.worst().evaluations;
    if (on_worst_) on_worst_(evaluator_.worst(), elapsed());
    return evaluator_.evaluate(pair);
  }

  const Sought& sought_;
  const WorstOptions& options_;
  const OnWorst& on_worst_;
  const Clock::time_point began_ = Clock::now();
  std::vector<Evaluation> candidates_;
  ShapeEvaluator evaluator_;
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
  return ShapeSearch(method, sought, options, on_worst).run(starts);
}

std::vector<Pair> drawn_starts(std::optional<ContactFeature> feature, std::uint64_t seed) {
  constexpr std::uint64_t of_a_cell = 4, of_a_family = 4;
  std::vector<Pair> starts;
  for (std::uint64_t index = 0; index < of_a_cell; ++index) {
    for (int decade = first_decade; decade <= last_decade; ++decade) {
      for (std::size_t f = 0; f < contact_feature_count; ++f) {
        const auto drawn = static_cast<ContactFeature>(f);
        if (feature && drawn != *feature) continue;
        if (const auto pair = draw_in_stratum(drawn, decade, seed, index)) starts.push_back(*pair);
      }
    }
  }
  for (std::uint64_t index = 0; index < of_a_family; ++index)
    for (const Family& family : families()) starts.push_back(family.generate(seed, index));
  return starts;
}

std::vector<Pair> close_starts(std::optional<ContactFeature> feature, std::uint64_t seed) {
  constexpr std::uint64_t of_a_family = 2;
  std::vector<Pair> starts;
  for (const CloseContact& contact : draw_close_round(seed, 0))
    if (!feature || contact.feature == *feature || *feature == ContactFeature::containment)
      starts.push_back(contact.pair);
  for (std::uint64_t index = 0; index < of_a_family; ++index)
    for (const Family& family : families()) starts.push_back(family.generate(seed, index));
  return starts;
}

std::optional<double> usual_ns(const std::unique_ptr<Method>& method, double (*clock)()) {
  constexpr std::uint64_t count = 101, seed = 1;
  const std::unique_ptr<Method> asked = timed(*method, clock);
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
