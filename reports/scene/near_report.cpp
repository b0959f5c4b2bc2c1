// SPDX-License-Identifier: MIT
#include "reports/scene/near_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/json.hpp"
#include "corpus/pairs/pair_json.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

const char* word_of(Proof proof) {
  switch (proof) {
    case Proof::direction:
      return "direction";
    case Proof::point:
      return "point";
    case Proof::points:
      return "points";
    case Proof::none:
      break;
  }
  return "none";
}

std::string name_of(const NearStudy& study, std::uint32_t index) {
  return study.names.empty() ? std::to_string(index) : study.names[index];
}

json near_pair_json(const NearPair& pair) {
  return {{"a", pair.bodies.first},         {"b", pair.bodies.second},
          {"distance", pair.distance},      {"error", pair.error},
          {"within", pair.within},          {"certificate", word_of(pair.proof)},
          {"on_a", vector_json(pair.on_a)}, {"on_b", vector_json(pair.on_b)}};
}

std::string check_text(const ClosePairsCheck& check) {
  const auto& [referee, certificates, referee_ms, certificates_ms] = check;
  return fmt::format(
      "referee: {} pairs judged, {} wrong, {} not proved, {:.0f} ms\n"
      "certificates: {} checked, {} failed, {} pairs without one, {:.0f} ms\n",
      referee.asked, referee.wrong, referee.undecided, referee_ms, certificates.checked, certificates.failed,
      certificates.undecided, certificates_ms);
}

/// Returns a field of CSV, in quotation marks if it needs them.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string near_text(const NearStudy& study, std::size_t listed) {
  const ClosePairs& s = study.pairs;
  std::string text = fmt::format(
      "{} cylinders\n{} pairs with boxes that meet: {} within {}, {} undecided\n"
      "decided by: spheres {}, cylinders {}, distances {}, proofs {}\n"
      "CPU time: models {:.1f} ms, tree of boxes {:.1f} ms, decisions {:.1f} ms\n",
      s.bodies, s.candidates.size(), s.within.size(), study.clearance, s.undecided,
      s.decided[index_of(Level::sphere)], s.decided[index_of(Level::cylinder)],
      s.decided[index_of(Level::distance)], s.decided[index_of(Level::certified)], s.prepare_ms, s.tree_ms,
      s.cascade_ms);
  if (study.check) text += check_text(*study.check);
  const std::size_t count = std::min(listed, study.nearest.size());
  if (count > 0) text += fmt::format("{:>24}  {:11}  pair\n", "distance", "certificate");
  for (const NearPair& pair : std::span(study.nearest).first(count))
    text += fmt::format("{:>24}  {:11}  {} - {}\n", pair.distance, word_of(pair.proof),
                        name_of(study, pair.bodies.first), name_of(study, pair.bodies.second));
  return text;
}

std::string near_json(const NearStudy& study) {
  const ClosePairs& s = study.pairs;
  json decided = json::object(), nearest = json::array();
  for (const Level level : crowd_levels) decided[to_string(level)] = s.decided[index_of(level)];
  for (const NearPair& pair : study.nearest) nearest.push_back(near_pair_json(pair));
  json all{{"cylinders", s.bodies}};
  if (study.generated.empty()) {
    all["file"] = study.file;
  } else {
    all["generated"] = study.generated;
    all["seed"] = std::to_string(study.seed);
  }
  all["clearance"] = study.clearance;
  all["candidates"] = s.candidates.size();
  all["decided"] = std::move(decided);
  all["undecided"] = s.undecided;
  all["cpu_ms"] = {{"prepare", s.prepare_ms}, {"tree", s.tree_ms}, {"ladder", s.cascade_ms}};
  if (study.check) {
    const auto& [referee, certificates, referee_ms, certificates_ms] = *study.check;
    all["verification"] = {{"asked", referee.asked},
                           {"wrong", referee.wrong},
                           {"undecided", referee.undecided},
                           {"cpu_ms", referee_ms}};
    all["certificates"] = {{"checked", certificates.checked},
                           {"failed", certificates.failed},
                           {"undecided", certificates.undecided},
                           {"cpu_ms", certificates_ms}};
  }
  all["nearest"] = std::move(nearest);
  all["within"] = s.within;
  if (!study.names.empty()) all["names"] = study.names;
  return all.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string near_csv(const NearStudy& study) {
  std::string text = "a,b,distance,error,within,certificate,ax,ay,az,bx,by,bz\n";
  for (const NearPair& p : study.nearest)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(name_of(study, p.bodies.first)),
                        csv_field(name_of(study, p.bodies.second)), p.distance, p.error, p.within,
                        word_of(p.proof), p.on_a[0], p.on_a[1], p.on_a[2], p.on_b[0], p.on_b[1], p.on_b[2]);
  return text;
}

}  // namespace cyl
