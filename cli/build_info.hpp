// SPDX-License-Identifier: MIT
// What this executable was built from and where it runs: goes beside every measured number.
#pragma once

#include <string>

namespace cyl {

struct BuildInfo {
  std::string version;   ///< of the project
  std::string commit;    ///< of the sources, "-dirty" where they differ from it, "unknown" outside git
  std::string compiler;  ///< name and version
  std::string flags;
  std::string cpu;  ///< the processor's own name for itself, "unknown" where it does not tell

  std::string text() const;  ///< for --version
};

BuildInfo build_info();

}  // namespace cyl
