// SPDX-License-Identifier: MIT
// Scenes from files, by the ending of the name:
//   .jsonl  a cylinder a line: {"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2,"name":"..."}
//   .csv    columns x y z ax ay az radius height, and name if there is one, named by the first line in any
//   order .urdf   a robot; of a .srdf beside it the pairs of links that are not to be checked .xml MuJoCo's
//   MJCF, through MuJoCo's own loader
#pragma once

#include <string>

#include "scenes/scene.hpp"

namespace cyl {

/// Throws std::runtime_error "FILE: ..." on what cannot be read.
Scene read_scene(const std::string& file);

Scene read_urdf(const std::string& file);
Scene read_mjcf(const std::string& file);
/// Cylinders that stand still, each on a link of its own.
Scene still_scene(std::vector<std::pair<std::string, Cylinder>> cylinders);

}  // namespace cyl
