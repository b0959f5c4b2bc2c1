// SPDX-License-Identifier: MIT
#include "scenes/study/shown_pairs.hpp"

#include <algorithm>
#include <utility>

#include "solver/distance.hpp"

namespace cyl {
namespace {

class Chooser {
 public:
  Chooser(const SceneOptions& question, const SceneStudy& study) : q_(question), s_(study) {}

  std::vector<Shown> chosen() {
    for (std::size_t k = 0; k < std::min(first_shown_cap, s_.configurations); ++k) add(k, {});
    if (s_.closest) add_closest(*s_.closest);
    for (const Level level : enum_values<Level>) {
      add_worst(Reason::alarm, level, &Score::alarm);
      add_worst(Reason::missed, level, &Score::missed);
    }
    return std::move(shown_);
  }

 private:
  void add(std::size_t configuration, Highlight highlight) {
    auto at = std::find_if(shown_.begin(), shown_.end(),
                           [&](const Shown& shown) { return shown.configuration == configuration; });
    if (at == shown_.end()) {
      at = shown_.emplace(at);
      at->configuration = configuration;
    }
    at->highlights.push_back(highlight);
  }

  void add_closest(const ClosestCall& call) {
    const auto pair = std::find_if(s_.pairs.begin(), s_.pairs.end(),
                                   [&](const PairStudy& p) { return p.a == call.a && p.b == call.b; });
    add(call.configuration, {Reason::closest,
                             static_cast<std::size_t>(pair - s_.pairs.begin()),
                             {},
                             call.distance - q_.clearance});
  }

  void add_worst(Reason reason, Level level, Extreme Score::*extreme) {
    const auto of = [&](std::size_t pair) { return s_.pairs[pair].alone[index_of(level)].*extreme; };
    std::vector<std::size_t> worst;
    for (std::size_t i = 0; i < s_.pairs.size(); ++i)
      if (of(i).length > 0) worst.push_back(i);
    std::stable_sort(worst.begin(), worst.end(),
                     [&](std::size_t i, std::size_t j) { return of(i).length > of(j).length; });
    worst.resize(std::min(worst_shown_cap, worst.size()));
    for (const std::size_t i : worst) add(of(i).configuration, {reason, i, level, of(i).length});
  }

  const SceneOptions& q_;
  const SceneStudy& s_;
  std::vector<Shown> shown_;
};

Sample sample_of(const ProxyModels& a, const ProxyModels& b, const Pair& solids, double clearance) {
  Sample sample;
  const Distance d = distance(a.solid, b.solid);
  sample.distance = d.value;
  sample.on_a = a.solid.center + d.on_a;
  sample.on_b = b.solid.center + d.on_b;
  const Proximity proof = proximity(Level::certified, a, b, clearance);
  sample.within = proof == Proximity::unclear ? referee_within(solids, clearance).value_or(true)
                                              : proof == Proximity::within;
  for (const Level level : enum_values<Level>)
    sample.wrong[index_of(level)] = accepted(level, a, b, clearance) != sample.within;
  return sample;
}

}  // namespace

std::vector<Shown> shown_configurations(const Scene& scene, const SceneOptions& question,
                                        const SceneStudy& study) {
  std::vector<Shown> all = Chooser(question, study).chosen();
  for (Shown& shown : all) {
    shown.joints = joints_of(scene, question, shown.configuration);
    shown.placed = place(scene, shown.joints);
    const std::vector<ProxyModels> models = models_of(shown.placed);
    for (const PairStudy& pair : study.pairs)
      shown.pairs.push_back(sample_of(models[pair.a], models[pair.b],
                                      {shown.placed[pair.a], shown.placed[pair.b]}, question.clearance));
  }
  return all;
}

}  // namespace cyl
