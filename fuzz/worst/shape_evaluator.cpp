// SPDX-License-Identifier: MIT
#include "fuzz/worst/shape_evaluator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/pairs/strata.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// Added to the value of what is beyond the claim, so that it is above all that is within.
constexpr double beyond = 100;
/// A value must be better by so many decades to be worth a proof.
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

/// One slide may not quite touch, so there are two.
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

}  // namespace

std::unique_ptr<Method> timed(Method& method, double (*clock)()) {
  return std::make_unique<Timed>(method, clock);
}

Pair Ray::at(double margin) const {
  Pair p = touching;
  p.b.center += margin * size * direction;
  return p;
}

ShapeEvaluator::ShapeEvaluator(const std::unique_ptr<Method>& method, const Sought& sought,
                               const WorstOptions& options)
    : method_(method), sought_(sought), options_(options), claim_(method->claim()) {
  if (options.objective == Objective::time) timed_ = timed(*method, options.clock);
}

bool ShapeEvaluator::broken() const { return breaks_ >= crash_cap; }

Evaluation ShapeEvaluator::evaluate(const Pair& pair) {
  const std::optional<Ray> ray = ray_of(pair);
  if (!ray || !is_in(options_.domain, pair) || !is_in(options_.domain, ray->touching)) return {};
  const unsigned breaks = breaks_;
  const Evaluation found = options_.objective == Objective::margin ? most_wrong_on(pair, *ray)
                           : options_.objective == Objective::time ? slowest_on(pair, *ray)
                                                                   : highest_on(pair, *ray);
  if (breaks_ > breaks) return {};
  if (found.value > best_.value) best_ = found;
  return found;
}

std::vector<ShapeEvaluator::Probe> ShapeEvaluator::ask_along(const Pair& pair, const Ray& ray,
                                                             int per_decade) {
  std::vector<Probe> probes{{pair, distance(pair.a, pair.b).value / ray.size}};
  for (int i = per_decade * decades_up; i >= -per_decade * decades_down; --i) {
    const double margin = std::pow(10, static_cast<double>(i) / per_decade);
    probes.push_back({ray.at(margin), margin});
    if (margin <= 1) probes.push_back({ray.at(-margin), -margin});
  }
  ask(probes);
  return probes;
}

