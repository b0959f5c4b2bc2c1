// SPDX-License-Identifier: MIT
#include <utility>

#include "base/json.hpp"
#include "base/statistics.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "reports/scene/scene_report.hpp"
#include "scenes/study/shown_pairs.hpp"

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
                      {"false_alarm", s.alarm.length},
                      {"missed", s.missed.length}});
  }
  return {{"a", scene.bodies[pair.a].name},
          {"b", scene.bodies[pair.b].name},
          {"bodies", {pair.a, pair.b}},
          {"samples", pair.samples},
          {"known", is_known(scene, pair)},
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

json words_json(const StudyWords& w) {
  return {{"counts", w.counts},     {"left_out", w.left_out},
          {"pairs", w.pairs},       {"configurations", w.configurations},
          {"enough", w.enough},     {"recommended", w.recommended},
          {"remarks", w.remarks},   {"cost", w.cost},
          {"forgiven", w.forgiven}, {"capsules", w.capsules},
          {"rounding", w.rounding}, {"closest", w.closest},
          {"verified", w.verified}, {"motions", w.motions}};
}

json highlight_json(const Highlight& highlight) {
  json all{{"why", to_string(highlight.reason)}};
  if (highlight.reason == Reason::first) return all;
  all["pair"] = highlight.pair;
  if (highlight.reason != Reason::closest) all["model"] = to_string(highlight.model);
  all["length"] = highlight.length;
  return all;
}

json sample_json(const Sample& sample) {
  json wrong = json::array();
  for (const Level level : enum_values<Level>)
    if (sample.wrong[index_of(level)]) wrong.push_back(to_string(level));
  return {{"distance", sample.distance},
          {"within", sample.within},
          {"wrong", std::move(wrong)},
          {"on_a", vector_json(sample.on_a)},
          {"on_b", vector_json(sample.on_b)}};
}

/// Returns only the joints that --at takes.
json joints_json(const Scene& scene, const std::vector<double>& values) {
  json joints = json::object();
  for (std::size_t i = 0; i < scene.links.size(); ++i) {
    const Link& link = scene.links[i];
    if (link.motion != Motion::fixed && !link.follow) joints[link.joint] = values[i];
  }
  return joints;
}

json pose_json(const Pose& pose) {
  json axes = json::array();
  for (int k = 0; k < 3; ++k) axes.push_back(vector_json(pose.linear().col(k)));
  return {{"center", vector_json(pose.translation())}, {"axes", std::move(axes)}};
}

/// Returns the poses of the shapes that solids only bound: boxes, and the boxes of meshes.
json boxes_json(const Scene& scene, const Shown& shown) {
  json boxes = json::array();
  const std::vector<Pose> poses = pose_links(scene, shown.joints);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (!body.box) continue;
    boxes.push_back({{"body", i}});
    boxes.back().update(pose_json(poses[body.link] * body.box->pose));
  }
  return boxes;
}

const char* motion_word(const Link& link) {
  if (link.held) return "held";
  return link.motion == Motion::turn ? "turn" : link.motion == Motion::slide ? "slide" : "fixed";
}

/// Returns what forward kinematics needs about a link and the joint that carries it.
json link_json(const Link& link) {
  json all{{"name", link.name}, {"motion", motion_word(link)}, {"origin", pose_json(link.origin)}};
  if (link.parent) all["parent"] = *link.parent;
  if (!link.joint.empty()) all["joint"] = link.joint;
  if (link.motion == Motion::fixed) return all;
  all["axis"] = vector_json(link.axis);
  if (!link.follow) all["limits"] = {link.low, link.high};
  if (const auto& f = link.follow)
    all["follows"] = {{"link", f->link}, {"multiplier", f->multiplier}, {"offset", f->offset}};
  return all;
}

json body_json(const Scene& scene, const Body& body) {
  json all{{"name", body.name},
           {"link", scene.links[body.link].name},
           {"on", body.link},
           {"solid", cylinder_json(body.solid)}};
  if (body.box)
    all["holds"] = {{"shape", body.box->shape},
                    {"size", vector_json(body.box->size)},
                    {"pose", pose_json(body.box->pose)}};
  return all;
}

json shown_json(const Scene& scene, const Shown& shown) {
  json reasons = json::array(), cylinders = json::array(), pairs = json::array();
  for (const Highlight& highlight : shown.highlights) reasons.push_back(highlight_json(highlight));
  for (const Cylinder& c : shown.placed) cylinders.push_back(cylinder_json(c));
  for (const Sample& sample : shown.pairs) pairs.push_back(sample_json(sample));
  return {{"configuration", shown.configuration},       {"reasons", std::move(reasons)},
          {"joints", joints_json(scene, shown.joints)}, {"cylinders", std::move(cylinders)},
          {"boxes", boxes_json(scene, shown)},          {"pairs", std::move(pairs)}};
}

/// The joints are those of a refuted pair. The bound is that of a proved one.
json proof_json(const Scene& scene, const MotionProof& proof) {
  json joints = json::object();
  for (const std::size_t link : proof.between) joints[scene.links[link].joint] = proof.joints[link];
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
  all["motions_checked"] = {{"configurations", study.against}, {"wrong", study.contradicted}};
}

}  // namespace

std::string study_json(const Scene& scene, const SceneOptions& q, const SceneStudy& s) {
  json left_out = json::array(), pairs = json::array(), alone = json::object(), models = json::array(),
       links = json::array(), bodies = json::array(), kept = json::array(), roundings = json::array(),
       rounded = json::array();
  for (const auto& [shape, link] : scene.left_out) left_out.push_back(shape + " of " + link);
  for (const PairStudy& pair : s.pairs) pairs.push_back(pair_json(scene, q, pair));
  for (const RoundingCost& r : s.roundings) {
    roundings.push_back({{"rounding", r.rounding},
                         {"pairs", r.cheaper},
                         {"false_alarms", r.alarms},
                         {"all_rounded", r.all_rounded}});
    rounded.push_back(r.ns);
  }
  for (const Level level : enum_values<Level>) {
    alone[to_string(level)] = s.alone_ns[index_of(level)];
    models.push_back(model_json(q, s, level));
  }
  for (const Link& link : scene.links) links.push_back(link_json(link));
  for (const Body& body : scene.bodies) bodies.push_back(body_json(scene, body));
  for (const Shown& configuration : shown_configurations(scene, q, s))
    kept.push_back(shown_json(scene, configuration));
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
           {"asked_referee", s.asked_referee},
           {"undecided", s.undecided},
           {"ns_per_configuration",
            {{"kinematics", s.kinematics_ns},
             {"models", s.models_ns},
             {"recommended", s.cascade_ns},
             {"rounded", std::move(rounded)},
             {"alone", std::move(alone)}}},
           {"words", words_json(words_of(scene, q, s))},
           {"models", std::move(models)},
           {"roundings", std::move(roundings)},
           {"links", std::move(links)},
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
  if (s.motions) add_motions(all, scene, *s.motions);
  if (!scene.srdf.empty()) all["srdf"] = scene.srdf;
  return layout(all);
}

}  // namespace cyl
