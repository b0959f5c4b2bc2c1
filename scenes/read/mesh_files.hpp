// SPDX-License-Identifier: MIT
// The vertices of meshes: STL, binary or ASCII, and Wavefront OBJ.
#pragma once

#include <string>
#include <vector>

#include "solver/cylinder.hpp"

namespace cyl {

/// Returns the vertices of a mesh. The ending of the name determines the format. Throws std::runtime_error
/// with the reason, without the file's name: another format, not found, truncated, no vertex, or a vertex
/// that is not finite.
std::vector<Vector3> read_mesh(const std::string& file);

/// Returns the path of a mesh that a robot's file names: beside it, "file://", or "package://NAME/..". It
/// searches a package below the folder NAME, or below a folder that contains NAME, from the robot's own
/// folder upwards. Empty if it is not found.
std::string find_mesh(const std::string& name, const std::string& robot);

}  // namespace cyl
