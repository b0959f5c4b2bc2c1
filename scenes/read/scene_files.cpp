// SPDX-License-Identifier: MIT
#include "scenes/read/scene_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "base/json.hpp"
#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

using Named = std::pair<std::string, Solid>;

/// The last column may be missing.
constexpr std::array<std::string_view, 9> columns{"x",  "y",      "z",      "ax",      "ay",
                                                  "az", "radius", "height", "rounding"};

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

std::vector<std::string> fields_of(const std::string& text) {
  std::vector<std::string> fields(1);
  for (const char c : text) {
    if (c == ',')
      fields.emplace_back();
    else if (c != '\r')
      fields.back() += c;
  }
  for (std::string& field : fields) {
    field.erase(0, field.find_first_not_of(" \t"));
    field.erase(field.find_last_not_of(" \t") + 1);
  }
  return fields;
}

class CsvLines {
 public:
  Named operator()(const std::string& text) {
    const std::vector<std::string> fields = fields_of(text);
    if (fields.size() != width_)
      throw std::runtime_error(std::to_string(fields.size()) + " fields, not " + std::to_string(width_));
    std::array<double, columns.size()> x{};
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (at_[i] == width_) continue;
      const std::string& field = fields[at_[i]];
      const char* end = field.data() + field.size();
      const auto [rest, error] = std::from_chars(field.data(), end, x[i]);
      if (error != std::errc() || rest != end)
        throw std::runtime_error(std::string(columns[i]) + " is '" + field + "', no number");
    }
    return {name_ < width_ ? fields[name_] : "", {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6], x[7], x[8]}};
  }
  void head(const std::string& text) {
    const std::vector<std::string> fields = fields_of(text);
    width_ = fields.size();
    const auto find = [&](std::string_view name) {
      return static_cast<std::size_t>(std::find(fields.begin(), fields.end(), name) - fields.begin());
    };
    name_ = find("name");
    for (std::size_t i = 0; i < columns.size(); ++i)
      if ((at_[i] = find(columns[i])) == width_ && i + 1 < columns.size())
        throw std::runtime_error("no column '" + std::string(columns[i]) + "'");
  }

 private:
  std::array<std::size_t, columns.size()> at_{};
  std::size_t name_ = 0, width_ = 0;
};

Scene read_lines(const std::string& file, bool csv) {
  check_given_file(file, list_cap);
  std::ifstream in(file);
  if (!in) throw std::runtime_error("it cannot be opened");
  std::vector<Named> cylinders;
  CsvLines lines;
  std::string text;
  bool headed = !csv;
  std::size_t number = 1, bytes = 0;
  for (std::string room(line_cap, '\0'); in.getline(room.data(), line_cap); ++number) {
    const auto got = static_cast<std::size_t>(in.gcount());
    text.assign(room, 0, in.eof() ? got : got - 1);
    if ((bytes += got) > list_cap)
      throw std::runtime_error(fmt::format("it is larger than {} MiB", list_cap >> 20));
    if (text.find_first_not_of(" \t\r") == text.npos) continue;
    try {
      if (!headed) {
        lines.head(text);
        headed = true;
        continue;
      }
      cylinders.push_back(csv ? lines(text) : parse_json_line(text));
      if (const Defect defect = find_defect(cylinders.back().second); defect != Defect::none)
        throw std::runtime_error(to_string(defect));
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("line {}: {}", number, error.what()));
    }
  }
  if (in.bad()) throw std::runtime_error("it cannot be read");
  if (!in.eof())
    throw std::runtime_error(fmt::format("line {} is longer than {} MiB", number, line_cap >> 20));
  return still_scene(std::move(cylinders));
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
    if (ending == ".jsonl") return read_lines(file, false);
    if (ending == ".csv") return read_lines(file, true);
#ifdef DAYLIGHT_WITH_URDFDOM
    if (ending == ".urdf" || ending == ".xacro") return read_urdf(files);
#else
    if (ending == ".urdf" || ending == ".xacro")
      throw std::runtime_error("this build reads no URDF, for urdfdom was not there (liburdfdom-dev)");
#endif
    if (ending == ".xml") return read_mjcf(files);
    throw std::runtime_error("not a scene: expected .jsonl, .csv, .urdf or .xml");
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
