// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "base/scratch_test.hpp"
#include "scenes/read/scene_files.hpp"

namespace cyl {

/// Returns the scene that a file of this ending and text has.
inline Scene read_text(const std::string& ending, const std::string& text) {
  const Scratch scratch;
  return read_scene(scratch.write("scene" + ending, text));
}

}  // namespace cyl
