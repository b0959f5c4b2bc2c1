// SPDX-License-Identifier: MIT
#include "scenes/shown_pairs.hpp"

#include <algorithm>
#include <utility>

#include "solver/distance.hpp"

namespace cyl {
namespace {

class Keeper {
 public:
  Keeper(const SceneQuestion& question, const SceneStudy& study) : q_(question), s_(study) {}

  std::vector<Kept> chosen() {
    for (std::size_t k = 0; k < std::min(first_kept_cap, s_.configurations); ++k) keep(k, {});
    if (s_.closest) keep_closest(*s_.closest);
    for (const Rung rung : all_rungs) {
      keep_worst(Why::alarm, rung, &Score::alarm, &Score::alarm_in);
      keep_worst(Why::missed, rung, &Score::missed, &Score::missed_in);
    }
    return std::move(kept_);
  }

 private:
  void keep(std::size_t configuration, Reason reason) {
    auto at = std::find_if(kept_.begin(), kept_.end(),
                           [&](const Kept& kept) { return kept.configuration == configuration; });
    if (at == kept_.end()) {
      at = kept_.emplace(at);
      at->configuration = configuration;
    }
    at->reasons.push_back(reason);
  }

  void keep_closest(const ClosestCall& call) {
    const auto pair = std::find_if(s_.pairs.begin(), s_.pairs.end(),
                                   [&](const PairStudy& p) { return p.a == call.a && p.b == call.b; });
    keep(call.configuration,
         {Why::closest, static_cast<std::size_t>(pair - s_.pairs.begin()), {}, call.distance - q_.clearance});
  }

  void keep_worst(Why why, Rung rung, double Score::*length, std::size_t Score::*where) {
    const auto score = [&](std::size_t pair) -> const Score& {
      return s_.pairs[pair].alone[static_cast<std::size_t>(rung)];
    };
    std::vector<std::size_t> worst;
    for (std::size_t i = 0; i < s_.pairs.size(); ++i)
      if (score(i).*length > 0) worst.push_back(i);
    const std::size_t count = std::min(worst_kept_cap, worst.size());
    std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(count), worst.end(),
                      [&](std::size_t i, std::size_t j) {
                        return std::pair(-(score(i).*length), i) < std::pair(-(score(j).*length), j);
                      });
    worst.resize(count);
    for (const std::size_t i : worst) keep(score(i).*where, {why, i, rung, score(i).*length});
  }

  const SceneQuestion& q_;
  const SceneStudy& s_;
  std::vector<Kept> kept_;
};

SeenPair see(const Models& a, const Models& b, const Pair& solids, double clearance) {
  SeenPair seen;
  const Distance d = distance(a.solid, b.solid);
  seen.distance = d.value;
  seen.on_a = a.solid.center + d.on_a;
  seen.on_b = b.solid.center + d.on_b;
  const Look proof = look(Rung::certified, a, b, clearance);
  seen.within =
      proof == Look::closer ? referee_within(solids, clearance).value_or(true) : proof == Look::within;
  for (const Rung rung : all_rungs)
    seen.wrong[static_cast<std::size_t>(rung)] = trusted(rung, a, b, clearance) != seen.within;
  return seen;
}

}  // namespace

std::vector<Kept> kept_configurations(const Scene& scene, const SceneQuestion& question,
                                      const SceneStudy& study) {
  std::vector<Kept> all = Keeper(question, study).chosen();
  for (Kept& kept : all) {
    kept.joints = joints_of(scene, question, kept.configuration);
    kept.placed = place(scene, kept.joints);
    const std::vector<Models> models = models_of(kept.placed, question.clearance);
    for (const PairStudy& pair : study.pairs)
      kept.pairs.push_back(see(models[pair.a], models[pair.b], {kept.placed[pair.a], kept.placed[pair.b]},
                               question.clearance));
  }
  return all;
}

}  // namespace cyl
