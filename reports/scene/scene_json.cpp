// SPDX-License-Identifier: MIT
#include <utility>

#include "base/json.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "reports/scene/scene_report.hpp"
#include "scenes/shown_pairs.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

std::string dump(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

/// A line a field, and of lists of objects a line each.
std::string layout(const json& all) {
  std::string text;
  for (const auto& [key, value] : all.items()) {
    text += (text.empty() ? "{" : ",\n ") + dump(key) + ":";
    if (!value.is_array() || value.empty() || !value.front().is_object()) {
      text += dump(value);
      continue;
    }
    const char* before = "[\n  ";
    for (const json& line : value) text += std::exchange(before, ",\n  ") + dump(line);
    text += "]";
  }
  return text + "}\n";
}

json plan_json(const Plan& plan) {
  json rungs = json::array();
  for (std::size_t i = 0; i < plan.first.size(); ++i)
    if (plan.first[i]) rungs.push_back(to_string(all_rungs[i]));
  rungs.push_back(to_string(plan.last));
  return rungs;
}

json pair_json(const Scene& scene, const SceneQuestion& q, const PairStudy& pair) {
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
          {"bodies", {pair.a, pair.b}},
          {"samples", pair.samples},
          {"within", pair.within},
          {"least_distance", pair.least},
          {"greatest_distance", pair.greatest},
          {"models", std::move(models)},
          {"needs", to_string(needed(pair, q.tolerated))},
          {"recommended", plan_json(pair.plan)},
          {"recommended_wrong", pair.plan_wrong}};
}

json model_json(const SceneQuestion& q, const SceneStudy& s, Rung rung) {
  const Total t = total_of(s, rung, q.tolerated);
  return {{"model", to_string(rung)}, {"decides", t.decided},         {"suffices", t.suffices},
          {"wrong", t.wrong},         {"wrong_pairs", t.wrong_pairs}, {"false_alarm", t.alarm},
          {"missed", t.missed}};
}

json words_json(const StudyWords& w) {
  return {{"counts", w.counts},     {"left_out", w.left_out},
          {"pairs", w.pairs},       {"configurations", w.configurations},
          {"enough", w.enough},     {"recommended", w.recommended},
          {"cost", w.cost},         {"forgiven", w.forgiven},
          {"capsules", w.capsules}, {"closest", w.closest},
          {"verified", w.verified}};
}

json reason_json(const Reason& reason) {
  json all{{"why", to_string(reason.why)}};
  if (reason.why == Why::first) return all;
  all["pair"] = reason.pair;
  if (reason.why != Why::closest) all["model"] = to_string(reason.model);
  all["length"] = reason.length;
  return all;
}

json seen_json(const SeenPair& seen) {
  json wrong = json::array();
  for (const Rung rung : all_rungs)
    if (seen.wrong[static_cast<std::size_t>(rung)]) wrong.push_back(to_string(rung));
  return {{"distance", seen.distance},
          {"within", seen.within},
          {"wrong", std::move(wrong)},
          {"on_a", vector_json(seen.on_a)},
          {"on_b", vector_json(seen.on_b)}};
}

/// Only the joints that --at takes.
json joints_json(const Scene& scene, const std::vector<double>& values) {
  json joints = json::object();
  for (std::size_t i = 0; i < scene.links.size(); ++i) {
    const Link& link = scene.links[i];
    if (link.motion != Motion::fixed && !link.follow) joints[link.joint] = values[i];
  }
  return joints;
}

json kept_json(const Scene& scene, const Kept& kept) {
  json reasons = json::array(), cylinders = json::array(), pairs = json::array();
  for (const Reason& reason : kept.reasons) reasons.push_back(reason_json(reason));
  for (const Cylinder& c : kept.placed) cylinders.push_back(cylinder_json(c));
  for (const SeenPair& seen : kept.pairs) pairs.push_back(seen_json(seen));
  return {{"configuration", kept.configuration},
          {"reasons", std::move(reasons)},
          {"joints", joints_json(scene, kept.joints)},
          {"cylinders", std::move(cylinders)},
          {"pairs", std::move(pairs)}};
}

}  // namespace

std::string study_json(const Scene& scene, const SceneQuestion& q, const SceneStudy& s) {
  json pairs = json::array(), alone = json::object(), models = json::array(), bodies = json::array(),
       kept = json::array();
  for (const PairStudy& pair : s.pairs) pairs.push_back(pair_json(scene, q, pair));
  for (const Rung rung : all_rungs) {
    alone[to_string(rung)] = s.alone_ns[static_cast<std::size_t>(rung)];
    models.push_back(model_json(q, s, rung));
  }
  for (const Body& body : scene.bodies)
    bodies.push_back({{"name", body.name}, {"link", scene.links[body.link].name}});
  for (const Kept& configuration : kept_configurations(scene, q, s))
    kept.push_back(kept_json(scene, configuration));
  json all{{"file", q.file},
           {"seed", std::to_string(q.seed)},
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
           {"words", words_json(words_of(scene, q, s))},
           {"models", std::move(models)},
           {"bodies", std::move(bodies)},
           {"pairs", std::move(pairs)},
           {"kept", std::move(kept)}};
  if (s.closest)
    all["closest_call"] = {{"a", scene.bodies[s.closest->a].name},
                           {"b", scene.bodies[s.closest->b].name},
                           {"configuration", s.closest->configuration},
                           {"distance", s.closest->distance},
                           {"size", s.closest->size}};
  if (const auto& v = s.verification)
    all["verification"] = {
        {"asked", v->asked}, {"wrong", v->wrong}, {"tolerated", v->tolerated}, {"undecided", v->undecided}};
  return layout(all);
}

}  // namespace cyl
