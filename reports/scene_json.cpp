// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "reports/scene_study.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

json plan_json(const Plan& plan) {
  json rungs = json::array();
  for (std::size_t i = 0; i < plan.first.size(); ++i)
    if (plan.first[i]) rungs.push_back(to_string(all_rungs[i]));
  rungs.push_back(to_string(plan.last));
  return rungs;
}

json pair_json(const Scene& scene, const PairStudy& pair) {
  json models = json::array();
  for (const Rung rung : all_rungs) {
    const auto i = static_cast<std::size_t>(rung);
    const Score& s = pair.alone[i];
    models.push_back({{"model", to_string(rung)},
                      {"decides", pair.decided[i]},
                      {"wrong", s.wrong},
                      {"false_alarm", s.alarm},
                      {"missed", s.missed}});
  }
  return {{"a", scene.bodies[pair.a].name},
          {"b", scene.bodies[pair.b].name},
          {"samples", pair.samples},
          {"within", pair.within},
          {"least_distance", pair.least},
          {"greatest_distance", pair.greatest},
          {"models", std::move(models)},
          {"recommended", plan_json(pair.plan)},
          {"recommended_wrong", pair.plan_wrong}};
}

}  // namespace

std::string study_json(const Scene& scene, const SceneQuestion& q, const SceneStudy& s) {
  json pairs = json::array(), alone = json::object();
  for (const PairStudy& pair : s.pairs) pairs.push_back(pair_json(scene, pair));
  for (const Rung rung : all_rungs) alone[to_string(rung)] = s.alone_ns[static_cast<std::size_t>(rung)];
  json all{{"seed", q.seed},
           {"clearance", q.clearance},
           {"tolerated", q.tolerated},
           {"configurations", s.configurations},
           {"cylinders", s.bodies},
           {"left_out", scene.left_out},
           {"notes", scene.notes},
           {"pairs_checked", s.pairs_by_reason[0]},
           {"pairs_same_link", s.pairs_by_reason[1]},
           {"pairs_adjacent", s.pairs_by_reason[2]},
           {"pairs_disabled", s.pairs_by_reason[3]},
           {"asked_referee", s.asked_referee},
           {"undecided", s.undecided},
           {"ns_per_configuration",
            {{"kinematics", s.kinematics_ns},
             {"models", s.models_ns},
             {"recommended", s.plan_ns},
             {"alone", std::move(alone)}}},
           {"pairs", std::move(pairs)}};
  if (s.closest)
    all["closest_call"] = {{"a", scene.bodies[s.closest->a].name},
                           {"b", scene.bodies[s.closest->b].name},
                           {"configuration", s.closest->configuration},
                           {"distance", s.closest->distance},
                           {"size", s.closest->size}};
  if (const auto& v = s.verification)
    all["verification"] = {
        {"asked", v->asked}, {"wrong", v->wrong}, {"tolerated", v->tolerated}, {"undecided", v->undecided}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace cyl
