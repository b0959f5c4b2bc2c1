// SPDX-License-Identifier: MIT
// What a shared library is linked with, read from its file: nothing of it is run.
#pragma once

#include <string>
#include <string_view>

namespace cyl {

/// Returns "-lccd -lfcl" for the bytes of a shared library of ELF that is linked with these, beside what
/// every compiler links; "" where there is none, or the bytes are no such file.
std::string linked_libraries(std::string_view elf);

/// Likewise, of a file; "" where it cannot be read.
std::string linked_libraries_of(const std::string& file);

}  // namespace cyl
