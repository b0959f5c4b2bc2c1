// SPDX-License-Identifier: MIT
// The sources and flags of this executable and the machine it runs on, for every measured number.
#pragma once

#include <string>

namespace cyl {

struct BuildInfo {
  std::string version;   ///< of the project
  std::string commit;    ///< of the sources; "-dirty" if they differ from it, "unknown" outside git
  std::string compiler;  ///< name and version
  std::string flags;
  std::string cpu;  ///< the processor's own name, or "unknown"

  std::string text() const;  ///< for --version
};

BuildInfo build_info();

}  // namespace cyl
