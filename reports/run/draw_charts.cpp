// SPDX-License-Identifier: MIT
#include "reports/run/draw_charts.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "base/process/child.hpp"
#include "reports/run/report_data.hpp"

namespace cyl {

namespace fs = std::filesystem;

std::vector<std::string> draw_charts(const RunData& data, const std::string& out, const std::string& script) {
  if (Child({"/bin/sh", "-c", "command -v node >/dev/null 2>&1"}, {}).wait() != 0)
    throw std::runtime_error("charts need Node.js: apt-get install nodejs");
  if (script.empty()) throw std::runtime_error("reports/web/chart.mjs is not beside this program");
  const auto began = fs::file_time_type::clock::now();
  // The paths are absolute, so that Node.js does not take them for options.
  const std::vector<std::string> command{"node", fs::absolute(script).string(), fs::absolute(out).string()};
  if (Child(command, {.input = report_json(data)}).wait() != 0)
    throw std::runtime_error("node " + script + " failed");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(out))
    if (entry.path().extension() == ".svg" && entry.last_write_time() >= began)
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace cyl
