// SPDX-License-Identifier: MIT
// The vertices of meshes: STL, binary or ASCII, and Wavefront OBJ.
#pragma once

#include <string>
#include <vector>

#include "solver/cylinder.hpp"

namespace cyl {

/// Returns the vertices of a mesh. The ending of the name tells the format. Throws std::runtime_error, why
/// the file cannot be read, without its name: another format, not there, cut short, no vertex, one not
/// finite.
std::vector<Vector3> read_mesh(const std::string& file);

/// Returns where a mesh is that a robot's file names: beside it, "file://", or "package://NAME/..", which is
/// sought below the folder NAME, or a folder that has it, from the robot's own folder upwards. Empty where
/// nothing is there.
std::string find_mesh(const std::string& name, const std::string& robot);

}  // namespace cyl
