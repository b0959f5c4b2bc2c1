// SPDX-License-Identifier: MIT
#include "scenes/study/scene_study.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/stopwatch.hpp"
#include "base/usage_error.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// The most configurations that are timed, and the most pairs in all of them. Then the models fit into the
/// near memory of a processor, and a round ends before other processes get their turn.
constexpr std::size_t timed_cap = 32, timed_pairs_cap = 2000;
constexpr std::chrono::duration<double> timed_least = std::chrono::milliseconds(5);

class Study {
 public:
  Study(const Scene& scene, const SceneOptions& question) : scene_(scene), q_(question) {
    result_.bodies = scene.bodies.size();
    result_.drawn = moves(scene) && q_.at.empty();
    result_.configurations = result_.drawn ? q_.configurations : 1;
    const PairRule rule(scene);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const PairRule::Reason reason = rule.reason(scene.bodies[j], scene.bodies[i]);
        ++result_.pairs_by_reason[static_cast<std::size_t>(reason)];
        const bool in_place = reason == PairRule::Reason::floating && !q_.at.empty();
        if (reason != PairRule::Reason::checked && !in_place) continue;
        PairStudy pair;
        pair.a = j;
        pair.b = i;
        result_.pairs.push_back(pair);
      }
    }
    const std::size_t most = samples_cap / std::max<std::size_t>(1, result_.pairs.size());
    result_.configurations = std::clamp<std::size_t>(most, 1, result_.configurations);
  }

  SceneStudy run() {
    for (std::size_t k = 0; k < result_.configurations; ++k) observe(k);
    for (PairStudy& pair : result_.pairs) pair.cascade = recommend(pair, q_.tolerated);
    check_cascades();
    if (q_.prove) prove();
    measure();
    return std::move(result_);
  }

 private:
  std::vector<double> joints(std::size_t configuration) const { return joints_of(scene_, q_, configuration); }

  void observe(std::size_t configuration) {
    placed_ = place(scene_, joints(configuration));
    models_ = models_of(placed_);
    for (PairStudy& pair : result_.pairs) observe(pair, configuration);
  }

  void observe(PairStudy& pair, std::size_t configuration) {
    const ProxyModels &a = models_[pair.a], &b = models_[pair.b];
    const Pair solids{placed_[pair.a], placed_[pair.b]};
    std::optional<bool> truth;
    std::size_t set = 0;
    bool decided = false;
    for (const Level level : enum_values<Level>) {
      const Proximity seen = proximity(level, a, b, q_.clearance);
      if (seen == Proximity::unclear) continue;
      if (index_of(level) < 3) set |= std::size_t{1} << index_of(level);
      if (!std::exchange(decided, true)) ++pair.decided[index_of(level)];
      if (level == Level::certified) truth = seen == Proximity::within;
    }
    ++pair.outcomes[set];
    if (!truth) {
      ++result_.asked_referee;
      truth = referee_within(solids, q_.clearance);
      if (!truth) ++result_.undecided;
    }
    const bool is_within = truth.value_or(true);
    const double d = distance(a.solid, b.solid).value;
    for (const Level level : enum_values<Level>)
      score(pair.alone[index_of(level)], accepted(level, a, b, q_.clearance), is_within, d, configuration);
    pair.least = pair.samples == 0 ? d : std::min(pair.least, d);
    pair.greatest = pair.samples == 0 ? d : std::max(pair.greatest, d);
    ++pair.samples;
    pair.within += is_within;
    const auto miss = [&](double value) { return std::fabs(value - q_.clearance); };
    if (!result_.closest || miss(d) < miss(result_.closest->distance))
      result_.closest = ClosestCall{pair.a, pair.b, configuration, d, size_of(solids)};
    truths_.push_back(is_within);
  }

  void score(Score& s, bool said, bool is_within, double d, std::size_t configuration) const {
    if (said == is_within) return;
    ++s.wrong;
    const double by = is_within ? q_.clearance - d : d - q_.clearance;
    Extreme& worst = is_within ? s.missed : s.alarm;
    if (by > worst.length) worst = {by, configuration};
  }

  // Compares what is recommended with the truths found above. The referee judges some of it anew.
  void check_cascades() {
    const std::size_t stride = truths_.size() / verified_cap + 1;
    std::size_t answer = 0;
    for (std::size_t k = 0; k < result_.configurations; ++k) {
      placed_ = place(scene_, joints(k));
      models_ = models_of(placed_);
      for (PairStudy& pair : result_.pairs) {
        const bool said = within(pair.cascade, models_[pair.a], models_[pair.b], q_.clearance);
        pair.cascade_wrong += said != truths_[answer];
        if (answer++ % stride == 0)
          result_.verification.add({placed_[pair.a], placed_[pair.b]}, q_.clearance, q_.tolerated, said);
      }
    }
  }

  void prove() {
    BodyPairs pairs, others;
    for (const PairStudy& pair : result_.pairs) {
      pairs.push_back({pair.a, pair.b, pair.least});
    }
    for (std::size_t b = 0; b < scene_.bodies.size() && q_.prove_others; ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        const std::size_t one = scene_.bodies[a].link, other = scene_.bodies[b].link;
        if (one != other && is_legal({scene_.bodies[a].solid, scene_.bodies[b].solid}) &&
            !carries_directly(scene_, one, other) &&
            std::ranges::none_of(pairs, [&](const BodyPair& p) { return p.a == a && p.b == b; }))
          others.push_back({a, b});
      }
    }
    result_.motions = prove_motions(scene_, pairs, {.clearance = q_.clearance, .seed = q_.seed}, others);
  }

  void measure() {
    const std::size_t pairs = std::max<std::size_t>(1, result_.pairs.size());
    const std::size_t calls = std::min(timed_cap, std::max<std::size_t>(1, timed_pairs_cap / pairs));
    const std::size_t count = std::min(calls, result_.configurations);
    std::vector<std::vector<double>> drawn;
    std::vector<std::vector<Solid>> placed;
    std::vector<std::vector<ProxyModels>> models;
    for (std::size_t k = 0; k < count; ++k) {
      drawn.push_back(joints(k));
      placed.push_back(place(scene_, drawn.back()));
      models.push_back(models_of(placed.back()));
    }
    const auto time = [&](const auto& once) {
      return series_cost(
                 [&](std::span<const std::size_t> order) {
                   double sum = 0;
                   for (const std::size_t call : order) sum += once(call % count);
                   keep(sum);
                 },
                 calls, timed_least)
          .ns;
    };
    std::vector<Solid> into;
    result_.kinematics_ns = time([&](std::size_t k) {
      place(scene_, pose_links(scene_, drawn[k]), into);
      return into.empty() ? 0 : into.back().center.x();
    });
    std::vector<ProxyModels> made(scene_.bodies.size());
    result_.models_ns = time([&](std::size_t k) {
      for (std::size_t i = 0; i < made.size(); ++i) made[i] = make_models(placed[k][i]);
      return made.empty() ? 0 : made.back().ball.rounding;
    });
    const auto ask_all = [&](const auto& ask) {
      if (result_.pairs.empty()) return 0.0;
      return time([&](std::size_t k) {
        int hits = 0;
        for (std::size_t i = 0; i < result_.pairs.size(); ++i)
          hits += ask(i, models[k][result_.pairs[i].a], models[k][result_.pairs[i].b]);
        return hits;
      });
    };
    std::vector<Cascade> recommended;  // a list of its own, because cascades cost more beside other data
    for (const PairStudy& pair : result_.pairs) recommended.push_back(pair.cascade);
    result_.cascade_ns = ask_all([&](std::size_t pair, const ProxyModels& a, const ProxyModels& b) {
      return within(recommended[pair], a, b, q_.clearance);
    });
    for (const Level level : enum_values<Level>)
      result_.alone_ns[index_of(level)] =
          ask_all([&, level](std::size_t, const ProxyModels& a, const ProxyModels& b) {
            return accepted(level, a, b, q_.clearance);
          });
  }

  const Scene& scene_;
  const SceneOptions& q_;
  SceneStudy result_;
  std::vector<Solid> placed_;
  std::vector<ProxyModels> models_;
  std::vector<bool> truths_;  ///< by configuration, then pair
};

