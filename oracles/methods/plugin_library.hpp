// SPDX-License-Identifier: MIT
// Loads the shared library of a plug-in, and reads the description that it gives of its methods.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "oracles/plugin.h"

namespace cyl {

/// The description that a library gives of one of its methods. `method` was loaded in another process. Its
/// pointers only show whether the library has the function.
struct PluginLabel {
  std::string name, version, source;
  DaylightMethod method;

  bool solids() const { return method.ask_solids != nullptr; }  ///< it is asked about structs
};

/// Reads the labels of all methods in a process of its own, because the constructors of a library may do
/// anything. Throws std::runtime_error, with a message for the user, if there are none.
std::vector<PluginLabel> read_labels(const std::string& file);

/// Loads the library in this process and returns all its methods, with all fields of today's interface. A
/// field that their own does not have is 0. Throws as read_labels() does.
std::vector<DaylightMethod> load_plugin(const std::string& file);

/// Returns at most `cap` bytes of a library's text, and nothing for null.
std::string plugin_text(const char* text, std::size_t cap);

}  // namespace cyl
