// SPDX-License-Identifier: MIT
// The vertices of meshes: STL, binary or ASCII, and Wavefront OBJ.
#pragma once

#include <string>
#include <vector>

#include "solver/solid.hpp"

namespace cyl {

/// Returns the vertices of a mesh with these bytes. The ending of the name determines the format. Throws
/// std::runtime_error with the reason, without the file's name: another format, truncated, no vertex, or a
/// vertex that is not finite.
std::vector<Vector3> read_mesh(const std::string& file, const std::string& bytes);

}  // namespace cyl
