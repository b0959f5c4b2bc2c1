// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <set>
#include <stdexcept>

#include "scenes/read/scene_files.hpp"

namespace cyl {

void read_srdf(const std::string& file, Scene& scene) {
  pugi::xml_document document;
  if (const auto read = document.load_file(file.c_str()); !read)
    throw std::runtime_error(fmt::format("{}: {}, at byte {}", file, read.description(), read.offset));
  const pugi::xml_node robot = document.child("robot");
  if (!robot) throw std::runtime_error(file + ": no <robot>");
  scene.srdf = file;
  std::set<std::string> missing;
  for (const pugi::xml_node& e : robot.children("disable_collisions")) {
    const auto link_of = [&](const char* attribute) {
      const std::string name = e.attribute(attribute).value();
      const auto found = std::ranges::find(scene.links, name, &Link::name);
      if (found == scene.links.end()) missing.insert(name);
      return static_cast<std::size_t>(found - scene.links.begin());
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
