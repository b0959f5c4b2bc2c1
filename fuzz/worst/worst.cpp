// SPDX-License-Identifier: MIT
#include "fuzz/worst/worst.hpp"

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <exception>
#include <string_view>
#include <utility>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/strata.hpp"
#include "fuzz/guided/mutator.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

using Clock = std::chrono::steady_clock;

/// Of a shape on which nothing is wrong.
constexpr double nothing = -1000;
/// Added to the value of what is beyond the claim, so that it is above all that is within.
constexpr double beyond = 100;
/// A value must be better by so many decades to be worth a proof.
constexpr double gain_tol = 1e-4;

/// Rungs of the ladder of margins: 1e-15 to 10 apart, to 1 into each other.
constexpr int rungs_per_decade = 4, decades_down = 15, decades_up = 1;
/// Parts into which the step from the last rung that is wrong to the next is cut, again and again.
constexpr int parts = 16, cuts = 2;

/// Evaluations of one walk. Walks of this length from several places find more than longer ones.
constexpr int walk_cap = 250;
/// Changes in a coordinate below which a walk is over.
constexpr double walk_step_tol = 1e-5;
/// Mutations of the worst pair of which the worst is walked from.
constexpr int mutations = 12;
/// Part of the budget that looking at the starts may take.
constexpr double starts_part = 0.25;
/// A search ends after so many crashes, or hangs of a second each: it has found its worst.
constexpr unsigned crash_cap = 64, hang_cap = 3;

/// Calls of which the least time counts, unless they have taken too long already.
constexpr int timed_calls = 3;
constexpr double repeat_ns_cap = 1e8;
constexpr int clock_looks = 8;

/// Enclosures are asked to this part of the margin, and to no less than doubles give.
constexpr double enclosure_part = 1e-4, enclosure_least = 1e-18, enclosure_most = 1e-6;

int rank(Failure failure) {
  return failure == Failure::crash ? 3 : failure == Failure::hang ? 2 : failure == Failure::none ? 0 : 1;
}

