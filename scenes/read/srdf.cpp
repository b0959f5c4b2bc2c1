// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <stdexcept>

#include "scenes/read/scene_files.hpp"

namespace cyl {

void read_srdf(NamedFiles& files, const std::string& file, NamedBy by, Scene& scene) {
  pugi::xml_document document;
  files.load(document, file, by);
  const pugi::xml_node robot = document.child("robot");
  if (!robot) throw std::runtime_error("no <robot>");
  scene.srdf = file;
  std::map<std::string, std::size_t> links;
  for (std::size_t i = 0; i < scene.links.size(); ++i) links.emplace(scene.links[i].name, i);
  std::set<std::string> missing;
  for (const pugi::xml_node& e : robot.children("disable_collisions")) {
    const auto link_of = [&](const char* attribute) {
      const std::string name = e.attribute(attribute).value();
      const auto found = links.find(name);
      if (found != links.end()) return found->second;
      missing.insert(name);
      return scene.links.size();
    };
    const std::size_t one = link_of("link1"), other = link_of("link2");
    if (std::max(one, other) == scene.links.size()) continue;
    scene.disabled.emplace_back(one, other);
    scene.exemptions.push_back({one, other, e.attribute("reason").value()});
  }
  if (!missing.empty())
    scene.notes.push_back(
        fmt::format("{} names links that are not there: {}.", file, fmt::join(missing, ", ")));
}

}  // namespace cyl
