// SPDX-License-Identifier: MIT
// Scenes from files. The ending of the name determines the format. A .jsonl file has one solid a line,
// {"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2,"rounding":0.1,"name":"..."}, with optional rounding
// and name. A .urdf file has a robot. An .srdf file names the link pairs that are not
// checked. An .xml file is MuJoCo's MJCF. Its bodies, joints, geoms and their defaults are read, and ignored
// parts are named.
#pragma once

#include <string>
#include <vector>

#include "scenes/read/named_files.hpp"
#include "scenes/scene.hpp"

namespace cyl {

/// Without an SRDF named, that beside a .urdf file is read, of the same name. Files may name files in
/// `folders`, besides those that named_files.hpp states. Throws std::runtime_error "FILE: ..." on what cannot
/// be read.
Scene read_scene(const std::string& file, const std::string& srdf = "",
                 const std::vector<std::string>& folders = {});

/// Each throws std::runtime_error with the reason, without the file's name.
Scene read_urdf(NamedFiles& files);
Scene read_mjcf(NamedFiles& files);
/// Adds the pairs of links that an SRDF disables; links that the scene has not are noted.
void read_srdf(NamedFiles& files, const std::string& file, NamedBy by, Scene& scene);
/// Solids that stand still, each on a link of its own.
Scene still_scene(std::vector<std::pair<std::string, Solid>> cylinders);

}  // namespace cyl
