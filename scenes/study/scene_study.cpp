// SPDX-License-Identifier: MIT
#include "scenes/study/scene_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "base/stopwatch.hpp"
#include "base/usage_error.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// The most configurations that are timed, and the most pairs in all of them. Then the models fit into the
/// near memory of a processor, and a round ends before other processes get their turn.
constexpr std::size_t timed_cap = 32, timed_pairs_cap = 2000;
constexpr std::chrono::duration<double> timed_least = std::chrono::milliseconds(5);

/// The most models of bodies that are made at a time, and samples that are looked at without a look at the
/// time.
constexpr std::size_t models_cap = 20'000, samples_cap = 500'000;
/// Pairs that a thread takes at a time.
constexpr std::size_t block_size = 32;

/// The results of the samples of one pair, besides its study.
struct Samples {
  std::vector<bool> within;  ///< by configuration
  std::size_t asked_referee = 0, undecided = 0;
  std::optional<ClosestCall> closest;
  Verification verification;
};

class Study {
 public:
  Study(const Scene& scene, const SceneOptions& question)
      : scene_(scene), q_(question), began_(std::chrono::steady_clock::now()) {
    result_.bodies = scene.bodies.size();
    result_.drawn = moves(scene) && q_.at.empty();
    result_.configurations = result_.drawn ? q_.configurations : 1;
    static_cast<void>(joints(0));  // throws here, not in another thread
    list_pairs();
    samples_.resize(result_.pairs.size());
  }

  SceneStudy run() {
    each_sample(true, [this](std::size_t pair, std::size_t k, const auto& placed, const auto& models) {
      observe(pair, k, placed, models);
    });
    for (PairStudy& pair : result_.pairs) pair.cascade = recommend(pair, q_.tolerated);
    check_cascades();
    add_up();
    if (q_.prove) prove();
    measure();
    return std::move(result_);
  }

 private:
  std::vector<double> joints(std::size_t configuration) const { return joints_of(scene_, q_, configuration); }

