// SPDX-License-Identifier: MIT
#include <utility>

#include "base/json.hpp"
#include "base/statistics.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "reports/scene/scene_report.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

std::string dump(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

/// Puts each field on a line. In a list of objects, each object has its own line.
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

json cascade_json(const Cascade& cascade) {
  json levels = json::array();
  for (std::size_t i = 0; i < cascade.first.size(); ++i)
    if (cascade.first[i]) levels.push_back(to_string(enum_values<Level>[i]));
  levels.push_back(to_string(cascade.last));
  return levels;
}

json pair_json(const Scene& scene, const SceneOptions& q, const PairStudy& pair) {
  const RateBounds rate = rate_bounds(pair.samples, pair.within);
  json models = json::array();
  for (const Level level : enum_values<Level>) {
    const auto i = index_of(level);
    const Score& s = pair.alone[i];
    models.push_back({{"model", to_string(level)},
                      {"decides", pair.decided[i]},
                      {"wrong", s.wrong},
                      {"false_alarm", s.alarm},
                      {"missed", s.missed}});
  }
  return {{"a", scene.bodies[pair.a].name},
          {"b", scene.bodies[pair.b].name},
          {"bodies", {pair.a, pair.b}},
          {"samples", pair.samples},
          {"known", is_known(pair)},
          {"within", pair.within},
          {"within_rate", {rate.lower, rate.upper}},
          {"least_distance", pair.least},
          {"greatest_distance", pair.greatest},
          {"models", std::move(models)},
          {"needs", to_string(needed(pair, q.tolerated))},
          {"recommended", cascade_json(pair.cascade)},
          {"recommended_wrong", pair.cascade_wrong}};
}

json model_json(const SceneOptions& q, const SceneStudy& s, Level level) {
  const Total t = total_of(s, level, q.tolerated);
  return {{"model", to_string(level)}, {"decides", t.decided},         {"suffices", t.suffices},
          {"wrong", t.wrong},          {"wrong_pairs", t.wrong_pairs}, {"false_alarm", t.alarm},
          {"missed", t.missed}};
}

json pose_json(const Pose& pose) {
  json axes = json::array();
  for (int k = 0; k < 3; ++k) axes.push_back(vector_json(pose.linear().col(k)));
  return {{"center", vector_json(pose.translation())}, {"axes", std::move(axes)}};
}

json body_json(const Scene& scene, const Body& body) {
  json all{{"name", body.name}, {"link", scene.links[body.link].name}, {"solid", solid_json(body.solid)}};
  if (body.box)
    all["holds"] = {{"shape", body.box->shape},
                    {"size", vector_json(body.box->size)},
                    {"pose", pose_json(body.box->pose)}};
  return all;
}

/// The joints are those of a refuted pair. The bound is that of a proved one.
json proof_json(const Scene& scene, const MotionProof& proof) {
  json joints = json::object();
  for (std::size_t i = 0; i < proof.between.size(); ++i)
    joints[scene.links[proof.between[i]].joint] = proof.joints[i];
  return {{"a", scene.bodies[proof.a].name},
          {"b", scene.bodies[proof.b].name},
          {"bodies", {proof.a, proof.b}},
          {"verdict", to_string(proof.verdict)},
          {"bound", proof.bound},
          {"least_seen", proof.least},
          {"joints", std::move(joints)},
          {"boxes", proof.boxes},
          {"open_share", proof.open_share}};
}

json exemption_json(const Scene& scene, const ExemptionProof& proof) {
  const Exemption& said = scene.exemptions[proof.exemption];
  json bodies = json::array();
  for (const MotionProof& pair : proof.bodies) bodies.push_back(proof_json(scene, pair));
  return {{"link1", scene.links[said.a].name},
          {"link2", scene.links[said.b].name},
          {"verdict", to_string(proof.verdict)},
          {"not_looked_at", proof.not_looked_at},
          {"pairs", std::move(bodies)}};
}

void add_motions(json& all, const Scene& scene, const MotionStudy& study) {
  json motions = json::array(), exemptions = json::array();
  for (const MotionProof& proof : study.pairs) motions.push_back(proof_json(scene, proof));
  for (const ExemptionProof& proof : study.exemptions) exemptions.push_back(exemption_json(scene, proof));
  all["motions"] = std::move(motions);
  all["exemptions"] = std::move(exemptions);
  all["motions_cpu_ms"] = study.ms;
  all["motions_wrong"] = study.contradicted;
}

}  // namespace

std::string study_json(const Scene& scene, const SceneOptions& q, const SceneStudy& s) {
  json left_out = json::array(), pairs = json::array(), alone = json::object(), models = json::array(),
       bodies = json::array();
  for (const auto& [shape, link] : scene.left_out) left_out.push_back(shape + " of " + link);
  for (const PairStudy& pair : s.pairs) pairs.push_back(pair_json(scene, q, pair));
  for (const Level level : enum_values<Level>) {
    alone[to_string(level)] = s.alone_ns[index_of(level)];
    models.push_back(model_json(q, s, level));
  }
  for (const Body& body : scene.bodies) bodies.push_back(body_json(scene, body));
  json all{{"file", q.file},
           {"seed", std::to_string(q.seed)},
           {"clearance", q.clearance},
           {"tolerated", q.tolerated},
           {"configurations", s.configurations},
           {"cylinders", s.bodies},
           {"left_out", std::move(left_out)},
           {"not_moved", joints_held_between(scene, s)},
           {"notes", scene.notes},
           {"pairs_checked", s.pairs_by_reason[0]},
           {"pairs_same_body", s.pairs_by_reason[1]},
           {"pairs_adjacent", s.pairs_by_reason[2]},
           {"pairs_disabled", s.pairs_by_reason[3]},
           {"pairs_floating", s.pairs_by_reason[4]},
           {"pairs_far", s.far},
           {"asked_referee", s.asked_referee},
           {"undecided", s.undecided},
           {"ns_per_configuration",
            {{"kinematics", s.kinematics_ns},
             {"models", s.models_ns},
             {"recommended", s.cascade_ns},
             {"alone", std::move(alone)}}},
           {"models", std::move(models)},
           {"bodies", std::move(bodies)},
           {"pairs", std::move(pairs)}};
  if (s.closest)
    all["closest_call"] = {{"a", scene.bodies[s.closest->a].name},
                           {"b", scene.bodies[s.closest->b].name},
                           {"configuration", s.closest->configuration},
                           {"distance", s.closest->distance},
                           {"size", s.closest->size}};
  const Verification& v = s.verification;
  all["verification"] = {
      {"asked", v.asked}, {"wrong", v.wrong}, {"tolerated", v.tolerated}, {"undecided", v.undecided}};
  if (s.motions) add_motions(all, scene, *s.motions);
  if (!scene.srdf.empty()) all["srdf"] = scene.srdf;
  return layout(all);
}

}  // namespace cyl