/// Answers with the time of a call as the distance.
class Timed final : public Method {
 public:
  Timed(Method& method, double (*clock)()) : method_(method), clock_(clock) {}
  std::string_view name() const override { return method_.name(); }
  std::string_view version() const override { return method_.version(); }
  Claim claim() const override { return method_.claim(); }
  MethodAnswer ask(const Pair& pair) override {
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

/// Two slides touch where one does not quite.
std::optional<Ray> ray_of(const Pair& pair) {
  Ray ray{pair, {0, 0, 0}, size_of(pair)};
  for (int i = 0; i < 2; ++i) {
    const Distance d = distance(ray.touching.a, ray.touching.b);
    if (d.verdict == Verdict::invalid || !(d.direction.norm() > 0.5)) return {};
    ray.direction = d.direction;
    ray.touching.b.center -= d.value * d.direction;
  }
  return ray;
}

class Hunt {
 public:
  Hunt(const std::unique_ptr<Method>& method, const Sought& sought, const WorstOptions& options,
       const OnWorst& on_worst)
      : method_(method), sought_(sought), options_(options), on_worst_(on_worst), claim_(method->claim()) {
    if (options.search == Search::time) timed_ = std::make_unique<Timed>(*method, options.clock);
  }

  Worst run(std::span<const Pair> starts) {
    look_at_starts(starts);
    RandomStream stream("worst", options_.seed, 0);
    for (std::size_t round = 0; !starts.empty() && !over(); ++round) {
      if (candidates_.empty())
        try_start(mutate(starts[stream.below(starts.size())], stream.bits()));
      else
        walk(place(round, stream), stream);
    }
    return std::move(worst_);
  }

 private:
  /// A shape that was looked at: how bad, and the pair on its ray that is.
  struct Look {
    double value = nothing;
    Pair pair{};
  };
  struct Answered {
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

  /// Those that have the features sought as they stand go first.
  void look_at_starts(std::span<const Pair> starts) {
    for (const bool of_it : {true, false}) {
      for (const Pair& start : starts) {
        if (over() ||
            static_cast<double>(worst_.evaluations) >=
                starts_part * static_cast<double>(options_.evaluation_cap) ||
            elapsed() >= starts_part * options_.budget)
          break;
        if (likely_of_it(start, distance(start.a, start.b)) == of_it) try_start(start);
      }
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Look& x, const Look& y) { return x.value > y.value; });
  }

  void try_start(const Pair& start) {
    const std::optional<Pair> pair = bring_into(options_.domain, start);
    if (!pair) {
      ++worst_.evaluations;
      return;
    }
    const Look look = look_at(*pair);
    if (look.value > nothing) candidates_.push_back(look);
  }

  /// Where the next walk begins: at the worst, at the next of the starts, at the worst of some mutations of
  /// the worst.
  Pair place(std::size_t round, RandomStream& stream) {
    const Pair& worst = best_.value > nothing ? best_.pair : candidates_.front().pair;
    if (round % 3 == 0) return worst;
    if (round % 3 == 1) return candidates_[round / 3 % candidates_.size()].pair;
    Look kept{nothing, worst};
    for (int i = 0; i < mutations && !over(); ++i) {
      const std::optional<Pair> pair = bring_into(options_.domain, mutate(worst, stream.bits()));
      if (!pair) continue;
      const Look look = look_at(*pair);
      if (look.value > kept.value) kept = look;
    }
    return kept.pair;
  }

  // NLopt's status codes say nothing that counts: what was found was noted on the way. The sizes of the first
  // steps are drawn, or two walks from one place would be the same.
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
    Hunt& hunt;
    PairChart chart;
    nlopt_opt optimizer;
    std::exception_ptr thrown;
  };

  static double objective(unsigned, const double* x, double*, void* data) {
    Walk& w = *static_cast<Walk*>(data);
    const unsigned breaks = w.hunt.breaks_;
    double value = nothing;
    try {
      const Pair pair =
          w.chart.pair(std::span<const double, PairChart::dimensions>(x, PairChart::dimensions));
      value = w.hunt.look_at(pair).value;
    } catch (...) {
      w.thrown = std::current_exception();
    }
    if (w.thrown || w.hunt.over() || w.hunt.breaks_ > breaks) nlopt_force_stop(w.optimizer);
    return value;
  }

  /// A shape on which something breaks counts for nothing: it is not walked from.
  Look look_at(const Pair& pair) {
    ++worst_.evaluations;
    if (on_worst_) on_worst_(worst_, elapsed());
    const std::optional<Ray> ray = ray_of(pair);
    if (!ray || !is_in(options_.domain, pair) || !is_in(options_.domain, ray->touching)) return {};
    const unsigned breaks = breaks_;
    const Look look = options_.search == Search::time ? slowest_on(pair, *ray) : most_wrong_on(pair, *ray);
    if (breaks_ > breaks) return {};
    if (look.value > best_.value) best_ = look;
    return look;
  }

  /// The pair itself and the rungs.
  std::vector<Answered> ladder(const Pair& pair, const Ray& ray, int per_decade) {
    std::vector<Answered> probes{{pair, distance(pair.a, pair.b).value / ray.size}};
    for (int i = per_decade * decades_up; i >= -per_decade * decades_down; --i) {
      const double margin = std::pow(10, static_cast<double>(i) / per_decade);
      probes.push_back({ray.at(margin), margin});
      if (margin <= 1) probes.push_back({ray.at(-margin), -margin});
    }
    ask(probes);
    return probes;
  }

  /// Stops at the first hang and notes what fails.
  void ask(std::vector<Answered>& probes) {
    std::vector<Pair> pairs;
    std::vector<Question> questions;
    for (const Answered& probe : probes) {
      questions.push_back({0, pairs.size()});
      pairs.push_back(probe.pair);
    }
    Caps caps;
    caps.hangs = 1;
    const auto said = ask_contained({timed_ ? &timed_ : &method_, 1}, pairs, questions, caps);
    worst_.questions += said.size();
    for (std::size_t i = 0; i < said.size(); ++i) {
      probes[i].answer = said[i].answer;
      if (said[i].answer.status == Status::failed) note_failure(probes[i]);
    }
  }

  void note_failure(const Answered& probe) {
    const Failure failure = probe.answer.failure;
    if (failure == Failure::crash) ++breaks_;
    if (failure == Failure::hang) breaks_ += crash_cap / hang_cap + 1;
    if (worst_.failed && rank(failure) <= rank(worst_.failed->failure)) return;
    if (!likely_of_it(probe.pair, distance(probe.pair.a, probe.pair.b))) return;
    if (sought_.also && !sought_.also(probe.pair)) return;
    worst_.failed = FailedPair{probe.pair, failure, probe.answer.reason};
  }

  /// Whether the features sought meet, by the solver: quick, and proved later where it matters.
  bool likely_of_it(const Pair& pair, const Distance& d) const {
    if (!sought_.feature) return true;
    if (d.verdict == Verdict::invalid) return false;
    const bool inside = d.value < 0 && (contains(pair.a, pair.b) || contains(pair.b, pair.a));
    return (inside ? ContactFeature::containment : feature_along(pair, d.direction)) == *sought_.feature;
  }

  /// For the optimiser: beyond the claim by the margin, else by the part of the claim that is used.
  double value_of(double margin, double size) const {
    const double gap = margin * size, claimed = reach(claim_, size);
    return gap >= claimed ? beyond + std::log10(margin) : std::log10(gap / claimed);
  }

  /// The value if the answer is wrong, by the solver.
  double likely_value(const Answered& probe) const {
    if (probe.answer.status != Status::answered) return nothing;
    const Verdict said = probe.answer.verdict;
    const bool wrong = probe.margin < 0 ? said == Verdict::disjoint
                                        : said == Verdict::intersecting || said == Verdict::touching;
    if (!wrong || (sought_.kind && (*sought_.kind == FindingKind::wrong_intersecting) != (probe.margin > 0)))
      return nothing;
    const Distance d = distance(probe.pair.a, probe.pair.b);
    if (std::abs(d.value) <= d.error || (d.value < 0) != (probe.margin < 0)) return nothing;
    if (!likely_of_it(probe.pair, d)) return nothing;
    const double size = size_of(probe.pair);
    return value_of(std::abs(d.value) / size, size);
  }

  /// The worst of the answers, if that is worse than `value`.
  const Answered* worst_among(const std::vector<Answered>& probes, double& value) const {
    const Answered* worst = nullptr;
    for (const Answered& probe : probes) {
      const double v = likely_value(probe);
      if (v <= value) continue;
      value = v;
      worst = &probe;
    }
    return worst;
  }

  Look most_wrong_on(const Pair& pair, const Ray& ray) {
    Look look;
    const std::vector<Answered> rungs = ladder(pair, ray, rungs_per_decade);
    const Answered* found = worst_among(rungs, look.value);
    if (found == nullptr) return look;
    Answered worst = *found;
    double step = std::pow(10, 1.0 / rungs_per_decade);
    for (int cut = 0; cut < cuts && look.value + std::log10(step) > best_.value; ++cut) {
      const double part = std::pow(step, 1.0 / parts);
      std::vector<Answered> probes;
      double margin = worst.margin;
      for (int i = 1; i < parts; ++i) probes.push_back({ray.at(margin *= part), margin});
      ask(probes);
      if (const Answered* worse = worst_among(probes, look.value)) worst = *worse;
      step = part;
    }
    look.pair = worst.pair;
    if (look.value > proved_value() + gain_tol) look.value = prove(worst, look.value);
    return look;
  }

  double proved_value() const { return worst_.wrong ? proved_ : nothing; }

  double prove(const Answered& wrong, double likely) {
    const MethodAnswer& answer = wrong.answer;
    Proofs proofs(wrong.pair, {&answer, 1});
    Trial& proved = proofs.of(wrong.pair);
    if (!proved.decided())
      return nothing;
    proved.distance_at(std::clamp(enclosure_part * std::abs(wrong.margin), enclosure_least, enclosure_most));
    const auto finding = compare(proved, claim_, answer);
    if (!finding || !is_refuted_verdict(finding->kind) || !finding->margin) return nothing;
    if (sought_.kind && finding->kind != *sought_.kind) return nothing;
    if (sought_.feature && contact_feature(wrong.pair, proved.truth) != sought_.feature) return nothing;
    if (sought_.also && !sought_.also(wrong.pair)) return nothing;
    const double size = size_of(wrong.pair);
    const double margin = finding->margin->lo;
    const double value = finding->severity == Severity::contract ? beyond + std::log10(margin)
                                                                 : std::min(value_of(margin, size), 0.0);
    if (value > proved_value()) {
      proved_ = value;
      worst_.wrong = WrongPair{wrong.pair, proved.truth.verdict, *finding};
    }
    return std::min(value, likely);
  }

  // Where the slowest does not count, the next may.
  Look slowest_on(const Pair& pair, const Ray& ray) {
    std::vector<Answered> rungs = ladder(pair, ray, 1);
    std::stable_sort(rungs.begin(), rungs.end(), [](const Answered& x, const Answered& y) {
      return x.answer.distance > y.answer.distance;
    });
    for (const Answered& rung : rungs) {
      if (rung.answer.status != Status::answered) continue;
      if (!likely_of_it(rung.pair, distance(rung.pair.a, rung.pair.b))) continue;
      const double ns = rung.answer.distance;
      if (!worst_.slow || ns > worst_.slow->ns) return confirm(rung);
      return {std::log10(std::max(1.0, ns)), rung.pair};
    }
    return {};
  }

  /// A time that something else caused does not come again.
  Look confirm(const Answered& rung) {
    std::vector<Answered> again{rung, rung};
    ask(again);
    double ns = rung.answer.distance;
    for (const Answered& a : again)
      ns = a.answer.status == Status::answered ? std::min(ns, a.answer.distance) : 0;
    if (ns > 0 && (!worst_.slow || ns > worst_.slow->ns) && belongs(rung.pair))
      worst_.slow = SlowPair{rung.pair, ns};
    return {std::log10(std::max(1.0, ns)), rung.pair};
  }

  bool belongs(const Pair& pair) const {
    if (sought_.feature && contact_feature(pair, judge(pair)) != sought_.feature) return false;
    return !sought_.also || sought_.also(pair);
  }

  const std::unique_ptr<Method>& method_;
  const Sought& sought_;
  const WorstOptions& options_;
  const OnWorst& on_worst_;
  const Claim claim_;
  const Clock::time_point began_ = Clock::now();
  std::unique_ptr<Method> timed_;
  std::vector<Look> candidates_;
  Look best_;
  double proved_ = nothing;
  unsigned breaks_ = 0;
  Worst worst_;
};

double read_clock(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

}  // namespace

double cpu_clock() { return read_clock(CLOCK_PROCESS_CPUTIME_ID); }
double wall_clock() { return read_clock(CLOCK_MONOTONIC); }

bool Worst::beyond_claim() const {
  return failed || (wrong && wrong->finding.severity == Severity::contract);
}

Worst worst_of(const std::unique_ptr<Method>& method, std::span<const Pair> starts, const Sought& sought,
               const WorstOptions& options, const OnWorst& on_worst) {
  return Hunt(method, sought, options, on_worst).run(starts);
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

std::optional<double> usual_ns(const std::unique_ptr<Method>& method, double (*clock)()) {
  constexpr std::uint64_t count = 101, seed = 1;
  const std::unique_ptr<Method> timed = std::make_unique<Timed>(*method, clock);
  std::vector<Pair> pairs;
  std::vector<Question> questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    questions.push_back({0, pairs.size()});
    pairs.push_back(find_family("random")->generate(seed, i));
  }
  Caps caps;
  caps.hangs = 1;
  std::vector<double> ns;
  for (const ContainedAnswer& said : ask_contained({&timed, 1}, pairs, questions, caps))
    if (said.answer.status == Status::answered) ns.push_back(said.answer.distance);
  if (ns.empty()) return {};
  const auto middle = ns.begin() + static_cast<std::ptrdiff_t>(ns.size() / 2);
  std::nth_element(ns.begin(), middle, ns.end());
  return *middle;
}

}  // namespace cyl