void ShapeEvaluator::ask(std::vector<Probe>& probes) {
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

void ShapeEvaluator::note_failure(const Probe& probe) {
  const Failure failure = probe.answer.failure;
  if (failure == Failure::crash) ++breaks_;
  if (failure == Failure::hang) breaks_ += crash_cap / hang_cap + 1;
  if (worst_.failed && rank(failure) <= rank(worst_.failed->failure)) return;
  if (!likely_sought(probe.pair, distance(probe.pair.a, probe.pair.b))) return;
  if (sought_.also && !sought_.also(probe.pair)) return;
  worst_.failed = FailedPair{probe.pair, failure, probe.answer.reason};
}

bool ShapeEvaluator::likely_sought(const Pair& pair, const Distance& d) const {
  if (!sought_.feature) return true;
  if (d.verdict == Verdict::invalid) return false;
  return feature_at(pair, d.value < 0, d.direction) == *sought_.feature;
}

double ShapeEvaluator::value_of(double margin, double size) const {
  const double gap = margin * size, claimed = reach(claim_, size);
  return gap >= claimed ? beyond + std::log10(margin) : std::log10(gap / claimed);
}

double ShapeEvaluator::likely_value(const Probe& probe) const {
  if (probe.answer.status != Status::answered) return nothing_wrong;
  const Verdict said = probe.answer.verdict;
  const bool wrong = probe.margin < 0 ? said == Verdict::disjoint
                                      : said == Verdict::intersecting || said == Verdict::touching;
  if (!wrong || (sought_.kind && (*sought_.kind == FindingKind::wrong_intersecting) != (probe.margin > 0)))
    return nothing_wrong;
  const Distance d = distance(probe.pair.a, probe.pair.b);
  if (std::abs(d.value) <= d.error || (d.value < 0) != (probe.margin < 0)) return nothing_wrong;
  if (!likely_sought(probe.pair, d)) return nothing_wrong;
  const double size = size_of(probe.pair);
  return value_of(std::abs(d.value) / size, size);
}

const ShapeEvaluator::Probe* ShapeEvaluator::worst_among(const std::vector<Probe>& probes,
                                                         double& value) const {
  const Probe* worst = nullptr;
  for (const Probe& probe : probes) {
    const double v = likely_value(probe);
    if (v <= value) continue;
    value = v;
    worst = &probe;
  }
  return worst;
}

Evaluation ShapeEvaluator::most_wrong_on(const Pair& pair, const Ray& ray) {
  Evaluation found;
  const std::vector<Probe> probes = ask_along(pair, ray, margins_per_decade);
  const Probe* first = worst_among(probes, found.value);
  if (first == nullptr) return found;
  Probe worst = *first;
  double step = std::pow(10, 1.0 / margins_per_decade);
  for (int cut = 0; cut < cuts && found.value + std::log10(step) > best_.value; ++cut) {
    const double part = std::pow(step, 1.0 / parts);
    std::vector<Probe> between;
    double margin = worst.margin;
    for (int i = 1; i < parts; ++i) between.push_back({ray.at(margin *= part), margin});
    ask(between);
    if (const Probe* worse = worst_among(between, found.value)) worst = *worse;
    step = part;
  }
  found.pair = worst.pair;
  if (found.value > proved_value() + gain_tol) found.value = prove(worst, found.value);
  return found;
}

double ShapeEvaluator::proved_value() const { return worst_.wrong ? proved_ : nothing_wrong; }

double ShapeEvaluator::prove(const Probe& wrong, double likely) {
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

Evaluation ShapeEvaluator::slowest_on(const Pair& pair, const Ray& ray) {
  std::vector<Probe> probes = ask_along(pair, ray, 1);
  std::stable_sort(probes.begin(), probes.end(),
                   [](const Probe& x, const Probe& y) { return x.answer.distance > y.answer.distance; });
  for (const Probe& probe : probes) {
    if (probe.answer.status != Status::answered) continue;
    if (!likely_sought(probe.pair, distance(probe.pair.a, probe.pair.b))) continue;
    const double ns = probe.answer.distance;
    if (!worst_.slow || ns > worst_.slow->ns) return confirm(probe);
    return {std::log10(std::max(1.0, ns)), probe.pair};
  }
  return {};
}

Evaluation ShapeEvaluator::confirm(const Probe& probe) {
  std::vector<Probe> again{probe, probe};
  ask(again);
  double ns = probe.answer.distance;
  for (const Probe& a : again) ns = a.answer.status == Status::answered ? std::min(ns, a.answer.distance) : 0;
  if (ns > 0 && (!worst_.slow || ns > worst_.slow->ns) && belongs(probe.pair))
    worst_.slow = SlowPair{probe.pair, ns};
  return {std::log10(std::max(1.0, ns)), probe.pair};
}

Evaluation ShapeEvaluator::highest_on(const Pair& pair, const Ray& ray) {
  Evaluation found;
  const Probe* highest = nullptr;
  const std::vector<Probe> probes =
      ask_along(pair, ray, options_.objective == Objective::undecided ? margins_per_decade : 1);
  for (const Probe& probe : probes) {
    if (probe.answer.status != Status::answered) continue;
    const double score =
        badness_of(options_.objective, claim_, probe.pair, probe.answer, Effort::likely).value;
    if (!(score > 0) || std::log10(score) <= found.value) continue;
    if (!likely_sought(probe.pair, distance(probe.pair.a, probe.pair.b))) continue;
    found = {std::log10(score), probe.pair};
    highest = &probe;
  }
  const double known = worst_.scored ? std::log10(worst_.scored->score) : nothing_wrong;
  if (!highest || found.value <= known + gain_tol) return found;
  const Badness proved =
      badness_of(options_.objective, claim_, highest->pair, highest->answer, Effort::proved);
  if (!(proved.value > 0) || !belongs(highest->pair)) return {};
  found.value = std::min(found.value, std::log10(proved.value));
  if (found.value > known) worst_.scored = ScoredPair{highest->pair, proved.value, proved.beyond};
  return found;
}

bool ShapeEvaluator::belongs(const Pair& pair) const {
  if (sought_.feature && contact_feature(pair) != sought_.feature) return false;
  return !sought_.also || sought_.also(pair);
}

}  // namespace cyl