/// Returns the cost of a cascade on the samples, by weights.
double weight_of(const Cascade& cascade, const PairStudy& pair) {
  double sum = 0;
  for (std::size_t set = 0; set < pair.outcomes.size(); ++set) {
    double once = 0;
    bool decided = false;
    for (std::size_t i = 0; i < cascade.first.size() && !decided; ++i) {
      if (!cascade.first[i]) continue;
      once += level_weight[i];
      decided = (set >> i & 1) != 0;
    }
    if (!decided) once += level_weight[index_of(cascade.last)];
    sum += once * static_cast<double>(pair.outcomes[set]);
  }
  return sum;
}

}  // namespace

std::vector<double> joints_of(const Scene& scene, const SceneOptions& question, std::size_t configuration) {
  if (moves(scene) && question.at.empty()) return draw_joints(scene, question.seed, configuration);
  return joints_at(scene, question.at);
}

Total total_of(const Scene& scene, const SceneStudy& study, Level level, double tolerated) {
  Total t;
  for (const PairStudy& pair : study.pairs) {
    const Score& score = pair.alone[index_of(level)];
    t.decided += pair.decided[index_of(level)];
    t.suffices += is_known(scene, pair) && suffices(pair, level, tolerated);
    t.wrong += score.wrong;
    t.wrong_pairs += score.wrong > 0;
    t.alarm = std::max(t.alarm, score.alarm.length);
    t.missed = std::max(t.missed, score.missed.length);
  }
  return t;
}

bool suffices(const PairStudy& pair, Level level, double tolerated) {
  const Score& s = pair.alone[index_of(level)];
  return s.wrong == 0 || (s.missed.length == 0 && s.alarm.length > 0 && s.alarm.length <= tolerated);
}

bool is_statistical(const PairStudy& pair) {
  return pair.cascade.last == Level::sphere || pair.cascade.last == Level::outer;
}

Level needed(const PairStudy& pair, double tolerated) {
  for (const Level level : {Level::sphere, Level::outer, Level::cylinder, Level::distance})
    if (suffices(pair, level, tolerated)) return level;
  return Level::certified;
}

Cascade recommend(const PairStudy& pair, double tolerated) {
  Cascade best;
  best.last = Level::certified;
  for (const Level last : {Level::sphere, Level::outer, Level::cylinder, Level::distance, Level::certified}) {
    if (last != Level::certified && !suffices(pair, last, tolerated)) continue;
    for (unsigned set = 0; set < 8; ++set) {
      const Cascade cascade{{(set & 1) != 0, (set & 2) != 0, (set & 4) != 0}, last};
      if (weight_of(cascade, pair) < weight_of(best, pair)) best = cascade;
    }
  }
  return best;
}

SceneStudy study_scene(const Scene& scene, const SceneOptions& question) {
  if (scene.bodies.size() > study_cap)
    throw UsageError("more than " + std::to_string(study_cap) + " cylinders");
  return Study(scene, question).run();
}

}  // namespace cyl
