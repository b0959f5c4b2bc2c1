// SPDX-License-Identifier: MIT
#include "scenes/read/scene_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "base/json.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

using Named = std::pair<std::string, Solid>;

/// Throws std::runtime_error if a number is not 0 but smaller than any double.
struct UnderflowCheck : nlohmann::detail::json_sax_acceptor<nlohmann::json> {
  bool number_float(double x, const std::string& text) {
    if (x == 0 && text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != text.npos)
      throw std::runtime_error(text + " underflows a double");
    return true;
  }
};

Named parse_json_line(const std::string& text) {
  auto object = parse_json(text);
  UnderflowCheck check;
  nlohmann::json::sax_parse(text, &check);
  if (!object.is_object()) throw std::runtime_error("a line is an object with center, axis, radius, height");
  if (object.contains("a") && object.contains("b"))
    throw std::runtime_error(
        "this is a pair, but a line of a scene is one solid: center, axis, radius, height; `daylight check` "
        "answers pairs");
  const std::string name = object.value("name", "");
  object.erase("name");
  // The solids of a scene have the same fields as the solids of pairs.
  const CaseLine read =
      parse_case(R"({"a":)" + object.dump() + R"(,"b":{"shape":"sphere","center":[0,0,0],"radius":1}})", 1);
  if (read.value) return {name, read.value->pair.a};
  const std::size_t place = read.error.find(": ") + 2;  // in the line made above
  throw std::runtime_error(read.error.substr(place + (read.error.compare(place, 2, "a.") == 0 ? 2 : 0)));
}

Scene read_lines(const std::string& file) {
  check_given_file(file, list_cap);
  std::ifstream in(file);
  if (!in) throw std::runtime_error("it cannot be opened");
  std::vector<Named> solids;
  LineReader lines(in);
  for (std::size_t bytes = 0; lines.next();) {
    const std::string text(lines.text());
    if ((bytes += text.size()) > list_cap)
      throw std::runtime_error(fmt::format("it is larger than {} MiB", list_cap >> 20));
    if (text.size() > line_cap)
      throw std::runtime_error(fmt::format("line {} is longer than {} MiB", lines.line(), line_cap >> 20));
    try {
      solids.push_back(parse_json_line(text));
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("line {}: {}", lines.line(), error.what()));
    }
  }
  if (in.bad()) throw std::runtime_error("it cannot be read");
  return still_scene(std::move(solids));
}

/// Returns the greatest value that the joint of a link takes, without its sign.
double greatest_value(const Scene& scene, const Link& link) {
  if (!link.follow) return std::max(std::fabs(link.low), std::fabs(link.high));
  const Follow& f = *link.follow;
  return std::fabs(f.multiplier) * greatest_value(scene, scene.links[f.link]) + std::fabs(f.offset);
}

/// Throws if a joint may take a link to a place that doubles cannot represent, or has such a range.
void refuse_far_joints(const Scene& scene) {
  double reach = 0;  // of all links in one straight chain
  for (const Link& link : scene.links) {
    const double greatest = link.motion == Motion::fixed ? 0 : greatest_value(scene, link);
    reach += link.origin.translation().cwiseAbs().sum() + (link.motion == Motion::slide ? greatest : 0);
    if (!std::isfinite(2 * greatest) || !std::isfinite(reach))
      throw std::runtime_error(
          "joint " + link.joint +
          ": its limits or its origin are so large that numbers overflow: give smaller ones");
  }
}

/// Escapes the names, because they are shown: a stranger may have chosen them.
void escape_names(Scene& scene) {
  const auto escape = [](std::string& text) { text = escaped_controls(text); };
  escape(scene.name);
  for (Link& link : scene.links) {
    escape(link.name);
    escape(link.joint);
  }
  for (Body& body : scene.bodies) {
    escape(body.name);
    std::ranges::for_each(body.paired, escape);
  }
  for (LeftOut& shape : scene.left_out) {
    escape(shape.shape);
    escape(shape.link);
  }
  std::ranges::for_each(scene.notes, escape);
  for (Exemption& exemption : scene.exemptions) escape(exemption.reason);
}

}  // namespace

Scene still_scene(std::vector<std::pair<std::string, Solid>> cylinders) {
  Scene scene;
  for (auto& [name, solid] : cylinders) {
    const std::size_t i = scene.links.size();
    scene.links.emplace_back();
    scene.links.back().shapes = 1;
    scene.bodies.push_back({name.empty() ? std::to_string(i + 1) : std::move(name), i, solid, 1, 1});
  }
  return scene;
}

Scene read_scene(const std::string& file, const std::string& srdf, const std::vector<std::string>& folders) {
  NamedFiles files(file, folders);
  const std::filesystem::path path(file);
  const std::string ending = path.extension().string();
  const auto naming = [](const std::string& name, auto work) {
    try {
      return work();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(name + ": " + error.what());
    }
  };
  Scene scene = naming(file, [&] {
    if (ending == ".jsonl") return read_lines(file);
#ifdef DAYLIGHT_WITH_URDFDOM
    if (ending == ".urdf" || ending == ".xacro") return read_urdf(files);
#else
    if (ending == ".urdf" || ending == ".xacro")
      throw std::runtime_error("this build reads no URDF, for urdfdom was not there (liburdfdom-dev)");
#endif
    if (ending == ".xml") return read_mjcf(files);
    throw std::runtime_error("not a scene: expected .jsonl, .urdf or .xml");
  });
  naming(file, [&] { refuse_far_joints(scene); });
  const std::string beside = std::filesystem::path(path).replace_extension(".srdf").string();
  if (!srdf.empty())
    naming(srdf, [&] { read_srdf(files, srdf, NamedBy::user, scene); });
  else if (ending == ".urdf" && std::filesystem::exists(beside))
    naming(beside, [&] { read_srdf(files, beside, NamedBy::file, scene); });
  escape_names(scene);
  return scene;
}

}  // namespace cyl