  void list_pairs() {
    const PairRule rule(scene_);
    const auto add = [&](std::size_t a, std::size_t b) {
      PairStudy& pair = result_.pairs.emplace_back();
      pair.a = a;
      pair.b = b;
    };
    const auto is_asked = [&](PairRule::Reason reason) {
      return reason == PairRule::Reason::checked ||
             (reason == PairRule::Reason::floating && !q_.at.empty());  // as it is placed
    };
    std::size_t asked = 0;
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        const PairRule::Reason reason = rule.reason(scene_.bodies[a], scene_.bodies[b]);
        ++result_.pairs_by_reason[static_cast<std::size_t>(reason)];
        if (is_asked(reason) && ++asked <= listed_cap) add(a, b);
      }
    }
    if (asked <= listed_cap) return;
    result_.pairs.clear();
    for (const Body& body : scene_.bodies) result_.reaches.push_back(reach_of(scene_, body));
    const auto near = near_pairs(result_.reaches, q_.clearance, near_cap, [&](std::size_t a, std::size_t b) {
      return is_asked(rule.reason(scene_.bodies[a], scene_.bodies[b]));
    });
    if (near.size() > near_cap)
      throw InputError("more than " + std::to_string(near_cap) + " pairs of shapes may come near each other");
    for (const auto& [a, b] : near) add(a, b);
    result_.far = asked - near.size();
  }

  // Looks at all pairs in all configurations, those of a pair in order. In the first pass, the deadline
  // makes the configurations fewer.
  template <class Look>
  void each_sample(bool first_pass, const Look& look) {
    const std::size_t pairs = result_.pairs.size(), blocks = (pairs + block_size - 1) / block_size;
    if (pairs == 0) return;
    const std::size_t chunk =
        std::clamp<std::size_t>(std::min(models_cap / result_.bodies, samples_cap / pairs), 1, 1000);
    std::set<std::size_t> used;
    for (const PairStudy& pair : result_.pairs) used.insert({pair.a, pair.b});
    std::vector<std::vector<Solid>> placed(chunk);
    std::vector<std::vector<ProxyModels>> models(chunk);
    for (std::size_t first = 0; first < result_.configurations; first += chunk) {
      const std::size_t count = std::min(chunk, result_.configurations - first);
      on_all_cores(
          count, q_.workforce.threads,
          [&](std::size_t i) {
            placed[i] = place(scene_, joints(first + i));
            models[i].resize(placed[i].size());
            for (const std::size_t body : used) models[i][body] = make_models(placed[i][body]);
          },
          [](std::size_t) {});
      on_all_cores(
          blocks, q_.workforce.threads,
          [&](std::size_t block) {
            for (std::size_t p = block * block_size; p < std::min(pairs, (block + 1) * block_size); ++p)
              for (std::size_t i = 0; i < count; ++i) look(p, first + i, placed[i], models[i]);
          },
          [&](std::size_t done) {
            if (!q_.workforce.show) return;
            const double at =
                static_cast<double>(first) + static_cast<double>(count * done) / static_cast<double>(blocks);
            q_.workforce.show(at / static_cast<double>(result_.configurations),
                              fmt::format("{} of {} pairs in {} configurations",
                                          first_pass ? "samples" : "checks", pairs, result_.configurations));
          });
      if (first_pass && samples_end()) result_.configurations = first + count;
    }
  }

  bool samples_end() const {
    const auto now = std::chrono::steady_clock::now(), end = q_.workforce.deadline;
    return end != std::chrono::steady_clock::time_point::max() &&
           now >= (q_.prove ? began_ + (end - began_) / 2 : end);
  }

  void observe(std::size_t index, std::size_t configuration, const std::vector<Solid>& placed,
               const std::vector<ProxyModels>& models) {
    PairStudy& pair = result_.pairs[index];
    Samples& samples = samples_[index];
    const ProxyModels &a = models[pair.a], &b = models[pair.b];
    const Distance d = distance(a.solid, b.solid);
    std::array<Proximity, level_count> seen;
    seen.fill(Proximity::apart);  // which a model around the solids proves for all
    std::optional<bool> truth;
    std::size_t set = 0;
    bool decided = false;
    for (const Level level : enum_values<Level>) {
      if (seen[0] == Proximity::apart && level > Level::outer) break;
      Proximity& here = seen[index_of(level)];
      here = level == Level::distance ? proximity_of(d, q_.clearance) : proximity(level, a, b, q_.clearance);
      if (here == Proximity::unclear) continue;
      if (index_of(level) < 3) set |= std::size_t{1} << index_of(level);
      if (!std::exchange(decided, true)) ++pair.decided[index_of(level)];
      if (level == Level::certified || level == Level::sphere) truth = here == Proximity::within;
    }
    ++pair.outcomes[set];
    if (!truth) {
      ++samples.asked_referee;
      truth = referee_within({placed[pair.a], placed[pair.b]}, q_.clearance);
      if (!truth) ++samples.undecided;
    }
    const bool is_within = truth.value_or(true);
    for (const Level level : enum_values<Level>) {
      const Proximity said = seen[index_of(level)];
      score(pair.alone[index_of(level)],
            level == Level::inner      ? said == Proximity::within
            : level == Level::distance ? !(d.value > q_.clearance)
                                       : said != Proximity::apart,
            is_within, d.value);
    }
    pair.least = pair.samples == 0 ? d.value : std::min(pair.least, d.value);
    pair.greatest = pair.samples == 0 ? d.value : std::max(pair.greatest, d.value);
    ++pair.samples;
    pair.within += is_within;
    pair.met += is_within && shapes_meet(pair, placed);
    if (!samples.closest || miss(d.value) < miss(samples.closest->distance))
      samples.closest =
          ClosestCall{pair.a, pair.b, configuration, d.value, size_of({placed[pair.a], placed[pair.b]})};
    samples.within.push_back(is_within);
  }

  /// Whether shapes that two solids stand for are within the clearance, if the solids are.
  bool shapes_meet(const PairStudy& pair, const std::vector<Solid>& placed) const {
    const Body &a = scene_.bodies[pair.a], &b = scene_.bodies[pair.b];
    if (!a.box && !b.box) return true;
    if ((a.box && !a.inner) || (b.box && !b.inner)) return false;
    return referee_within({inner_at(a, placed[pair.a]), inner_at(b, placed[pair.b])}, q_.clearance) == true;
  }

  double miss(double distance) const { return std::fabs(distance - q_.clearance); }

  void score(Score& s, bool said, bool is_within, double d) const {
    if (said == is_within) return;
    ++s.wrong;
    double& worst = is_within ? s.missed : s.alarm;
    worst = std::max(worst, is_within ? q_.clearance - d : d - q_.clearance);
  }

  // Compares what is recommended with the truths found above. The referee judges some of it anew.
  void check_cascades() {
    const std::size_t pairs = result_.pairs.size(),
                      stride = pairs * result_.configurations / verified_cap + 1;
    each_sample(false, [&](std::size_t i, std::size_t k, const auto& placed, const auto& models) {
      PairStudy& pair = result_.pairs[i];
      const bool said = within(pair.cascade, models[pair.a], models[pair.b], q_.clearance);
      pair.cascade_wrong += said != samples_[i].within[k];
      if ((k * pairs + i) % stride == 0)
        samples_[i].verification.add({placed[pair.a], placed[pair.b]}, q_.clearance, q_.tolerated, said);
    });
  }

  void add_up() {
    for (const Samples& samples : samples_) {
      result_.asked_referee += samples.asked_referee;
      result_.undecided += samples.undecided;
      result_.verification.add(samples.verification);
      const auto rank = [&](const ClosestCall& c) { return std::pair(miss(c.distance), c.configuration); };
      if (!result_.closest || rank(*samples.closest) < rank(*result_.closest))
        result_.closest = samples.closest;
    }
  }

  void prove() {
    BodyPairs pairs, others;
    std::vector<double> seen;
    std::set<std::pair<std::size_t, std::size_t>> checked;
    for (const PairStudy& pair : result_.pairs) {
      pairs.emplace_back(pair.a, pair.b);
      seen.push_back(pair.least);
    }
    if (q_.prove_others) checked.insert(pairs.begin(), pairs.end());
    for (std::size_t b = 0; b < scene_.bodies.size() && q_.prove_others; ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        const std::size_t one = scene_.bodies[a].link, other = scene_.bodies[b].link;
        if (one != other && is_legal({scene_.bodies[a].solid, scene_.bodies[b].solid}) &&
            !is_far(result_, a, b, q_.clearance) && !carries_directly(scene_, one, other) &&
            !checked.contains({a, b}))
          others.emplace_back(a, b);
      }
    }
    result_.motions = prove_motions(
        scene_, pairs, seen, {.clearance = q_.clearance, .seed = q_.seed, .workforce = q_.workforce}, others);
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
  const std::chrono::steady_clock::time_point began_;
  std::vector<Samples> samples_;  ///< by pair
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

Total total_of(const SceneStudy& study, Level level, double tolerated) {
  Total t;
  for (const PairStudy& pair : study.pairs) {
    const Score& score = pair.alone[index_of(level)];
    t.decided += pair.decided[index_of(level)];
    t.suffices += is_known(pair) && suffices(pair, level, tolerated);
    t.wrong += score.wrong;
    t.wrong_pairs += score.wrong > 0;
    t.alarm = std::max(t.alarm, score.alarm);
    t.missed = std::max(t.missed, score.missed);
  }
  return t;
}

bool suffices(const PairStudy& pair, Level level, double tolerated) {
  const Score& s = pair.alone[index_of(level)];
  return s.wrong == 0 || (s.missed == 0 && s.alarm > 0 && s.alarm <= tolerated);
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

bool is_far(const SceneStudy& study, std::size_t a, std::size_t b, double clearance) {
  return !study.reaches.empty() && gap_between(study.reaches[a], study.reaches[b]) > clearance;
}

SceneStudy study_scene(const Scene& scene, const SceneOptions& question) {
  return Study(scene, question).run();
}

}  // namespace cyl
