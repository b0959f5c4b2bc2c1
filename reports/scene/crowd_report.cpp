// SPDX-License-Identifier: MIT
#include "reports/scene/crowd_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/json.hpp"
#include "corpus/pairs/pair_json.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

std::string json_text(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json times_json(double prepare_ms, double tree_ms, double cascade_ms) {
  return {{"prepare", prepare_ms}, {"tree", tree_ms}, {"ladder", cascade_ms}};
}

json growth_json(const GrowthRow& row) {
  return {{"cylinders", row.cylinders},
          {"candidates", row.candidates},
          {"within", row.within},
          {"cpu_ms", times_json(row.prepare_ms, row.tree_ms, row.cascade_ms)}};
}

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

json near_json(const NearPair& pair) {
  return {{"a", pair.bodies.first},         {"b", pair.bodies.second},
          {"distance", pair.distance},      {"error", pair.error},
          {"within", pair.within},          {"certificate", word_of(pair.proof)},
          {"on_a", vector_json(pair.on_a)}, {"on_b", vector_json(pair.on_b)}};
}

/// The numbers in the order of a CSV: centre, axis, radius, height, and a rounding that is not 0.
std::string solid_text(const Cylinder& c) {
  std::string text = "[";
  for (const double x : {c.center[0], c.center[1], c.center[2], c.axis[0], c.axis[1], c.axis[2], c.radius})
    text += format_double(x) + ",";
  text += format_double(c.height);
  if (c.rounding != 0) text += "," + format_double(c.rounding);
  return text + "]";
}

/// One of `rows` on each line.
template <class Rows, class Text>
std::string list_text(const Rows& rows, Text text_of) {
  std::string text = "[";
  const char* before = "\n  ";
  for (const auto& row : rows) text += std::exchange(before, ",\n  ") + text_of(row);
  return text + "]";
}

json head_json(const Crowd& crowd) {
  const ClosePairs& s = crowd.pairs;
  json decided;
  for (const Level level : crowd_levels) decided[to_string(level)] = s.decided[index_of(level)];
  json all{{"cylinders", s.bodies}};
  if (crowd.generated.empty()) {
    all["file"] = crowd.file;
  } else {
    all["generated"] = crowd.generated;
    all["seed"] = std::to_string(crowd.seed);
  }
  all["clearance"] = crowd.clearance;
  all["candidates"] = s.candidates.size();
  all["decided"] = std::move(decided);
  all["undecided"] = s.undecided;
  all["cpu_ms"] = times_json(s.prepare_ms, s.tree_ms, s.cascade_ms);
  if (const auto& check = crowd.check) {
    const auto& [referee, certificates, referee_ms, certificates_ms] = *check;
    all["verification"] = {{"asked", referee.asked},
                           {"wrong", referee.wrong},
                           {"undecided", referee.undecided},
                           {"cpu_ms", referee_ms}};
    all["certificates"] = {{"checked", certificates.checked},
                           {"failed", certificates.failed},
                           {"undecided", certificates.undecided},
                           {"cpu_ms", certificates_ms}};
  }
  return all;
}

}  // namespace

GrowthRow growth_row(const ClosePairs& pairs) {
  return {pairs.bodies,     pairs.candidates.size(), pairs.within.size(),
          pairs.prepare_ms, pairs.tree_ms,           pairs.cascade_ms};
}

std::string crowd_head() {
  return fmt::format("{:>10} {:>12} {:>10} {:>10} {:>10} {:>10} {:>10} {:>11} {:>10} {:>11}\n", "cylinders",
                     "boxes meet", "sphere", "cylinder", "distance", "undecided", "within", "prepare ms",
                     "tree ms", "ladder ms");
}

std::string crowd_line(const ClosePairs& s) {
  return fmt::format("{:>10} {:>12} {:>10} {:>10} {:>10} {:>10} {:>10} {:>11.2f} {:>10.2f} {:>11.2f}\n",
                     s.bodies, s.candidates.size(), s.decided[0], s.decided[3], s.decided[4] + s.decided[5],
                     s.undecided, s.within.size(), s.prepare_ms, s.tree_ms, s.cascade_ms);
}

std::string crowd_check_text(const ClosePairsCheck& check) {
  const auto& [referee, certificates, referee_ms, certificates_ms] = check;
  return fmt::format(
      "referee: {} pairs asked, {} wrong, {} not proved; {:.0f} ms\n"
      "certificates: {} checked, {} failed, {} pairs without one; {:.0f} ms\n",
      referee.asked, referee.wrong, referee.undecided, referee_ms, certificates.checked, certificates.failed,
      certificates.undecided, certificates_ms);
}

std::string crowd_json(const Crowd& crowd) {
  std::string text;
  const auto add = [&](std::string_view key, std::string_view value) {
    text += text.empty() ? "{" : ",\n ";
    text += fmt::format("\"{}\":{}", key, value);
  };
  const json head = head_json(crowd);
  for (const auto& [key, value] : head.items()) add(key, json_text(value));
  if (!crowd.growth.empty())
    add("growth", list_text(crowd.growth, [](const GrowthRow& row) { return json_text(growth_json(row)); }));
  add("nearest", list_text(crowd.nearest, [](const NearPair& pair) { return json_text(near_json(pair)); }));
  add("within", json_text(crowd.pairs.within));
  if (crowd.cylinders.size() <= crowd_page_cap) {
    if (!crowd.names.empty()) add("names", json_text(crowd.names));
    add("solids", list_text(crowd.cylinders, solid_text));
  }
  return text + "}\n";
}

}  // namespace cyl
