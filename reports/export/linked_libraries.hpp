// SPDX-License-Identifier: MIT
// Reads the libraries that a shared library is linked with from its file, without running it.
#pragma once

#include <string>
#include <string_view>

namespace cyl {

/// Returns "-lccd -lfcl" for the bytes of an ELF shared library that is linked with these, without the
/// libraries that every compiler links. Returns "" if there are none, or if the bytes are not such a file.
std::string linked_libraries(std::string_view elf);

/// The same for a file; "" if it cannot be read.
std::string linked_libraries_of(const std::string& file);

}  // namespace cyl
